"""Whether a week is enough: said in one line, and no surer than the forecast is."""

from __future__ import annotations

from dataclasses import replace
from datetime import timedelta

import pytest
from PySide6.QtWidgets import QApplication, QStyledItemDelegate, QStyleOptionViewItem
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart_pane import ChartPane
from seacruise.desktop.legs import LegsTable
from seacruise.desktop.pages.words import about, rounded
from seacruise.desktop.result_panel import ResultPanel
from seacruise.desktop.verdict import days_text, verdict_on
from seacruise.passage import Passage


def lasting(passage: Passage, hours: float, beyond_h: float = 0.0, *, real: bool = True) -> Passage:
    passage = replace(passage, forecast=replace(passage.forecast, real=real))
    return replace(passage, arrival=passage.departure + timedelta(hours=hours), beyond_forecast_h=beyond_h)


@pytest.mark.parametrize(
    ("hours", "beyond_h", "text", "dress"),
    [
        (5.0, 0.0, "A day is enough, one way.", "good"),
        (50.43, 0.0, "2 d 2 h: a week is enough, one way, with 4 d 22 h to spare.", "good"),
        (50.43, 8.0, "2 d 2 h: a week is probably enough, one way, with 4 d 22 h to spare.", "hint"),
        (150.0, 0.0, "6 d 6 h: a week is enough, one way, with 18 h to spare.", "good"),
        (170.0, 0.0, "7 d 2 h: a week is not enough, 2 h too long.", "fault"),
        (245.2, 227.0, "10 d 5 h: a week is hardly enough, 3 d 5 h too long.", "fault"),
    ],
)
def test_a_week_is_enough_or_not(
    app: QApplication, passage: Passage, hours: float, beyond_h: float, text: str, dress: str
) -> None:
    verdict = verdict_on(lasting(passage, hours, beyond_h))
    assert (verdict.text, verdict.dress) == (text, dress)


@pytest.mark.parametrize(
    ("hours", "text", "dress"),
    [
        (5.0, "In this weather a day is enough, one way.", "hint"),
        (50.0, "2 d 2 h: in this weather a week is enough, one way, with 4 d 22 h to spare.", "hint"),
        (200.0, "8 d 8 h: in this weather a week is not enough, 1 d 8 h too long.", "fault"),
    ],
)
def test_practice_weather_promises_nothing(
    app: QApplication, passage: Passage, hours: float, text: str, dress: str
) -> None:
    verdict = verdict_on(lasting(passage, hours, real=False))
    assert (verdict.text, verdict.dress) == (text, dress)


def test_the_answer_begins_with_it(app: QApplication, qtbot: QtBot, passage: Passage) -> None:
    panel = ResultPanel()
    qtbot.addWidget(panel)
    for hours, dress in ((50.0, "good"), (200.0, "fault"), (60.0, "good")):
        sailed = lasting(passage, hours)
        panel.show_passage(sailed, passage.departure, earlier=False)
        assert panel.verdict.text() == verdict_on(sailed).text
        assert panel.verdict.objectName() == dress
        assert panel.verdict.text() in panel.accessibleName()


def test_long_times_are_told_in_days(app: QApplication) -> None:
    assert [days_text(hours) for hours in (7.2, 24.0, 51.0)] == ["7 h", "1 d 0 h", "2 d 3 h"]
    assert [rounded(hours) for hours in (0.5, 19.0, 163.0)] == ["30 min", "19 h", "6 d 19 h"]
    assert [about(hours) for hours in (6.5, 26.0, 100.0)] == ["6 h 30 min", "26 h", "4 d 4 h"]


@pytest.mark.parametrize(
    ("whole", "first"),
    [
        ("Generated, not a forecast. It stands in because …", "Generated, not a forecast."),
        ("Pogoda ćwiczebna, to nie prognoza. Średnia …", "Pogoda ćwiczebna, to nie prognoza."),
        ("Weather data by Open-Meteo.com (CC BY 4.0); its service is free.", None),
        ("Sample weather of 20. November.", None),
    ],
)  # fmt: skip
def test_the_ribbon_over_the_chart_is_one_sentence(
    app: QApplication, qtbot: QtBot, whole: str, first: str | None
) -> None:
    pane = ChartPane()
    qtbot.addWidget(pane)
    pane.show_ribbon(whole)
    assert pane.ribbon.text() == (first or whole)
    assert pane.ribbon.toolTip() == whole


def test_the_colour_of_the_wind_stands_behind_its_figure(
    app: QApplication, qtbot: QtBot, passage: Passage
) -> None:
    table = LegsTable()
    qtbot.addWidget(table)
    table.show_passage(passage)
    index = table.legs.index(0, table.legs.column("tws"))
    option = QStyleOptionViewItem()
    option.decorationSize = table.iconSize()
    delegate = table.itemDelegateForIndex(index)
    assert isinstance(delegate, QStyledItemDelegate)
    delegate.initStyleOption(option, index)
    assert option.decorationPosition == QStyleOptionViewItem.Position.Right
    assert not option.icon.isNull()
