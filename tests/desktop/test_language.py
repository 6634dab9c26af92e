"""The window's language: which one, numbers and dates, and the core's sentences at its border."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QAbstractItemModel, QCoreApplication, QLocale, Qt
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDialogButtonBox,
    QLabel,
    QMenu,
    QTabBar,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from seacruise.desktop import language
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.window import MainWindow
from seacruise.errors import NoPassageError
from seacruise.resources import resource_path
from tests.desktop.conftest import HeldPlanner

TEMPLATES: list[str] = json.loads(resource_path("assets/translations/core.json").read_text("utf-8"))


@pytest.fixture
def polish(qapp: QApplication) -> Iterator[None]:
    before = QLocale()
    language.speak(qapp, "pl")
    yield
    language.speak(qapp, "en")
    QLocale.setDefault(before)


@pytest.mark.parametrize(
    ("environ", "kept", "code"),
    [
        ({"SEACRUISE_LANGUAGE": "pl"}, "en", "pl"),
        ({"SEACRUISE_LANGUAGE": "pl_PL.UTF-8"}, "", "pl"),
        ({"SEACRUISE_LANGUAGE": "tlh"}, "pl", "pl"),
        ({}, "pl", "pl"),
        ({}, "en", "en"),
    ],
)
def test_the_language_is_asked_for_or_chosen(
    tmp_path: Path, environ: dict[str, str], kept: str, code: str
) -> None:
    memory = WindowMemory(tmp_path)
    language.choose(memory, kept)
    assert language.chosen(memory) == kept
    assert language.wanted(memory, environ) == code


def test_a_damaged_choice_is_none(tmp_path: Path) -> None:
    memory = WindowMemory(tmp_path)
    memory.keep("language", {"code": ["pl"]})
    assert language.chosen(memory) == ""
    assert language.chosen(None) == ""


def test_without_a_choice_the_system_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    class Polish:
        @staticmethod
        def system() -> Polish:
            return Polish()

        @staticmethod
        def uiLanguages() -> list[str]:  # noqa: N802 - Qt's own name
            return ["de-DE", "pl-Latn-PL", "pl"]

    monkeypatch.setattr(language, "QLocale", Polish)
    assert language.wanted(None, {}) == "pl"


def test_every_choice_has_a_name() -> None:
    assert set(language.choices()) == {"", *language.LANGUAGES}


def test_in_english_nothing_is_changed() -> None:
    assert language.current() == "en"
    assert language.sentence("Practice weather: generated, not a forecast.").startswith("Practice weather:")
    assert language.fill("{n:.1f} kn", n=6.54) == "6.5 kn"


@pytest.mark.usefixtures("polish")
def test_polish_writes_numbers_days_and_buttons_its_own_way() -> None:
    assert language.current() == "pl"
    assert language.fill("{n:.1f} w. {m:d} {name}", n=6.54, m=1234, name="a.b") == "6,5 w. 1234 a.b"
    assert QLocale().toString(1.5, "f", 1) == "1,5"
    assert QLocale().dayName(7, QLocale.FormatType.LongFormat) == "niedziela"
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
    assert buttons.button(QDialogButtonBox.StandardButton.Cancel).text().replace("&", "") == "Anuluj"


@pytest.mark.usefixtures("polish")
@pytest.mark.parametrize("why", ["No space left on device", "no space left on device"])
def test_what_the_system_says_is_no_sentence_of_the_core(why: str) -> None:
    text = f"(GPX file) cannot be written to here.gpx: {why}; choose another place, or free some space there."
    said = language.sentence(text)
    assert "brak: space" not in said.lower()
    assert "space left on device" in said or "miejsca" in said


SNAPPED = (
    "The passage begins 1.3 nm from Gdynia, at the nearest water of the chart that is connected with the "
    "open sea. Zones that are kept clear of: 3."
)
SNAPPED_PL = (
    "Trasa zaczyna się 1,3 Mm od punktu Gdynia, na najbliższej wodzie mapy połączonej z otwartym morzem. "
    "Omijane strefy: 3."
)
FAILED = (
    "Practice weather, not a forecast. It stands in because no Storm Glass key is set and Open-Meteo "
    "failed (Open-Meteo did not answer within 20 seconds; try again, or plan with practice weather.)."
)
FAILED_PL = (
    "Pogoda ćwiczebna, to nie prognoza. Zastępuje prognozę, bo nie ma klucza Storm Glass, a "
    "Open-Meteo zawiodło (Open-Meteo nie odpowiada od 20 s; spróbuj ponownie albo planuj z pogodą "
    "ćwiczebną.)."
)
JUMP = "Storm Glass follows ecmwf until 27 Nov 00:00 UTC, then noaa; the wind jumps there by up to 1.8 m/s."
JUMP_PL = (
    "Storm Glass opiera się na ecmwf do 27 lis 00:00 UTC, potem noaa; wiatr zmienia się tam skokowo nawet o "
    "1,8 m/s."
)
POLAR = (
    "a.csv, line 1, cell 3: the wind speeds must increase, 6 kn comes after 8; correct it or choose another "
    "polar file."
)
POLAR_PL = (
    "a.csv, wiersz 1, komórka 3: prędkości wiatru muszą rosnąć, a 6 kn jest po 8; popraw to albo wybierz "
    "inny plik biegunowej."
)


@pytest.mark.usefixtures("polish")
@pytest.mark.parametrize(
    ("said", "heard"),
    [
        (SNAPPED, SNAPPED_PL),
        (FAILED, FAILED_PL),
        (
            "The GPX file cannot be written to /tmp/x.gpx: there is no folder /tmp; create it first.",
            "Nie można zapisać (plik GPX) do /tmp/x.gpx: nie ma folderu /tmp; najpierw go utwórz.",
        ),
        (
            "Computed on Sun 20 Nov 2016 06:00 UTC with Open-Meteo; that forecast is 31 h old.",
            "Obliczono niedz. 20 lis 2016 06:00 UTC, wiatr: Open-Meteo; wiek tej prognozy: 31 h.",
        ),
        (
            "The mean is without MET Norway: MET Norway has trouble of its own (HTTP 503).",
            "Średnia jest bez MET Norway: MET Norway ma własne kłopoty (HTTP 503).",
        ),
        (JUMP, JUMP_PL),
        (POLAR, POLAR_PL),
        ("Mean of a.grb (1.5), b.grb (2) and Storm Glass", "Średnia: a.grb (1.5), b.grb (2) i Storm Glass"),
        ("Nobody knows this sentence. Nor this one!", "Nobody knows this sentence. Nor this one!"),
        ("", ""),
    ],
)
def test_sentences_of_the_core_in_polish(said: str, heard: str) -> None:
    assert language.sentence(said) == heard


@pytest.mark.usefixtures("polish")
def test_every_template_is_told_from_every_other() -> None:
    for template in TEMPLATES:
        values = [f"Xq{letter}" for letter, _ in zip("abcdefgh", re.findall(r"\{\}", template), strict=False)]
        wanted = QCoreApplication.translate("core", template).format(*values)
        assert language.sentence(template.format(*values)) == wanted, template


@pytest.mark.usefixtures("polish")
def test_a_sentence_costs_next_to_nothing() -> None:
    language.sentence("warm")
    begun = time.thread_time()
    for number in range(200):
        language.sentence(
            f"Sailed {number} again, nobody knows what this sentence means at all; what a pity."
        )
    assert (time.thread_time() - begun) / 200 < 0.005
    # What was said once is remembered.
    assert language.sentence("warm") is language.sentence("warm")


# ------------------------------------------------------------------------------------------ the whole window

ENGLISH = re.compile(
    r"\b(the|and|of|with|is|are|from|for|not|you|your|this|that|which|when|where|wind|passage|forecast|yacht|"
    r"departure|arrival|hours?|days?|save|open|close|cancel|show|search|nm)\b",
    re.IGNORECASE,
)
# Names of things that are called so everywhere.
NAMES = re.compile(
    r"Ctrl\+\S+|https?://\S+|www\.\S+|Open-Meteo(\.com)?|Storm Glass|open-meteo\.com|/\S+|NOAA GFS|Z2|"
    r"Apache License \d\.\d|Open Database License|Offshore Racing Congress|CC BY|Passage Maker|Open \d+"
)


# What the planner and the wind of these tests say.
OF_TESTS = (
    *("Gdynia lies 0.8 nm from open water; the passage begins there.", "Half of the vertices settled"),
    *("Test wind: not a forecast.", "Test wind, veering slowly"),
)


def texts_of(root: QWidget) -> Iterator[tuple[str, str]]:
    """Everything that a window says, with whoever says it."""
    for widget in [root, *root.findChildren(QWidget)]:
        name = f"{type(widget).__name__} {widget.objectName()}"
        for get in ("text", "title", "windowTitle", "toolTip", "accessibleName", "accessibleDescription"):
            if callable(method := getattr(widget, get, None)):
                yield name, str(method())
        for get in ("placeholderText", "suffix", "prefix", "specialValueText", "statusTip", "whatsThis"):
            if callable(method := getattr(widget, get, None)):
                yield name, str(method())
        if isinstance(widget, QComboBox):
            yield from ((name, widget.itemText(row)) for row in range(widget.count()))
        if isinstance(widget, QTabBar):
            for tab in range(widget.count()):
                yield name, widget.tabText(tab)
                yield name, widget.tabToolTip(tab)
        if isinstance(widget, QTableView) and (model := widget.model()) is not None:
            yield from ((name, text) for text in _texts_of_model(model))
        for action in widget.actions():
            yield from ((name, text) for text in (action.text(), action.toolTip(), action.statusTip()))


def _texts_of_model(model: QAbstractItemModel) -> Iterator[str]:
    roles = (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole)
    for role in roles:
        for column in range(model.columnCount()):
            yield str(model.headerData(column, Qt.Orientation.Horizontal, role) or "")
            for row in range(min(model.rowCount(), 200)):
                yield str(model.index(row, column).data(role) or "")


def english_in(root: QWidget, names: set[str]) -> list[str]:
    """What a window says in English."""
    found = []
    for who, text in texts_of(root):
        if "Licensed under the Apache License" in text:
            # NOTICE is what it is.
            continue
        rest = NAMES.sub("", text)
        for name in (*names, *OF_TESTS):
            rest = rest.replace(name, "")
        if ENGLISH.search(rest):
            found.append(f"{who}: {text}")
    return sorted(set(found))


@pytest.mark.usefixtures("polish")
def test_no_english_is_left_in_the_window(
    make_window: Callable[..., MainWindow], planner: HeldPlanner, qtbot: QtBot, tmp_path: Path
) -> None:
    window = make_window(memory=WindowMemory(tmp_path))
    names = {window.form.yacht_box.itemText(row) for row in range(window.form.yacht_box.count())}
    assert not (left := english_in(window, names)), "\n".join(left)
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    for open_one in (
        window.desk.show_weather,
        window.desk.show_yachts,
        window.desk.save,
        window.desk.show_passages,
        window.show_about,
        lambda: window.planning.frame.open_page(window.planning.departures),
        lambda: window.planning.frame.open_page(window.planning.reach),
    ):
        open_one()
        QApplication.processEvents()
    qtbot.wait(300)
    assert not (left := english_in(window, names)), "\n".join(left)


@pytest.mark.usefixtures("polish")
def test_each_key_of_a_menu_is_one_entrys(make_window: Callable[..., MainWindow]) -> None:
    bar = make_window().menuBar()
    for actions in (bar.actions(), *(menu.actions() for menu in bar.findChildren(QMenu))):
        texts = [action.text() for action in actions if action.isVisible() and not action.isSeparator()]
        keys = [match[1].lower() for text in texts if (match := re.search(r"&(\w)", text))]
        assert len(keys) == len(set(keys)), texts


@pytest.mark.usefixtures("polish")
def test_errors_are_polish(
    make_window: Callable[..., MainWindow], planner: HeldPlanner, qtbot: QtBot
) -> None:
    window = make_window()
    planner.error = NoPassageError(
        "Every way leads through more wind than the 20.0 kn you allow; leave at another time or raise the "
        "limit.",
        reason="wind-limit",
    )
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    said = [label.text() for label in window.side.findChildren(QLabel)]
    assert "Brak trasy: za silny wiatr" in said
    told = "Każda droga prowadzi przez wiatr silniejszy niż dopuszczone 20,0 kn; wyjdź o innej porze albo "
    assert told + "podnieś ograniczenie." in said
    assert english_in(window.side, set()) == []
