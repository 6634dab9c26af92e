"""Open-Meteo and MET Norway through the command line: exit codes, sentences, and what stays."""

from __future__ import annotations

import contextlib
import json
import socket
import time
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from seacruise import cli
from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather import metno, openmeteo
from seacruise.weather.http import Limits
from seacruise.weather.openmeteo import OpenMeteo, OpenMeteoConfig
from tests.weather.weatherserver import met_norway, open_meteo

NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
BOX = (54.0, 17.0, 56.0, 19.0)
SHORT = Limits(connect_s=1.0, read_s=0.5, total_s=1.5, tries=2, backoff_s=0.01)
PATIENT = replace(SHORT, read_s=20.0, total_s=20.0)
FETCH = ["weather", "fetch", "--from", "55.2,17.4", "--to", "55.6,17.9"]
SERVERS = {"open-meteo": open_meteo, "metno": met_norway}
VARIABLES = {"open-meteo": "SEACRUISE_OPENMETEO_URL", "metno": "SEACRUISE_METNO_URL"}

CASES = [
    ("A", "reset", "broke off"),
    ("A", "timeout", "did not answer within"),
    ("A", "503", "trouble of its own"),
    ("D", "portal", "sign in"),
    ("D", "stream-error", "incomplete or not JSON"),
    ("D", "last-year", "check this computer's date"),
]


@pytest.mark.parametrize("service", SERVERS)
@pytest.mark.parametrize(
    ("behaviour", "words"), [case[1:] for case in CASES], ids=[f"{case[0]}-{case[1]}" for case in CASES]
)
def test_fault_on_the_command_line(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    service: str,
    behaviour: str,
    words: str,
) -> None:
    _hurry(monkeypatch, SHORT if behaviour == "timeout" else PATIENT)
    with SERVERS[service](behaviour) as server:
        monkeypatch.setenv(VARIABLES[service], server.url)
        assert cli.main([*FETCH, "--forecast", service]) == 4
    out, err = capsys.readouterr()
    assert out == ""
    last = err.strip().splitlines()[-1]
    assert words in last
    assert "Traceback" not in err

    # the earlier forecast is still there
    with SERVERS[service]() as server:
        monkeypatch.setenv(VARIABLES[service], server.url)
        assert cli.main([*FETCH, "--forecast", service]) == 0
    capsys.readouterr()
    with SERVERS[service](behaviour) as server:
        monkeypatch.setenv(VARIABLES[service], server.url)
        assert cli.main([*FETCH, "--forecast", service, "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["times"] > 24


def _hurry(monkeypatch: pytest.MonkeyPatch, limits: Limits) -> None:
    """Shorten deadlines and pauses, which are held by tests of their own."""
    quick = OpenMeteoConfig(limits=limits, max_points=6, max_ensemble_points=6)
    quicker = metno.MetNoConfig(limits=limits, max_points=4, pace_s=0.0)
    monkeypatch.setattr(openmeteo, "OpenMeteoConfig", lambda: quick)
    monkeypatch.setattr(metno, "MetNoConfig", lambda: quicker)


def test_auto_without_a_network_is_practice_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    begin = time.monotonic()
    assert cli.main(FETCH) == 0
    # nothing to wait for: the connection is refused
    assert time.monotonic() - begin < 20.0
    out, err = capsys.readouterr()
    assert "Wind from Open-Meteo, because no Storm Glass key is set" in err
    assert "Open-Meteo failed (Open-Meteo cannot be reached)" in out
    assert out.startswith("Practice weather - generated, not a forecast")


def test_weather_info_tells_of_all_services(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with open_meteo() as server:
        monkeypatch.setenv("SEACRUISE_OPENMETEO_URL", server.url)
        assert cli.main([*FETCH, "--forecast", "open-meteo"]) == 0
    capsys.readouterr()
    assert cli.main(["weather", "info", "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    sources = {source["name"]: source for source in document["sources"]}
    assert sources["open-meteo"]["usable"] is True
    assert sources["stormglass"]["usable"] is False
    assert "STORMGLASS_API_KEY" in sources["stormglass"]["remark"]
    assert "non-commercial" in sources["open-meteo"]["terms"]
    assert "MET Norway" in sources["metno"]["terms"]
    kept = {entry["service"]: entry for entry in document["cached"]}
    assert set(kept) == {"open-meteo wind", "open-meteo sea"}
    assert 0.0 <= kept["open-meteo wind"]["age_h"] < 1.0
    assert cli.main(["weather", "info"]) == 0
    told = capsys.readouterr().out
    assert "CC BY 4.0" in told
    assert "open-meteo wind" in told


@contextlib.contextmanager
def deaf_port() -> Iterator[int]:
    """Give a port whose queue of connections is full, so that the next one is not even refused."""
    with socket.create_server(("127.0.0.1", 0), backlog=0) as listener, contextlib.ExitStack() as waiting:
        port = listener.getsockname()[1]
        for _ in range(4):
            knock = waiting.enter_context(socket.socket())
            knock.setblocking(False)
            knock.connect_ex(("127.0.0.1", port))
        time.sleep(0.1)
        with socket.socket() as probe:
            probe.settimeout(0.3)
            try:
                probe.connect(("127.0.0.1", port))
            except TimeoutError:
                yield port
                return
            except OSError:
                pass
        pytest.skip("CONNECT TIMEOUT NOT TESTED: this system answers for a full queue")


def test_A_connect_timeout(settings: Settings) -> None:  # noqa: N802 (the letter is the fault's group)
    config = OpenMeteoConfig(limits=replace(SHORT, connect_s=0.4, total_s=20.0), max_points=4)
    begin = time.monotonic()
    with deaf_port() as port, pytest.raises(WeatherError, match=r"within 0\.4 seconds") as caught:
        OpenMeteo(replace(settings, openmeteo_url=f"http://127.0.0.1:{port}"), config).wind(
            BOX, departure=None, now=NOW, job=Job()
        )
    # whoever does not pick up is not called again
    assert time.monotonic() - begin < 10.0
    assert caught.value.reason == "timeout"
