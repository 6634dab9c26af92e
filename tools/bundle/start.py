"""Where the bundled program starts: ``seacruise``, with what ``python -m`` does for its own modules."""

from __future__ import annotations

import os
import sys
from pathlib import Path

if __name__ == "__main__":
    # A program without a console on Windows has no streams at all; what it says there goes nowhere.
    nowhere = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 - open until the program ends
    sys.stdout, sys.stderr = sys.stdout or nowhere, sys.stderr or nowhere

    # SeaCruise starts itself as `sys.executable -m seacruise.weather.isolated`: there is no Python to ask.
    match sys.argv[1:]:
        case ["-m", "seacruise.weather.isolated", question, answer]:
            from seacruise.weather.isolated import main as read_weather

            read_weather(question, answer)
        case ["-m", "seacruise.warmup"]:
            from seacruise.warmup import warm_up

            warm_up()
        case _:
            from seacruise.cli import main

            sys.exit(main())
