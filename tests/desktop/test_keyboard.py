"""Everything by the keyboard: it is reached by Tab, it has a name, and no two things share a key."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCalendarWidget,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenu,
    QScrollBar,
    QTabBar,
    QWidget,
)
from pytestqt.qtbot import QtBot

from seacruise.desktop import language
from seacruise.desktop.about import AboutDialog
from seacruise.desktop.window import MainWindow

_INNER = (QScrollBar, QHeaderView, QCalendarWidget)


def fields_of(root: QWidget) -> list[QWidget]:
    """What can be operated and seen in a window: enabled, with a place of its own in the order of Tab."""
    return [
        widget
        for widget in root.findChildren(QWidget)
        if widget.window() is root.window()
        and widget.isVisible()
        and widget.isEnabled()
        and widget.focusProxy() is None
        and widget.focusPolicy().value & Qt.FocusPolicy.TabFocus.value
        and not isinstance(widget, _INNER)
        and not isinstance(widget.parentWidget(), _INNER)
        and not _is_part(widget)
    ]


def _is_part(widget: QWidget) -> bool:
    """Whether it is the inside of another field: the line of a spin box, the button that clears a line."""
    parent = widget.parentWidget()
    if isinstance(widget, QLineEdit) and parent is not None and hasattr(parent, "lineEdit"):
        return True
    return widget.objectName() in {"qt_scrollarea_viewport", "qt_spinbox_lineedit"}


def name_of(widget: QWidget) -> str:
    """Its name for a screen reader: its own, its text, or that of the label whose buddy it is."""
    if widget.accessibleName():
        return widget.accessibleName()
    if isinstance(widget, QAbstractButton | QLabel) and widget.text():
        return widget.text()
    parent = widget.parentWidget()
    if parent is not None and parent.focusProxy() is widget and parent.accessibleName():
        return parent.accessibleName()
    labels = widget.window().findChildren(QLabel)
    return next((label.text() for label in labels if label.buddy() is widget), "")


def walked(root: QWidget, *, backwards: bool = False) -> set[QWidget]:
    """What the focus comes by, as Tab is pressed until it comes round."""
    fields = fields_of(root)
    fields[0].setFocus(Qt.FocusReason.TabFocusReason)
    seen: set[QWidget] = set()
    for _ in range(3 * len(fields) + 20):
        focused = QApplication.focusWidget()
        assert focused is not None
        seen.add(focused)
        key = Qt.Key.Key_Backtab if backwards else Qt.Key.Key_Tab
        QTest.keyClick(
            focused, key, Qt.KeyboardModifier.ShiftModifier if backwards else Qt.KeyboardModifier(0)
        )
        if QApplication.focusWidget() is fields[0] and len(seen) > 1:
            break
    return seen


def said(widgets: list[QWidget]) -> list[str]:
    return [f"{type(w).__name__} {w.objectName()!r} {name_of(w)!r}" for w in widgets]


def check(root: QWidget, qtbot: QtBot) -> None:
    root.window().activateWindow()
    QApplication.processEvents()
    # A page that reads its yachts or its passages has no fields until it has them.
    qtbot.waitUntil(lambda: bool(fields_of(root)), timeout=20_000)
    fields = fields_of(root)
    assert not said([widget for widget in fields if not name_of(widget)])
    forth, back = walked(root), walked(root, backwards=True)
    assert not said([widget for widget in fields if widget not in forth])
    assert not said([widget for widget in fields if widget not in back])


# --- every field -----------------------------------------------------------------------------------------


def test_the_window_with_a_passage(answered: MainWindow, qtbot: QtBot) -> None:
    answered.form.options_bar.show_options(shown=True)
    check(answered, qtbot)


@pytest.mark.parametrize("page", ["departures", "reach"])
def test_the_pages_below_the_chart(answered: MainWindow, qtbot: QtBot, page: str) -> None:
    answered.planning.frame.open_page(getattr(answered.planning, page))
    check(answered, qtbot)


@pytest.mark.parametrize("page", ["weather", "yachts", "passages"])
def test_the_pages_of_their_own(window: MainWindow, qtbot: QtBot, page: str) -> None:
    getattr(window.desk, f"show_{page}")()
    check(getattr(window.desk, page), qtbot)


def test_the_options(window: MainWindow, qtbot: QtBot) -> None:
    window.form.options_bar.open_dialog()
    check(window.form.options_bar.dialog, qtbot)


def test_about(window: MainWindow, qtbot: QtBot) -> None:
    window.show_about()
    dialog = window.findChild(AboutDialog)
    assert dialog is not None
    check(dialog, qtbot)
    dialog.close()


# --- keys ------------------------------------------------------------------------------------------------


@pytest.fixture(params=["en", "pl"])
def spoken(qapp: QApplication, request: pytest.FixtureRequest) -> Iterator[str]:
    """Language of the window; asked for before the window."""
    language.speak(qapp, request.param)
    yield request.param
    language.speak(qapp, "en")


def mnemonic(text: str) -> str:
    """Give the letter after the ampersand, as Alt takes it."""
    return QKeySequence.mnemonic(text).toString()


def test_no_two_shortcuts_clash(spoken: str, answered: MainWindow) -> None:
    keys: dict[str, set[str]] = defaultdict(set)
    for action in answered.findChildren(QAction):
        for key in action.shortcuts():
            keys[key.toString()].add(action.text())
    assert not {key: texts for key, texts in keys.items() if len(texts) > 1}


def test_no_two_entries_of_a_menu_share_a_letter(spoken: str, answered: MainWindow) -> None:
    for menu in answered.menuBar().findChildren(QMenu):
        letters = Counter(filter(None, (mnemonic(action.text()) for action in menu.actions())))
        assert not [letter for letter, number in letters.items() if number > 1], menu.title()
        assert all("&" in action.text() for action in menu.actions() if action.text() and action.isEnabled())


@pytest.mark.parametrize("page", ["", "departures", "reach"])
def test_no_two_letters_of_the_window_clash(spoken: str, answered: MainWindow, page: str) -> None:
    if page:
        answered.planning.frame.open_page(getattr(answered.planning, page))
    answered.form.options_bar.show_options(shown=True)
    letters: dict[str, set[str]] = defaultdict(set)
    for action in answered.menuBar().actions():
        letters[mnemonic(action.text())].add(action.text())
    for widget in answered.findChildren(QWidget):
        if not widget.isVisible() or widget.window() is not answered:
            continue
        if isinstance(widget, QAbstractButton) or (isinstance(widget, QLabel) and widget.buddy() is not None):
            letters[mnemonic(widget.text())].add(widget.text())
        if isinstance(widget, QTabBar):
            for at in range(widget.count()):
                letters[mnemonic(widget.tabText(at))].add(widget.tabText(at))
    letters.pop("")
    assert not {letter: texts for letter, texts in letters.items() if len(texts) > 1}


def test_the_focus_can_be_seen(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    alike = []
    for field in fields_of(window.form):
        window.chart.view.setFocus()
        QApplication.processEvents()
        area = QRect(field.mapTo(window.form, field.rect().topLeft()), field.size()).adjusted(-3, -3, 3, 3)
        before = window.form.grab(area).toImage()
        field.setFocus(Qt.FocusReason.TabFocusReason)
        QApplication.processEvents()
        if window.form.grab(area).toImage() == before:
            alike.append(field)
    assert not said(alike)


def test_the_columns_are_chosen_by_keys(make_window: Callable[..., MainWindow]) -> None:
    window = make_window()
    window.resize(700, 480)
    QApplication.processEvents()
    columns = window.habits.columns
    assert window.form.isVisible()
    assert not window.side.isVisible()
    columns.actions["answer"].trigger()
    assert window.side.isVisible()
    assert not window.form.isVisible()
    columns.actions["question"].trigger()
    assert window.form.isVisible()
    window.resize(1280, 800)
    QApplication.processEvents()
    assert window.form.isVisible()
    assert window.side.isVisible()
