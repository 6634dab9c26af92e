"""What a passage does after the end of its forecast; how forecasts and currents are mixed on request."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise import cli
from seacruise.errors import InputError, NoPassageError
from seacruise.export.jsonform import passage_to_json
from seacruise.export.textform import passage_to_text
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT
from seacruise.weather.beyond import Beyond
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.routing.worlds import cache_dir_of
from tests.weather.worlds import uniform, write_layers

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)


def rising() -> Wind:
    """Westerly of 6 m/s that rises to 14 in its last two hours, and ends four hours after the departure."""
    wind = uniform(hours=(0.0, 2.0, 4.0), lat=np.arange(54.0, 59.0), lon=np.arange(16.0, 23.0))
    u = np.array([6.0, 6.0, 14.0], dtype=np.float32)[:, None, None]
    return replace(wind, u=np.broadcast_to(u, wind.u.shape))


@pytest.fixture(scope="module")
def settings_of_all(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


def planned(settings: Settings, beyond: Beyond, **options: Any) -> Passage:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    wind = rising()
    request = PassageRequest(
        SOUTH, NORTH, yacht, wind, wind.forecast.valid_from, Options(beyond=beyond, **options)
    )
    return plan(request, settings=settings)


@pytest.mark.parametrize("preset", ["precise", "classic"])
def test_a_passage_is_sailed_in_the_wind_it_says(settings_of_all: Settings, preset: Any) -> None:
    wind = rising()
    horizon = wind.forecast.valid_to.timestamp()
    held, faded = (planned(settings_of_all, mode, preset=preset) for mode in ("hold", "fade"))
    for passage in (held, faded):
        # hours beyond the forecast are counted from its own end, whatever is made of them
        assert passage.forecast.valid_to == wind.forecast.valid_to
        assert passage.beyond_forecast_h == pytest.approx(passage.duration_h - 4.0, abs=1e-6)
        assert passage.beyond_forecast_h > 1.0
    after = held.track.time > horizon
    np.testing.assert_allclose(held.track.tws_kn[after] * MS_PER_KNOT, 14.0, atol=0.01)
    after = faded.track.time > horizon
    # the mean over the four hours is 8 m/s, to be reached in a day
    wanted = 14.0 - 6.0 * (faded.track.time[after] - horizon) / 86_400.0
    np.testing.assert_allclose(faded.track.tws_kn[after] * MS_PER_KNOT, wanted, atol=0.02)


def test_the_passage_says_which_it_was(settings_of_all: Settings) -> None:
    held, faded = (planned(settings_of_all, mode) for mode in ("hold", "fade"))
    assert (held.beyond, faded.beyond) == ("hold", "fade")
    assert "beyond" not in passage_to_json(held)["forecast"]
    assert passage_to_json(faded)["forecast"]["beyond"] == "fade"
    assert any("wind, held beyond the end" in notice for notice in held.notices)
    assert any("wind, fading to the usual beyond the end" in notice for notice in faded.notices)
    assert "fading to the usual" in passage_to_text(faded, now=faded.departure)


def test_who_will_not_sail_on_held_wind_is_told_when_it_ends(settings_of_all: Settings) -> None:
    with pytest.raises(
        NoPassageError, match=r"after the forecast, which ends at 2026-01-01 04:00 UTC"
    ) as caught:
        planned(settings_of_all, "refuse")
    assert caught.value.reason == "outside-forecast"
    with pytest.raises(InputError, match="hold, fade, refuse, not 'dream'"):
        planned(settings_of_all, "dream")  # type: ignore[arg-type]


def test_forecasts_are_mixed_by_weight_and_put_to_a_current(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    axes: dict[str, Any] = {"lat": np.arange(53.0, 61.0), "lon": np.arange(15.0, 22.0)}

    def write(name: str, **layers: float) -> str:
        values = {key: (np.full((3, 8, 7), value), {"units": "m s-1"}) for key, value in layers.items()}
        return str(write_layers(tmp_path / name, values, **axes))

    first, second = write("a.nc", u10=4.0, v10=0.0), write("b.nc", u10=8.0, v10=0.0)
    words = ["weather", "fetch", "--from", "Gdynia", "--to", "Stockholm", "--format", "json"]
    words += ["--forecast", first, "--forecast", second, "--weights", "3,1"]
    assert cli.main([*words, "--current", write("c.nc", uo=0.5, vo=0.0)]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["forecast"]["source"] == "Mean of a.nc (3) and b.nc (1)"
    assert cli.main([*words, "--current", first]) == 2
    assert "a.nc cannot be used: none of its variables is a current" in capsys.readouterr().err
    assert cli.main([*words, "--weights", "3,x"]) == 2
    assert "'3,x' is not a list of numbers above 0 such as 2,1" in capsys.readouterr().err
    assert cli.main([*words, "--weights", "1"]) == 2
    assert "There are 1 weights for 2 forecasts" in capsys.readouterr().err
