"""The passage plan on paper from the window: in its language, and written beside it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEventLoop, QTimer
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from seacruise.desktop import language
from seacruise.desktop.exporting import Exporter
from seacruise.desktop.printed import TEXTS, paper_words
from seacruise.export import pdf
from seacruise.export.words import DAYS, MONTHS, Words
from seacruise.passage import Passage
from tests.conftest import REPOSITORY
from tests.passages import veering_wind


@pytest.fixture
def polish(qapp: QApplication) -> Iterator[None]:
    before = language.current()
    language.speak(qapp, "pl")
    yield
    language.speak(qapp, before)


def everything(passage: Passage) -> list[Passage]:
    """Passages that between them make the sheet say all it can."""
    checks = replace(passage.checks, land_free=False, zones_free=False, within_limits=False)
    first, *more = passage.waypoints
    both = replace(first, tack="both", steer_deg=60.0, current_kn=0.5, current_to_deg=90.0)
    late = passage.departure.replace(hour=23)
    return [
        passage,
        replace(passage, checks=checks, beyond="fade", manoeuvre_h=0.5, waypoints=(both, *more)),
        replace(
            passage, forecast=replace(passage.forecast, issued=None), waypoints=(first,) * 90 + tuple(more)
        ),
        replace(passage, forecast=replace(passage.forecast, issued=late, valid_to=passage.departure)),
        replace(passage, notices=("A notice.",) * 60, waypoints=(first,) * 22 + tuple(more)),
    ]


def test_the_window_knows_every_text_of_the_sheet(passage: Passage) -> None:
    said: set[str] = set()

    def say(text: str) -> str:
        said.add(text)
        return text

    wind = veering_wind()
    gust = (1.3 * np.hypot(wind.u, wind.v)).astype(np.float32)
    gusty = replace(wind, gust=gust, wave=np.ones_like(wind.u))
    for one in everything(passage):
        pdf.pages(one, wind=gusty, words=Words(say=say))
    assert said - set(TEXTS) <= {"{value:.1f}"}, "say these in desktop/printed.py"
    # what this passage does not say stands there for others, and nothing else does
    assert set(TEXTS) - said <= {*DAYS, *MONTHS, "Log (UTC, continued)"}
    assert {*DAYS, *MONTHS} <= set(TEXTS)


def test_texts_are_literals_that_the_tools_find() -> None:
    tree = ast.parse((REPOSITORY / "seacruise" / "desktop" / "printed.py").read_text("utf-8"))
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    marked = [c for c in calls if isinstance(c.func, ast.Name) and c.func.id == "QT_TRANSLATE_NOOP"]
    assert [ast.literal_eval(call.args[1]) for call in marked] == list(TEXTS)


def test_in_polish_the_longest_line_of_the_summary_is_not_cut(polish: None) -> None:
    told = paper_words().fill(
        "tacks {tacks}, gybes {gybes}, course changes {changes}", tacks=179, gybes=102, changes=347
    )
    assert len(told) <= 52, "what is longer ends in ..."


def test_in_polish_the_sheet_is_polish_and_nothing_lies_over_another(passage: Passage, polish: None) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    if QCoreApplication.translate("paper", "Departure") == "Departure":
        pytest.skip("The Polish words of the sheet are not in assets/translations yet.")
    book = pdf.pages(passage, wind=veering_wind(), words=paper_words())
    assert len(book) == 2
    for page in book:
        renderer = FigureCanvasAgg(page).get_renderer()  # type: ignore[no-untyped-call]
        boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in page.texts]
        for k, (text, box) in enumerate(boxes):
            over = [other for other, there in boxes[k + 1 :] if box.overlaps(there)]
            assert not over, f"{text!r} lies on {over}"
            assert box.x1 <= page.bbox.width - 0.3 * page.dpi, text
        said = {text for text, _ in boxes}
        assert not said & {
            "Yacht",
            "Departure",
            "Strongest wind",
            "Legs",
            "Position",
            "Weather along the passage",
        }


def test_the_plan_is_written_beside_the_window(passage: Passage, qtbot: QtBot, tmp_path: Path) -> None:
    """Drawing it takes seconds; the window goes on meanwhile."""
    parent = QWidget()
    qtbot.addWidget(parent)
    exporter = Exporter(parent)
    target = tmp_path / "plan.pdf"
    beats: list[int] = []
    heart = QTimer(parent)
    heart.timeout.connect(lambda: beats.append(1))
    heart.start(20)
    loop = QEventLoop()
    exporter.saved.connect(loop.quit)
    exporter.failed.connect(loop.quit)
    QTimer.singleShot(60_000, loop.quit)
    words = paper_words()
    exporter.write(target, lambda path: pdf.write_pdf(passage, path, wind=veering_wind(), words=words))
    loop.exec()
    exporter.shut_down()
    assert target.read_bytes().startswith(b"%PDF-")
    assert len(beats) >= 5
