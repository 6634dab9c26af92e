"""The page of saved passages: opened as it was, renamed, deleted and brought back, also after a restart."""

from __future__ import annotations

import sqlite3
import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from datetime import UTC, datetime
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QInputDialog
from pytestqt.qtbot import QtBot

from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.pages.passages_model import answer_of, asked_of, form_values
from seacruise.desktop.pages.passages_page import PassagesPage
from seacruise.passage import Options
from seacruise.passages import Listing, Opened, SavedPassages
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.passages import hand_made_passage, veering_wind

MakePage = Callable[[], PassagesPage]


@pytest.fixture(scope="module")
def answer() -> Answer:
    question = Question(
        start=Port("Gdynia", "PL", 54.5189, 18.5531),
        end=Port("", "", 59.2875, 18.9106),
        departure=datetime(2016, 11, 20, 6, tzinfo=UTC),
        yacht=find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")])),
        forecast=("sample",),
        options=Options(max_wind_kn=30.0),
        via=Port("", "", 57.0, 18.0),
    )
    return Answer(hand_made_passage(), veering_wind(), question)


@pytest.fixture
def make_page(app: QApplication, qtbot: QtBot, settings: Settings) -> Iterator[MakePage]:
    pages: list[PassagesPage] = []

    def make() -> PassagesPage:
        page = PassagesPage(settings)
        pages.append(page)
        qtbot.addWidget(page)
        page.resize(900, 500)
        page.show()
        with qtbot.waitSignal(page.loaded, timeout=20_000):
            page.load()
        return page

    yield make
    for page in pages:
        page.shut_down()


def names(page: PassagesPage) -> list[str]:
    model = page.table.sorted
    return [model.row_at(model.index(row, 0)).name for row in range(model.rowCount())]


def save(page: PassagesPage, qtbot: QtBot, answer: Answer, *wanted: str) -> None:
    for name in wanted:
        with qtbot.waitSignal(page.saved, timeout=20_000):
            page.save(answer, name)


def do(page: PassagesPage, qtbot: QtBot, act: Callable[[], Any]) -> None:
    with qtbot.waitSignal(page.loaded, timeout=20_000):
        act()


def test_empty_it_says_what_to_do(make_page: MakePage) -> None:
    page = make_page()
    assert page.invitation.isVisible()
    assert "save it" in page.invitation.text()
    assert not page.table.isVisible()
    assert not page.open_button.isVisible()


def test_after_a_restart_it_opens_as_it_was(make_page: MakePage, qtbot: QtBot, answer: Answer) -> None:
    save(make_page(), qtbot, answer, "To Sandhamn")
    page = make_page()
    assert names(page) == ["To Sandhamn"]
    assert page.current is not None
    assert "Computed on" in page.details.text()
    assert "which is no forecast" in page.details.text()
    with qtbot.waitSignal(page.open_requested, timeout=20_000) as caught:
        QTest.keyClick(page.table, Qt.Key.Key_Return)
    opened = caught.args[0]
    assert isinstance(opened, Opened)
    again = answer_of(opened)
    assert again.passage.waypoints == answer.passage.waypoints
    assert again.passage.notices == answer.passage.notices
    assert again.question.options == answer.question.options
    assert again.question.via == answer.question.via
    assert asked_of(again.question) == opened.asked
    values = form_values(opened.asked)
    assert (values["start"], values["end"]) == ("Gdynia", "59.2875, 18.9106")
    assert (values["max_wind_kn"], values["forecast"]) == (30.0, ("sample",))


def test_renamed_by_key_and_dialog(make_page: MakePage, qtbot: QtBot, answer: Answer) -> None:
    page = make_page()
    save(page, qtbot, answer, "a", "b")
    page.table.choose(lambda entry: entry.name == "a")
    QTest.keyClick(page.table, Qt.Key.Key_F2)
    dialog = page.findChild(QInputDialog)
    assert dialog is not None
    assert dialog.textValue() == "a"
    dialog.setTextValue("midsummer")
    do(page, qtbot, dialog.accept)
    assert sorted(names(page)) == ["b", "midsummer"]
    assert page.current is not None
    assert page.current.name == "midsummer"


