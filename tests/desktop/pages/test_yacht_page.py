"""The page of yachts: search, diagram, targets, comparison, files that join the fleet, and fits from logs."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from seacruise.desktop.pages.polar_diagram import PolarDiagram
from seacruise.desktop.pages.yacht_model import (
    Shown,
    fit_from_logs,
    import_polar,
    keep_fit,
    look_at,
    reading_at,
    scaled,
    search_yachts,
)
from seacruise.desktop.pages.yacht_page import YachtPage
from seacruise.desktop.pages.yacht_words import angle_text
from seacruise.desktop.style import CARD, tinted
from seacruise.errors import InputError
from seacruise.export.polar_slices import LogPoints, slice_of, target_at
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT as KN
from seacruise.yacht.files import read_polar, write_polar
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailSet
from seacruise.yacht.tacks import TwoSided
from tests.yacht.logs.voyages import nmea, voyage
from tests.yacht.polars import polar_kn, small

YACHT = "Bavaria 46 Cruiser"
TABLE = "# name: {name}\ntwa/tws;6;10;16\n45;4.0;5.5;6.2\n90;5.0;6.6;7.4\n150;3.0;4.8;6.4\n"


def bent(share: float = 0.85) -> TwoSided:
    starboard = small()
    port = Polar("port", starboard.tws, starboard.twa, share * starboard.speed_table)
    return TwoSided("Bent mast", port, starboard)


def two_sails() -> Polar:
    genoa = polar_kn((6, 10), (45, 90, 120), ((4, 5.5), (5, 6.6), (4.2, 6)), "Genoa")
    gennaker = polar_kn((6, 10), (90, 120, 160), ((5.5, 7), (5.2, 7.2), (3.4, 5.3)), "Gennaker")
    return SailSet("Two sails", (genoa, gennaker)).to_table()


@pytest.fixture
def page(app: QApplication, qtbot: QtBot, settings: Settings) -> Iterator[YachtPage]:
    made = YachtPage(settings)
    qtbot.addWidget(made)
    made.resize(900, 900)
    made.show()
    yield made
    made.shut_down()


@pytest.fixture
def loaded(page: YachtPage, qtbot: QtBot) -> YachtPage:
    page.load(YACHT)
    wait_for(page, YACHT, qtbot)
    return page


@pytest.mark.parametrize("size", [(900, 720), (900, 560), (760, 430)])
def test_the_button_to_sail_with_her_is_in_sight(
    loaded: YachtPage, qtbot: QtBot, size: tuple[int, int]
) -> None:
    loaded.resize(*size)
    button = loaded.take_button
    qtbot.waitUntil(lambda: button.visibleRegion().boundingRect() == button.rect())
    assert loaded.view.mapTo(loaded, QPoint(0, 0)).y() >= 0


def wait_for(page: YachtPage, name: str, qtbot: QtBot, other: str = "") -> None:
    """Wait until a yacht is shown."""

    def there() -> bool:
        shown = page.view.shown
        if shown is None or shown[0].yacht.name != name:
            return False
        return (shown[1].yacht.name if shown[1] else "") == other

    qtbot.waitUntil(there, timeout=20_000)


def dropped(page: YachtPage, *paths: Path) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    args = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    enter = QDragEnterEvent(QPoint(5, 5), *args)
    QApplication.sendEvent(page, enter)
    assert enter.isAccepted()
    QApplication.sendEvent(page, QDropEvent(QPointF(5, 5), *args))


def said(page: YachtPage) -> str:
    return " ".join(label.text() for label in page.findChildren(QLabel) if label.isVisible())


# --- model ---------------------------------------------------------------------------------------------


def test_search_finds_by_beginning_and_without_accents() -> None:
    names = ["Albin Nova", "Bavaria 36", "Bavaria 46 Cruiser", "Östlind 30"]
    assert search_yachts("", names) == names
    assert search_yachts("bav 46", names) in ([], ["Bavaria 46 Cruiser"])
    assert search_yachts("ostl", names) == ["Östlind 30"]
    assert search_yachts("46", names) == ["Bavaria 46 Cruiser"]


def test_rows_are_the_winds_of_the_table() -> None:
    shown = look_at(small())
    assert [row.tws_kn for row in shown.rows] == [6, 10, 16]
    assert (shown.least_kn, shown.most_kn) == (6, 16)
    assert shown.rows[1].beat.twa == pytest.approx(42, abs=0.3)
    many = look_at(polar_kn(range(1, 41), (45, 90, 150), np.full((3, 40), 5.0)))
    assert len(many.rows) == 14
    assert [row.tws_kn for row in look_at(small(), tws_kn=[7.0, 9.0]).rows] == [7.0, 9.0]


def test_a_share_of_the_polar_takes_the_apparent_wind_along() -> None:
    slow = Polar("slow", small().tws, small().twa, 0.9 * small().speed_table)
    expected, found = target_at(slow, 10.0, 60.0), scaled(target_at(small(), 10.0, 60.0), 90.0)
    for name in ("boat_speed_kn", "vmg_kn", "awa", "aws_kn"):
        assert getattr(found, name) == pytest.approx(getattr(expected, name))


def test_each_tack_reads_its_own_polar() -> None:
    yacht = bent()
    for angle in (-60.0, 60.0):
        expected = float(yacht.speed_on(10.0 * KN, angle)) / KN
        assert reading_at(yacht, 10.0, angle, 100.0).boat_speed_kn == pytest.approx(expected)


def test_an_angle_in_words() -> None:
    shown: Shown = look_at(two_sails())
    cut = slice_of(shown.table, 10.0)
    dead = angle_text(shown, cut, 20.0, 100.0, hull=True)
    assert "to windward" in dead
    assert f"Tacking at {cut.beat.twa:.0f}°" in dead
    assert "Tacking" not in angle_text(shown, cut, 20.0, 100.0, hull=False)
    assert "by turns" in angle_text(shown, cut, 72.0, 100.0, hull=True)
    assert "Gennaker" in angle_text(shown, cut, 120.0, 100.0, hull=True)
    both = look_at(bent())
    on_port = angle_text(both, slice_of(bent().port, 10.0), -20.0, 100.0, hull=True)
    assert "TWA 20° port" in on_port
    assert "Tacking" not in on_port


def test_an_imported_polar_is_the_sailors_own(settings: Settings, tmp_path: Path) -> None:
    path = tmp_path / "mine.csv"
    path.write_text(TABLE.format(name="Mine"))
    polar = import_polar(path, settings)
    assert polar.path == settings.user_polars / "mine.csv"
    assert polar.path.read_bytes() == path.read_bytes()
    assert import_polar(polar.path, settings).name == "Mine"
    with pytest.raises(InputError, match=r"already a polar file mine\.csv"):
        import_polar(path, settings)
    again = tmp_path / "again.csv"
    again.write_text(TABLE.format(name="MINE"))
    with pytest.raises(InputError, match=r"you have the yacht MINE in mine\.csv"):
        import_polar(again, settings)


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [("a.gpx", "x", "must end in"), ("a.csv", "nothing", "a.csv"), ("a.csv", None, "There is no polar file")],
)
def test_what_is_no_polar_is_refused(
    settings: Settings, tmp_path: Path, name: str, content: str | None, sentence: str
) -> None:
    if content is not None:
        (tmp_path / name).write_text(content)
    with pytest.raises(InputError, match=sentence):
        import_polar(tmp_path / name, settings)
    assert not list(settings.user_polars.glob("*"))


# --- diagram -------------------------------------------------------------------------------------------


@pytest.fixture
def diagram(app: QApplication, qtbot: QtBot) -> PolarDiagram:
    made = PolarDiagram()
    qtbot.addWidget(made)
    made.resize(420, 420)
    made.show_yachts([small()])
    made.show()
    return made


def test_the_pointer_reads_an_angle(diagram: PolarDiagram, qtbot: QtBot) -> None:
    centre, radius = diagram._frame()
    with qtbot.waitSignal(diagram.angle_changed):
        QTest.mouseMove(diagram, (centre + QPointF(0.7 * radius, 0.0)).toPoint())
    assert diagram.angle == pytest.approx(90.0, abs=1.0)
    QTest.mouseMove(diagram, (centre + QPointF(-5.0, 0.7 * radius)).toPoint())
    assert diagram.angle == pytest.approx(179.0, abs=1.5)


def test_keys_go_round_and_change_the_wind(diagram: PolarDiagram, qtbot: QtBot) -> None:
    diagram.setFocus()
    QTest.keyClick(diagram, Qt.Key.Key_Right)
    assert diagram.angle == 45.0
    QTest.keyClick(diagram, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert diagram.angle == 50.0
    for _ in range(60):
        QTest.keyClick(diagram, Qt.Key.Key_Left)
    assert diagram.angle == 0.0
    with qtbot.waitSignal(diagram.wind_wanted) as wanted:
        QTest.keyClick(diagram, Qt.Key.Key_Up)
    assert wanted.args == [1]
    QTest.keyClick(diagram, Qt.Key.Key_Escape)
    assert diagram.angle is None


def test_curve_and_hull_are_painted_where_they_are(diagram: PolarDiagram) -> None:
    def pixel(angle: float, share: float) -> QColor:
        place = diagram._place(angle, share).toPoint()
        return diagram.grab().toImage().pixelColor(place)

    cut = diagram.slices[0][1]
    top = diagram._top()
    on = float(np.interp(75.0, cut.twa, cut.speed_kn)) / top
    ground = QColor(tinted(CARD, "day"))
    assert pixel(75.0, on) != ground
    assert pixel(75.0, 0.99) == ground
    within = pixel(75.0, 0.5 * on)
    diagram.show_hull(False)
    assert within != ground
    assert pixel(75.0, 0.5 * on) == ground
    diagram.show_light("night")
    assert pixel(75.0, 0.99) == QColor(tinted(CARD, "night"))


def test_both_tacks_are_drawn_where_they_differ(diagram: PolarDiagram) -> None:
    half = not diagram.full
    assert half
    diagram.look_at(-30.0)
    assert diagram.angle == 30.0
    diagram.show_yachts([bent()])
    assert diagram.full
    port, starboard = diagram.slices[0][-1], diagram.slices[0][1]
    assert port.beat.vmg_kn == pytest.approx(0.85 * starboard.beat.vmg_kn)
    diagram.look_at(-30.0)
    assert diagram.angle == -30.0
    points = LogPoints(np.array([10.0, 10.0]), np.array([60.0, -60.0]), np.array([12.0, 6.0]))
    diagram.show_yachts([small()], points)
    assert diagram.full
    assert diagram._top() >= 12.0
    diagram.grab()
    diagram.show_yachts([small()])
    assert diagram.angle == 30.0


@pytest.mark.parametrize(
    "yacht",
    [
        polar_kn((8,), (45, 90), ((4,), (6,))),
        polar_kn((6, 12), (45, 90), ((0.0, 0.0), (0.0, 0.0))),
        polar_kn((6, 12), (100, 150), ((60, 70), (40, 50))),
    ],
    ids=["one wind", "never moves", "very fast"],
)
def test_odd_yachts_are_drawn(diagram: PolarDiagram, yacht: Polar) -> None:
    diagram.show_yachts([yacht, small()])
    for kn in (1.0, 8.0, 40.0):
        diagram.set_wind(kn)
        diagram.look_at(100.0)
        assert not diagram.grab().isNull()


# --- page ----------------------------------------------------------------------------------------------


def test_a_page_is_empty_then_busy_then_full(page: YachtPage, qtbot: QtBot) -> None:
    assert "no yachts yet" in said(page)
    assert not page.take_button.isEnabled()
    page.load(YACHT)
    assert page.busy.isVisible()
    assert "Reading" in said(page)
    wait_for(page, YACHT, qtbot)
    assert not page.busy.isVisible()
    assert page.fleet.current == YACHT
    assert YACHT in said(page)
    assert "Best beat 42°" in page.view.reading.text()


def test_a_search_narrows_the_list_and_keys_choose(loaded: YachtPage, qtbot: QtBot) -> None:
    field = loaded.fleet.search
    field.setFocus()
    QTest.keyClicks(field, "carter")
    assert loaded.fleet.shown == ["Carter 30"]
    assert loaded.fleet.current == YACHT
    with qtbot.waitSignal(loaded.yacht_chosen) as chosen:
        QTest.keyClick(field, Qt.Key.Key_Return)
    assert chosen.args is not None
    assert chosen.args[0].name == "Carter 30"
    wait_for(loaded, "Carter 30", qtbot)
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert len(loaded.fleet.shown) > 50
    QTest.keyClick(field, Qt.Key.Key_Down)
    assert loaded.fleet.current != "Carter 30"


def test_the_button_takes_the_yacht_that_is_looked_at(loaded: YachtPage, qtbot: QtBot) -> None:
    with qtbot.waitSignal(loaded.yacht_chosen) as chosen:
        loaded.take_button.click()
    assert chosen.args == [loaded.polar]


def test_slider_row_and_reading_agree(loaded: YachtPage) -> None:
    view = loaded.view
    view.wind_slider.setValue(14)
    assert view.wind_label.text() == "14 kn"
    view.diagram.look_at(90.0)
    assert loaded.polar is not None
    expected = float(loaded.polar.speed(14 * KN, 90.0)) / KN
    assert f"TWA 90°: {expected:.2f} kn" in view.reading.text()
    assert view.diagram.accessibleDescription() == view.reading.text()
    loaded.set_percent(90.0)
    assert f"{0.9 * expected:.2f} kn" in view.reading.text()
    row = view.table.sorted.index(2, 0)
    view.table.clicked.emit(row)
    assert view.wind_slider.value() == 8
    view.diagram.wind_wanted.emit(1)
    assert view.wind_slider.value() == 9


def test_percent_is_told_and_scales_the_table(loaded: YachtPage, qtbot: QtBot) -> None:
    table = loaded.view.table.sorted

    def vmg() -> float:
        return float(table.index(3, 3).data())

    whole = vmg()
    with qtbot.waitSignal(loaded.percent_changed) as told:
        loaded.view.percent_box.setValue(80.0)
    assert told.args == [80.0]
    assert vmg() == pytest.approx(0.8 * whole, abs=0.01)


def test_a_second_yacht_is_compared(loaded: YachtPage, qtbot: QtBot) -> None:
    table = loaded.view.table
    assert table.isColumnHidden(7)
    loaded.view.other_box.setCurrentText("Carter 30")
    wait_for(loaded, YACHT, qtbot, other="Carter 30")
    assert not table.isColumnHidden(7)
    assert table.sorted.index(3, 7).data().startswith("+")
    assert len(loaded.view.diagram.slices) == 2
    loaded.view.diagram.look_at(90.0)
    assert "Carter 30:" in loaded.view.reading.text()
    loaded.view.other_box.setCurrentIndex(0)
    wait_for(loaded, YACHT, qtbot)
    assert table.isColumnHidden(7)


def test_a_dropped_polar_joins_the_fleet(loaded: YachtPage, qtbot: QtBot, tmp_path: Path) -> None:
    path = tmp_path / "mine.csv"
    path.write_text(TABLE.format(name="Mine"))
    with qtbot.waitSignal(loaded.fleet_changed):
        dropped(loaded, path)
    wait_for(loaded, "Mine", qtbot)
    assert loaded.message is not None
    assert "Mine is in your fleet" in loaded.message.sentence
    assert loaded.polar is not None
    assert loaded.polar.path is not None
    assert loaded.polar.path.name == "mine.csv"


def test_a_refusal_is_told_and_nothing_changes(loaded: YachtPage, qtbot: QtBot, tmp_path: Path) -> None:
    path = tmp_path / "broken.csv"
    path.write_text("twa/tws;6;10\n45;x;5\n")
    dropped(loaded, path, tmp_path / "b.gpx")
    qtbot.waitUntil(lambda: loaded.message is not None, timeout=20_000)
    assert loaded.message is not None
    assert loaded.message.kind == "error"
    assert "broken.csv, line 2" in loaded.message.sentence
    assert "b.gpx" in loaded.message.sentence
    assert loaded.fleet.current == YACHT


def test_a_broken_file_in_the_folder_is_told(page: YachtPage, qtbot: QtBot, settings: Settings) -> None:
    settings.user_polars.mkdir(parents=True)
    (settings.user_polars / "bad.csv").write_text("nothing")
    page.load(YACHT)
    wait_for(page, YACHT, qtbot)
    assert page.message is not None
    assert "bad.csv" in page.message.sentence


def test_a_fleet_that_was_read_elsewhere(page: YachtPage, qtbot: QtBot) -> None:
    page.choose("Two sails")
    page.show_fleet({"Test": small(), "Two sails": two_sails()})
    wait_for(page, "Two sails", qtbot)
    page.show_fleet({"Test": small()})
    wait_for(page, "Test", qtbot)


@pytest.mark.parametrize("width", [480, 900])
def test_everything_has_room_and_a_name(loaded: YachtPage, width: int) -> None:
    loaded.resize(width, 900)
    loaded.show_light("night")
    QApplication.processEvents()
    buttons = (loaded.take_button, loaded.add_button, loaded.fit_button)
    for button in buttons:
        assert button.width() >= button.sizeHint().width()
    view = loaded.view
    for widget in (*buttons, view.diagram, view.wind_slider, view.percent_box, view.hull_box, view.table):
        assert widget.mapTo(loaded, QPoint(widget.width(), 0)).x() <= width
        assert widget.accessibleName() or getattr(widget, "text", str)()
    assert loaded.fleet.view.visualRect(loaded.fleet.view.currentIndex()).intersects(
        loaded.fleet.view.viewport().rect()
    )


# --- from a log ----------------------------------------------------------------------------------------


def log_of(yacht: Any, path: Path) -> Path:
    path.write_text("\n".join(nmea(voyage(yacht, hours=1.5), variation="0.0,E")))
    return path


class _Signed:
    """A yacht that differs between the tacks, for a voyage that asks with signed angles."""

    def __init__(self, yacht: TwoSided) -> None:
        self.speed = yacht.speed_on


def test_a_log_shows_a_difference_between_the_tacks(settings: Settings, tmp_path: Path) -> None:
    log = log_of(_Signed(bent(0.8)), tmp_path / "bent.nmea")
    found = fit_from_logs([log], small(), Job())
    assert isinstance(found.yacht, TwoSided)
    assert found.tacks == pytest.approx(0.25, abs=0.12)
    assert found.points.both_tacks
    kept = keep_fit(found, settings)
    assert kept.path is not None
    assert read_polar(kept.path).name == "Test (log)"
    assert kept.path.with_suffix(".cells").is_file()


def test_a_fit_is_shown_kept_and_in_the_fleet(
    page: YachtPage, qtbot: QtBot, settings: Settings, tmp_path: Path
) -> None:
    settings.user_polars.mkdir(parents=True)
    write_polar(small(), settings.user_polars / "test.csv")
    page.load("Test")
    wait_for(page, "Test", qtbot)
    page.set_percent(80.0)
    page.fit([log_of(small(), tmp_path / "july.nmea")])
    assert page.fit_panel.cancel_button.isVisible()
    wait_for(page, "Test (log)", qtbot, other="Test")
    assert "july.nmea" in page.fit_panel.words.text()
    assert "of the polar it was held against" in page.fit_panel.words.text()
    assert page.view.share == 100.0
    assert page.view.diagram.full
    assert not page.fit_panel.show_button.isEnabled()
    with qtbot.waitSignal(page.fleet_changed, timeout=20_000):
        page.fit_panel.keep_button.click()
    wait_for(page, "Test (log)", qtbot)
    assert not page.fit_panel.isVisible()
    assert page.polar is not None
    assert page.polar.path is not None
    assert page.polar.path.is_file()


def test_a_fit_can_be_dropped_and_cancelled(loaded: YachtPage, qtbot: QtBot, tmp_path: Path) -> None:
    log = log_of(small(), tmp_path / "july.nmea")
    loaded.fit([log])
    loaded.fit_panel.cancel_button.click()
    assert not loaded.fit_panel.isVisible()
    assert loaded.message is not None
    assert loaded.message.title == "Cancelled"
    loaded.fit([log])
    wait_for(loaded, f"{YACHT} (log)", qtbot, other=YACHT)
    loaded.choose("Carter 30")
    wait_for(loaded, "Carter 30", qtbot, other=YACHT)
    loaded.fit_panel.show_button.click()
    wait_for(loaded, f"{YACHT} (log)", qtbot, other=YACHT)
    loaded.fit_panel.drop_button.click()
    wait_for(loaded, "Carter 30", qtbot)
    assert not loaded.fit_panel.isVisible()


def test_a_log_that_cannot_be_used(loaded: YachtPage, qtbot: QtBot, tmp_path: Path) -> None:
    loaded.fit([tmp_path / "none.nmea"])
    qtbot.waitUntil(lambda: loaded.message is not None, timeout=20_000)
    assert loaded.message is not None
    assert "There is no log" in loaded.message.sentence
    assert not loaded.fit_panel.isVisible()
    assert loaded.view.shown is not None
