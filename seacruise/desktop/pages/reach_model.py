"""Where to go: the ports that fit into the time there is, as rows to sort and filter; without Qt."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from enum import Enum
from typing import TYPE_CHECKING, Final, Protocol

import numpy as np

from seacruise.desktop.equal_time import TimeLine, open_lines
from seacruise.errors import InputError
from seacruise.geodesy import great_circle_m
from seacruise.model import Options
from seacruise.ports import Port
from seacruise.reach import PortReached, Reach, ReachRequest, farthest_nm, margin_deg
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.text import fold
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from seacruise.desktop.compute import Answer
    from seacruise.progress import Job
    from seacruise.routing.reach import Isochrone
    from seacruise.settings import Settings
    from seacruise.weather.wind import Wind
    from seacruise.yacht.polar import Polar

_TOLERANCE_DEG: Final = 0.003
_AT_SHORE_M: Final = 2500.0
"""The grid that lines are drawn on has a point every 1.3 nm of the plane; the last wet one is not farther."""


@dataclass(frozen=True, slots=True)
class Outset:
    """From where, when and how she sets out: what the form says but for the end.

    Attributes
    ----------
    forecast
        As on the command line, one name or several files.
    avoid
        Areas that the sailor marked on the chart.
    weights
        Of several forecasts in their mean; empty for equal ones.
    """

    start: Port
    departure: datetime | None
    yacht: Polar
    forecast: tuple[str, ...]
    options: Options
    avoid: tuple[Zone, ...] = ()
    weights: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Wish:
    """The time there is.

    Attributes
    ----------
    hours
        In all [h]: out, stay and back, or out alone.
    stay_h
        In the port [h]; not asked where she stays there.
    back
        There and back, not one way.
    """

    outset: Outset
    hours: float
    stay_h: float = 0.0
    back: bool = True


class Explorer(Protocol):
    """`seacruise.reach.reach`, or what a test puts in its place."""

    def __call__(
        self, request: ReachRequest, *, ports: Sequence[Port], settings: Settings, job: Job
    ) -> Reach:
        """Find the ports."""
        ...


Clearance = Callable[["NDArray[np.float64]", "NDArray[np.float64]"], "NDArray[np.float64]"]
Fetcher = Callable[["Outset", float, Sequence[Port], "Settings", "Job"], "Wind"]


def explore_ports(request: ReachRequest, *, ports: Sequence[Port], settings: Settings, job: Job) -> Reach:
    """`seacruise.reach.reach`."""
    from seacruise.reach import reach

    return reach(request, ports=ports, settings=settings, job=job)


def fetch_for_outset(
    outset: Outset, hours: float, ports: Sequence[Port], settings: Settings, job: Job
) -> Wind:
    """`seacruise.reach.fetch_wind_around` as the form asks it."""
    from seacruise.reach import fetch_wind_around

    return fetch_wind_around(
        outset.start,
        outset.yacht,
        options=outset.options,
        hours=hours,
        ports=ports,
        names=outset.forecast,
        departure=outset.departure,
        settings=settings,
        job=job,
        weights=outset.weights or None,
    )


@dataclass(frozen=True, slots=True)
class Found:
    """The ports, and the lines of equal time for the chart."""

    wish: Wish
    reach: Reach
    rows: tuple[Row, ...]
    lines: tuple[TimeLine, ...]


def find_ports(
    wish: Wish,
    *,
    ports: Sequence[Port],
    settings: Settings,
    job: Job,
    known: Answer | None = None,
    fetcher: Fetcher = fetch_for_outset,
    explorer: Explorer = explore_ports,
) -> Found:
    """Find the ports in reach.

    Parameters
    ----------
    known
        An answer whose wind is used when it is of the same forecast and reaches every port she may reach.

    Raises
    ------
    SeaCruiseError
        Why there is no answer; `CancelledError` when the job was cancelled.
    """
    from seacruise.sea.zones import layer_files, load_zones

    outset = wish.outset
    if wish.back and wish.stay_h >= wish.hours:
        raise InputError(
            f"A stay of {wish.stay_h:g} h does not fit into {wish.hours:g} h; give less, or more time."
        )
    job.check()
    layers = NO_ZONES
    if known is not None and _same_wind(wish, known, ports):
        wind, layers = known.wind, known.layers
    else:
        job.report("wind", None, "Getting the wind")
        wind = fetcher(outset, wish.hours, ports, settings, job)
        layers = load_zones(layer_files(settings.layers))
    job.check()
    request = ReachRequest(
        outset.start,
        outset.yacht,
        wind,
        wish.hours,
        outset.departure,
        stay_h=wish.stay_h if wish.back else 0.0,
        options=outset.options,
        zones=Zones((*layers.zones, *outset.avoid)),
    )
    reached = explorer(request, ports=ports, settings=settings, job=job)
    job.check()
    job.report("search", None, "Drawing lines of equal time")
    lines = lines_of(reached.isochrones, clearance_m=_clearance(wish, ports, settings))
    return Found(wish, reached, rows_of(reached, back=wish.back), tuple(lines))


def _clearance(wish: Wish, ports: Sequence[Port], settings: Settings) -> Clearance:
    """Distance from the shore in the sea around a start, which has just been searched."""

    def clearance_m(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> NDArray[np.float64]:
        from seacruise.sea import Sea

        start = wish.outset.start
        most = farthest_nm(wish.outset.yacht, wish.outset.options, wish.hours)
        margin = 1.0 + margin_deg(start, ports, most)
        sea = Sea.around((start.lat,), (start.lon,), margin_deg=margin, cache_dir=settings.cache_dir)
        return sea.clearance_m(lat, lon)

    return clearance_m


def _same_wind(wish: Wish, known: Answer, ports: Sequence[Port]) -> bool:
    outset = wish.outset
    if (outset.forecast, outset.weights) != (known.question.forecast, known.question.weights):
        return False
    most = farthest_nm(outset.yacht, outset.options, wish.hours) * METRES_PER_NM
    lat, lon = np.array([p.lat for p in ports]), np.array([p.lon for p in ports])
    near = great_circle_m(outset.start.lat, outset.start.lon, lat, lon) <= most
    return bool(known.wind.covers(lat[near], lon[near]).all())


# ---------------------------------------------------------------------------------------------- rows


class Fit(Enum):
    """Whether a port fits into the time there is, the best first."""

    FITS = 0
    TOO_LONG = 1
    OUT_ONLY = 2


@dataclass(frozen=True, slots=True)
class Row:
    """A port in reach.

    Attributes
    ----------
    spare_h
        Time left over [h]; how much there is too little, negative, when it does not fit; ``None`` when she
        cannot even sail back.
    """

    found: PortReached
    fit: Fit
    spare_h: float | None

    @property
    def port(self) -> Port:
        """The port."""
        return self.found.port


def rows_of(reached: Reach, *, back: bool) -> tuple[Row, ...]:
    """Say of each port how it fits, those reached first before the others."""
    return tuple(_row(port, reached, back=back) for port in reached.ports)


def _row(found: PortReached, reached: Reach, *, back: bool) -> Row:
    if not back:
        return Row(found, Fit.FITS, reached.hours - found.out_h)
    if found.back_h is None:
        return Row(found, Fit.OUT_ONLY, None)
    spare = reached.hours - found.out_h - reached.stay_h - found.back_h
    return Row(found, Fit.FITS if found.return_fits else Fit.TOO_LONG, spare)


def matches(row: Row, text: str, *, only_fitting: bool) -> bool:
    """Whether a row is to be shown: it fits, and its name or country begins a word like the text."""
    if only_fitting and row.fit is not Fit.FITS:
        return False
    wanted = fold(text)
    return not wanted or f" {wanted}" in f" {fold(row.port.name)} {row.port.country.casefold()}"


def home_by(reached: Reach) -> datetime:
    """End of the time there is."""
    return reached.departure + timedelta(hours=reached.hours)


# --------------------------------------------------------------------------------------------- lines


def lines_of(areas: Sequence[Isochrone], *, clearance_m: Clearance) -> list[TimeLine]:
    """Lines of equal time for the chart, without the shores.

    Parameters
    ----------
    clearance_m
        Distance from the shore [m] of positions [degrees], by which the shores of the outermost area are
        known: those of the others are shared with the next larger one.
    """
    from seacruise.routing.reach import Isochrone

    rings = [ring for area in areas[-1:] for polygon in area.polygons for ring in polygon]
    if not rings:
        return []
    points = np.concatenate(rings)
    shore = points[clearance_m(points[:, 0], points[:, 1]) < _AT_SHORE_M]
    lines = open_lines([*areas, Isochrone(math.inf, ((shore,),))])
    return [TimeLine(line.hours, tuple(_thinned(piece) for piece in line.pieces)) for line in lines]


def _thinned(piece: NDArray[np.float64]) -> NDArray[np.float64]:
    """Leave out points that move a line by less than it is wide on the chart."""
    import shapely

    thin: NDArray[np.float64] = shapely.get_coordinates(shapely.LineString(piece).simplify(_TOLERANCE_DEG))
    return thin
