"""What can be switched on on the chart, and what is said about a place."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QMenu
from pytestqt.qtbot import QtBot

from seacruise.desktop.avoid import Avoided, circle
from seacruise.desktop.banner import Banner
from seacruise.desktop.chart.field_layer import FIELD_STOPS, field_table
from seacruise.desktop.chart.labels import Labels, around
from seacruise.desktop.chart.palette import DAY, DUSK, NIGHT, PALETTES, Palette, colours_of
from seacruise.desktop.chart.plane import point
from seacruise.desktop.chart.schemes import SCHEMES
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer, Question, compute
from seacruise.desktop.daylight import Light, light_along, spans, sun_events
from seacruise.desktop.equal_time import TimeLine, find_time_lines, hours_drawn, open_lines
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.messages import Message
from seacruise.desktop.readout import bearing_text, from_start_text, wind_text
from seacruise.desktop.style import apply_style, tinted
from seacruise.desktop.via import join
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError
from seacruise.geodesy import great_circle_m
from seacruise.passage import Options, Passage, PassageRequest
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.routing.reach import Isochrone
from seacruise.sea.zones import Zones
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import Forecast, Wind
from tests.desktop.conftest import HeldPlanner, fetch_at_once, settle, texts_of
from tests.passages import hand_made_passage, veering_wind

MakeWindow = Callable[..., MainWindow]


def pixel(view: ChartView, lat: float, lon: float, shift: tuple[int, int] = (0, 0)) -> QColor:
    at = view.viewportTransform().map(point(lat, lon))
    return view.grab().toImage().pixelColor(round(at.x()) + shift[0], round(at.y()) + shift[1])


# --- field of colour -----------------------------------------------------------------------------------


def steady_wind(knots: float, west: float = 10.0, east: float = 30.0) -> Wind:
    moment = datetime(2016, 11, 20, tzinfo=UTC)
    forecast = Forecast("Steady", None, moment, moment, 1.0, 1.0)
    u = np.full((1, 2, 2), knots * 1852 / 3600, dtype=np.float32)
    lat, lon = np.array([53.0, 66.0]), np.array([west, east])
    return Wind(np.array([moment.timestamp()]), lat, lon, u, np.zeros_like(u), forecast)


@pytest.mark.parametrize("knots", [11.0, 21.0, 34.0])
def test_the_field_has_the_colour_of_its_wind(view: ChartView, qtbot: QtBot, knots: float) -> None:
    wind = steady_wind(knots, east=20.0)
    view.show_place(57.0, 19.7)
    settle(view, qtbot)
    water = pixel(view, 57.0, 19.7)
    view.field.show_wind(wind, wind.time[0])
    view.field.setVisible(True)
    pure = QColor(dict(FIELD_STOPS)[knots])
    share = DAY.field_alpha / 255
    for channel in ("red", "green", "blue"):
        blend = share * getattr(pure, channel)() + (1 - share) * getattr(water, channel)()
        assert getattr(pixel(view, 57.0, 19.7), channel)() == pytest.approx(blend, abs=3)
    assert pixel(view, 57.0, 20.4) == DAY.water, "no wind is known there"


def test_a_calm_is_hardly_tinted() -> None:
    table = field_table(200)
    assert table[0, 3] < 0.4 * 200 < table[-1, 3] <= 200
    assert (table[:, :3] <= table[:, 3:]).all(), "premultiplied"


def test_the_field_follows_time(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    view.field.setVisible(True)
    settle(view, qtbot)
    view.show_time(answer, float(answer.wind.time[0]))
    before = pixel(view, 57.0, 19.9)
    view.show_time(answer, float(answer.wind.time[-1]))
    assert pixel(view, 57.0, 19.9) != before


# --- what the route's colours mean ---------------------------------------------------------------------


@pytest.mark.parametrize("key", list(SCHEMES))
def test_a_scheme_names_each_of_its_colours(app: QApplication, key: str) -> None:
    scheme, track = SCHEMES[key], hand_made_passage().track
    classes = scheme.classes(track)
    assert classes.shape == track.time.shape
    assert classes.min() >= 0
    assert classes.max() < len(scheme.colours) == len(scheme.names()) == len(set(scheme.names()))
    assert scheme.title()


def test_the_engine_is_a_point_of_sail_of_its_own() -> None:
    track = hand_made_passage().track
    classes = SCHEMES["point"].classes(track)
    assert set(classes[track.motor]) == {5}
    assert 5 not in classes[~track.motor]


def test_the_route_changes_its_colours(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    track = answer.passage.track
    number = int(np.flatnonzero(track.leg == 2)[30])
    for key, scheme in SCHEMES.items():
        view.show_scheme(scheme)
        wanted = scheme.colours[int(scheme.classes(track)[number])]
        assert pixel(view, float(track.lat[number]), float(track.lon[number])) == wanted, key


# --- day and night -------------------------------------------------------------------------------------


def test_nights_of_a_passage_in_november() -> None:
    """Gotland, 20 November 2016: the almanac has sunrise 06:47 and sunset 14:24 UTC at 57.5 N 18 E."""
    track = hand_made_passage().track
    light = light_along(track)
    assert set(light) == {Light.DAY, Light.TWILIGHT, Light.NIGHT}
    events = sun_events(track)
    kinds = [event.kind for event in events]
    assert kinds == ["sunrise", "sunset", "sunrise", "sunset"][: len(kinds)]
    for event in events:
        moment = datetime.fromtimestamp(event.time, UTC)
        middle = 6.6 if event.kind == "sunrise" else 14.4
        assert moment.hour + moment.minute / 60 == pytest.approx(middle, abs=0.5)


@given(st.lists(st.integers(0, 3), min_size=2, max_size=60))
def test_spans_are_the_whole_and_meet(classes: list[int]) -> None:
    found = spans(np.array(classes, dtype=np.int64))
    assert found[0][1] == 0
    assert found[-1][2] == len(classes) - 1
    for (one, _, end), (other, begin, _) in pairwise(found):
        assert end == begin
        assert one != other
    assert all(classes[begin] == number for number, begin, _ in found)


def test_the_strip_shows_the_light_under_way(window_with_route: MainWindow) -> None:
    parts = window_with_route.chart.time_bar.strip.parts
    assert parts[0][1] == 0.0
    assert parts[-1][2] == pytest.approx(1.0)
    assert {light for light, _, _ in parts} == set(Light)
    assert "%" in window_with_route.chart.time_bar.strip.accessibleName()


# --- lines of equal time -------------------------------------------------------------------------------


@given(st.floats(0.3, 600.0))
def test_a_dozen_even_hours_at_most(duration_h: float) -> None:
    hours = hours_drawn(duration_h)
    assert len(hours) <= 12
    assert all(h < duration_h for h in hours)
    assert len({round(b - a, 9) for a, b in pairwise(hours)}) <= 1


def square(size: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Area of which the side at x = 0 is shore, shared by all sizes."""
    return np.array([[0.0, 0.0], [0.0, 2.0], [size, 2.0], [size, 0.0], [0.0, 0.0]])


