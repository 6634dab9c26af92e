# Each target does its own set-up in .venv, with any Python from 3.11 on; repeats are instant.
# On Windows: see "Without make" in README.md.

BIN := .venv/bin
export PYTHON

.PHONY: help run demo test bench bundle translations clean distclean
.NOTPARALLEL:

help:
	@echo "make run    open the window (without a display: make demo)"
	@echo "make demo   compute Gdynia - Stockholm on real wind of 2016; writes build/demo.png and build/demo.gpx"
	@echo "make test   ruff, mypy and all tests"
	@echo "make bench  measure; prints JSON"
	@echo "make bundle one folder for computers without Python: build/bundle/seacruise (docs/bundle.md)"
	@echo "make translations  collect and compile the words of the window (docs/architecture.md, Languages)"
	@echo "make clean  remove what was built; make distclean: .venv too"

run:
	@tools/setup.sh
	@if [ "$$(uname -s)" = Linux ] && [ -z "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
	    echo "No display here (neither DISPLAY nor WAYLAND_DISPLAY is set): running the demo instead." >&2; \
	    $(MAKE) --no-print-directory demo; \
	else \
	    $(BIN)/seacruise; \
	fi

demo:
	@tools/setup.sh
	@mkdir -p build
	$(BIN)/seacruise plan --from Gdynia --to Stockholm --depart 2016-11-20T06:00Z \
	    --yacht "Bavaria 46 Cruiser" --forecast sample --chart build/demo.png --gpx build/demo.gpx

# The import contracts are held by tests/test_house.py. The window is tested after the rest: its tests look at how long
# the screen stands still.
test:
	@tools/setup.sh dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/python -m pytest --numprocesses=2 --dist=loadfile --ignore=tests/desktop --ignore=tests/display
	$(BIN)/python -m pytest --numprocesses=2 --dist=loadfile tests/desktop
	$(BIN)/python -m pytest tests/display

bench:
	@tools/setup.sh bench
	@$(BIN)/python -m benchmarks

bundle:
	@tools/setup.sh bundle
	@$(BIN)/python tools/bundle/build.py

translations:
	@tools/setup.sh
	@$(BIN)/python tools/translations.py update
	@$(BIN)/python tools/translations.py release
	@$(BIN)/python tools/translations.py check

clean:
	rm -rf build dist .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache

distclean: clean
	rm -rf .venv
	find seacruise tests tools benchmarks -name __pycache__ -prune -exec rm -rf {} +
