"""Studies and reaches that a test makes up, and holds back until it wants them."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from datetime import UTC, datetime, timedelta

from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.pages.departures_model import Begun
from seacruise.desktop.pages.reach_model import Outset
from seacruise.passage import Options, PassageRequest, Place
from seacruise.ports import Port, find_port, load_ports
from seacruise.progress import Job
from seacruise.reach import PortReached, Reach, ReachRequest
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.study import Band, Run, Spread, Study
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.passages import hand_made_passage, steady_forecast, veering_wind

FIRST = datetime(2016, 11, 20, 6, tzinfo=UTC)
BAVARIA = "Bavaria 46 Cruiser"


def yachts() -> dict[str, Polar]:
    fleet = load_fleet([resource_path("polars")])
    return {name: find_yacht(name, fleet) for name in (BAVARIA, "Nordic Folkboat")}


def port(name: str) -> Port:
    return find_port(name, load_ports())


def question() -> Question:
    return Question(port("Gdynia"), port("Sandhamn"), FIRST, yachts()[BAVARIA], ("sample",), Options())


def answer() -> Answer:
    return Answer(hand_made_passage(), veering_wind(), question())


def later(hours: float) -> datetime:
    return FIRST + timedelta(hours=hours)


def run_of(
    departure: datetime, hours: float | None, yacht: str = BAVARIA, *, held_h: float = 0.0, band: bool = False
) -> Run:
    if hours is None:
        return Run(departure, yacht, reason="becalmed", message="The yacht is becalmed off Hel.")
    return Run(
        departure,
        yacht,
        duration_h=hours,
        arrival=departure + timedelta(hours=hours),
        distance_nm=300.0,
        max_tws_kn=20.0 + hours / 10.0,
        upwind_share=0.25,
        night_h=8.0,
        motor_h=0.0,
        beyond_forecast_h=held_h,
        band=Band((), Spread(hours - 1.0, hours + 0.5, hours + 3.0), Spread(None, None, None))
        if band
        else None,
    )


def begun(count: int, *names: str) -> Begun:
    slots = tuple((later(6.0 * k), name) for name in names or (BAVARIA,) for k in range(count))
    return Begun("Gdynia", "Sandhamn", steady_forecast(), slots)


class HeldComparer:
    """Gives each departure the hours that a test says, once it lets it go."""

    def __init__(self, hours: Callable[[PassageRequest], float | None]) -> None:
        self._hours = hours
        self._free = threading.Semaphore(0)
        self.asked: list[PassageRequest] = []
        self.members_asked = 0

    def let_go(self, count: int = 1) -> None:
        self._free.release(count)

    def __call__(
        self, requests: Sequence[PassageRequest], *, settings: Settings, job: Job, members: bool
    ) -> Study:
        self.asked.extend(requests)
        self.members_asked += members
        while not self._free.acquire(timeout=0.005):
            job.check()
        request = requests[0]
        assert request.departure is not None
        run = run_of(request.departure, self._hours(request), request.yacht.name, band=members)
        return Study(request.start.name, request.end.name, request.wind.forecast, (run,))


def outset() -> Outset:
    return Outset(port("Visby"), FIRST, yachts()[BAVARIA], ("sample",), Options())


def reached(name: str, out_h: float, back_h: float | None, *, hours: float, stay_h: float) -> PortReached:
    where = port(name)
    fits = back_h is not None and out_h + stay_h + back_h <= hours
    return PortReached(
        port=where,
        lat=where.lat,
        lon=where.lon,
        snapped_nm=0.1,
        distance_nm=6.0 * out_h,
        out_h=out_h,
        arrival=later(out_h),
        back_h=back_h,
        leave_by=later(hours - back_h) if fits and back_h is not None else None,
        return_fits=fits,
        beyond_forecast_h=0.0,
    )


class HeldExplorer:
    """Finds three ports: one that fits, one that is too far to come back in time, one that is one way."""

    def __init__(self) -> None:
        self.gate = threading.Event()
        self.requests: list[ReachRequest] = []

    def __call__(
        self, request: ReachRequest, *, ports: Sequence[Port], settings: Settings, job: Job
    ) -> Reach:
        self.requests.append(request)
        job.report("search", 0.5, "half of the vertices settled")
        while not self.gate.wait(0.005):
            job.check()
        times = {"hours": request.hours, "stay_h": request.stay_h}
        found = (
            reached("Byxelkrok", 5.0, 6.0, **times),
            reached("Västervik", 9.0, 12.0, **times),
            reached("Świnoujście", 20.0, None, **times),
        )
        start = request.start
        return Reach(
            Place(start.name, start.lat, start.lon, start.lat, start.lon, 0.0),
            request.departure or FIRST,
            request.hours,
            request.stay_h,
            request.yacht.name,
            request.wind.forecast,
            found,
            100,
            notices=("Test wind: not a forecast.",),
        )


def fetch_for_departures(asked: Question, settings: Settings, job: Job) -> Wind:
    return veering_wind()


def fetch_for_reach(asked: Outset, hours: float, ports: Sequence[Port], settings: Settings, job: Job) -> Wind:
    return veering_wind()