def test_shores_are_not_drawn() -> None:
    areas = [Isochrone(h, ((square(h),),)) for h in (1.0, 2.0, 3.0)]
    lines = open_lines(areas)
    assert [line.hours for line in lines] == [1.0, 2.0]
    for line in lines:
        (piece,) = line.pieces
        assert piece.tolist() == [[0.0, 2.0], [line.hours, 2.0], [line.hours, 0.0], [0.0, 0.0]]


def test_an_area_without_shore_is_a_closed_line() -> None:
    inner, outer = square(1.0) + 5.0, square(9.0)
    (line,) = open_lines([Isochrone(1.0, ((inner,),)), Isochrone(2.0, ((outer,),))])
    assert [piece.tolist() for piece in line.pieces] == [inner.tolist()]


def test_lines_lie_where_she_can_be(real_answer: Answer, settings: Settings) -> None:
    lines = find_time_lines(real_answer, settings=settings, job=Job())
    passage, track = real_answer.passage, real_answer.passage.track
    assert [line.hours for line in lines] == hours_drawn(passage.duration_h)
    fastest = 12.0 * METRES_PER_NM
    for line in lines:
        points = np.concatenate(line.pieces)
        away = great_circle_m(passage.start.lat, passage.start.lon, points[:, 0], points[:, 1])
        assert away.max() <= fastest * line.hours
        # The passage itself is on the line when its time has come, but for what the lattice is coarser.
        then = passage.departure.timestamp() + 3600.0 * line.hours
        lat, lon = np.interp(then, track.time, track.lat), np.interp(then, track.time, track.lon)
        assert great_circle_m(lat, lon, points[:, 0], points[:, 1]).min() < 6 * METRES_PER_NM


