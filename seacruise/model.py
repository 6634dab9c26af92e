"""The words of a passage as types: what a sailor asks, and what is answered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.ports import Port
from seacruise.routing.stencil import COURSES, RECTANGULAR_COURSES
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import SECONDS_PER_HOUR
from seacruise.weather.beyond import BEYOND, Beyond

if TYPE_CHECKING:
    from seacruise.weather.wind import Current, Forecast, Wind
    from seacruise.yacht.polar import Polar

SCHEMA = "seacruise.passage/1"

Preset = Literal["precise", "classic"]
Tack = Literal["port", "starboard", "both"]


@dataclass(frozen=True, slots=True)
class Options:
    """How to search; the defaults are the ``precise`` preset.

    Attributes
    ----------
    directions
        Courses of the first search (12, 24, 36, 60, 72, 108 or 132); ``None`` lets the preset choose.
    spacing_nm
        Distance of neighbouring lattice vertices [nm]; ``None`` lets the preset choose.
    area
        ``"ellipse"`` (provably large enough) or ``"rectangle"`` (R1: half a degree to each side).
    refine
        Search again in a corridor with more courses and finer spacing, then relax the waypoints.
    corridor
        Without it the waypoints of the first search are relaxed at once: half the time, and a passage that
        is mostly within 0.1 % of the refined one, among islands 0.7 %; for what is dragged.
    tacking
        Let the yacht make good the convex hull of her polar: beats and runs become passages.
    percent_of_polar
        Share of the polar's speed that this crew reaches [%].
    motor_below_kn, motor_speed_kn
        Start the engine when she would sail slower than this [kn], and the speed it gives [kn].
    fuel_rate_l_h
        Consumption under engine [l/h].
    max_wind_kn, max_gust_kn, max_wave_m
        Never sail an edge on which the true wind exceeds this [kn], nor, where the forecast has them, its
        gusts [kn] or the significant height of its waves [m].
    shore_clearance_nm
        Keep this far off every shore [nm], but on the way out of and into the ports.
    tack_penalty_min, gybe_penalty_min
        What a tack and a gybe cost [min]; boards are then searched, not put in afterwards.
    turn_penalty
        R3's penalty: minutes for each 10 degrees by which the course changes.
    board_h
        In open water she goes about this often on a beat or run [h]; ``None`` for every hour and a half.
    most_turns
        Tacks and gybes the crew wants to make at the most; boards get longer where the water allows it.
    may_wait_h
        She may leave up to this much later [h] where that brings her there earlier or at all.
    percent_at_night
        Share of her speed that the crew keeps in the dark [%].
    sea_state_percent
        What each metre of waves above half a metre takes off her speed head to sea [%], less on other
        courses and nothing from astern; see `seacruise.yacht.knobs`.
    lattice
        ``"rectangular"`` has 8, 16 or 32 courses (R2, R3); reach knows the triangular one only.
    safety_radius_nm, safety_levels
        Within this distance of shores and zones [nm] the lattice is refined ``2 ** safety_levels`` times
        (R3).
    beyond
        After the end of the forecast ``"hold"`` the last wind (R1), ``"fade"`` it to the usual, or
        ``"refuse"`` to sail on; see `seacruise.weather.beyond`.
    currents
        Reckon with the current, where there is one.
    """

    preset: Preset = "precise"
    directions: int | None = None
    spacing_nm: float | None = None
    area: Literal["ellipse", "rectangle"] | None = None
    refine: bool = True
    corridor: bool = True
    tacking: bool = True
    percent_of_polar: float = 100.0
    motor_below_kn: float | None = None
    motor_speed_kn: float = 5.0
    fuel_rate_l_h: float = 2.5
    max_wind_kn: float | None = None
    max_gust_kn: float | None = None
    max_wave_m: float | None = None
    shore_clearance_nm: float | None = None
    tack_penalty_min: float = 0.0
    gybe_penalty_min: float = 0.0
    turn_penalty: float = 0.0
    board_h: float | None = None
    most_turns: int | None = None
    may_wait_h: float = 0.0
    percent_at_night: float = 100.0
    sea_state_percent: float = 0.0
    lattice: Literal["triangular", "rectangular"] = "triangular"
    safety_radius_nm: float | None = None
    safety_levels: int = 0
    beyond: Beyond = "hold"
    currents: bool = True

    @property
    def turning_costs(self) -> bool:
        """Whether any manoeuvre costs time."""
        return self.tack_penalty_min + self.gybe_penalty_min + self.turn_penalty > 0.0


def check_options(options: Options) -> None:
    """Refuse options that make no sense."""

    def within(value: float | None, low: float, high: float, what: str) -> None:
        if value is not None and not low <= value <= high:
            raise InputError(f"{what} of {value:g} is out of range; give {low:g} to {high:g}.")

    if options.beyond not in BEYOND:
        raise InputError(f"After the forecast one can {', '.join(BEYOND)}, not {options.beyond!r}.")
    within(options.percent_of_polar, 10.0, 200.0, "A percentage of the polar")
    within(options.spacing_nm, 0.05, 100.0, "A spacing [nm]")
    within(options.max_wind_kn, 1.0, 200.0, "A wind limit [kn]")
    within(options.max_gust_kn, 1.0, 200.0, "A limit of gusts [kn]")
    within(options.max_wave_m, 0.1, 30.0, "A limit of the wave height [m]")
    within(options.shore_clearance_nm, 0.1, 15.0, "A distance from the shore [nm]")
    within(options.tack_penalty_min, 0.0, 120.0, "The cost of a tack [min]")
    within(options.gybe_penalty_min, 0.0, 120.0, "The cost of a gybe [min]")
    within(options.turn_penalty, 0.0, 60.0, "A penalty for turning [min for 10 degrees]")
    within(options.board_h, 0.1, 24.0, "A length of boards [h]")
    within(options.most_turns, 0, 1000, "A number of tacks and gybes")
    within(options.may_wait_h, 0.0, 240.0, "A time to wait [h]")
    within(options.motor_below_kn, 0.0, 50.0, "A boat speed [kn] to start the engine below")
    within(options.motor_speed_kn, 0.1, 50.0, "A speed under engine [kn]")
    within(options.fuel_rate_l_h, 0.0, 1000.0, "A fuel rate [l/h]")
    within(options.percent_at_night, 10.0, 100.0, "A percentage of the speed at night")
    within(options.sea_state_percent, 0.0, 50.0, "A loss of speed for each metre of waves [%]")
    within(options.safety_radius_nm, 0.1, 15.0, "A radius of safety zones [nm]")
    within(options.safety_levels, 0, 6, "A number of safety levels")
    if (options.safety_radius_nm is None) != (options.safety_levels == 0):
        raise InputError("Safety zones need both, a radius and a number of levels from 1 to 6.")
    known = COURSES[1:] if options.lattice == "triangular" else RECTANGULAR_COURSES
    if options.directions is not None and options.directions not in known:
        choice = ", ".join(map(str, known))
        raise InputError(
            f"A {options.lattice} lattice cannot have {options.directions} directions; choose {choice}."
        )
    if options.preset == "classic" and options.directions not in {None, 12}:
        raise InputError("The classic preset has 12 directions; choose --preset precise for more.")
    if options.preset == "classic" and (options.turning_costs or options.most_turns is not None):
        raise InputError("The classic preset knows no cost of manoeuvres; choose --preset precise for them.")
    if options.preset == "classic" and (options.lattice != "triangular" or options.safety_levels):
        raise InputError(
            "The classic preset has its own lattice; choose --preset precise for another or for safety zones."
        )


@dataclass(frozen=True, slots=True)
class PassageRequest:
    """What a sailor asks.

    Attributes
    ----------
    departure
        Timezone-aware; ``None`` means the next full hour that the forecast covers.
    zones
        Areas to keep out of, see `seacruise.sea.zones`.
    current
        How the water moves; ``None`` for the current that came with the wind, if there is one.
    near
        A passage that answered nearly the same question. Where ``options.corridor`` is left out, its line is
        pulled straight in this one's wind, in place of a search in the corridor.
    """

    start: Port
    end: Port
    yacht: Polar
    wind: Wind
    departure: datetime | None = None
    options: Options = field(default_factory=Options)
    zones: Zones = NO_ZONES
    current: Current | None = None
    near: Passage | None = None

    @property
    def stream(self) -> Current | None:
        """The current that is reckoned with."""
        return (self.current or self.wind.current) if self.options.currents else None


@dataclass(frozen=True, slots=True)
class Place:
    """An end of a passage: the port that was asked for and the water from which one can sail.

    Attributes
    ----------
    lat, lon
        The snapped position [degrees], on water connected with the open sea.
    snapped_nm
        How far that is from the port's own position [nm].
    """

    name: str
    lat: float
    lon: float
    port_lat: float
    port_lon: float
    snapped_nm: float


@dataclass(frozen=True, slots=True)
class Waypoint:
    """A point of the passage, and the leg that begins there (``None`` throughout at the end).

    Attributes
    ----------
    time
        Timezone-aware UTC.
    course_deg
        Course made good over ground, degrees true.
    boat_speed_kn, sog_kn
        Mean speed of the leg through the water and over ground [kn].
    steer_deg
        Course to steer at the begin of the leg, degrees true: the course made good but for the current.
    sail
        The sail to set at the begin of the leg, of a polar that knows several; else ``None``.
    current_kn, current_to_deg
        Current at the begin of the leg and where it sets to; ``None`` where none was given.
    twa_deg
        True wind angle at the begin of the leg, folded to 0-180; ``tack`` names the side.
    tack
        ``"port"`` or ``"starboard"``: the side the wind comes from; ``"both"`` on a beat or run in water too
        narrow to plan the boards, of which the course made good is told; ``None`` under engine.
    """

    lat: float
    lon: float
    time: datetime
    course_deg: float | None = None
    leg_nm: float | None = None
    boat_speed_kn: float | None = None
    tws_kn: float | None = None
    twd_deg: float | None = None
    twa_deg: float | None = None
    motor: bool | None = None
    tack: Tack | None = None
    sog_kn: float | None = None
    steer_deg: float | None = None
    sail: str | None = None
    current_kn: float | None = None
    current_to_deg: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """The passage as it was re-sailed, a sample every six minutes and at each waypoint; shapes ``(n,)``.

    Attributes
    ----------
    time
        Seconds since 1970-01-01T00:00Z.
    leg
        Index of the waypoint at which the present leg began.
    """

    time: NDArray[np.float64]
    lat: NDArray[np.float64]
    lon: NDArray[np.float64]
    course_deg: NDArray[np.float64]
    boat_speed_kn: NDArray[np.float64]
    tws_kn: NDArray[np.float64]
    twd_deg: NDArray[np.float64]
    twa_deg: NDArray[np.float64]
    motor: NDArray[np.bool_]
    leg: NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Checks:
    """What the finished passage was held against; see `seacruise.routing.resail`."""

    resailed_h: float
    land_free: bool
    zones_free: bool
    within_limits: bool


@dataclass(frozen=True, slots=True)
class SearchReport:
    """How the passage was found: size of the search and seconds per stage."""

    directions: int
    spacing_nm: float
    vertices: int
    edges: int
    settled: int
    seconds: dict[str, float]


@dataclass(frozen=True, slots=True)
class Passage:
    """The answer: a passage that was sailed again, leg by leg, before anyone is shown it.

    Times are UTC. ``notices`` are sentences a sailor must read with it (snapped ports, held wind,
    practice weather); ``manoeuvre_h`` is the part of the duration that turning took; ``beyond`` is what was
    made of the wind after the forecast, where ``beyond_forecast_h`` were sailed; ``lower_bound_h`` is 0 where
    none was reckoned; ``lattice_edges`` gives the edges searched first, ``(n, 4)`` as lat1, lon1, lat2, lon2,
    for drawing; ``line`` holds the positions ``(m, 2)`` [degrees] between which boards were laid out.
    """

    start: Place
    end: Place
    yacht: str
    departure: datetime
    arrival: datetime
    distance_nm: float
    direct_distance_nm: float
    waypoints: tuple[Waypoint, ...]
    tacks: int
    gybes: int
    course_changes: int
    max_tws_kn: float
    motor_h: float
    fuel_l: float
    beyond_forecast_h: float
    forecast: Forecast
    lower_bound_h: float
    checks: Checks
    search: SearchReport
    track: Track
    notices: tuple[str, ...] = ()
    manoeuvre_h: float = 0.0
    beyond: Beyond = "hold"
    lattice_edges: Callable[[], NDArray[np.float32]] | None = field(default=None, repr=False, compare=False)
    line: NDArray[np.float64] | None = field(default=None, repr=False, compare=False)

    @property
    def duration_h(self) -> float:
        """Hours from departure to arrival."""
        return (self.arrival - self.departure).total_seconds() / SECONDS_PER_HOUR

    @property
    def mean_speed_kn(self) -> float:
        """Distance sailed by the hours it took [kn]."""
        return self.distance_nm / self.duration_h if self.duration_h > 0 else 0.0
