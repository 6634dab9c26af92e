"""The chart: pixels where they must be, and an answer in every corner of the world."""

from __future__ import annotations

import dataclasses
import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from matplotlib.legend import Legend

from seacruise.export import chart, chartlabels, chartwork
from seacruise.export.beside import Beside, draw_beside
from seacruise.passage import Passage, Track
from seacruise.ports import load_ports
from tests.passages import veering_wind


def size_of(png: bytes) -> tuple[int, int]:
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", png[16:24])
    return int(width), int(height)


def moved(passage: Passage, *, lat: float, lon: float, squeeze: float = 1.0) -> Passage:
    """The same passage elsewhere, or in small."""

    def shift(values: np.ndarray, first: float, offset: float) -> np.ndarray:
        return np.asarray(first + offset + (values - first) * squeeze)

    track = passage.track
    first_lat, first_lon = float(track.lat[0]), float(track.lon[0])
    new_track: Track = dataclasses.replace(
        track, lat=shift(track.lat, first_lat, lat), lon=shift(track.lon, first_lon, lon)
    )
    waypoints = tuple(
        dataclasses.replace(
            w,
            lat=first_lat + lat + (w.lat - first_lat) * squeeze,
            lon=first_lon + lon + (w.lon - first_lon) * squeeze,
        )
        for w in passage.waypoints
    )
    return dataclasses.replace(passage, track=new_track, waypoints=waypoints)


def pixels(png: bytes) -> np.ndarray:
    from io import BytesIO

    from matplotlib.image import imread

    return np.asarray(imread(BytesIO(png), format="png"))[..., :3]


def share(picture: np.ndarray, colour: str) -> float:
    wanted = np.array([int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    return float((np.abs(picture - wanted).max(axis=-1) < 0.01).mean())


def test_a_passage_to_the_north_is_drawn_upright_with_land_and_sea(passage: Passage) -> None:
    png = chart.chart(passage, wind=veering_wind())
    width, height = size_of(png)
    assert (width, height) == (round(8.5 * chartwork.DPI), round(11 * chartwork.DPI))
    picture = pixels(png)
    assert share(picture, chartwork.WATER) > 0.15
    assert share(picture, chartwork.LAND) > 0.15
    assert share(picture, chartwork.MAGENTA) > 0.0001


def test_barbs_stand_at_sea_only_when_there_is_wind(passage: Passage) -> None:
    with_wind, without = pixels(chart.chart(passage, wind=veering_wind())), pixels(chart.chart(passage))
    changed = np.abs(with_wind - without).max(axis=-1) > 0.05
    assert 0.002 < changed.mean() < 0.2
    land = np.array([int(chartwork.LAND[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    on_land = np.abs(without - land).max(axis=-1) < 0.01
    # A barb's foot is at sea; only its shaft may reach over a shore.
    assert (changed & on_land).sum() < 0.15 * changed.sum()


def test_a_passage_to_the_east_is_drawn_across(passage: Passage) -> None:
    turned = dataclasses.replace(
        passage.track,
        lat=np.full_like(passage.track.lat, 55.2),
        lon=np.linspace(13.0, 18.5, passage.track.lon.size),
    )
    assert size_of(chart.chart(dataclasses.replace(passage, track=turned)))[0] == round(11 * chartwork.DPI)


@pytest.mark.parametrize(
    ("lat", "lon", "squeeze"),
    [(0.0, 0.0, 0.01), (-89.0, -40.0, 1.0), (0.0, -25.0, 1.0), (3.0, 3.0, 0.2)],
    ids=["harbour", "southern ocean", "beyond the coast we have", "small"],
)
def test_any_place_and_size(passage: Passage, lat: float, lon: float, squeeze: float) -> None:
    elsewhere = moved(passage, lat=lat, lon=lon, squeeze=squeeze)
    assert (
        len(np.unique(pixels(chart.chart(elsewhere, wind=veering_wind()))[::5, ::5].reshape(-1, 3), axis=0))
        > 50
    )


def test_the_same_passage_gives_the_same_picture(passage: Passage, tmp_path: Path) -> None:
    for name in ("a.png", "b.png"):
        chart.write_chart(passage, tmp_path / name, wind=veering_wind())
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [
        (54.0, 59.9, [54, 55, 56, 57, 58, 59]),
        (54.51, 54.56, None),
        (-1.2, 2.2, [-1, -0.5, 0, 0.5, 1, 1.5, 2]),
    ],
)
def test_graticule_lies_on_whole_degrees_and_minutes(
    low: float, high: float, ticks: list[float] | None
) -> None:
    found = chartwork.nice_ticks(low, high)
    assert 2 <= len(found) <= 9
    assert all(abs(tick * 60 - round(tick * 60)) < 1e-9 for tick in found)
    assert ticks is None or found == pytest.approx(ticks)


@pytest.mark.parametrize(
    ("value", "text"), [(54.5, "54°30'N"), (-0.25, "0°15'S"), (57.0, "57°N"), (54.99999, "55°N")]
)
def test_degrees_are_written_as_on_charts(value: float, text: str) -> None:
    assert chartwork.degrees(value, "N", "S") == text


@pytest.mark.parametrize(
    ("before", "after", "side"),
    [
        (None, (7, 5), (-1, 0)),
        ((0, -9), (0, 9), (1, 0)),
        ((-9, 0), (9, 0), (0, 1)),
        ((-9, 3), (9, 3), (0, -1)),
        ((6, -6), None, (-1, 0)),
    ],
    ids=["first leg to the right", "straight up", "straight across", "a tack", "last leg from the right"],
)
def test_labels_keep_clear_of_the_legs(
    before: tuple[int, int] | None, after: tuple[int, int] | None, side: tuple[int, int]
) -> None:
    here = [p for p in (before, (0, 0), after) if p is not None]
    assert chartlabels.free_sides(np.array(here, dtype=float), 0 if before is None else 1)[0] == side


# ------------------------------------------------------------------------------------- labels and land


def test_labels_lie_on_the_chart_and_over_nothing_else(passage: Passage) -> None:
    """Neither over another, nor over the way, nor over a waypoint; the ports near the way are named."""
    frame = chartwork.frame_of(passage.track.lon, passage.track.lat)
    _, axes = chartwork.canvas(frame)
    taken = chartlabels.draw_waypoints(axes, passage)
    marked = chartlabels.draw_ports(axes, frame, passage, load_ports(), taken)
    assert marked >= 10
    labels = [text for text in axes.texts if text.get_text()]
    names = {text.get_text() for text in labels}
    assert {"Gdynia\nSun 06:00", "Sandhamn\nTue 01:17", "Visby"} <= names
    assert any(name.startswith("1: Sun ") for name in names)
    boxes = [text.get_window_extent() for text in labels]
    page = axes.get_window_extent()
    lon = np.interp(np.linspace(0, 1, 4000), np.linspace(0, 1, passage.track.lon.size), passage.track.lon)
    lat = np.interp(np.linspace(0, 1, 4000), np.linspace(0, 1, passage.track.lat.size), passage.track.lat)
    way = axes.transData.transform(np.column_stack([lon, chartwork.mercator(lat)]))
    for k, box in enumerate(boxes):
        assert page.x0 <= box.x0 <= box.x1 <= page.x1
        assert page.y0 <= box.y0 <= box.y1 <= page.y1
        assert not box.count_overlaps(boxes[:k])
        assert not box.count_contains(way)


@given(
    st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3)), min_size=3, max_size=9),
)
def test_land_is_cut_as_geometry_cuts_it(corners: list[tuple[float, float]]) -> None:
    from shapely import Polygon, box

    ring = np.array([*corners, corners[0]])
    whole = Polygon(ring)
    assume(whole.is_valid and whole.area > 1e-3)
    frame = chartwork.Frame(-1.0, 1.5, -0.5, 1.0, 8.0, 8.0)
    cut = chartwork._cut(ring, frame)
    wanted = whole.intersection(box(-1.0, -0.5, 1.5, 1.0))
    x, y = cut.T if len(cut) else (np.zeros(1), np.zeros(1))
    area = abs(float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))) / 2
    assert area == pytest.approx(wanted.area, abs=1e-9)
    if len(cut):
        assert cut[:, 0].min() >= -1.0 - 1e-12
        assert cut[:, 0].max() <= 1.5 + 1e-12
        assert (cut[0] == cut[-1]).all()