def test_lines_come_and_go_with_their_switch(window_with_route: MainWindow, qtbot: QtBot) -> None:
    window = window_with_route
    assert window.chart.view.isochrones.count == 0
    window.layers.jobs.finished.emit(0, [TimeLine(6.0, (square(1.0) + np.array([56.0, 18.0]),))])
    assert window.chart.view.isochrones.count == 1
    window.menus.layers["isochrones"].setChecked(False)
    assert not window.chart.view.isochrones.isVisible()


# --- zones and areas to avoid --------------------------------------------------------------------------


@given(st.floats(54.0, 65.0), st.floats(10.0, 29.0), st.sampled_from((1.0, 5.0, 20.0)))
def test_an_avoided_circle_is_as_wide_as_it_says(lat: float, lon: float, radius_nm: float) -> None:
    (ring,) = circle(lat, lon, radius_nm, "here").rings
    assert np.array_equal(ring[0], ring[-1])
    sides = (ring[1:] + ring[:-1]) / 2
    away = great_circle_m(lat, lon, sides[:, 1], sides[:, 0]) / METRES_PER_NM
    assert away.min() >= 0.995 * radius_nm
    assert away.max() <= 1.01 * radius_nm


def test_avoiding_is_undone_and_done_again(app: QApplication) -> None:
    avoided, told = Avoided(), []
    avoided.changed.connect(lambda: told.append(len(avoided.zones)))
    avoided.add(57.0, 19.0, 5.0)
    avoided.add(58.0, 19.0, 5.0)
    avoided.remove(avoided.zones[0])
    avoided.stack.undo()
    avoided.stack.undo()
    avoided.stack.redo()
    assert told == [1, 2, 1, 2, 1, 2]


def test_an_area_avoided_is_sailed_around_and_drawn(
    window_with_route: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window, view = window_with_route, window_with_route.chart.view
    qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)
    planner.gate.set()
    before = pixel(view, 57.0, 19.9)
    view.avoid_picked.emit(57.0, 19.9, 20.0)
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    assert len(planner.requests[-1].zones.zones) == 1
    assert pixel(view, 57.0, 19.9) != before
    assert view.zones.zones_at(57.0, 19.9) == list(window.steering.avoided.zones)
    window.steering.avoided.stack.undo()
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    assert not planner.requests[-1].zones
    assert view.zones.zones_at(57.0, 19.9) == []


LAYER = """{"type": "Feature", "properties": {"name": "Firing range"}, "geometry": {"type": "Polygon",
"coordinates": [[[19.0, 56.5], [20.0, 56.5], [20.0, 57.5], [19.0, 57.5], [19.0, 56.5]]]}}"""


