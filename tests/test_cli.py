"""The command line: exit codes, one sentence for an error, JSON alone, and nothing heavy for --help."""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from datetime import UTC, datetime
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import seacruise.passage
import seacruise.weather.source
from seacruise import cli
from seacruise.commands import common, plan, polar_show, request, window
from seacruise.errors import CancelledError, InputError, NoPassageError, WeatherError
from seacruise.passage import Passage, PassageRequest
from seacruise.progress import Job
from seacruise.settings import Settings
from tests.passages import veering_wind

PLAN = ["plan", "--from", "Gdynia", "--to", "Stockholm", "--yacht", "Bavaria 46 Cruiser"]
SAMPLE = [*PLAN, "--depart", "2016-11-20T06:00Z", "--forecast", "sample"]


class Asked:
    """Stands in for the rooms behind the command line and keeps what they were asked."""

    def __init__(self, passage: Passage) -> None:
        self.passage = passage
        self.request: PassageRequest | None = None
        self.wind: dict[str, Any] = {}
        self.error: Exception | None = None

    def plan(self, request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        self.request = request
        job.report("search", 0.5, "searching")
        if self.error is not None:
            raise self.error
        return self.passage

    def fetch_wind(self, names: list[str], **keywords: Any) -> Any:
        self.wind = {"names": list(names), **keywords}
        return veering_wind()


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, passage: Passage) -> Asked:
    stand_in = Asked(passage)
    monkeypatch.setattr(seacruise.passage, "plan", stand_in.plan)
    monkeypatch.setattr(seacruise.weather.source, "fetch_wind", stand_in.fetch_wind)
    return stand_in


def one_sentence(err: str) -> str:
    lines = [line for line in err.splitlines() if line.startswith("seacruise: ")]
    assert len(lines) == 1, err
    assert "Traceback" not in err
    return lines[0]


def run_process(*words: str, env: dict[str, str] | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "seacruise", *words],
        capture_output=True,
        text=True,
        encoding="utf-8",
        env={**os.environ, **(env or {})},
        timeout=120,
        check=False,
    )


# --------------------------------------------------------------------------------------------- start-up


