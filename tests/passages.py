"""A passage made by hand, for rooms that show passages: consistent to the last digit, found by nobody.

Courses, distances, times and wind angles are computed from the waypoints, so that a test may check one
against the other.
"""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import (
    angle_between_deg,
    destination,
    great_circle_m,
    rhumb_course_deg,
    rhumb_distance_m,
)
from seacruise.passage import Checks, Passage, Place, SearchReport, Track, Waypoint
from seacruise.units import METRES_PER_NM, MS_PER_KNOT
from seacruise.weather.wind import Forecast, Wind, from_direction, to_direction

DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)
SAMPLE_SECONDS = 360.0

# latitude, longitude, boat speed on the leg that begins there [kn], under engine
COURSE_LINE = (
    (54.5280, 18.5700, 5.8, False),
    (54.6500, 18.8900, 7.4, False),
    (55.6000, 18.2000, 8.1, False),
    (56.5000, 17.4500, 7.9, False),
    (57.4000, 17.5500, 7.6, False),
    (58.3000, 17.9500, 6.9, False),
    (58.9000, 18.7500, 5.0, True),
    (59.2850, 18.9400, None, None),
)


def steady_forecast() -> Forecast:
    return Forecast(
        source="Test wind, veering slowly",
        issued=datetime(2016, 11, 20, 0, tzinfo=UTC),
        valid_from=datetime(2016, 11, 20, 0, tzinfo=UTC),
        valid_to=datetime(2016, 11, 22, 0, tzinfo=UTC),
        step_h=6.0,
        resolution_deg=1.0,
        notice="Test wind: not a forecast.",
        real=False,
    )


def veering_wind() -> Wind:
    """Wind over the Baltic that veers from SSW to WNW in two days and freshens to the west."""
    begin = datetime(2016, 11, 20, tzinfo=UTC).timestamp()
    time = begin + np.arange(0.0, 49 * 3600, 6 * 3600)
    lat, lon = np.arange(52.0, 68.0), np.arange(7.0, 33.0)
    hours = (time - begin)[:, None, None] / 3600.0
    direction = 200.0 + 2.0 * hours + 0.0 * (lat[:, None] + lon)
    speed = 7.0 + 0.12 * (24.0 - lon) * (1.0 + hours / 48.0) + 0.0 * lat[:, None]
    u, v = from_direction(speed, direction)
    return Wind(time, lat, lon, u.astype(np.float32), v.astype(np.float32), steady_forecast())


def _wind_at(
    wind: Wind, time: NDArray[np.float64], lat: NDArray[np.float64], lon: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    speed, direction = to_direction(*wind.at(time, lat, lon))
    return speed / MS_PER_KNOT, direction


def _waypoints(wind: Wind) -> tuple[Waypoint, ...]:
    points: list[Waypoint] = []
    time = DEPARTURE
    for here, there in pairwise(COURSE_LINE):
        lat, lon, speed_kn, motor = here
        assert speed_kn is not None
        course = float(rhumb_course_deg(lat, lon, there[0], there[1]))
        leg_nm = float(rhumb_distance_m(lat, lon, there[0], there[1])) / METRES_PER_NM
        moment = np.array([time.timestamp()])
        tws, twd = (float(a[0]) for a in _wind_at(wind, moment, np.array([lat]), np.array([lon])))
        starboard = (twd - course) % 360.0 < 180.0
        points.append(
            Waypoint(
                lat=lat,
                lon=lon,
                time=time,
                course_deg=course,
                leg_nm=leg_nm,
                boat_speed_kn=speed_kn,
                tws_kn=tws,
                twd_deg=twd,
                twa_deg=float(angle_between_deg(twd, course)),
                motor=motor,
                tack=None if motor else "starboard" if starboard else "port",
            )
        )
        time += timedelta(hours=leg_nm / speed_kn)
    last = COURSE_LINE[-1]
    return (*points, Waypoint(lat=last[0], lon=last[1], time=time))


def _track(waypoints: tuple[Waypoint, ...], wind: Wind) -> Track:
    columns: list[NDArray[np.float64]] = []
    for number, (here, there) in enumerate(pairwise(waypoints)):
        begin, end = here.time.timestamp(), there.time.timestamp()
        time = np.append(np.arange(begin, end - 1.0, SAMPLE_SECONDS), end if there is waypoints[-1] else [])
        assert here.boat_speed_kn is not None
        assert here.course_deg is not None
        sailed = (time - begin) * here.boat_speed_kn * MS_PER_KNOT
        lat, lon = destination(here.lat, here.lon, here.course_deg, sailed)
        tws, twd = _wind_at(wind, time, lat, lon)
        full = np.ones_like(time)
        twa = angle_between_deg(twd, here.course_deg)
        columns.append(
            np.stack(
                [
                    *(time, lat, lon, full * here.course_deg, full * here.boat_speed_kn),
                    *(tws, twd, twa, full * bool(here.motor), full * number),
                ]
            )
        )
    time, lat, lon, course, speed, tws, twd, twa, motor, leg = np.concatenate(columns, axis=1)
    return Track(time, lat, lon, course, speed, tws, twd, twa, motor.astype(np.bool_), leg.astype(np.int64))


def moved_east(passage: Passage, degrees: float) -> Passage:
    """Sail the same farther east, on beyond 180 degrees where that lies in between."""
    waypoints = tuple(replace(w, lon=w.lon + degrees) for w in passage.waypoints)
    track = replace(passage.track, lon=passage.track.lon + degrees)
    return replace(passage, waypoints=waypoints, track=track)


def hand_made_passage() -> Passage:
    """Gdynia to Sandhamn in about 40 hours, the last leg under engine."""
    wind = veering_wind()
    waypoints = _waypoints(wind)
    track = _track(waypoints, wind)
    first, last = waypoints[0], waypoints[-1]
    distance_nm = sum(w.leg_nm or 0.0 for w in waypoints)
    direct_nm = float(great_circle_m(first.lat, first.lon, last.lat, last.lon)) / METRES_PER_NM
    duration_h = (last.time - first.time).total_seconds() / 3600.0
    motor_h = (last.time - waypoints[-2].time).total_seconds() / 3600.0
    return Passage(
        start=Place("Gdynia", first.lat, first.lon, 54.5189, 18.5531, 0.81),
        end=Place("Sandhamn", last.lat, last.lon, 59.2875, 18.9106, 0.92),
        yacht="Bavaria 46 Cruiser",
        departure=first.time,
        arrival=last.time,
        distance_nm=distance_nm,
        direct_distance_nm=direct_nm,
        waypoints=waypoints,
        tacks=1,
        gybes=2,
        course_changes=6,
        max_tws_kn=float(track.tws_kn.max()),
        motor_h=motor_h,
        fuel_l=2.5 * motor_h,
        beyond_forecast_h=max(0.0, duration_h + 6.0 - 48.0),
        forecast=wind.forecast,
        lower_bound_h=0.97 * duration_h,
        checks=Checks(resailed_h=duration_h, land_free=True, zones_free=True, within_limits=True),
        search=SearchReport(
            directions=12,
            spacing_nm=5.0,
            vertices=2_345,
            edges=27_801,
            settled=1_987,
            seconds={"sea": 0.2, "lattice": 0.01, "wind": 0.05, "search": 0.02, "refine": 0.3, "check": 0.1},
        ),
        track=track,
        notices=("Gdynia lies 0.8 nm from open water; the passage begins there.", wind.forecast.notice),
    )
