"""The sun, against dates and times that any almanac has."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from seacruise.sun import CIVIL_TWILIGHT_DEG, night_hours, sun_altitude_deg


def seconds(*when: int) -> float:
    return datetime(*when, tzinfo=UTC).timestamp()  # type: ignore[arg-type, misc]


@pytest.mark.parametrize(
    ("when", "declination"),
    [
        ((2016, 3, 20, 4, 30), 0.0),
        ((2016, 6, 20, 22, 34), 23.436),
        ((2016, 9, 22, 14, 21), 0.0),
        ((2016, 12, 21, 10, 44), -23.436),
        ((2026, 6, 21, 8, 24), 23.436),
    ],
)
def test_at_the_pole_the_altitude_is_the_declination_of_the_almanac(
    when: tuple[int, ...], declination: float
) -> None:
    assert float(sun_altitude_deg(seconds(*when), 90.0, 0.0)) == pytest.approx(declination, abs=0.01)


@pytest.mark.parametrize(
    ("day", "minutes"), [((2016, 2, 11), -14.23), ((2016, 11, 3), 16.43), ((2016, 4, 15), 0.0)]
)
def test_noon_comes_by_the_equation_of_time(day: tuple[int, ...], minutes: float) -> None:
    """At Greenwich the sun is highest at 12:00 less the equation of time."""
    time = seconds(*day, 11) + np.arange(0, 7200.0, 5.0)
    highest = time[np.argmax(sun_altitude_deg(time, 51.48, 0.0))]
    assert (seconds(*day, 12) - highest) / 60.0 == pytest.approx(minutes, abs=0.5)


def test_east_is_earlier() -> None:
    noon = seconds(2016, 4, 15, 12)
    time = noon - 7200.0 + np.arange(0, 7200.0, 5.0)
    highest = time[np.argmax(sun_altitude_deg(time, 57.0, 15.0))]
    assert (noon - highest) / 3600.0 == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize(
    ("lat", "day", "low", "high"),
    [
        (0.0, (2016, 3, 20), 11.1, 11.4),  # twelve hours of night but twice the twilight
        (70.0, (2016, 6, 21), 0.0, 0.0),
        (57.0, (2016, 6, 21), 3.5, 5.5),
        (57.0, (2016, 12, 21), 15.0, 16.2),
        (80.0, (2016, 12, 21), 24.0, 24.0),
    ],
)
def test_nights_of_a_day(lat: float, day: tuple[int, ...], low: float, high: float) -> None:
    begin = datetime(*day, tzinfo=UTC)  # type: ignore[arg-type, misc]
    times = np.array([(begin + timedelta(minutes=6 * k)).timestamp() for k in range(241)])
    hours = night_hours(times, np.full(241, lat), np.full(241, 18.0))
    assert low - 0.01 <= hours <= high + 0.01


def test_twilight_is_no_night() -> None:
    time = seconds(2016, 11, 20, 12) + np.arange(0.0, 12 * 3600.0, 60.0)
    altitude = sun_altitude_deg(time, 57.0, 18.0)
    dusk = time[np.argmax(altitude < 0.0)], time[np.argmax(altitude < CIVIL_TWILIGHT_DEG)]
    assert 30 * 60 < dusk[1] - dusk[0] < 60 * 60
