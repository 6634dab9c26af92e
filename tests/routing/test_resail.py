"""Sailing again: the compiled stepping against a plain one with the wind and the polar themselves."""

from __future__ import annotations

import numpy as np
import pytest

from seacruise.geodesy import rhumb_course_deg, rhumb_distance_m, to_mercator
from seacruise.passage import PassageRequest, how_of, waters_of
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.routing.find import Question
from seacruise.routing.manoeuvres import Course
from seacruise.routing.resail import STEP_S, resail
from seacruise.settings import Settings
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import to_direction
from seacruise.yacht.fleet import find_yacht, load_fleet

LAT, LON = np.array([55.0, 56.0, 56.6, 57.4]), np.array([19.0, 18.6, 19.6, 19.8])


def test_plain_stepping_agrees(settings: Settings) -> None:
    wind = sample_wind()
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    ends = Port("A", "", LAT[0], LON[0]), Port("B", "", LAT[-1], LON[-1])
    request = PassageRequest(*ends, yacht, wind)
    sea, _ = waters_of(request, settings)
    begin = wind.forecast.valid_from.timestamp() + 6 * 3600
    how = how_of(request.options)
    asked = Question(sea, wind, yacht, how, (LAT[0], LON[0]), (LAT[-1], LON[-1]), begin)
    course = Course(*to_mercator(LAT, LON), np.zeros(3, dtype=bool))
    sailed = resail(asked, course, fuel_rate_l_h=0.0)

    t, arrivals = begin, []
    for k in range(3):
        leg = LAT[k], LON[k], LAT[k + 1], LON[k + 1]
        heading, length, done = float(rhumb_course_deg(*leg)), float(rhumb_distance_m(*leg)), 0.0

        def speed(when: float, share: float, leg: tuple[float, ...] = leg, heading: float = heading) -> float:
            here = leg[0] + (leg[2] - leg[0]) * share, leg[1] + (leg[3] - leg[1]) * share
            tws, twd = to_direction(*wind.at(when, *here))
            return float(yacht.speed(tws, twd - heading))

        while done < length - 1e-6:
            v = speed(t, done / length)
            half = min(STEP_S, (length - done) / v) / 2
            v = speed(t + half, (done + v * half) / length)
            spent = min(STEP_S, (length - done) / v)
            t, done = t + spent, done + v * spent
        arrivals.append(t)
    assert sailed.arrived
    assert sailed.time[sailed.at[1:]] - begin == pytest.approx(np.array(arrivals) - begin, rel=1e-3)
