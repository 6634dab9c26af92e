"""Night, waves and engine on whole passages: what they take and give, against plain stepping."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.geodesy import rhumb_course_deg, rhumb_distance_m
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.sun import sun_altitude_deg
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.knobs import night_share, sea_state_share
from seacruise.yacht.polar import Polar
from tests.routing.worlds import DEPARTURE, HOUR, T0, sloop, wind_of

Plan = Callable[..., Passage]

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
YACHT = sloop()
STEP_S = 300.0


@pytest.fixture(scope="module")
def sailed(sea_settings: Settings) -> Plan:
    """Plan the 60 nm between south and north, each question only once."""

    @cache
    def find(
        wind: Wind,
        *,
        polar: Polar = YACHT,
        departure: datetime = DEPARTURE,
        back: bool = False,
        **options: Any,
    ) -> Passage:
        ends = (NORTH, SOUTH) if back else (SOUTH, NORTH)
        asked = PassageRequest(*ends, polar, wind, departure, Options(**options))
        return plan(asked, settings=sea_settings)

    return find


def rough_wind() -> Wind:
    """A south-westerly that veers and freshens over waves that grow with it."""
    time = T0 + np.arange(-6.0, 60.0, 3.0) * HOUR
    grown = np.linspace(0.0, 1.0, time.size)[:, None, None]
    wind = wind_of(time, [57.0], 6.0 + 3.0 * grown, 280.0 + 40.0 * grown)
    return replace(wind, wave=np.ascontiguousarray(0.8 + 2.0 * grown, dtype=np.float32))


ROUGH = rough_wind()


def hours_by_stepping(
    found: Passage, wind: Wind, share: Callable[[float, float, float, float], float]
) -> float:
    """Sail the waypoints with `Wind`, `Polar` and a share of her speed at (time, lat, lon, TWA); hours."""
    t = found.departure.timestamp()
    for a, b in zip(found.waypoints[:-1], found.waypoints[1:], strict=True):
        leg = a.lat, a.lon, b.lat, b.lon
        course, length, done = float(rhumb_course_deg(*leg)), float(rhumb_distance_m(*leg)), 0.0
        while done < length - 1e-6:

            def speed(when: float, f: float) -> float:
                lat, lon = leg[0] + (leg[2] - leg[0]) * f, leg[1] + (leg[3] - leg[1]) * f  # noqa: B023
                tws, twd = to_direction(*wind.at(when, lat, lon))
                twa = float(twd) - course  # noqa: B023
                return float(YACHT.speed(float(tws), twa)) * share(when, lat, lon, twa)

            begin = speed(t, done / length)
            half = min(STEP_S, (length - done) / begin) / 2.0
            middle = speed(t + half, min(1.0, (done + begin * half) / length))
            spent = min(STEP_S, (length - done) / middle)
            t, done = t + spent, done + middle * spent
    return (t - found.departure.timestamp()) / HOUR


def wave_at(wind: Wind, when: float) -> float:
    assert wind.wave is not None
    return float(np.interp(when, wind.time, wind.wave[:, 0, 0]))


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize(
    ("at_night", "per_metre"), [(0.7, 0.0), (1.0, 0.15), (0.8, 0.1)], ids=["night", "waves", "both"]
)
def test_night_and_waves_slow_a_passage_as_its_own_polar_slowed(
    at_night: float, per_metre: float, back: bool, sailed: Plan
) -> None:
    knobs = {"percent_at_night": 100 * at_night, "sea_state_percent": 100 * per_metre}
    # Into a night of November.
    found = sailed(ROUGH, back=back, departure=DEPARTURE + timedelta(hours=7), **knobs)

    def share(when: float, lat: float, lon: float, twa: float) -> float:
        dark = float(night_share(sun_altitude_deg(when, lat, lon), at_night=at_night))
        return dark * float(sea_state_share(wave_at(ROUGH, when), twa, per_metre=per_metre))

    assert found.duration_h == pytest.approx(hours_by_stepping(found, ROUGH, share), rel=1e-3)
    # The knobs are felt: by the whole share of a November night, by a few per cent of what waves take.
    assert hours_by_stepping(found, ROUGH, lambda *_: 1.0) < 0.99 * found.duration_h


@pytest.mark.parametrize("back", [False, True])
def test_night_and_waves_never_make_a_passage_faster(back: bool, sailed: Plan) -> None:
    hours = [
        sailed(ROUGH, back=back, percent_at_night=night, sea_state_percent=waves).duration_h
        for night, waves in ((100.0, 0.0), (90.0, 0.0), (70.0, 0.0), (70.0, 10.0), (70.0, 20.0))
    ]
    assert hours == sorted(hours)


TOLERATED = 1.0005
"""Waypoints are thinned for a share of the duration, and boards fall as they fall."""


@hypothesis_settings(max_examples=30, deadline=None)
@given(
    tws=st.floats(1.5, 9.0),
    direction=st.sampled_from([0.0, 20.0, 45.0, 90.0, 180.0, 200.0]),
    below_kn=st.floats(0.5, 7.0),
    speed_kn=st.floats(0.5, 7.0),
)
@example(tws=2.375, direction=90.0, below_kn=2.375, speed_kn=3.0)
def test_an_engine_never_makes_a_passage_slower(
    tws: float, direction: float, below_kn: float, speed_kn: float, sailed: Plan
) -> None:
    wind = wind_of([T0 - HOUR, T0 + 240 * HOUR], [57.0], tws, direction)
    without = sailed(wind)
    motored = sailed(wind, motor_below_kn=below_kn, motor_speed_kn=speed_kn)
    assert motored.duration_h <= without.duration_h * TOLERATED


@pytest.mark.parametrize(("below_kn", "speed_kn"), [(2.0, 5.0), (4.0, 3.0), (5.0, 5.5), (8.0, 4.5)])
@pytest.mark.parametrize("ends", [("Visby", "Ventspils"), ("Klaipeda", "Visby"), ("Ronne", "Karlskrona")])
def test_an_engine_never_makes_a_passage_of_the_sample_slower(
    ends: tuple[str, str], below_kn: float, speed_kn: float, sea_settings: Settings
) -> None:
    ports, wind = load_ports(), sample_wind()
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    start, end = (find_port(name, ports) for name in ends)
    request = PassageRequest(start, end, yacht, wind, wind.forecast.valid_from + timedelta(hours=30))
    motor = Options(motor_below_kn=below_kn, motor_speed_kn=speed_kn)
    without = plan(request, settings=sea_settings)
    motored = plan(replace(request, options=motor), settings=sea_settings)
    assert motored.duration_h <= without.duration_h * TOLERATED
