"""Ports in reach, without a window."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from seacruise.desktop.pages.reach_model import (
    Fit,
    Found,
    Outset,
    Wish,
    find_ports,
    home_by,
    lines_of,
    matches,
)
from seacruise.errors import CancelledError, InputError
from seacruise.geodesy import great_circle_m
from seacruise.ports import Port, load_ports
from seacruise.progress import Job
from seacruise.reach import farthest_nm
from seacruise.routing.reach import Isochrone
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind
from tests.desktop.pages.doubles import HeldExplorer, answer, fetch_for_reach, later, outset
from tests.passages import veering_wind
from tests.routing.worlds import cache_dir_of


def found_by(settings: Settings, wish: Wish, **more: Any) -> tuple[Found, HeldExplorer]:
    explorer = HeldExplorer()
    explorer.gate.set()
    more.setdefault("fetcher", fetch_for_reach)
    found = find_ports(wish, ports=load_ports(), settings=settings, job=Job(), explorer=explorer, **more)
    return found, explorer


def never(*_: object) -> Wind:
    raise AssertionError("the wind was fetched")


def test_there_and_back_says_what_is_to_spare(settings: Settings) -> None:
    found, explorer = found_by(settings, Wish(outset(), 20.0, 4.0))
    assert [(row.port.name, row.fit, row.spare_h) for row in found.rows] == [
        ("Byxelkrok", Fit.FITS, 5.0),
        ("Västervik", Fit.TOO_LONG, -5.0),
        ("Świnoujście", Fit.OUT_ONLY, None),
    ]
    assert (explorer.requests[0].hours, explorer.requests[0].stay_h) == (20.0, 4.0)
    assert home_by(found.reach) == later(20)


def test_one_way_needs_no_time_to_stay_or_sail_back(settings: Settings) -> None:
    found, explorer = found_by(settings, Wish(outset(), 20.0, 30.0, back=False))
    assert {row.fit for row in found.rows} == {Fit.FITS}
    assert [row.spare_h for row in found.rows] == [15.0, 11.0, 0.0]
    assert explorer.requests[0].stay_h == 0.0


def test_a_stay_longer_than_the_time_is_refused_before_the_wind_is_fetched(settings: Settings) -> None:
    with pytest.raises(InputError, match="A stay of 20 h does not fit into 20 h"):
        found_by(settings, Wish(outset(), 20.0, 20.0), fetcher=never)


def test_the_wind_of_the_passage_shown_is_used_where_it_reaches(settings: Settings) -> None:
    found, _ = found_by(settings, Wish(outset(), 5.0), known=answer(), fetcher=never)
    assert found.rows


def test_other_winds_are_fetched(settings: Settings) -> None:
    fetched: list[float] = []

    def fetch(asked: Outset, hours: float, ports: Sequence[Port], settings: Settings, job: Job) -> Wind:
        fetched.append(hours)
        return veering_wind()

    found_by(settings, Wish(replace(outset(), forecast=("practice",)), 5.0), known=answer(), fetcher=fetch)
    mean = replace(outset(), forecast=("sample", "practice"), weights=(1.0, 2.0))
    weighed = replace(answer(), question=replace(answer().question, forecast=mean.forecast))
    found_by(settings, Wish(mean, 6.0), known=weighed, fetcher=fetch)
    small = replace(answer(), wind=_around_visby())
    found_by(settings, Wish(outset(), 40.0), known=small, fetcher=fetch)
    assert fetched == [5.0, 6.0, 40.0]


def _around_visby() -> Wind:
    wind = veering_wind()
    rows, columns = (wind.lat >= 57) & (wind.lat <= 58), (wind.lon >= 18) & (wind.lon <= 19)
    return replace(
        wind,
        lat=wind.lat[rows],
        lon=wind.lon[columns],
        u=wind.u[:, rows][:, :, columns],
        v=wind.v[:, rows][:, :, columns],
    )


def test_cancelling_ends_it(settings: Settings) -> None:
    explorer, job = HeldExplorer(), Job()
    errors: list[CancelledError] = []

    def work() -> None:
        try:
            find_ports(
                Wish(outset(), 20.0),
                ports=load_ports(),
                settings=settings,
                job=job,
                fetcher=fetch_for_reach,
                explorer=explorer,
            )
        except CancelledError as error:
            errors.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    job.cancel.set()
    thread.join(20)
    assert len(errors) == 1


@pytest.mark.parametrize(
    ("text", "fitting", "names"),
    [
        ("", False, ["Byxelkrok", "Västervik", "Świnoujście"]),
        ("vaster", False, ["Västervik"]),
        ("SWI", False, ["Świnoujście"]),
        ("se", False, ["Byxelkrok", "Västervik"]),
        ("vik", False, []),
        ("", True, ["Byxelkrok"]),
        ("pl", True, []),
    ],
)
def test_the_filter(settings: Settings, text: str, fitting: bool, names: list[str]) -> None:
    found, _ = found_by(settings, Wish(outset(), 20.0, 4.0))
    assert [row.port.name for row in found.rows if matches(row, text, only_fitting=fitting)] == names


def _square(half: float, *, east: float) -> NDArray[np.float64]:
    """Sides of a square of water whose western side is a shore at 18 E."""
    lat = np.array([57 - half, 57 - half, 57 + half, 57 + half, 57 - half])
    lon = np.array([18.0, east, east, 18.0, 18.0])
    return np.stack([lat, lon], axis=1)


def test_the_outermost_line_leaves_the_shore_out_too() -> None:
    """The coast runs along 18 E; both areas lie east of it."""

    def clearance_m(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> NDArray[np.float64]:
        return (lon - 18.0) * 60_000.0

    areas = [Isochrone(h, ((_square(h / 10, east=18.0 + h / 5),),)) for h in (2.0, 4.0)]
    lines = lines_of(areas, clearance_m=clearance_m)
    assert [line.hours for line in lines] == [2.0, 4.0]
    (piece,) = lines[-1].pieces
    assert piece[:, 1].min() == 18.0
    along_shore = (piece[:-1, 1] == 18.0) & (piece[1:, 1] == 18.0)
    assert not along_shore.any()
    assert len(piece) == 4


def test_no_water_no_lines() -> None:
    def never_asked(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> NDArray[np.float64]:
        raise AssertionError("nothing to look for")

    assert lines_of([], clearance_m=never_asked) == []
    assert lines_of([Isochrone(1.0, ())], clearance_m=never_asked) == []


def test_ports_and_lines_of_a_real_reach(
    settings: Settings, tmp_path_factory: pytest.TempPathFactory
) -> None:
    settings = replace(settings, cache_dir=cache_dir_of(tmp_path_factory.getbasetemp()))
    found = find_ports(
        Wish(outset(), 8.0, 0.0),
        ports=load_ports(),
        settings=settings,
        job=Job(),
        fetcher=lambda *_: sample_wind(),
    )
    assert {"Västervik", "Fårösund"} <= {row.port.name for row in found.rows}
    for row in found.rows:
        if row.fit is Fit.FITS:
            assert row.spare_h is not None
            assert row.found.out_h + (row.found.back_h or 0.0) + row.spare_h == pytest.approx(8.0)
    assert [line.hours for line in found.lines] == [1, 2, 3, 4, 5, 6, 7, 8]
    assert found.lines[-1].pieces
    start = outset().start
    for line in (found.lines[0], found.lines[-1]):
        away = np.concatenate(
            [great_circle_m(start.lat, start.lon, piece[:, 0], piece[:, 1]) for piece in line.pieces]
        )
        assert away.max() <= farthest_nm(outset().yacht, outset().options, line.hours) * METRES_PER_NM
