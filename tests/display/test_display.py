"""The real program, by mouse and keys, from an empty home to a route in a plotter's file."""

from __future__ import annotations

import math
import os
import time
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from datetime import datetime
from functools import partial
from pathlib import Path

import pytest

from seacruise.export.gpx import NAMESPACE
from tests.display.conftest import Program, Screen, middle

pytestmark = pytest.mark.display

SIZES = ((1024, 700), (1280, 800), (1920, 1080))
LIGHTS = ("day", "dusk", "night")
CALCULATE = {"en": "&Calculate", "pl": "&Oblicz"}
"""What is written on the button, by language."""


class Camera:
    """Takes pictures of the screen, for the gallery where ``SEACRUISE_SHOTS`` names a folder."""

    def __init__(self, program: Program, folder: Path, prefix: str) -> None:
        self._program, self._folder, self._prefix = program, folder, prefix

    def shoot(self, name: str) -> Path:
        """Take a picture of what is within the window's frame, whatever lies over it."""
        target = self._folder / f"{self._prefix}-{name}.png"
        assert self._program.ask(f"shoot {target}")
        return target


@pytest.fixture
def start(screen: Screen, home: Path) -> Iterator[Callable[..., Program]]:
    programs: list[Program] = []

    def begin(*words: str, size: tuple[int, int] | None = (1280, 800)) -> Program:
        programs.append(Program(screen, *words, size=size))
        return programs[-1]

    yield begin
    for program in programs:
        program.kill()


def wait_until_calm(program: Program) -> None:
    """Wait until nothing computes and the chart is complete."""

    def is_calm() -> bool:
        ask = program.ask
        return not ask("steering.router.is_busy") and bool(ask("chart.view.is_settled"))

    program.wait("a calm window", is_calm)


def first_numbers(program: Program) -> tuple[str, float]:
    """Departure and duration of the passage that is shown."""
    departure = str(program.ask("state.answer.passage.departure"))
    return departure, float(program.ask("state.answer.passage.duration_h"))


# ---------------------------------------------------------------------------------------- the whole way


@pytest.mark.parametrize("language", CALCULATE)
def test_from_an_empty_home_to_a_saved_route(
    start: Callable[..., Program], screen: Screen, home: Path, tmp_path: Path, language: str
) -> None:
    screen.env |= {"SEACRUISE_LANGUAGE": language}
    shots = Path(os.environ.get("SEACRUISE_SHOTS", tmp_path))
    program = start()
    camera = Camera(program, shots, language)
    close_guide(program, camera)
    assert program.ask("form.calculate_button")["text"] == CALCULATE[language]
    fill_the_form(program, camera)
    calculate(program)
    camera.shoot("passage")
    drag_the_departure(program)
    sail_via(program, camera)
    turn_the_pages(program, camera)
    target = save_as_gpx(program, tmp_path / "to the skerries.gpx", camera)
    check_gpx(target)
    look_at_every_size_and_light(program, camera)
    leave(program)
    everything_is_kept(start(size=None), light="night")
    log = home / "data" / "seacruise.log"
    assert not log.exists() or "ERROR" not in log.read_text(encoding="utf-8")


def close_guide(program: Program, camera: Camera) -> None:
    """Look at the guide that a new sailor is shown, step by step."""
    program.wait_for("chart.view.is_settled")
    for step in range(3):
        program.wait_for("habits.guide.step", step)
        camera.shoot(f"guide-{step + 1}")
        program.click("habits.guide.next_button")
    program.wait("the guide put away", lambda: not program.ask("habits.guide")["visible"])


def fill_the_form(program: Program, camera: Camera) -> None:
    """Type the ports, choose forecast, day and yacht."""
    program.wait("the ports", lambda: program.ask("form.yacht_box")["currentText"])
    program.write("form.start_field", "gdy")
    program.click_item("form.start_field.popup", "Gdynia")
    program.wait("Gdynia", lambda: program.ask("form.start_field")["text"] == "Gdynia")
    program.write("form.end_field", "visb")
    program.wait("an offer", lambda: program.ask("form.end_field.popup")["visible"])
    camera.shoot("type-ahead")
    program.screen.keys("Down", "Return")
    program.wait("Visby", lambda: program.ask("form.end_field")["text"] == "Visby")
    program.click("form.forecast_box")
    program.click_item("form.forecast_box.view", "('sample',)")
    program.wait("the forecast", lambda: program.ask("form.departure.calendar_button")["enabled"])
    program.click("form.departure.calendar_button")
    program.wait("the calendar", lambda: program.ask("form.departure.popup")["visible"])
    camera.shoot("calendar")
    program.click_item("form.departure.calendar.#qt_calendar_calendarview", "21")
    program.wait("the day", lambda: "2016-11-21" in program.ask("form.departure.moment"))
    program.click("form.yacht_box")
    program.wait("the yachts", lambda: program.ask("form.yacht_box.view")["visible"])
    program.screen.type("Delphia 47")
    program.screen.keys("Return")
    program.wait("the yacht", lambda: program.ask("form.yacht_box")["currentText"] == "Delphia 47")
    program.write("form.departure.time_edit", "0000")


