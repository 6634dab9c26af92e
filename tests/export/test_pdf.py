"""The passage plan as a PDF: nothing cut, nothing written over something else."""

from __future__ import annotations

import re
import zlib
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
import pytest

from seacruise import cli
from seacruise.errors import InputError
from seacruise.export.chartwork import INK, MAGENTA
from seacruise.export.paper import HEIGHT_IN, WIDTH_IN
from seacruise.export.pdf import NOT_A_CHART, pages, pdf, write_pdf
from seacruise.narrative import tell
from seacruise.passage import Passage, Waypoint
from tests.passages import veering_wind

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LONG = "Świnoujście – Yachthafen am Nordmolenkopf bei der alten Werft und dem Leuchtturm"


def with_legs(passage: Passage, count: int) -> Passage:
    """Sail the first leg over and over, a quarter of an hour each time."""
    first, last = passage.waypoints[0], passage.waypoints[-1]
    legs: list[Waypoint] = [
        replace(first, time=first.time + timedelta(minutes=15 * k), lat=54.528 + k / 1000)
        for k in range(count)
    ]
    return replace(passage, waypoints=(*legs, last))


def crowded(passage: Passage) -> Passage:
    long = replace(
        with_legs(passage, 150),
        yacht="A yacht with a name that has no end, sail number and sponsor, of the owner's mother-in-law",
        start=replace(passage.start, name=LONG),
        end=replace(passage.end, name=LONG[::-1]),
    )
    notice = "A notice that goes on for a while, as notices do when there is much to be said about a thing, "
    forecast = replace(passage.forecast, source="A service of many words " * 8)
    return replace(long, notices=tuple(f"{notice * 2}number {k}." for k in range(40)), forecast=forecast)


def written(page: Figure) -> list[str]:
    return [text.get_text() for text in page.texts]


def legs_of(book: list[Figure]) -> list[str]:
    return [
        text for page in book for text in written(page) if re.fullmatch(r"\w{3} +\d+ \w{3} \d\d:\d\d", text)
    ]


def drifting(passage: Passage) -> Passage:
    """Sail the same over water that moves."""
    legs = [
        replace(w, steer_deg=((w.course_deg or 0.0) + 5.0) % 360.0, current_kn=0.4, current_to_deg=90.0)
        for w in passage.waypoints[:-1]
    ]
    return replace(passage, waypoints=(*legs, passage.waypoints[-1]))


@pytest.mark.parametrize("change", [lambda passage: passage, crowded, drifting])
def test_no_text_lies_on_another_or_off_the_page(
    passage: Passage, change: Callable[[Passage], Passage]
) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    for page in pages(change(passage), wind=veering_wind()):
        renderer = FigureCanvasAgg(page).get_renderer()  # type: ignore[no-untyped-call]
        boxes = [(text, text.get_window_extent(renderer)) for text in page.texts]
        width, height = WIDTH_IN * page.dpi, HEIGHT_IN * page.dpi
        for text, box in boxes:
            assert box.x0 >= 0.3 * page.dpi, text
            assert box.x1 <= width - 0.3 * page.dpi, text
            assert 0.15 * page.dpi <= box.y0 <= box.y1 <= height - 0.3 * page.dpi, text
        for k, (text, box) in enumerate(boxes):
            over = [other.get_text() for other, there in boxes[k + 1 :] if box.overlaps(there)]
            assert not over, f"{text.get_text()!r} lies on {over}"
        areas = [axes.get_window_extent(renderer) for axes in page.axes]
        for text, box in boxes:
            assert not any(box.overlaps(area) for area in areas), f"{text.get_text()!r} lies on a drawing"


def test_a_common_passage_takes_two_pages(passage: Passage) -> None:
    book = pages(passage, wind=veering_wind())
    assert len(book) == 2
    assert len(legs_of(book)) == len(passage.waypoints)
    first = " ".join(written(book[0]))
    for part in (
        "Gdynia – Sandhamn: 43 h 17 min",
        passage.yacht,
        "Strongest wind",
        "At night",
        *passage.notices,
    ):
        assert part in first
    assert "Weather along the passage" in written(book[1])


@pytest.mark.parametrize("count", [20, 26, 27, 28, 60, 150])
def test_no_leg_is_lost(passage: Passage, count: int) -> None:
    long = with_legs(passage, count)
    book = pages(long)
    numbers = [text for page in book[1:] for text in written(page) if re.fullmatch(r"\d+", text)]
    assert [n for n in map(str, range(count + 1)) if n not in numbers] == []
    assert len(legs_of(book)) == count + 1
    assert [text for text in written(book[-1]) if text.startswith("Page ")] == [
        f"Page {len(book)} of {len(book)}"
    ]


