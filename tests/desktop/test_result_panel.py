from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from seacruise.along import upwind_share
from seacruise.desktop.result_panel import ResultPanel, facts_of
from seacruise.desktop.units_choice import units_choice
from seacruise.desktop.window import MainWindow
from seacruise.passage import Passage
from seacruise.sun import night_hours
from tests.desktop.conftest import texts_of
from tests.passages import veering_wind

NOW = datetime(2016, 11, 20, 7, tzinfo=UTC)


@pytest.fixture
def units() -> Iterator[None]:
    """Units may be chosen; afterwards they are as before."""
    yield
    units_choice().choose(wind="kn", distance="nm", height="m", clock="utc")


@pytest.fixture
def panel(app: QApplication, qtbot: QtBot) -> ResultPanel:
    widget = ResultPanel()
    qtbot.addWidget(widget)
    widget.resize(324, 600)
    return widget


def shown(panel: ResultPanel) -> dict[str, str]:
    """Rows of the summary that are not hidden."""
    return {left.text(): right.text() for left, right in panel._rows if not left.isHidden()}


def test_one_glance_has_what_decides(panel: ResultPanel, passage: Passage) -> None:
    panel.show_passage(passage, NOW, earlier=False)
    hours, minutes = divmod(round(passage.duration_h * 60), 60)
    assert panel.duration.text() == f"{hours} h {minutes:02d} min"
    assert panel.arrival.text().splitlines()[0] == "Departs Sun 20 Nov 2016 06:00 UTC"
    track = passage.track
    assert shown(panel) == {
        "Distance": f"{passage.distance_nm:.1f} nm",
        "Mean speed": f"{passage.mean_speed_kn:.1f} kn",
        "Strongest wind": f"{passage.max_tws_kn:.0f} kn",
        "Against the wind": f"{100 * upwind_share(track):.0f} %",
        "In the dark": f"{night_hours(track.time, track.lat, track.lon):.0f} h",
        "Tacks and gybes": "1 and 2",
        "Under engine": shown(panel)["Under engine"],
        "Beyond the forecast": shown(panel)["Beyond the forecast"],
    }
    assert shown(panel)["Under engine"].endswith(f", {passage.fuel_l:.0f} l")


def test_gusts_are_told_where_the_forecast_has_them(passage: Passage) -> None:
    wind = veering_wind()
    gusty = replace(wind, gust=np.hypot(wind.u, wind.v) * np.float32(1.4))
    (strongest,) = [fact.value for fact in facts_of(passage, "", gusty) if fact.name == "Strongest wind"]
    told, gusts = strongest.split(" kn, gusts ")
    assert float(gusts.removesuffix(" kn")) == pytest.approx(1.4 * float(told), abs=1.5)


def test_why_there_is_practice_weather_is_told_to_who_points_at_it(
    panel: ResultPanel, passage: Passage
) -> None:
    whole = "Practice weather: generated, not a forecast. It stands in because no Storm Glass key is set."
    unreal = replace(passage.forecast, real=False, notice=whole)
    panel.show_passage(replace(passage, forecast=unreal, notices=(whole,)), NOW, earlier=False)
    (card,) = [card for card in panel._banners if card.message.kind == "warning"]
    assert [label.text() for label in card.findChildren(QLabel)] == ["Not a forecast for today"]
    assert card.toolTip() == whole
    assert whole in card.accessibleName()


@pytest.mark.parametrize(("times", "name"), [(1.0, ""), (2.0, "fault")])
def test_a_near_gale_is_told_in_red(panel: ResultPanel, passage: Passage, times: float, name: str) -> None:
    track = replace(passage.track, tws_kn=passage.track.tws_kn * times)
    panel.show_passage(
        replace(passage, track=track, max_tws_kn=passage.max_tws_kn * times), NOW, earlier=False
    )
    (value,) = [right for left, right in panel._rows if left.text() == "Strongest wind"]
    assert value.objectName() == name
    assert "Beaufort" in value.toolTip()


def test_engine_and_held_wind_are_told_only_when_there_are_any(passage: Passage) -> None:
    sailed = replace(passage, motor_h=0.0, beyond_forecast_h=3.0)
    names = [fact.name for fact in facts_of(sailed, "Visby", None)]
    assert names[0] == "By way of"
    assert names[-1] == "Beyond the forecast"
    assert "Under engine" not in names


def test_figures_explain_themselves(passage: Passage) -> None:
    tips = {fact.name: fact.tip for fact in facts_of(passage, "", None)}
    assert "straight line" in tips["Distance"]
    assert "60°" in tips["Against the wind"]
    assert "6°" in tips["In the dark"]


def test_warnings_stand_before_the_figures_and_remarks_after_them(
    panel: ResultPanel, passage: Passage, qtbot: QtBot
) -> None:
    panel.show_passage(passage, NOW, earlier=False)
    panel.show()
    qtbot.waitExposed(panel)
    kinds = {banner.message.kind: banner.y() for banner in panel._banners}
    distance = panel._rows[0][0].y()
    assert kinds["warning"] < distance < kinds["info"]


def test_rows_of_another_passage_leave_none_behind(panel: ResultPanel, passage: Passage) -> None:
    panel.show_passage(passage, NOW, earlier=False, via="Visby")
    assert "By way of" in shown(panel)
    panel.show_passage(replace(passage, motor_h=0.0), NOW, earlier=True)
    assert not {"By way of", "Under engine"} & shown(panel).keys()
    assert panel.heading.text().startswith("Earlier passage: ")


def test_other_units_are_shown_at_once(answered: MainWindow, units: None) -> None:
    assert " nm" in texts_of(answered)
    units_choice().choose(wind="m/s", distance="km")
    said = texts_of(answered)
    assert " m/s" in said
    assert " km" in said


def test_everything_can_be_read_out_and_copied(panel: ResultPanel, passage: Passage) -> None:
    panel.show_passage(passage, NOW, earlier=False)
    assert panel.duration.text() in panel.accessibleName()
    assert all(label.text() for label in panel.findChildren(QLabel) if not label.isHidden())