def test_zones_of_the_layers_are_on_the_chart_from_the_start(
    make_window: MakeWindow, settings: Settings, qtbot: QtBot
) -> None:
    settings.layers.mkdir(parents=True)
    (settings.layers / "range.geojson").write_text(LAYER)
    window = make_window()
    zones = window.chart.view.zones
    qtbot.waitUntil(lambda: len(zones.zones_at(57.0, 19.5)) == 1)
    assert zones.zones_at(57.0, 19.5)[0].name == "Firing range"


def test_a_broken_layer_is_told(make_window: MakeWindow, settings: Settings, qtbot: QtBot) -> None:
    settings.layers.mkdir(parents=True)
    (settings.layers / "broken.geojson").write_text("{")
    window = make_window()
    qtbot.waitUntil(lambda: window.side.banner is not None)
    assert window.side.banner is not None
    assert "broken.geojson" in window.side.banner.message.sentence


def test_an_open_zone_is_fainter(view: ChartView, qtbot: QtBot) -> None:
    zone = replace(circle(57.0, 19.9, 30.0, "night shooting"), valid_from=1000.0, valid_to=2000.0)
    view.show_place(57.0, 19.9)
    view.zones.show_zones(Zones((zone,)))
    settle(view, qtbot)
    fills = []
    for time in (1500.0, 3000.0):
        view.zones.show_time(time)
        fills.append(pixel(view, 57.07, 19.93))
    distance = [abs(fill.green() - DAY.water.green()) for fill in fills]
    assert distance[0] > distance[1] > 0


# --- via ------------------------------------------------------------------------------------------------


def test_two_passages_are_joined() -> None:
    first = hand_made_passage()
    second = replace(
        first, departure=first.arrival, arrival=first.arrival + (first.arrival - first.departure)
    )
    shifted = first.track.time + (first.arrival - first.departure).total_seconds()
    second = replace(second, track=replace(first.track, time=shifted))
    both = join(first, second, direct_distance_nm=300.0)
    assert both.duration_h == pytest.approx(2 * first.duration_h)
    assert both.distance_nm == pytest.approx(2 * first.distance_nm)
    assert len(both.waypoints) == 2 * len(first.waypoints) - 1
    assert (np.diff(both.track.time) > 0).all()
    assert set(np.diff(both.track.leg)) <= {0, 1}
    assert both.track.leg[-1] == len(both.waypoints) - 2
    assert both.lower_bound_h == 0.0, "nothing is proved about the sum"


