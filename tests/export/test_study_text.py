"""The table of a study: what of it was sailed after the forecast, and in which wind."""

from __future__ import annotations

from dataclasses import replace
from datetime import timedelta
from typing import Literal

import pytest

from seacruise.export.study import study_to_text
from seacruise.passage import Passage
from seacruise.study import Run, Study


def study_of(passage: Passage, hours: float, beyond: Literal["hold", "fade"]) -> Study:
    late = replace(passage, beyond_forecast_h=hours, beyond=beyond)
    first = Run(
        late.departure, late.yacht, duration_h=late.duration_h, arrival=late.arrival, max_tws_kn=20.0,
        distance_nm=late.distance_nm, upwind_share=0.2, night_h=12.0, motor_h=0.0, beyond_forecast_h=hours,
        passage=late,
    )  # fmt: skip
    second = replace(first, departure=late.departure + timedelta(hours=6), duration_h=late.duration_h + 1.0)
    return Study(late.start.name, late.end.name, late.forecast, (first, second))


@pytest.mark.parametrize(
    ("beyond", "how"), [("hold", "held as it was."), ("fade", "which fades to the usual there.")]
)
def test_hours_after_the_forecast_are_named_as_they_were_sailed(
    passage: Passage, beyond: Literal["hold", "fade"], how: str
) -> None:
    text = study_to_text(study_of(passage, 3.0, beyond), now=passage.departure)
    assert f"! Late: hours sailed after the end of the forecast, in its last wind, {how}" in text
    assert "Held" not in text
    assert text.count("   3 h") >= 1


def test_without_such_hours_nothing_is_said_of_them(passage: Passage) -> None:
    text = study_to_text(study_of(passage, 0.0, "fade"), now=passage.departure)
    assert "! Late" not in text