def test_where_land_is_cut_no_shore_is_drawn() -> None:
    frame = chartwork.Frame(0.0, 1.0, 0.0, 1.0, 8.0, 8.0)
    island = np.array([[0.5, 0.5], [2.0, 0.5], [2.0, 0.8], [0.5, 0.8], [0.5, 0.5]])
    cut = chartwork._cut(island, frame)
    pen = chartwork._pen(cut, frame)
    drawn = {
        (tuple(cut[k - 1]), tuple(cut[k]))
        for k in range(1, len(cut))
        if pen[k] == 2  # Path.LINETO
    }
    assert all(not (a[0] == b[0] == 1.0) for a, b in drawn)
    assert ((0.5, 0.8), (0.5, 0.5)) in drawn or ((0.5, 0.5), (0.5, 0.8)) in drawn


# --- what lies beside the passage ----------------------------------------------------------------------


def test_members_and_other_ways_are_drawn_under_it_and_named_clear_of_it(passage: Passage) -> None:
    line = np.array([[w.lat, w.lon] for w in passage.waypoints])
    members = tuple(line + np.array([0.0, 0.1 * k]) for k in range(3))
    ways = (("east of Gotland, 51 h 46 min", line + np.array([0.0, 1.5])),)
    frame = chartwork.frame_of(passage.track.lon, passage.track.lat)
    _, axes = chartwork.canvas(frame)
    track = chartwork.draw_passage(axes, passage)
    (box,) = draw_beside(axes, Beside(members, ways), passage)
    told = axes.get_legend()
    assert told is not None
    assert [text.get_text() for text in told.get_texts()] == ["fastest in each of 3 members", ways[0][0]]
    drawn = [artist for artist in axes.get_lines() if artist.get_zorder() == 4]
    assert len(drawn) == 4
    assert all(artist.get_zorder() < track.get_zorder() for artist in drawn)
    places = axes.transData.transform(
        np.column_stack([passage.track.lon, chartwork.mercator(passage.track.lat)])
    )
    ends = places[[0, -1]]
    assert not any(box.contains(*end) for end in ends)
    engine = [one for one in axes.artists if isinstance(one, Legend)]
    assert [text.get_text() for one in engine for text in one.get_texts()] == ["under engine"]


def test_with_nothing_beside_the_picture_is_what_it_was(passage: Passage) -> None:
    assert chart.chart(passage) == chart.chart(passage, beside=Beside())
    line = np.array([[w.lat, w.lon] for w in passage.waypoints])
    assert chart.chart(passage) != chart.chart(passage, beside=Beside((line + 0.1,)))
