from __future__ import annotations

import math
import threading

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QWheelEvent
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart import palette
from seacruise.desktop.chart.barbs import barb_counts, direction_classes, make_barb
from seacruise.desktop.chart.graticule import angle_label, scale_bar, step_minutes
from seacruise.desktop.chart.land import LandCells, cell_box, clip_ring
from seacruise.desktop.chart.plane import CHARTED, point, position, rectangle
from seacruise.desktop.chart.ports_layer import rank_by_room
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.chart.wind_layer import LEAST_PX, spacing_m
from seacruise.desktop.compute import Answer
from seacruise.geodesy import rhumb_distance_m
from seacruise.ports import Port
from tests.desktop.conftest import settle


def colour_at(view: ChartView, lat: float, lon: float) -> QColor:
    at = view.viewportTransform().map(point(lat, lon))
    return view.grab().toImage().pixelColor(QPoint(round(at.x()), round(at.y())))


# --- barbs -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("speed_kn", "counts"),
    [
        (0.0, (0, 0, 0)),
        (2.4, (0, 0, 0)),
        (2.5, (0, 0, 1)),
        (10.0, (0, 1, 0)),
        (15.0, (0, 1, 1)),
        (47.4, (0, 4, 1)),
        (50.0, (1, 0, 0)),
        (65.0, (1, 1, 1)),
        (118.0, (2, 2, 0)),
    ],
)
def test_feathers_by_the_wmo(speed_kn: float, counts: tuple[int, int, int]) -> None:
    assert barb_counts(speed_kn) == counts


def test_the_shaft_points_to_where_the_wind_comes_from() -> None:
    shaft = make_barb(2).lines[0]
    assert shaft[:2] == (0.0, 0.0)
    assert shaft[3] < 0.0, "north is up, and y goes down"


def test_feathers_stand_on_the_side_of_low_pressure() -> None:
    north, south = make_barb(2, 1).lines[1], make_barb(2, -1).lines[1]
    assert north[2] > 0.0
    assert south[2] < 0.0


def test_a_calm_is_a_circle_and_a_lone_half_feather_stands_off_the_tip() -> None:
    assert make_barb(0).calm
    shaft, half = make_barb(1).lines
    assert half[1] > shaft[3]


@given(st.integers(1, 24))
def test_a_barb_shows_its_speed(fives: int) -> None:
    barb = make_barb(fives)
    long = [line for line in barb.lines[1:] if abs(line[2]) > 6]
    assert 10 * len(barb.pennants) + 2 * len(long) + (len(barb.lines) - 1 - len(long)) == fives


@given(st.floats(0.0, 360.0))
def test_the_nearest_of_72_directions(direction: float) -> None:
    assert (
        abs((int(direction_classes(np.array(direction))) * 5.0 - direction + 180.0) % 360.0 - 180.0)
        <= 2.5 + 1e-9
    )


@given(st.floats(1e-5, 0.4))
def test_barbs_keep_their_distance_at_every_zoom(scale: float) -> None:
    assert LEAST_PX - 1e-6 <= spacing_m(scale) * scale <= LEAST_PX * math.sqrt(2.0) + 1e-6


# --- graticule, scale, colours ------------------------------------------------------------------------


def test_angles_are_degrees_and_minutes() -> None:
    assert angle_label(57 * 60 + 30, "N", "S") == "57°30′N"
    assert angle_label(-18 * 60, "E", "W") == "18°W"
    assert angle_label(0, "E", "W") == "0°"


@given(st.floats(1.0, 1e5))
def test_lines_of_the_graticule_do_not_crowd(pixels_per_degree: float) -> None:
    step = step_minutes(pixels_per_degree)
    assert step / 60.0 * pixels_per_degree >= 110.0 or step == 3600


@given(st.floats(1e-4, 0.2), st.floats(54.0, 65.0))
def test_the_scale_bar_is_as_long_as_it_says(scale: float, lat: float) -> None:
    miles, pixels = scale_bar(scale, lat)
    east = point(lat, 18.0) + QPointF(pixels / scale, 0.0)
    there = position(east)
    metres = float(rhumb_distance_m(lat, 18.0, there[0], there[1]))
    assert metres == pytest.approx(miles * 1852.0, rel=1e-6)


