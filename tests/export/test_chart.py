"""The chart: pixels where they must be, and an answer in every corner of the world."""

from __future__ import annotations

import dataclasses
import struct
from pathlib import Path

import numpy as np
import pytest

from seacruise.export import chart
from seacruise.passage import Passage, Track
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
    assert (width, height) == (round(8.5 * chart.DPI), round(11 * chart.DPI))
    picture = pixels(png)
    assert share(picture, chart._WATER) > 0.15
    assert share(picture, chart._LAND) > 0.15
    assert share(picture, chart._MAGENTA) > 0.0001


def test_barbs_stand_at_sea_only_when_there_is_wind(passage: Passage) -> None:
    with_wind, without = pixels(chart.chart(passage, wind=veering_wind())), pixels(chart.chart(passage))
    changed = np.abs(with_wind - without).max(axis=-1) > 0.05
    assert 0.002 < changed.mean() < 0.2
    land = np.array([int(chart._LAND[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    on_land = np.abs(without - land).max(axis=-1) < 0.01
    # A barb's foot is at sea; only its shaft may reach over a shore.
    assert (changed & on_land).sum() < 0.15 * changed.sum()


def test_a_passage_to_the_east_is_drawn_across(passage: Passage) -> None:
    turned = dataclasses.replace(
        passage.track,
        lat=np.full_like(passage.track.lat, 55.2),
        lon=np.linspace(13.0, 18.5, passage.track.lon.size),
    )
    assert size_of(chart.chart(dataclasses.replace(passage, track=turned)))[0] == round(11 * chart.DPI)


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
    found = chart._nice_ticks(low, high)
    assert 2 <= len(found) <= 9
    assert all(abs(tick * 60 - round(tick * 60)) < 1e-9 for tick in found)
    assert ticks is None or found == pytest.approx(ticks)


@pytest.mark.parametrize(
    ("value", "text"), [(54.5, "54°30'N"), (-0.25, "0°15'S"), (57.0, "57°N"), (54.99999, "55°N")]
)
def test_degrees_are_written_as_on_charts(value: float, text: str) -> None:
    assert chart._degrees(value, "N", "S") == text


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
    assert chart._free_side(np.array(here, dtype=float), 0 if before is None else 1) == side