def test_in_a_current_the_course_to_steer_is_told(passage: Passage) -> None:
    inked = written(pages(drifting(passage))[1])
    assert "Steer" in inked
    first = passage.waypoints[0].course_deg
    assert first is not None
    assert f"{round(first) % 360:03d}°" in inked
    assert f"{round(first + 5.0) % 360:03d}°" in inked
    assert "Steer" not in written(pages(passage)[1])


def test_no_notice_is_lost(passage: Passage) -> None:
    said = " ".join(text for page in pages(crowded(passage)) for text in written(page))
    assert [k for k in range(40) if f"number {k}." not in said] == []


def test_each_page_says_that_it_is_no_chart_and_where_the_wind_is_from(passage: Passage) -> None:
    for page in pages(crowded(passage)):
        assert NOT_A_CHART in written(page)
        assert any(text.startswith("Wind: ") for text in written(page))
        assert any("OpenStreetMap" in text for text in written(page))


def test_the_log_stands_below_the_legs(passage: Passage) -> None:
    from seacruise.export.logform import say

    second = written(pages(passage, wind=veering_wind())[1])
    entries = tell(passage, wind=veering_wind())
    assert "Log (UTC)" in second
    assert [say(entry.phrase) for entry in entries if say(entry.phrase) not in second] == []
    assert second.index("Legs") < second.index("Log (UTC)")


@pytest.mark.parametrize("count", [8, 12, 20, 26])
def test_an_ordinary_passage_has_two_pages_with_all_its_legs(passage: Passage, count: int) -> None:
    """A long log is shortened then, and says by how much; departure and arrival always stand there."""
    one = with_legs(passage, count)
    book = pages(one, wind=veering_wind())
    assert len(book) == 2
    assert len(legs_of(book)) == count + 1
    second = written(book[1])
    told = [text for text in second if re.fullmatch(r"\w{3} \d\d:\d\d", text)]
    entries = tell(one, wind=veering_wind())
    left_out = [int(m[1]) for text in second if (m := re.match(r"\(and (\d+) smaller changes", text))]
    assert len(told) + sum(left_out) == len(entries)
    assert bool(left_out) == (len(told) < len(entries))
    assert any(text.startswith("Leaves Gdynia") for text in second)
    assert any(text.startswith("Arrives in Sandhamn") for text in second)


def test_more_legs_than_a_page_holds_go_on_and_the_log_is_whole(passage: Passage) -> None:
    one = with_legs(passage, 70)
    book = pages(one, wind=veering_wind())
    assert len(book) > 2
    assert len(legs_of(book)) == 71
    said = [text for page in book for text in written(page)]
    assert "Legs (continued)" in said
    assert not any("smaller changes" in text for text in said)
    told = [text for text in said if re.fullmatch(r"\w{3} \d\d:\d\d", text)]
    assert len(told) == len(tell(one, wind=veering_wind()))


@pytest.mark.parametrize(
    ("issued", "text"),
    [
        (None, "! When this wind was issued is not known."),
        (
            datetime(2016, 11, 20, 0, tzinfo=UTC),
            "! The wind is of Sun 20 Nov 2016 00:00 UTC, 6 h before departure.",
        ),
        (datetime(2016, 11, 20, 9, tzinfo=UTC), "! The wind is of Sun 20 Nov 2016 09:00 UTC."),
    ],
)
def test_how_old_the_wind_is_is_said(passage: Passage, issued: datetime | None, text: str) -> None:
    one = replace(passage, forecast=replace(passage.forecast, issued=issued))
    assert text in written(pages(one)[0])


def test_what_a_passage_fails_is_said_in_capitals(passage: Passage) -> None:
    assert "clear of land, within limits" in written(pages(passage)[0])
    checks = replace(passage.checks, land_free=False, within_limits=False)
    assert "CROSSES LAND, BEYOND A LIMIT" in written(pages(replace(passage, checks=checks))[0])


def test_without_colours_it_says_the_same(passage: Passage) -> None:
    """Engine, night, wind angle and what nobody forecast have a sign of their own besides the colour."""
    book = pages(passage, wind=veering_wind())
    chart, weather = book[0].axes[0], book[1].axes
    dashed = [line for line in chart.lines if line.is_dashed()]
    assert [line.get_label() for line in dashed] == ["under engine"]
    assert "engine" in [text.get_text() for text in weather[1].texts]
    angle = next(axes for axes in weather if axes.get_ylabel() == "Wind angle [°]")
    assert [line.get_linestyle() for line in angle.lines] == [":"]
    assert any(patch.get_hatch() for patch in weather[0].patches)


@pytest.mark.parametrize("name", ["Świnoujście", "Öregrund", "Liepāja", "Kāty Rybackie", "Pärnu", "Šventoji"])
def test_letters_of_the_baltic_are_embedded(passage: Passage, name: str) -> None:
    """Nothing missing in the font (matplotlib warns, which fails), and the font in the file."""
    data = pdf(replace(passage, start=replace(passage.start, name=name)))
    assert data.count(b"/FontFile2") >= 2
    assert b"/Subtype /Type3" not in data