def calculate(program: Program) -> None:
    """Press the button and wait for the answer."""
    program.click("form.calculate_button")
    program.wait_for("state.phase", "route", 120)
    wait_until_calm(program)
    assert program.ask("state.answer.passage.yacht") == "Delphia 47"
    assert program.ask("legs.isVisible")


def drag_the_departure(program: Program) -> None:
    """Drag the slider six hours or so on; the passage follows."""
    before = first_numbers(program)
    handle = middle(program.ask("chart.time_bar.departure_slider")["handle"])
    program.drag(handle, (handle[0] + 20, handle[1]))
    program.wait("another departure", lambda: first_numbers(program)[0] > before[0])
    program.wait("a precise passage", lambda: not program.ask("state.answer.rough"))
    wait_until_calm(program)
    assert first_numbers(program)[1] != before[1]


def sail_via(program: Program, camera: Camera) -> None:
    """Right-click on open water east of the straight way: sail by way of it."""
    spot = (56.3, 19.2)
    x, y = program.ask(f"place {spot[0]} {spot[1]}")
    program.screen.click(x, y, 3)
    menu = program.wait("the menu", lambda: program.ask("@popup"))
    camera.shoot("right-click")
    program.click_at(menu["items"][3]["rect"])
    program.wait_for("chart.view.ports.has_via")
    wait_until_calm(program)
    lat, lon = (
        float(program.ask("state.answer.question.via.lat")),
        float(program.ask("state.answer.question.via.lon")),
    )
    assert math.hypot(lat - spot[0], lon - spot[1]) < 0.05
    camera.shoot("via")
    x, y = program.ask("place 55.6 18.2")
    program.screen.click(x, y, 3)
    menu = program.wait("the menu", lambda: program.ask("@popup"))
    program.click_at(menu["items"][4]["rect"])
    program.wait("direct again", lambda: not program.ask("chart.view.ports.has_via"))
    wait_until_calm(program)


def turn_the_pages(program: Program, camera: Camera) -> None:
    """Compare departures and adopt one; find the ports in reach."""
    program.focus()
    program.screen.keys("ctrl+g")
    program.write("planning.departures.count_box", "4")
    program.click("planning.departures.run_button")
    program.wait_for("planning.departures.phase", "done", 120)
    camera.shoot("when-to-go")
    before = first_numbers(program)
    rows = [item for item in program.ask("planning.departures.table")["items"] if item["column"] == 0]
    program.click_at(rows[-1]["rect"])
    program.wait("the departure taken over", lambda: first_numbers(program)[0] > before[0])
    wait_until_calm(program)
    tabs = program.ask("planning.frame.tabs")["items"]
    program.click_at(tabs[1]["rect"])
    program.click("planning.reach.run_button")
    program.wait_for("planning.reach.phase", "done", 120)
    camera.shoot("where-to-go")
    assert program.ask("planning.reach.table")["items"]
    program.click("planning.frame.close_button")
    program.wait("the pages closed", lambda: not program.ask("planning.frame.is_open"))


def save_as_gpx(program: Program, target: Path, camera: Camera) -> Path:
    """Write a name into the dialog."""
    program.focus()
    program.screen.keys("ctrl+s")
    field = program.wait("the dialog", lambda: program.ask("@dialog.#fileNameEdit"))
    program.focus(str(field["window"]))
    camera.shoot("save")
    program.write("@dialog.#fileNameEdit", str(target))
    program.wait("the name", lambda: program.ask("@dialog.#fileNameEdit")["text"] == str(target))
    program.screen.keys("Return")
    program.wait("the file", target.is_file)
    program.focus()
    return target