def test_the_second_passage_leaves_where_and_when_the_first_arrives(settings: Settings) -> None:
    asked: list[PassageRequest] = []

    def planner(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        asked.append(request)
        passage = hand_made_passage()
        return replace(passage, arrival=passage.arrival) if len(asked) == 1 else passage

    start, end = Port("Gdynia", "PL", 54.5, 18.6), Port("Sandhamn", "SE", 59.29, 18.91)
    via = Port("Visby", "SE", 57.64, 18.28)
    polar: Any = None
    question = Question(start, end, None, polar, ("sample",), Options(), via)
    compute(question, settings=settings, job=Job(), planner=planner, fetcher=fetch_at_once)
    assert [request.end for request in asked] == [via, end]
    first = hand_made_passage()
    assert (asked[1].start.lat, asked[1].start.lon) == (first.end.lat, first.end.lon)
    assert asked[1].departure == first.arrival
    with pytest.raises(InputError, match="both the start and the end"):
        compute(
            replace(question, via=end), settings=settings, job=Job(), planner=planner, fetcher=fetch_at_once
        )


def test_via_is_set_dragged_and_dropped(
    window_with_route: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window, view = window_with_route, window_with_route.chart.view
    planner.gate.set()
    view.end_picked.emit("via", 57.0, 19.5)
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    assert planner.requests[-2].end.lat == 57.0
    assert "via" in view.ports.chosen
    at = view.viewportTransform().map(point(57.0, 19.5))
    assert view.ports.end_at(at, view.viewportTransform()) == "via"
    view.via_dropped.emit()
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    assert not view.ports.has_via
    assert window.steering.question().via is None


# --- the menu of a place --------------------------------------------------------------------------------


def texts(menu: QMenu) -> list[str]:
    return [action.text().replace("&", "") for action in menu.actions() if action.text()]


@pytest.mark.parametrize("reason", [QContextMenuEvent.Reason.Mouse, QContextMenuEvent.Reason.Keyboard])
def test_the_menu_of_a_place(
    window_with_route: MainWindow, qtbot: QtBot, reason: QContextMenuEvent.Reason
) -> None:
    window, view = window_with_route, window_with_route.chart.view
    zone = circle(*view.middle(), 10.0, "shoal")
    window.steering.avoided.put((zone,))
    at = view.viewport().rect().center() if reason is QContextMenuEvent.Reason.Mouse else QPoint(1, 1)
    view.contextMenuEvent(QContextMenuEvent(reason, at, view.mapToGlobal(at)))
    menu = next(iter(view.findChildren(QMenu)))
    said = texts(menu)
    assert said[1:4] == ["Sail from here", "Sail to here", "Sail via here"]
    assert "No longer avoid “shoal”" in said
    next(action for action in menu.actions() if action.text().replace("&", "") == "Sail to here").trigger()
    assert window.form.ends["to"].lat == pytest.approx(view.middle()[0], abs=0.05)
    next(action for action in menu.actions() if "avoid" in action.text() and "“" in action.text()).trigger()
    assert not window.steering.avoided.zones
    avoid = next(action.menu() for action in menu.actions() if action.menu() is not None)
    assert isinstance(avoid, QMenu)
    avoid.actions()[2].trigger()
    assert [zone.name for zone in window.steering.avoided.zones] == ["5 nm to avoid"]
    menu.close()


# --- measuring and reading out --------------------------------------------------------------------------


def test_measuring_with_the_mouse(window_with_route: MainWindow) -> None:
    window, view = window_with_route, window_with_route.chart.view
    window.chart.measure_button.click()
    assert view.is_measuring
    assert window.menus.layers["measure"].isChecked()
    begin, end = QPoint(120, 200), QPoint(220, 200)
    QTest.mousePress(view.viewport(), Qt.MouseButton.LeftButton, pos=begin)
    QTest.mouseMove(view.viewport(), end)
    QTest.mouseRelease(view.viewport(), Qt.MouseButton.LeftButton, pos=end)
    a, b = (view.position_at(QPointF(at)) for at in (begin, end))
    assert view.measure.text == bearing_text(*a, *b)
    assert view.measure.text.endswith("090°")
    QTest.mouseMove(view.viewport(), QPoint(300, 300))
    assert view.measure.text == bearing_text(*a, *b), "a line that was drawn stays"
    window.menus.layers["measure"].setChecked(False)
    assert not view.measure.begun
    assert not window.chart.measure_button.isChecked()


def test_measuring_with_the_keys(window_with_route: MainWindow, qtbot: QtBot) -> None:
    view = window_with_route.chart.view
    window_with_route.menus.layers["measure"].setChecked(True)
    view.setFocus()
    begin = view.middle()
    QTest.keyClick(view, Qt.Key.Key_Return)
    for _ in range(3):
        QTest.keyClick(view, Qt.Key.Key_Right)
    assert view.measure.text == bearing_text(*begin, *view.middle())
    QTest.keyClick(view, Qt.Key.Key_Return)
    QTest.keyClick(view, Qt.Key.Key_Up)
    assert view.measure.text.endswith("090°")
    QTest.keyClick(view, Qt.Key.Key_Escape)
    assert not view.is_measuring
    assert not window_with_route.menus.layers["measure"].isChecked()


def test_the_pointer_tells_wind_and_distance(window_with_route: MainWindow) -> None:
    window = window_with_route
    window.status.point(57.0, 19.5)
    said = window.status.position.text()
    wind = veering_wind()
    assert said.startswith("57°00.0'N 019°30.0'E")
    assert wind_text(wind, window.chart.time_bar.moment.timestamp(), 57.0, 19.5) in said
    assert "from Gdynia" in said


def test_words_of_the_readout(app: QApplication) -> None:
    wind = steady_wind(20.0)
    assert wind_text(wind, 0.0, 57.0, 19.0) == "wind 270° 20 kn"
    assert wind_text(wind, 0.0, 57.0, 40.0) == ""
    assert bearing_text(57.0, 19.0, 58.0, 19.0) == "60.0 nm 000°"
    assert from_start_text("Hel", (57.0, 19.0), 57.0, 19.0) == ""


# --- light ----------------------------------------------------------------------------------------------


def luminance(colour: QColor) -> float:
    channels = [
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (colour.redF(), colour.greenF(), colour.blueF())
    ]
    return float(np.dot(channels, (0.2126, 0.7152, 0.0722)))


def contrast(a: QColor, b: QColor) -> float:
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("palette", PALETTES.values(), ids=list(PALETTES))
def test_names_are_legible_in_every_light(palette: Palette) -> None:
    for ground in (palette.water, palette.land, palette.card):
        assert contrast(palette.ink, ground) >= 4.5
        assert contrast(palette.magenta, ground) >= 3.0
        assert contrast(palette.trouble, ground) >= 3.0
    assert contrast(palette.water, palette.land) >= 1.08, "the coast is told from the sea"


def test_nothing_dazzles_by_night() -> None:
    for name, colour in colours_of(NIGHT).items():
        assert luminance(colour) < 0.25, name
        assert colour.redF() + 0.02 >= colour.blueF() or luminance(colour) < 0.01, name
    assert luminance(NIGHT.water) < luminance(DUSK.water) < luminance(DAY.water)


@pytest.mark.parametrize("light", ["dusk", "night"])
def test_text_of_the_window_is_legible_in_the_dark(light: str) -> None:
    least = 4.5 if light == "dusk" else 3.0
    for ink, ground in (
        *(("#14304A", "#FFFFFF"), ("#52687B", "#FFFFFF"), ("#FFFFFF", "#0B5C8A"), ("#6B4700", "#FFF4D6")),
        *(("#8A1C1C", "#FDECEA"), ("#1D6B45", "#FFFFFF"), ("#0B5C8A", "#FFFFFF")),
    ):
        assert contrast(QColor(tinted(ink, light)), QColor(tinted(ground, light))) >= least, (ink, ground)


def test_the_light_is_switched_and_remembered(
    make_window: MakeWindow, settings: Settings, app: QApplication, qtbot: QtBot
) -> None:
    window = make_window(memory=WindowMemory(settings.data_dir))
    try:
        window.menus.choose("light", "night")
        window.menus.choose("scheme", "twa")
        assert window.chart.view.coast.colours is NIGHT
        window.chart.view.show_place(57.0, 19.9)
        settle(window.chart.view, qtbot)
        assert pixel(window.chart.view, 57.0, 19.9) in NIGHT.depths
        assert luminance(app.palette().window().color()) < 0.05
        window.close()
        second = make_window(memory=WindowMemory(settings.data_dir), fill=False)
        assert second.menus.chosen("light") == "night"
        assert second.menus.chosen("scheme") == "twa"
        assert second.chart.view.route.scheme is SCHEMES["twa"]
    finally:
        apply_style(app)


# --- the answer beside the chart ---------------------------------------------------------------------------


def test_a_banner_says_something_else_in_the_same_form(app: QApplication, qtbot: QtBot) -> None:
    banner = Banner(Message("info", "", "8 h are beyond the forecast."))
    qtbot.addWidget(banner)
    (label,) = banner.findChildren(QLabel)
    assert banner.say(Message("info", "", "9 h are beyond the forecast."))
    assert label.text() == banner.accessibleName() == "9 h are beyond the forecast."
    assert not banner.say(Message("warning", "", "10 h"))
    assert not banner.say(Message("info", "With a title", "10 h"))
    assert label.text() == "9 h are beyond the forecast."


def test_a_rough_answer_says_so_and_names_what_it_goes_by(window_with_route: MainWindow) -> None:
    window = window_with_route
    answer = window.state.answer
    assert answer is not None
    via = Port("Visby", "SE", 57.64, 18.28)
    window._rerouted(replace(answer, rough=True, question=replace(answer.question, via=via)))
    said = texts_of(window)
    assert "Roughly so far: Gdynia – Sandhamn" in said
    assert "By way of\nVisby" in said
    window._rerouted(answer)
    assert "Roughly" not in texts_of(window)
    assert "By way of" not in texts_of(window)


# --- labels ----------------------------------------------------------------------------------------------

BOXES = st.lists(
    st.tuples(st.floats(0, 700), st.floats(0, 500), st.floats(5, 150), st.floats(5, 30)), max_size=40
)


@given(BOXES)
def test_no_label_lies_over_another(boxes: list[tuple[float, float, float, float]]) -> None:
    labels, view = Labels(), QRectF(0, 0, 800, 600)
    labels.begin(view, [QRectF(600, 0, 200, 100)])
    kept = [QRectF(600, 0, 200, 100)]
    for box in boxes:
        place = labels.claim(QRectF(*box))
        clashes = any(QRectF(*box).intersects(other) for other in kept)
        assert (place is None) == (clashes or not view.contains(QRectF(*box)))
        if place is not None:
            kept.append(place)


def test_labels_stand_around_their_point() -> None:
    right, left, above, below = around(QPointF(100, 100), 40.0, 10.0, 5.0)
    assert right.left() == 105
    assert left.right() == 95
    assert above.bottom() == 95
    assert below.top() == 105


def test_labels_on_the_chart_do_not_collide(view: ChartView, answer: Answer, qtbot: QtBot) -> None:
    settle(view, qtbot)
    view.zones.show_zones(Zones((circle(57.0, 19.5, 10.0, "a shoal with a name"),)))
    taken: list[QRectF] = []
    begin, claim = view.easel.labels.begin, view.easel.labels.claim

    def begin_anew(view: QRectF, places: Iterable[QRectF] = ()) -> None:
        taken.clear()
        begin(view, places)

    def watch(*places: QRectF) -> QRectF | None:
        place = claim(*places)
        if place is not None:
            assert not any(place.intersects(other) for other in taken)
            taken.append(place)
        return place

    view.easel.labels.begin = begin_anew  # type: ignore[assignment, method-assign]
    view.easel.labels.claim = watch  # type: ignore[method-assign]
    view.grab()
    assert len(taken) >= 8
    assert {"a shoal with a name"} <= {label.text for label in view.easel.labels.written}


# --- fixtures --------------------------------------------------------------------------------------------


@pytest.fixture
def window_with_route(answered: MainWindow, qtbot: QtBot) -> MainWindow:
    qtbot.waitUntil(lambda: answered.chart.view.is_settled, timeout=30_000)
    return answered


@pytest.fixture(scope="module")
def real_answer(tmp_path_factory: pytest.TempPathFactory) -> Answer:
    """A passage that was really planned, in the sample's wind."""
    from seacruise.ports import find_port, load_ports
    from seacruise.resources import resource_path
    from seacruise.yacht.files import read_polar

    home: Path = tmp_path_factory.mktemp("home")
    ports = load_ports()
    question = Question(
        find_port("Visby", ports),
        find_port("Ventspils", ports),
        datetime(2016, 11, 20, 6, tzinfo=UTC),
        read_polar(resource_path("polars") / "bavaria-46-cruiser.csv"),
        ("sample",),
        Options(),
    )
    settings = Settings(cache_dir=home / "cache", data_dir=home / "data")
    return compute(question, settings=settings, job=Job())