def test_a_name_that_is_none_is_said(make_page: MakePage, qtbot: QtBot, answer: Answer) -> None:
    page = make_page()
    save(page, qtbot, answer, "a")
    assert page.current is not None
    with qtbot.waitSignal(page.failed, timeout=20_000):
        page.rename(page.current.number, "  ")
    assert page.fault.isVisible()
    assert "needs a name" in page.fault.label.text()
    assert names(page) == ["a"]
    QTest.mouseClick(page.fault.button, Qt.MouseButton.LeftButton)
    assert not page.fault.isVisible()


def test_deleted_and_brought_back(make_page: MakePage, qtbot: QtBot, answer: Answer) -> None:
    page = make_page()
    save(page, qtbot, answer, "a", "b", "c")
    page.table.choose(lambda entry: entry.name == "b")
    page.table.setFocus()
    do(page, qtbot, lambda: QTest.keyClick(page.table, Qt.Key.Key_Delete))
    assert sorted(names(page)) == ["a", "c"]
    assert page.current is not None
    assert page.undone.isVisible()
    assert page.undone.label.text() == "“b” is deleted."
    do(page, qtbot, lambda: QTest.keyClick(page.table, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier))
    assert sorted(names(page)) == ["a", "b", "c"]
    assert page.current.name == "b"
    assert not page.undone.isVisible()
    page.undo()
    assert not page.is_busy


def test_what_is_damaged_is_named_and_can_be_thrown_away(
    make_page: MakePage, qtbot: QtBot, answer: Answer, settings: Settings
) -> None:
    page = make_page()
    save(page, qtbot, answer, "a", "b")
    with closing(sqlite3.connect(settings.database)) as db:
        db.execute("UPDATE passage_body SET body = x'00' WHERE id = 1")
        db.commit()
    do(page, qtbot, page.load)
    assert names(page) == ["b"]
    assert page.damage.label.text() == "Damaged and left out: a."
    do(page, qtbot, page.damage.button.click)
    assert not page.damage.isVisible()
    assert SavedPassages(settings.database).listing().damaged == ()


def test_a_file_that_cannot_be_used_is_a_sentence(
    app: QApplication, qtbot: QtBot, settings: Settings
) -> None:
    settings.database.parent.mkdir(parents=True)
    settings.database.write_bytes(b"no database at all" * 300)
    page = PassagesPage(settings)
    qtbot.addWidget(page)
    page.show()
    with qtbot.waitSignal(page.failed, timeout=20_000):
        page.load()
    assert "is damaged; move it away" in page.fault.label.text()
    page.shut_down()


def test_nothing_that_was_asked_for_is_lost_at_the_end(
    make_page: MakePage, answer: Answer, settings: Settings
) -> None:
    page = make_page()
    for name in "abc":
        page.save(answer, name)
    page.shut_down()
    assert {entry.name for entry in SavedPassages(settings.database).listing().entries} == {"a", "b", "c"}


def test_the_store_is_never_touched_by_the_windows_thread(
    make_page: MakePage, qtbot: QtBot, answer: Answer, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads: list[bool] = []
    listing = SavedPassages.listing

    def watched(shelf: SavedPassages) -> Listing:
        threads.append(threading.current_thread() is threading.main_thread())
        return listing(shelf)

    monkeypatch.setattr(SavedPassages, "listing", watched)
    page = make_page()
    save(page, qtbot, answer, "a")
    do(page, qtbot, page.delete)
    do(page, qtbot, page.undo)
    assert threads == [False] * 4


def test_narrow_it_leaves_the_yachts_out(make_page: MakePage, qtbot: QtBot, answer: Answer) -> None:
    page = make_page()
    save(page, qtbot, answer, "a")
    assert not page.table.isColumnHidden(3)
    page.resize(480, 500)
    QApplication.processEvents()
    assert page.table.isColumnHidden(3)
    assert "Bavaria 46 Cruiser" in page.details.text()
