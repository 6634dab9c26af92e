"""The wind after the end of the forecast: held, or faded to the usual."""

from __future__ import annotations

from dataclasses import replace
from datetime import timedelta
from typing import Any

import numpy as np
import pytest

from seacruise.weather.beyond import FADE_H, extend
from seacruise.weather.wind import Wind
from tests.weather.worlds import uniform


def gale(**besides: Any) -> Wind:
    """Calm for twelve hours, then twelve of a rising westerly of up to 20 m/s."""
    wind = uniform(hours=(0.0, 12.0, 18.0, 24.0), **besides)
    u = np.array([0.0, 0.0, 10.0, 20.0])[:, None, None]
    return replace(wind, u=np.broadcast_to(u, wind.u.shape), v=np.zeros_like(wind.v))


def speed(wind: Wind, hours: float) -> float:
    return float(wind.at(wind.forecast.valid_to.timestamp() + hours * 3600, 55.5, 18.5)[0])


@pytest.mark.parametrize("mode", ["hold", "refuse"])
def test_holding_changes_nothing(mode: str) -> None:
    wind = gale()
    assert extend(wind, mode) is wind  # type: ignore[arg-type]
    assert speed(wind, 99.0) == 20.0


def test_fading_goes_to_the_mean_of_the_forecast_in_a_day() -> None:
    wind = extend(gale(), "fade")
    # 12 h of calm, 6 h of 0 to 10, 6 h of 10 to 20: 120 m/s h in 24 h, whatever the steps
    assert speed(wind, FADE_H) == pytest.approx(5.0, abs=1e-5)
    assert speed(wind, FADE_H / 2) == pytest.approx(12.5, abs=1e-5)
    assert speed(wind, 0.0) == 20.0
    assert speed(wind, 500.0) == pytest.approx(5.0, abs=1e-5)
    # before the horizon it is the forecast
    assert speed(wind, -6.0) == 10.0


def test_the_horizon_stays_that_of_the_forecast() -> None:
    wind = gale()
    assert extend(wind, "fade").forecast is wind.forecast


def test_what_is_not_needed_is_not_made() -> None:
    wind = gale()
    assert extend(wind, "fade", wind.forecast.valid_to) is wind
    assert extend(wind, "fade", wind.forecast.valid_to + timedelta(seconds=1)).time.size == 5
    single = uniform(hours=(0.0,))
    assert extend(single, "fade") is single


def test_members_fade_to_their_mean() -> None:
    calm, storm = replace(gale(), u=np.zeros((4, 4, 5), dtype=np.float32)), gale()
    wind = extend(replace(gale(spread=3.0, gust=25.0), members=(calm, storm)), "fade")
    for one in (wind, *wind.members):
        assert speed(one, FADE_H) == pytest.approx(10.0)
        # alone it would fade to its own mean, had it not been extended with the others
        assert extend(one, "fade") is one
    assert speed(wind.members[0], FADE_H / 2) == pytest.approx(5.0)
    assert wind.spread is not None
    assert wind.gust is not None
    np.testing.assert_array_equal(wind.spread[-1], 3.0)
    np.testing.assert_array_equal(wind.gust[-1], 25.0)


def test_gusts_and_waves_fade_and_the_spread_grows_to_how_much_the_wind_varied() -> None:
    wind = gale(spread=1.0, wave=2.0, gust=3.0)
    assert wind.wave is not None
    wave = wind.wave.copy()
    wave[-1] = 8.0
    faded = extend(replace(wind, wave=wave), "fade")
    assert faded.wave is not None
    assert faded.spread is not None
    assert faded.gust is not None
    assert float(faded.wave[-1, 0, 0]) == pytest.approx(2.0 + 6.0 * 3 / 24)
    # weights of the four times 6, 9, 6 and 3 h around the mean of 5
    variance = (6 * 25 + 9 * 25 + 6 * 25 + 3 * 225) / 24
    assert float(faded.spread[-1, 0, 0]) == pytest.approx(np.sqrt(variance), rel=1e-5)
    assert float(faded.gust[-1, 0, 0]) == pytest.approx(3.0)
