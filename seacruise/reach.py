"""Which ports she reaches in the time there is, and comes back from.

``ReachRequest -> Sea -> Lattice -> Wind -> search, forwards and backwards -> Reach``
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from seacruise.along import Position, distinct, sail_along
from seacruise.errors import InputError, NoPassageError
from seacruise.geodesy import great_circle_m
from seacruise.model import Options, PassageRequest, Place, check_options
from seacruise.passage import (
    NOBODY,
    SAME_PLACE_NM,
    check_cover,
    departure_of,
    how_of,
    place_of,
)
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR
from seacruise.ways import cut_off, sail_alone, ways_out

if TYPE_CHECKING:
    from pathlib import Path

    from seacruise.routing.reach import Explored, Isochrone, Outing
    from seacruise.sea import Sea
    from seacruise.weather.wind import Forecast, Wind
    from seacruise.yacht.polar import Polar

__all__ = ["LONGEST_H", "SCHEMA", "PortReached", "Reach", "ReachRequest", "reach"]

SCHEMA: Final = "seacruise.reach/1"

LONGEST_H: Final = 14 * 24.0
"""More time than this is not asked for [h]: no wind is known so far ahead."""

FAR_NM: Final = 2.0
"""A port farther than this from its water is named [nm]."""

_STEPS_H: Final = (0.25, 0.5, 1, 2, 3, 6, 12, 24, 48)
_MOST_LINES: Final = 8


@dataclass(frozen=True, slots=True)
class ReachRequest:
    """What a sailor asks: the ports that fit into the days there are.

    Attributes
    ----------
    hours
        Time that there is in all [h].
    departure
        Timezone-aware; ``None`` means the next full hour that the forecast covers.
    stay_h
        Time in a port before sailing back [h].
    options
        How she is sailed; of how it is searched, ``directions`` and ``spacing_nm`` count.
    zones
        Areas to keep out of.
    check
        Sail every way out again, as finished passages are; takes about as long as the search.
    """

    start: Port
    yacht: Polar
    wind: Wind
    hours: float
    departure: datetime | None = None
    stay_h: float = 0.0
    options: Options = field(default_factory=Options)
    zones: Zones = NO_ZONES
    check: bool = False


@dataclass(frozen=True, slots=True)
class PortReached:
    """A port that is reached in time.

    Attributes
    ----------
    lat, lon
        Water of the port [degrees], where the way ends.
    snapped_nm
        How far that is from the port's own position [nm].
    distance_nm
        Length of the way there, without tacks [nm].
    out_h, back_h
        Duration of the way there, and of the way back when she leaves after her stay [h]. The latter is
        ``None`` when she does not come back at all, and where it was not looked for: neither is she back in
        time, nor did she arrive within half of it.
    leave_by
        Latest departure that is back in time; ``None`` when there is none after the arrival.
    return_fits
        Whether out, stay and back fit into the time there is.
    beyond_forecast_h
        Hours of out and back that are sailed on wind held beyond the forecast.
    resailed_h
        Duration of the way there when it is sailed again step by step [h]; ``None`` where that was not
        asked, or where she does not arrive like that.
    land_free
        Whether that way is clear of land; ``None`` where it was not sailed again.
    """

    port: Port
    lat: float
    lon: float
    snapped_nm: float
    distance_nm: float
    out_h: float
    arrival: datetime
    back_h: float | None
    leave_by: datetime | None
    return_fits: bool
    beyond_forecast_h: float
    resailed_h: float | None = None
    land_free: bool | None = None


@dataclass(frozen=True, slots=True)
class Reach:
    """All ports that are reached, nearest in time first, and the water that is.

    Attributes
    ----------
    unreachable
        How many ports of the list are not reached in time, or not by water.
    isochrones
        The water reached within some times, least first.
    notices
        Sentences that a sailor must read with it.
    """

    start: Place
    departure: datetime
    hours: float
    stay_h: float
    yacht: str
    forecast: Forecast
    ports: tuple[PortReached, ...]
    unreachable: int
    isochrones: tuple[Isochrone, ...] = field(default=(), repr=False, compare=False)
    notices: tuple[str, ...] = ()


def reach(request: ReachRequest, *, ports: Sequence[Port], settings: Settings, job: Job = NOBODY) -> Reach:
    """Find every port that can be reached, the time there and the time back.

    The times are those of the lattice, in the wind of their hour; `plan` finds a passage that is a little
    faster, and sails it again.

    Raises
    ------
    InputError
        A number or an option makes no sense.
    NoPassageError
        The forecast does not cover the start or the departure, or there is no water.
    CancelledError
        The job was cancelled.
    """
    from seacruise.routing import reach as routing
    from seacruise.weather.beyond import extend

    _check(request)
    request = replace(request, wind=extend(request.wind, request.options.beyond))
    departure = departure_of(request.wind, request.departure)
    check_cover(request.wind, request.start)
    job.report("sea", None, "Reading the sea")
    sea = _sea_around(request, ports, settings)
    start = place_of(request.start, sea.snap(request.start.lat, request.start.lon, name=request.start.name))
    asked = _outing(request, sea, start, departure)
    near = _within(asked, request.wind, start, ports)
    waters = [(place.lat, place.lon) for _, place in near]
    explored = routing.explore(asked, waters, job)
    ways = ways_out(explored, waters)
    for k in cut_off(explored, waters):
        job.report("search", None, f"Searching the approach of {near[k][0].name}")
        ways[k] = sail_alone(_passage(request, near[k][0]), asked, explored, (k, waters[k]), job)
    job.report("search", None, "Drawing lines of equal time")
    lines = routing.isochrones(
        explored.lattice,
        sea,
        explored.out.arrival,
        departure=asked.departure,
        hours=_hours_drawn(request.hours),
    )
    found = [
        _port_reached(request, asked, explored, k, near[k])
        for k in np.argsort(explored.arrival, kind="stable").tolist()
        if np.isfinite(explored.arrival[k])
    ]
    if request.check:
        way_of = {near[k][0]: way for k, way in ways.items()}
        found = [_checked(request, asked, port, way_of[port.port], job) for port in found]
    others = sum(port.name != request.start.name for port in ports)
    return Reach(
        start,
        departure,
        request.hours,
        request.stay_h,
        request.yacht.name,
        request.wind.forecast,
        tuple(found),
        others - len(found),
        tuple(lines),
        _notices(request, start, found),
    )


def _check(request: ReachRequest) -> None:
    check_options(request.options)
    if not 0.0 < request.hours <= LONGEST_H:
        raise InputError(
            f"{request.hours:g} hours cannot be looked at; give more than 0 and at most {LONGEST_H:g}."
        )
    if not 0.0 <= request.stay_h < request.hours:
        raise InputError(
            f"A stay of {request.stay_h:g} h does not fit into {request.hours:g} h; give less, or more time."
        )


def farthest_nm(yacht: Polar, options: Options, hours: float) -> float:
    """Distance that a yacht cannot exceed in any wind [nm]."""
    from seacruise.routing.field import speed_table

    fastest = float(speed_table(yacht, how_of(options).handling).top[-1])
    return fastest * hours * SECONDS_PER_HOUR / METRES_PER_NM


def _sea_around(request: ReachRequest, ports: Sequence[Port], settings: Settings) -> Sea:
    """Read the sea around the start, as far as the ports she may reach lie."""
    from seacruise.sea import Sea

    start = request.start
    most = farthest_nm(request.yacht, request.options, request.hours)
    margin = 1.0 + margin_deg(start, ports, most)
    return Sea.around((start.lat,), (start.lon,), margin_deg=margin, cache_dir=settings.cache_dir)


def margin_deg(start: Port, ports: Sequence[Port], within_nm: float) -> float:
    """Degrees of latitude from a start to the farthest of the ports that lie within a distance."""
    away = [float(great_circle_m(start.lat, start.lon, p.lat, p.lon)) / METRES_PER_NM for p in ports]
    return max((nm for nm in away if nm <= within_nm), default=0.0) / 60


def fetch_wind_around(
    start: Port,
    yacht: Polar,
    *,
    options: Options,
    hours: float,
    ports: Sequence[Port],
    names: Sequence[str],
    departure: datetime | None,
    settings: Settings,
    job: Job,
    weights: Sequence[float] | None = None,
    current: Path | None = None,
) -> Wind:
    """Get the wind around a start, as far as the ports lie that she may reach within some hours.

    See `seacruise.weather.source.fetch_wind`.
    """
    from seacruise.sea import Sea
    from seacruise.weather.source import SERVICE_MARGIN_DEG, fetch_wind

    margin = SERVICE_MARGIN_DEG + margin_deg(start, ports, farthest_nm(yacht, options, hours))

    def is_water(lat: Any, lon: Any) -> Any:
        sea = Sea.around((start.lat,), (start.lon,), margin_deg=margin, cache_dir=settings.cache_dir)
        return sea.is_water(lat, lon)

    here = (start.lat, start.lon)
    return fetch_wind(
        names,
        start=here,
        end=here,
        departure=departure,
        settings=settings,
        job=job,
        is_water=is_water,
        margin_deg=margin,
        weights=weights,
        current=current,
    )


def _outing(request: ReachRequest, sea: Sea, start: Place, departure: datetime) -> Outing:
    from seacruise.routing.field import COARSE_SLICE_S, speed_table, wind_field
    from seacruise.routing.reach import Outing

    options = request.options
    handling = how_of(options).handling
    return Outing(
        sea,
        wind_field(
            request.wind,
            slice_s=COARSE_SLICE_S,
            since=departure.timestamp(),
            current=request.wind.current if options.currents else None,
            limits=handling.limits,
            knobs=handling.knobs,
        ),
        speed_table(request.yacht, handling),
        (start.lat, start.lon),
        departure.timestamp(),
        request.hours * SECONDS_PER_HOUR,
        stay=request.stay_h * SECONDS_PER_HOUR,
        directions=options.directions,
        spacing_nm=options.spacing_nm,
        zones=request.zones,
    )


def _within(asked: Outing, wind: Wind, start: Place, ports: Sequence[Port]) -> list[tuple[Port, Place]]:
    """Ports that may be reached, each with the water it is left from."""
    radius = asked.radius_m
    found = []
    for port in ports:
        away = float(great_circle_m(start.lat, start.lon, port.lat, port.lon))
        at_start = min(away, float(great_circle_m(start.port_lat, start.port_lon, port.lat, port.lon)))
        if at_start < SAME_PLACE_NM * METRES_PER_NM or not bool(wind.covers(port.lat, port.lon)):
            continue
        # A harbour up a river is farther away than its water.
        if away > radius + 40 * METRES_PER_NM:
            continue
        try:
            place = place_of(port, asked.sea.snap(port.lat, port.lon, name=port.name))
        except NoPassageError:
            continue
        if float(great_circle_m(start.lat, start.lon, place.lat, place.lon)) <= radius:
            found.append((port, place))
    return found


def _port_reached(
    request: ReachRequest, asked: Outing, explored: Explored, number: int, where: tuple[Port, Place]
) -> PortReached:
    port, place = where
    arrival, home = float(explored.arrival[number]), float(explored.home[number])
    leaves = arrival + asked.stay
    horizon = max(request.wind.forecast.valid_to.timestamp(), asked.departure)
    leave_by = float(explored.leave_by[number])
    held = max(0.0, arrival - horizon)
    if math.isfinite(home):
        held += max(0.0, home - max(leaves, horizon))
    return PortReached(
        port=port,
        lat=place.lat,
        lon=place.lon,
        snapped_nm=place.snapped_nm,
        distance_nm=float(explored.sailed_m[number]) / METRES_PER_NM,
        out_h=(arrival - asked.departure) / SECONDS_PER_HOUR,
        arrival=datetime.fromtimestamp(arrival, UTC),
        back_h=(home - leaves) / SECONDS_PER_HOUR if math.isfinite(home) else None,
        leave_by=datetime.fromtimestamp(leave_by, UTC) if leaves <= leave_by else None,
        return_fits=home <= asked.deadline,
        beyond_forecast_h=held / SECONDS_PER_HOUR,
    )


def _passage(request: ReachRequest, port: Port) -> PassageRequest:
    """Ask the passage to one of the ports."""
    return PassageRequest(
        request.start, port, request.yacht, request.wind, None, request.options, request.zones
    )


def _checked(
    request: ReachRequest, asked: Outing, found: PortReached, way: Sequence[Position], job: Job
) -> PortReached:
    """Sail the way to a port again."""
    job.check()
    job.report("check", None, "Sailing the ways out again")
    passage = _passage(request, found.port)
    sailed = sail_along(passage, distinct(way), departure=asked.departure, sea=asked.sea)
    hours = (float(sailed.time[-1]) - asked.departure) / SECONDS_PER_HOUR
    return replace(found, resailed_h=hours if sailed.arrived else None, land_free=sailed.land_free)


def _hours_drawn(hours: float) -> list[float]:
    """Choose the times for which a line is drawn: even hours, and the whole time."""
    step = next((s for s in _STEPS_H if hours / s <= _MOST_LINES), _STEPS_H[-1])
    return [k * step for k in range(1, math.ceil(hours / step - 1e-9))] + [hours]


def _notices(request: ReachRequest, start: Place, found: Sequence[PortReached]) -> tuple[str, ...]:
    notice = request.wind.forecast.notice
    said = [notice] if notice else []
    if start.snapped_nm > SAME_PLACE_NM:
        said.append(
            f"She sets out {start.snapped_nm:.1f} nm from {start.name}, at the nearest water of the chart "
            "that is connected with the open sea."
        )
    if request.zones:
        said.append(request.zones.told)
    if not found:
        said.append(
            "No port is reached: the time is too short, the wind too light, or stronger than is allowed."
        )
    inland = [port.port.name for port in found if port.snapped_nm > FAR_NM]
    if inland:
        said.append(
            f"More than {FAR_NM:g} nm from the water that is connected with the open sea, to which the time "
            f"counts: {', '.join(inland)}."
        )
    if request.check:
        said += check_notices(found)
    held = sum(port.beyond_forecast_h > 1 / 60 for port in found)
    if held:
        ways = "one port" if held == 1 else f"{held} ports"
        said.append(
            f"Ways to or from {ways} are sailed in part in the last known wind, held beyond the end of the "
            "forecast."
        )
    return tuple(said)


def check_notices(found: Sequence[PortReached]) -> list[str]:
    """Say what sailing the ways out again has shown."""
    longer = [(port.resailed_h / port.out_h - 1.0) * 100.0 for port in found if port.resailed_h]
    said = []
    if longer:
        said.append(
            f"{len(longer)} ways out were sailed again: their times are {min(longer):+.1f} to "
            f"{max(longer):+.1f} % off those told."
        )
    lost = [port.port.name for port in found if port.resailed_h is None]
    if lost:
        said.append(f"Sailed again she is becalmed on the way to {', '.join(lost)}.")
    ashore = [port.port.name for port in found if port.land_free is False]
    if ashore:
        said.append(f"Sailed again the way touches land on the way to {', '.join(ashore)}.")
    return said