def test_help_and_version_load_nothing_heavy() -> None:
    code = (
        "import sys\n"
        "from seacruise import cli\n"
        "try: cli.main(['plan', '--help'])\n"
        "except SystemExit: pass\n"
        "heavy = 'numba shapely matplotlib scipy netCDF4 eccodes PySide6 requests pandas numpy'.split()\n"
        "print('loaded:', [name for name in heavy if name in sys.modules])\n"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "--from" in answer.stdout
    assert answer.stdout.splitlines()[-1] == "loaded: []"


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        cli.main(["--version"])
    assert left.value.code == 0
    assert capsys.readouterr().out == f"SeaCruise {seacruise.__version__}\n"


def test_every_command_has_help_and_a_format(capsys: pytest.CaptureFixture[str]) -> None:
    for words in (["plan"], ["window"], ["polar", "show"], ["weather", "fetch"], ["weather", "info"]):
        with pytest.raises(SystemExit) as left:
            cli.main([*words, "--help"])
        assert left.value.code == 0
        assert "--format {text,json}" in capsys.readouterr().out


# ------------------------------------------------------------------------------------------------- plan


def test_plan_prints_what_a_sailor_reads(asked: Asked, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(SAMPLE) == 0
    out, err = capsys.readouterr()
    assert out.startswith("Gdynia - Sandhamn: 43 h 17 min\n")
    assert "searching" in err


def test_plan_prints_json_alone(asked: Asked, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([*SAMPLE, "--format", "json"]) == 0
    out, err = capsys.readouterr()
    assert json.loads(out)["schema"] == "seacruise.passage/1"
    assert "Note: Gdynia lies 0.8 nm from open water" in err


def test_plan_through_all_rooms(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No stand-ins: ports, polar, sample wind, sea, search, re-sailing, JSON and GPX."""
    words = ["plan", "--from", "Visby", "--to", "Västervik", "--yacht", "Bavaria 46 Cruiser"]
    when = ["--depart", "2016-11-20T06:00Z", "--forecast", "sample"]
    assert cli.main([*words, *when, "--format", "json", "--gpx", str(tmp_path / "a.gpx")]) == 0
    out, err = capsys.readouterr()
    answer = json.loads(out)
    assert (answer["start"]["name"], answer["end"]["name"]) == ("Visby", "Västervik")
    assert answer["checks"]["land_free"] is True
    assert 0 < answer["lower_bound_h"] <= answer["duration_h"]
    assert answer["direct_distance_nm"] <= answer["distance_nm"] < 3 * answer["direct_distance_nm"]
    assert "Sample weather" in err
    assert f'lat="{answer["waypoints"][0]["lat"]:.6f}"' in (tmp_path / "a.gpx").read_text(encoding="utf-8")


def test_plan_asks_for_what_was_said(asked: Asked) -> None:
    extra = "--preset classic --directions 24 --spacing 2,5 --area rectangle --no-refine --no-tacking"
    extra += " --no-current"
    more = "--percent-of-polar 90 --motor-below 3 --motor-speed 6 --fuel-rate 4 --max-wind 30"
    assert cli.main([*SAMPLE, *extra.split(), *more.split(), "--forecast", "more.grb"]) == 0
    assert asked.request is not None
    assert asked.request.departure == datetime(2016, 11, 20, 6, tzinfo=UTC)
    assert asked.request.start.name == "Gdynia"
    assert asked.request.yacht.name == "Bavaria 46 Cruiser"
    assert asked.wind["names"] == ["sample", "more.grb"]
    options = asked.request.options
    assert (options.preset, options.directions, options.spacing_nm, options.area) == (
        *("classic", 24, 2.5),
        "rectangle",
    )
    assert (options.refine, options.tacking, options.currents) == (False, False, False)
    assert (options.percent_of_polar, options.max_wind_kn) == (90, 30)
    assert (options.motor_below_kn, options.motor_speed_kn, options.fuel_rate_l_h) == (3, 6, 4)


def test_a_current_that_is_named_and_left_out_is_refused(
    asked: Asked, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main([*SAMPLE, "--current", "here.grb", "--no-current"]) == 2
    assert "--no-current" in capsys.readouterr().err
    assert asked.request is None


def test_what_was_not_said_is_the_preset(asked: Asked) -> None:
    assert cli.main(PLAN) == 0
    assert asked.request is not None
    assert asked.request.options == seacruise.passage.Options()
    assert asked.request.departure is None
    assert asked.wind["names"] == ["auto"]


def test_plan_writes_every_file(asked: Asked, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = {name: tmp_path / f"out.{name}" for name in ("gpx", "kml", "geojson", "csv", "chart")}
    assert cli.main([*SAMPLE, *(word for name, p in files.items() for word in (f"--{name}", str(p)))]) == 0
    begins = {name: path.read_bytes()[:8] for name, path in files.items()}
    assert begins["gpx"] == begins["kml"] == b"<?xml ve"
    assert begins["geojson"].startswith(b"{")
    assert begins["csv"] == b"number,t"
    assert begins["chart"] == b"\x89PNG\r\n\x1a\n"
    assert capsys.readouterr().err.count("Wrote ") == 5


def test_a_target_that_cannot_be_written_is_refused_before_computing(
    asked: Asked, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main([*SAMPLE, "--gpx", str(tmp_path / "nowhere" / "a.gpx")]) == 2
    assert "there is no folder" in one_sentence(capsys.readouterr().err)
    assert asked.request is None


def test_the_answer_is_printed_even_when_an_export_fails(
    asked: Asked, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    assert cli.main([*SAMPLE, "--gpx", str(tmp_path / "a.gpx")]) == 2
    out, err = capsys.readouterr()
    assert "43 h 17 min" in out
    assert "no space left" in one_sentence(err)


def test_a_reader_that_leaves_early_does_not_cost_the_files(
    asked: Asked, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def gone(*_: object, **__: object) -> None:
        raise BrokenPipeError

    monkeypatch.setattr(plan, "show", gone)
    with pytest.raises(BrokenPipeError):
        plan.run(cli.build_parser().parse_args([*SAMPLE, "--gpx", str(tmp_path / "a.gpx")]))
    assert (tmp_path / "a.gpx").stat().st_size > 1000


@pytest.mark.parametrize(
    ("words", "part"),
    [
        ([*SAMPLE, "--gpx", "~nobody-of-this-name/a.gpx"], "there is no folder"),
        (["polar", "show", "~nobody-of-this-name/a.csv"], "There is no polar file ~nobody-of-this-name"),
    ],
)
def test_a_home_that_nobody_has_is_a_path_that_is_not_there(
    words: list[str], part: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(words) == 2
    assert part in one_sentence(capsys.readouterr().err)


# ------------------------------------------------------------------------------------------------ errors


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (["plan"], "--from"),
        (["nonsense"], "nonsense"),
        (["plan", "--from"], "--from"),
        ([*SAMPLE, "--depart", "yesterday"], "write it as 2016-11-20T06:00Z"),
        ([*SAMPLE, "--depart", "0001-01-01T00:00+23:00"], "is not a time"),
        ([*SAMPLE, "--directions", "13"], "13"),
        ([*SAMPLE, "--spacing", "nan"], "from 0.1 to 60 nm"),
        ([*SAMPLE, "--percent-of-polar", "1_00"], "from 10 to 150 %"),
        ([*SAMPLE, "--prese", "classic"], "--prese"),
        ([*SAMPLE, "--format", "xml"], "xml"),
        ([*SAMPLE, "--gpx", ""], "file name is missing"),
        (["window", "--size", "12x"], "1280x800"),
        (["polar"], "ACTION"),
        (["plan", "--from", "Gdynja", "--to", "Stockholm", "--yacht", "Bavaria 46 Cruiser"], "Gdynia"),
        (["plan", "--from", "Gdynia", "--to", "Stockholm", "--yacht", "Titanic 1912"], "Titanic 1912"),
        (["polar", "show", "no/such/polar.csv"], "polar.csv"),
        (["ports", "list", "--search", "qqqq"], "qqqq"),
        (["ports", "check", "no-such-ports.csv"], "no-such-ports.csv"),
    ],
    ids=lambda value: " ".join(value)[-40:] if isinstance(value, list) else None,
)
def test_bad_input_is_one_sentence_and_code_2(
    asked: Asked, capsys: pytest.CaptureFixture[str], words: list[str], part: str
) -> None:
    assert cli.main(words) == 2
    out, err = capsys.readouterr()
    assert part in one_sentence(err)
    assert not out
    assert asked.request is None


@pytest.mark.parametrize(
    ("error", "code", "reason"),
    [
        (InputError("No."), 2, "bad-input"),
        (NoPassageError("Calm.", reason="becalmed", place=(55.0, 18.0)), 3, "becalmed"),
        (WeatherError("Quota.", reason="quota"), 4, "quota"),
        (CancelledError(), 130, "cancelled"),
        (KeyboardInterrupt(), 130, "cancelled"),
        (ZeroDivisionError("secret-key-1234"), 1, "internal"),
    ],
    ids=["input", "no passage", "weather", "cancelled", "ctrl-c", "ours"],
)
def test_exit_codes_and_reasons(
    asked: Asked, capsys: pytest.CaptureFixture[str], error: Exception, code: int, reason: str
) -> None:
    asked.error = error
    assert cli.main([*SAMPLE, "--format=json"]) == code
    out, err = capsys.readouterr()
    one_sentence(err)
    answer = json.loads(out)
    assert answer["reason"] == reason
    assert answer["message"] in err
    assert answer.get("place") == ({"lat": 55.0, "lon": 18.0} if reason == "becalmed" else None)


def test_a_mistake_of_ours_is_kept_for_the_report_without_the_key(
    asked: Asked, settings: Settings, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("STORMGLASS_API_KEY", "secret-key-1234")
    asked.error = ZeroDivisionError("header secret-key-1234 went wrong")
    assert cli.main(SAMPLE) == 1
    kept = settings.cache_dir / "last-error.txt"
    assert str(kept) in one_sentence(capsys.readouterr().err)
    text = kept.read_text(encoding="utf-8")
    assert "ZeroDivisionError" in text
    assert "secret-key-1234" not in text


@pytest.mark.skipif(os.name == "nt", reason="no SIGINT for child processes there")
def test_ctrl_c_cancels_the_job_and_leaves_with_130(tmp_path: Path) -> None:
    code = (
        "import sys, time\n"
        "import seacruise.passage, seacruise.weather.source\n"
        "from seacruise import cli\n"
        "def plan(request, *, settings, job):\n"
        "    print('planning', file=sys.stderr, flush=True)\n"
        "    while True:\n"
        "        job.check(); time.sleep(0.01)\n"
        "seacruise.passage.plan = plan\n"
        "seacruise.weather.source.fetch_wind = lambda *a, **k: None\n"
        f"sys.exit(cli.main({SAMPLE!r}))\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stderr is not None
    line = process.stderr.readline()
    assert line == "planning\n", line + process.stderr.read()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert not out
    assert one_sentence(err) == "seacruise: Cancelled."


@pytest.mark.skipif(os.name == "nt", reason="pipes close differently there")
def test_a_reader_that_leaves_early_is_no_error() -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "seacruise", "ports", "list", "--format", "json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    err = process.stderr.read()
    process.stderr.close()
    assert process.wait(timeout=60) == 0
    assert not err


def test_output_is_utf8_whatever_the_locale() -> None:
    answer = run_process(
        "ports",
        "list",
        "--search",
        "swinoujscie",
        env={"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    )
    assert answer.returncode == 0, answer.stderr
    assert "Świnoujście" in answer.stdout


# ---------------------------------------------------------------------------------------------- arguments


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("2016-11-20T06:00Z", datetime(2016, 11, 20, 6, tzinfo=UTC)),
        ("2016-11-20T06:00", datetime(2016, 11, 20, 6, tzinfo=UTC)),
        ("2016-11-20 06:00", datetime(2016, 11, 20, 6, tzinfo=UTC)),
        ("2016-11-20T07:30+01:30", datetime(2016, 11, 20, 6, tzinfo=UTC)),
        ("2016-02-29", datetime(2016, 2, 29, tzinfo=UTC)),
    ],
)
def test_times(text: str, time: datetime) -> None:
    assert common.parse_time(text) == time
    assert common.parse_time(text).tzinfo is UTC


@pytest.mark.parametrize("text", ["", "today", "2017-02-29", "2016-11-20T25:00", "20.11.2016", "1479621600"])
def test_what_is_no_time(text: str) -> None:
    with pytest.raises(argparse.ArgumentTypeError, match="is not a time"):
        common.parse_time(text)


@pytest.mark.parametrize("words", [["--from", "-33.9,18.4"], ["--from=-33.9,18.4"]])
def test_southern_positions_are_no_options(words: list[str]) -> None:
    rest = ["--to", "-22.9,14.5", "--yacht", "x"]
    arguments = cli.build_parser().parse_args(cli._guard_southern_latitudes(["plan", *words, *rest]))
    assert (arguments.start, arguments.end) == ("-33.9,18.4", "-22.9,14.5")


def test_sizes() -> None:
    assert common.parse_size("1280x800") == (1280, 800)
    for text in ("1280", "1x1", "axb", "1280x800x2", "1280.5x800"):
        with pytest.raises(argparse.ArgumentTypeError):
            common.parse_size(text)


# ------------------------------------------------------------------------------------------------ window


def test_no_arguments_mean_the_window(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    called: list[argparse.Namespace] = []

    def run(arguments: argparse.Namespace) -> int:
        called.append(arguments)
        return 0

    monkeypatch.setattr(window, "run", run)
    assert cli.main([]) == 0
    assert window.prefill(called[0]) == {}


def test_the_window_gets_what_was_said() -> None:
    words = ["window", "--from", "Gdynia", "--max-wind", "25", "--no-refine", "--size", "1000x700"]
    arguments = cli.build_parser().parse_args(words)
    assert window.prefill(arguments) == {"start": "Gdynia", "max_wind_kn": 25.0, "refine": False}


def test_without_a_display_a_picture_is_drawn_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    environ: dict[str, str] = {}
    window.choose_platform(environ, picture_only=True)
    assert environ == {"QT_QPA_PLATFORM": "offscreen"}
    with pytest.raises(InputError, match="no display") as refused:
        window.choose_platform({}, picture_only=False)
    assert refused.value.reason == "no-window"
    for there in ({"DISPLAY": ":0"}, {"WAYLAND_DISPLAY": "wayland-0"}, {"QT_QPA_PLATFORM": "offscreen"}):
        before = dict(there)
        window.choose_platform(there, picture_only=False)
        assert there == before


def test_a_missing_system_library_is_named_with_its_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
    monkeypatch.setitem(sys.modules, "seacruise.desktop.app", ModuleType("app"))
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(window, "_loads", lambda name: name != "libxcb-cursor.so.0")
    assert window.qt_trouble() == (
        "The window cannot open: Qt needs the system library libxcb-cursor.so.0; "
        "on Debian or Ubuntu: apt-get install libxcb-cursor0."
    )
    monkeypatch.setattr(window, "_loads", lambda name: True)
    monkeypatch.setattr(window, "_answers", lambda: True)
    assert window.qt_trouble() is None
    monkeypatch.setattr(window, "_answers", lambda: False)
    monkeypatch.setenv("DISPLAY", ":5")
    assert window.qt_trouble() == (
        "The window cannot open: the display ':5' does not answer; set DISPLAY to one that does."
    )


def test_a_library_that_qt_itself_misses_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    class Finder:
        def find_spec(self, name: str, *_: object) -> None:
            if name == "seacruise.desktop.app":
                raise ImportError("libEGL.so.1: cannot open shared object file: No such file or directory")

    monkeypatch.delitem(sys.modules, "seacruise.desktop.app", raising=False)
    monkeypatch.setattr(sys, "meta_path", [Finder(), *sys.meta_path])
    assert window.qt_trouble() == (
        "The window cannot open: Qt needs the system library libEGL.so.1; "
        "on Debian or Ubuntu: apt-get install libegl1."
    )


# -------------------------------------------------------------------------------- polar, ports, weather


def test_polar_show(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["polar", "show", "bavaria 46 cruiser", "--format", "json"]) == 0
    targets = json.loads(capsys.readouterr().out)
    assert targets["yacht"] == "Bavaria 46 Cruiser"
    assert targets["twa_deg"] == [52, 60, 75, 90, 110, 120, 135, 150]
    row = targets["boat_speed_kn"][targets["twa_deg"].index(90)]
    assert len(row) == len(targets["tws_kn"])
    assert all(0 < speed < 20 for speed in row)
    assert all(30 < twa < 60 for twa in targets["beat"]["twa_deg"])
    assert cli.main(["polar", "show", "bavaria 46 cruiser"]) == 0
    table = capsys.readouterr().out
    assert polar_show.to_text(targets) + "\n" == table
    assert f"{row[0]:.2f}" in table


def test_ports_list(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["ports", "list", "--search", "swinoujscie", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found[0]["name"] == "Świnoujście"
    assert set(found[0]) == {"name", "country", "lat", "lon"}
    assert cli.main(["ports", "list"]) == 0
    assert len(capsys.readouterr().out.splitlines()) > 100


def test_ports_check_finds_a_harbour_on_a_mountain(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "ports.csv"
    file.write_text(
        "name,country,lat,lon\nGdynia,PL,54.517,18.553\nKebnekaise,SE,65.0,18.5\n", encoding="utf-8"
    )
    assert cli.main(["ports", "check", str(file)]) == 2
    out = capsys.readouterr().out
    assert "Kebnekaise: no open water near it" in out
    assert "2 ports: 1 without open water" in out


def test_weather_fetch(asked: Asked, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["weather", "fetch", "--from", "Gdynia", "--to", "Stockholm", "--forecast", "open-meteo"]
    assert cli.main([*words, "--format", "json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["forecast"]["source"] == "Test wind, veering slowly"
    assert (answer["times"], answer["points"]) == (9, 16 * 26)
    assert asked.wind["names"] == ["open-meteo"]
    assert cli.main(words) == 0
    assert "9 times at 416 points" in capsys.readouterr().out


# ---------------------------------------------------------------------------------------------- progress


def test_weather_info_says_where_things_are(settings: Settings, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["weather", "info"]) == 0
    assert f"Your polars: {settings.user_polars}" in capsys.readouterr().out.splitlines()
    assert cli.main(["weather", "info", "--format", "json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert (answer["polars"], answer["database"]) == (str(settings.user_polars), str(settings.database))


def test_progress_on_a_terminal_is_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    report = common.TerminalReport()
    report("wind", 0.25, "wind 1 of 4")
    report("search", None, "searching")
    report.clear()
    err = capsys.readouterr().err
    assert "\n" not in err
    assert "wind 1 of 4  25%" in err
    assert err.endswith("\r\x1b[K")


def test_progress_in_a_log_is_a_line_a_stage(capsys: pytest.CaptureFixture[str]) -> None:
    report = common.TerminalReport()
    for stage, message in (("wind", "wind 1 of 2"), ("wind", "wind 2 of 2"), ("search", "searching")):
        report(stage, None, message)
    report.clear()
    assert capsys.readouterr().err == "wind 1 of 2\nsearching\n"


def test_a_second_ctrl_c_does_not_wait() -> None:
    # Started in the background, as services and nohup do, a process ignores Ctrl+C from birth.
    before = signal.getsignal(signal.SIGINT)
    with common.cancellable_job() as job:
        signal.raise_signal(signal.SIGINT)
        deadline = time.monotonic() + 30
        while not job.cancel.is_set() and time.monotonic() < deadline:
            time.sleep(0.001)
        with pytest.raises(CancelledError):
            job.check()
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before


def test_directions_are_those_of_the_contract() -> None:
    triangular, rectangular = {12, 24, 36, 60, 72, 108, 132}, {8, 16, 32}
    assert set(request.DIRECTIONS) == triangular | rectangular


@pytest.mark.parametrize("left", [True, False])
def test_a_worker_that_has_not_ended_does_not_end_the_program_in_its_own_way(left: bool) -> None:
    program = f"""
import atexit, sys, threading
from seacruise import cli
atexit.register(print, "Python ended")
def run(words):
    print("answer", words)
    if {left}:
        threading.Thread(target=threading.Event().wait, daemon=True).start()
    return 3
cli._run = run
sys.argv = ["seacruise", "plan"]
sys.exit(cli.main())
"""
    ended = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=60
    )
    assert (ended.returncode, ended.stderr) == (3, "")
    assert ended.stdout == "answer ['plan']\n" + ("" if left else "Python ended\n")