def test_wind_colours_are_told_apart_by_lightness_alone() -> None:
    def lightness(colour: QColor) -> float:
        channels = [
            c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
            for c in (colour.redF(), colour.greenF(), colour.blueF())
        ]
        luminance = float(np.dot(channels, (0.2126, 0.7152, 0.0722)))
        return 116.0 * luminance ** (1 / 3) - 16.0 if luminance > 0.008856 else 903.3 * luminance

    steps = -np.diff([lightness(colour) for colour in palette.WIND_COLOURS])
    assert (steps > 8.0).all()


@pytest.mark.parametrize(("tws", "name"), [(4.9, "< 5"), (5.0, "5–10"), (29.9, "25–30"), (30.0, "> 30")])
def test_the_legend_names_the_class_of_a_wind(tws: float, name: str) -> None:
    assert palette.wind_class_name(palette.wind_class(tws)) == name


# --- land ----------------------------------------------------------------------------------------------

BOX = (-1.0, -2.0, 3.0, 2.0)


@given(
    st.lists(st.floats(0.3, 5.0), min_size=5, max_size=40),
    st.tuples(st.floats(-2.0, 4.0), st.floats(-3.0, 3.0)),
)
def test_a_clipped_ring_covers_what_shapely_says(radii: list[float], centre: tuple[float, float]) -> None:
    angles = np.linspace(0.0, 2 * np.pi, len(radii), endpoint=False)
    ring = np.stack((np.cos(angles), np.sin(angles)), axis=1) * np.array(radii)[:, None] + centre
    clipped = clip_ring(ring, BOX)
    wanted = shapely.intersection(shapely.Polygon(ring), shapely.box(*BOX)).area
    x, y = (clipped[:, 0], clipped[:, 1]) if len(clipped) else (np.zeros(1), np.zeros(1))
    area = abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2.0
    assert area == pytest.approx(wanted, abs=1e-6)


def test_cells_hold_all_land_once() -> None:
    cells = LandCells(0)

    def land_within(depth: int, column: int, row: int) -> float:
        box = cell_box(depth, column, row)
        area = 0.0
        for ring in cells.cell(depth, column, row).split():
            cut = clip_ring(ring, box)
            x, y = cut[:, 0], cut[:, 1]
            area += float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2.0
        return area

    whole = land_within(0, 0, 0)
    parts = sum(land_within(3, column, row) for column in range(8) for row in range(8))
    assert parts == pytest.approx(whole, rel=1e-9)
    assert 0.2 < abs(whole) / (CHARTED.width() * CHARTED.height()) < 0.9


@pytest.mark.parametrize("zoom", [1.0, 3.0, 14.0])
def test_land_is_buff_and_the_sea_is_pale_at_every_zoom(view: ChartView, qtbot: QtBot, zoom: float) -> None:
    view.zoom(zoom)
    for lat, lon, colour in ((57.30, 18.30, palette.DAY.land), (57.0, 19.9, palette.DAY.water)):
        view.show_place(lat, lon)
        settle(view, qtbot)
        at = [colour_at(view, lat + d, lon + e) for d in (0.0, 0.012) for e in (0.0, 0.012)]
        assert colour in at, (lat, lon)


# --- ports ---------------------------------------------------------------------------------------------


@given(st.lists(st.tuples(st.floats(1e6, 3e6), st.floats(-1e7, -7e6)), min_size=1, max_size=60, unique=True))
def test_ports_of_one_rank_have_room(places: list[tuple[float, float]]) -> None:
    x, y = [p[0] for p in places], [p[1] for p in places]
    ranks = rank_by_room(x, y)
    assert ranks[0] == 0
    for level in range(16):
        size = 1_600_000.0 / 2**level
        cells = [
            (round(a / size), round(b / size)) for a, b, r in zip(x, y, ranks, strict=True) if r == level
        ]
        assert len(cells) == len(set(cells))


def test_chosen_ports_are_marked(view: ChartView, qtbot: QtBot) -> None:
    visby = Port("Visby", "SE", 57.6389, 18.2833)
    view.choose_ends({"from": visby})
    view.show_place(visby.lat, visby.lon)
    settle(view, qtbot)
    assert colour_at(view, visby.lat, visby.lon) == palette.DAY.magenta


# --- moving --------------------------------------------------------------------------------------------