def check_gpx(path: Path) -> None:
    """Hold the file against what a plotter reads: a route of named points, from port to port."""
    space = {"g": NAMESPACE}
    root = ET.parse(path).getroot()
    assert root.tag == f"{{{NAMESPACE}}}gpx"
    assert root.get("version") == "1.1"
    points = root.findall("g:rte/g:rtept", space)
    assert len(points) >= 3
    assert [p.findtext("g:name", "", space) for p in (points[0], points[-1])] == ["Gdynia", "Visby"]
    assert all(53.0 < float(p.attrib["lat"]) < 60.0 and 15.0 < float(p.attrib["lon"]) < 23.0 for p in points)
    times = [
        datetime.fromisoformat(t.text or "") for t in root.findall("g:trk/g:trkseg/g:trkpt/g:time", space)
    ]
    assert len(times) > len(points)
    assert times == sorted(times)


def look_at_every_size_and_light(program: Program, camera: Camera) -> None:
    """Change the size as a hand at the frame does, and the light by its keys."""
    program.wait(
        "the path of the file gone from the line below", lambda: not program.ask("statusBar.currentMessage")
    )
    for width, height in SIZES:
        program.resize(width, height)
        program.wait("the size", partial(has_size, program, width, height))
        for number, light in enumerate(LIGHTS, start=1):
            program.focus()
            program.screen.keys(f"ctrl+{number}")
            program.wait_for("layers.light", light)
            program.wait("the new light everywhere", partial(is_dressed, program))
            wait_until_calm(program)
            time.sleep(0.3)
            camera.shoot(f"{width}x{height}-{light}")
    program.resize(*SIZES[1])


def has_size(program: Program, width: int, height: int) -> bool:
    return bool(program.ask("centralWidget.window")["rect"][2:] == [width, height])


def is_dressed(program: Program) -> bool:
    return program.ask("wardrobe") is None or not program.ask("wardrobe.is_changing")


def everything_is_kept(program: Program, light: str) -> None:
    """See after another start that ports, yacht, forecast, light and size are as they were; no guide."""
    program.wait("the yachts", lambda: program.ask("form.yacht_box")["currentText"] == "Delphia 47")
    assert program.ask("form.start_field")["text"] == "Gdynia"
    assert program.ask("form.end_field")["text"] == "Visby"
    assert program.ask("form.forecast.0") == "sample"
    assert program.ask("layers.light") == light
    assert program.ask("habits.guide") is None
    assert program.ask("centralWidget.window")["rect"][2:] == list(SIZES[1])
    leave(program)


def leave(program: Program) -> None:
    """Quit by Ctrl+Q, without a complaint."""
    code, error = program.end()
    assert code == 0, error
    assert "Traceback" not in error


# -------------------------------------------------------------------------------------------- language


def test_another_language_while_it_computes(
    start: Callable[..., Program], screen: Screen, home: Path, tmp_path: Path
) -> None:
    screen.env.pop("SEACRUISE_LANGUAGE", None)
    program = start(
        "--from", "Gdynia", "--to", "Luleå", "--forecast", "sample", "--depart", "2016-11-20T06:00Z"
    )
    program.wait("the yachts", lambda: program.ask("form.yacht_box")["currentText"])
    screen.keys("ctrl+Return")
    program.wait("it computes", lambda: program.ask("state.phase") in {"computing", "route"})
    # By its letters: View, Language, the third entry.
    screen.keys("alt+v")
    program.wait("the menu", lambda: program.ask("@popup")["visible"])
    screen.keys("a")
    screen.keys("3")
    program.wait_for("form.calculate_button.text", CALCULATE["pl"])
    program.wait_for("state.phase", "route")
    assert program.ask("form.end_field")["text"] == "Luleå"
    assert float(program.ask("state.answer.passage.duration_h")) > 24.0
    wait_until_calm(program)
    Camera(program, Path(os.environ.get("SEACRUISE_SHOTS", tmp_path)), "pl").shoot("switched")
    program.window = str(program.ask("centralWidget")["window"])
    leave(program)
    again = start()
    again.wait("the yachts", lambda: again.ask("form.yacht_box")["currentText"])
    assert again.ask("form.calculate_button.text") == CALCULATE["pl"], "kept for the next start"
    leave(again)


# --------------------------------------------------------------------------------------------- closing


def test_closing_while_it_computes(start: Callable[..., Program], screen: Screen) -> None:
    program = start(
        "--from", "Gdynia", "--to", "Luleå", "--forecast", "sample", "--depart", "2016-11-20T06:00Z"
    )
    program.wait("the yachts", lambda: program.ask("form.yacht_box")["currentText"])
    screen.keys("ctrl+Return")
    program.wait("it computes", lambda: program.ask("state.phase") in {"computing", "route"})
    begun = time.monotonic()
    leave(program)
    assert time.monotonic() - begun < 20.0