def test_it_is_a_pdf_of_that_many_pages_and_the_same_each_time(passage: Passage) -> None:
    data = pdf(passage, wind=veering_wind())
    assert data.startswith(b"%PDF-1.")
    assert len(re.findall(rb"/Type /Page\b(?!s)", data)) == 2
    assert b"/Title (Gdynia - Sandhamn)" in data
    assert b"CreationDate" not in data
    assert pdf(passage, wind=veering_wind()) == data


def test_letters_are_text_and_not_pictures(passage: Passage) -> None:
    """Fonts are embedded as TrueType with a map to Unicode: Ś can be searched for."""
    data = pdf(replace(passage, start=replace(passage.start, name="Świnoujście")))
    assert b"/Subtype /Type3" not in data
    streams = [
        zlib.decompress(s) for s in re.findall(rb"stream\n(.*?)\nendstream", data, re.DOTALL) if s[:1] == b"x"
    ]
    assert any(b"beginbfrange" in s and b"015a" in s.lower() for s in streams)


def test_gusts_and_waves_are_drawn_where_they_are_known(passage: Passage) -> None:
    wind = veering_wind()
    tws = np.hypot(wind.u, wind.v)
    gusty = replace(wind, gust=(tws * 1.5).astype(np.float32), wave=np.full_like(tws, 1.75))
    drawn = pages(passage, wind=gusty)[1].axes
    assert "Waves [m]" in [axes.get_ylabel() for axes in drawn]
    assert " gusts" in [text.get_text() for text in drawn[0].texts]
    plain = pages(passage, wind=wind)[1].axes
    assert "Waves [m]" not in [axes.get_ylabel() for axes in plain]
    assert " gusts" not in [text.get_text() for text in plain[0].texts]


def test_what_is_beyond_the_forecast_is_hatched(passage: Passage) -> None:
    known = replace(passage, forecast=replace(passage.forecast, valid_to=passage.arrival))
    early = replace(passage, forecast=replace(passage.forecast, valid_to=datetime(2016, 11, 20, tzinfo=UTC)))

    def hatched(one: Passage) -> float:
        panel = pages(one)[1].axes[0]
        spans = [patch.get_extents().width for patch in panel.patches if patch.get_hatch()]
        return sum(spans) / panel.bbox.width

    assert hatched(known) == 0.0
    assert hatched(early) == pytest.approx(1.0)
    assert 0.0 < hatched(passage) < 0.3


def test_it_is_written_or_refused(passage: Passage, tmp_path: Path) -> None:
    write_pdf(passage, tmp_path / "p.pdf")
    assert (tmp_path / "p.pdf").read_bytes() == pdf(passage)
    with pytest.raises(InputError):
        write_pdf(passage, tmp_path / "none" / "p.pdf")


def test_plan_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "p.pdf"
    words = ["plan", "--from", "Visby", "--to", "Västervik", "--depart", "2016-11-20T06:00Z", "--forecast"]
    assert cli.main([*words, "sample", "--yacht", "Bavaria 46 Cruiser", "--pdf", str(target)]) == 0
    assert target.read_bytes().startswith(b"%PDF-")
    assert f"Wrote {target}" in capsys.readouterr().err


@pytest.mark.parametrize(("beyond", "name"), [("hold", "Held wind"), ("fade", "Fading wind")])
def test_the_wind_after_the_forecast_is_named_as_it_was_sailed(
    passage: Passage, beyond: Literal["hold", "fade"], name: str
) -> None:
    late = replace(passage, beyond=beyond, beyond_forecast_h=3.0)
    texts = written(pages(late, wind=veering_wind())[0])
    assert {text for text in texts if text.endswith(" wind")} & {"Held wind", "Fading wind"} == {name}


@pytest.mark.parametrize(("hours", "color"), [(3.0, INK), (20.0, MAGENTA)])
def test_much_of_it_beyond_the_forecast_is_told_as_a_warning(
    passage: Passage, hours: float, color: str
) -> None:
    page = pages(replace(passage, beyond_forecast_h=hours), wind=veering_wind())[0]
    (told,) = [text for text in page.texts if text.get_text().endswith(" beyond the forecast")]
    assert told.get_color() == color


@pytest.mark.parametrize(("hours", "head"), [(47.0, "47 h 00 min"), (50.5, "50 h 30 min (2 d 2 h)")])
def test_a_long_duration_is_told_in_days_too(passage: Passage, hours: float, head: str) -> None:
    late = replace(passage, arrival=passage.departure + timedelta(hours=hours))
    assert f"Gdynia – Sandhamn: {head}" in written(pages(late, wind=veering_wind())[0])