def wheel(view: ChartView, at: QPointF, clicks: int) -> None:
    event = QWheelEvent(
        at,
        QPointF(view.viewport().mapToGlobal(at.toPoint())),
        QPoint(),
        QPoint(0, 120 * clicks),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    view.wheelEvent(event)


@pytest.mark.parametrize("clicks", [1, 4, 9])
def test_the_wheel_zooms_at_the_pointer(view: ChartView, clicks: int) -> None:
    view.show_place(57.0, 19.0)
    at = QPointF(500.0, 220.0)
    before = position(view.viewportTransform().inverted()[0].map(at))
    scale = view.transform().m11()
    wheel(view, at, clicks)
    after = view.viewportTransform().map(point(*before))
    assert view.transform().m11() > scale
    assert math.hypot(after.x() - at.x(), after.y() - at.y()) <= 1.5


def test_zoom_ends_somewhere(view: ChartView) -> None:
    for _ in range(60):
        view.zoom_in()
    near = view.transform().m11()
    for _ in range(120):
        view.zoom_out()
    assert near <= 0.4 + 1e-9
    assert view.transform().m11() > 0.0
    assert view.transform().m11() < near


def test_keys_move_the_chart(view: ChartView) -> None:
    view.show_place(58.0, 20.0)
    view.setFocus()
    scale = view.transform().m11()
    before = view.viewportTransform().map(point(58.0, 20.0))
    QTest.keyClick(view, Qt.Key.Key_Right)
    moved = view.viewportTransform().map(point(58.0, 20.0))
    assert moved.x() - before.x() == pytest.approx(-60.0, abs=1.0)
    QTest.keyClick(view, Qt.Key.Key_Plus)
    assert view.transform().m11() > scale
    QTest.keyClick(view, Qt.Key.Key_Minus)
    assert view.transform().m11() == pytest.approx(scale)


def test_dragging_moves_the_chart_with_the_hand(view: ChartView) -> None:
    view.show_place(58.0, 20.0)
    before = view.viewportTransform().map(point(58.0, 20.0))
    QTest.mousePress(view.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(400, 300))
    QTest.mouseMove(view.viewport(), QPoint(430, 290))
    QTest.mouseMove(view.viewport(), QPoint(460, 280))
    QTest.mouseRelease(view.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(460, 280))
    after = view.viewportTransform().map(point(58.0, 20.0))
    assert (after - before).toPoint() == QPoint(60, -20)


def test_the_whole_passage_fits(view: ChartView, answer: Answer) -> None:
    inside = QRectF(view.viewport().rect())
    for waypoint in answer.passage.waypoints:
        assert inside.contains(view.viewportTransform().map(point(waypoint.lat, waypoint.lon)))


def test_it_still_fits_after_resizing(view: ChartView, answer: Answer) -> None:
    view.resize(420, 380)
    test_the_whole_passage_fits(view, answer)


# --- route ---------------------------------------------------------------------------------------------


def test_a_click_on_the_route_picks_its_leg(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    track = answer.passage.track
    middle = int(np.flatnonzero(track.leg == 3)[20])
    at = view.viewportTransform().map(point(float(track.lat[middle]), float(track.lon[middle])))
    with qtbot.waitSignal(view.leg_picked) as signal:
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=at.toPoint())
    assert signal.args == [3]


def test_a_click_beside_the_route_picks_none(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    with qtbot.waitSignal(view.leg_picked) as signal:
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(3, 3))
    assert signal.args == [-1]


def test_the_route_has_the_colour_of_its_wind(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    track = answer.passage.track
    number = int(np.flatnonzero(track.leg == 2)[30])
    wanted = palette.WIND_COLOURS[palette.wind_class(float(track.tws_kn[number]))]
    assert colour_at(view, float(track.lat[number]), float(track.lon[number])) == wanted


def test_the_boat_is_where_she_is_at_the_time(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    track = answer.passage.track
    number = int(np.flatnonzero(track.leg == 4)[25])
    at = view.viewportTransform().map(point(float(track.lat[number]), float(track.lon[number])))
    around = [QPoint(round(at.x()) + dx, round(at.y()) + dy) for dx in range(-2, 3) for dy in range(-2, 3)]

    def magenta() -> int:
        image = view.grab().toImage()
        return sum(image.pixelColor(place) == palette.DAY.magenta for place in around)

    assert magenta() == 0
    view.show_time(answer, float(track.time[number]))
    assert magenta() >= 5


def test_trouble_is_marked(view: ChartView, qtbot: QtBot) -> None:
    view.show_place(57.0, 19.9)
    settle(view, qtbot)
    view.trouble.mark((57.0, 19.9))
    assert colour_at(view, 57.0, 19.9) == palette.DAY.trouble
    view.trouble.mark(None)
    assert colour_at(view, 57.0, 19.9) == palette.DAY.water


def test_a_mark_of_trouble_covers_no_name(view: ChartView, qtbot: QtBot) -> None:
    view.ports.show_ports([Port("Visby", "SE", 57.64, 18.28)])
    view.ports.choose({"to": Port("Gdynia", "PL", 57.2, 19.9)})
    view.fit(rectangle(56.9, 17.6, 58.1, 20.6))
    settle(view, qtbot)
    view.grab()
    before = QRectF(view.ports.labels.kept["to"])
    at = view.viewportTransform().map(point(57.2, 19.9)) + QPointF(30.0, 0.0)
    view.trouble.mark(view.position_at(at))
    view.grab()
    (mark,) = view.trouble.taken(view.viewportTransform())
    assert before.intersects(mark)
    assert not view.ports.labels.kept["to"].intersects(mark)
    assert not view.ports.labels.is_free(mark)
    view.trouble.mark(None)
    view.grab()
    assert view.ports.labels.kept["to"] == before


def test_the_lattice_darkens_the_water(view: ChartView, qtbot: QtBot) -> None:
    view.fit(rectangle(56.9, 19.6, 57.1, 20.2))
    settle(view, qtbot)
    assert colour_at(view, 57.013, 19.913) == palette.DAY.water
    put_together: list[threading.Thread] = []

    def edges() -> NDArray[np.float32]:
        put_together.append(threading.current_thread())
        return np.array([[57.013, 19.5, 57.013, 20.3]], dtype=np.float32)

    view.coast.show_lattice(edges)
    view.refresh_coast()
    settle(view, qtbot)
    assert put_together
    assert threading.main_thread() not in put_together, "a lattice has a million edges"
    shades = [colour_at(view, 57.013 + d / 2000, 19.913).lightness() for d in range(-3, 4)]
    assert min(shades) < palette.DAY.water.lightness()


# --- while it moves ------------------------------------------------------------------------------------


def middle_of(view: ChartView, dx: int = 0, dy: int = 0) -> QImage:
    """Part of the picture that nothing keeps its place in, seen from where the chart was."""
    return view.grab().toImage().copy(300 + dx, 200 + dy, 150, 120)


def test_a_chart_that_moves_shows_the_same_elsewhere(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    qtbot.waitUntil(lambda: view.easel.has_sheet, timeout=10_000)
    drawn: list[int] = []
    view.coast.draw, draw = lambda *_: drawn.append(1), view.coast.draw  # type: ignore[method-assign]
    view.pan(37.0, -21.0)
    moving = middle_of(view, -37, 21)
    assert view.easel.is_moving
    assert not drawn, "one picture is moved, nothing is drawn anew"
    view.coast.draw = draw  # type: ignore[method-assign]
    settle(view, qtbot)
    view.pan(-37.0, 21.0)
    settle(view, qtbot)
    still = middle_of(view)
    differing = sum(
        moving.pixel(x, y) != still.pixel(x, y) for x in range(moving.width()) for y in range(moving.height())
    )
    assert differing < 0.02 * moving.width() * moving.height()


def test_what_changes_is_shown_while_the_chart_moves(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    qtbot.waitUntil(lambda: view.easel.has_sheet, timeout=10_000)
    view.pan(10.0, 0.0)
    before = middle_of(view)
    view.field.setVisible(True)
    assert not view.easel.has_sheet
    assert middle_of(view) != before


def test_a_sheet_is_stretched_only_so_far(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    qtbot.waitUntil(lambda: view.easel.has_sheet, timeout=10_000)
    drawn: list[int] = []
    view.wind.draw = lambda *_: drawn.append(1)  # type: ignore[method-assign]
    view.zoom(1.3)
    view.grab()
    assert not drawn
    view.zoom(2.5)
    view.grab()
    assert drawn


def test_an_end_that_is_dragged_leaves_the_names_alone(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    ports = (Port("A", "", 57.0, 19.0), Port("B", "", 58.0, 20.0))
    view.ports.show_ports(ports)
    view.choose_ends({"from": ports[0]})
    version = view.ports.version
    view.choose_ends({"from": Port("", "", 57.1, 19.1)})
    assert view.ports.version == version
    at = view.viewportTransform().map(point(57.1, 19.1))
    assert view.ports.end_at(at, view.viewportTransform()) == "from"
    view.choose_ends({"from": Port("B", "PL", 58.0, 20.0)})
    assert view.ports.version != version, "its name is written with the end, not with the ports"
