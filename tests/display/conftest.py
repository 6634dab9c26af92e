"""A screen of its own for the real program; skips, saying so, where there is none."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
SCREEN = (1920, 1080)
SIZE = (1280, 800)


@dataclass
class Screen:
    """An X server without a monitor, and what a person would do at it."""

    display: str
    env: dict[str, str]

    def xdotool(self, *words: str) -> str:
        answer = subprocess.run(
            ["xdotool", *words], env=self.env, capture_output=True, text=True, timeout=30, check=False
        )
        assert answer.returncode == 0, f"xdotool {' '.join(words)}: {answer.stderr}"
        return answer.stdout.strip()

    def click(self, x: int, y: int, button: int = 1, times: int = 1) -> None:
        self.xdotool("mousemove", str(x), str(y), "click", "--repeat", str(times), str(button))

    def keys(self, *names: str) -> None:
        self.xdotool("key", *names)

    def type(self, text: str) -> None:
        self.xdotool("type", "--delay", "15", text)


@pytest.fixture(scope="session")
def x_server() -> Iterator[str]:
    if not sys.platform.startswith("linux"):
        pytest.skip("NO DISPLAY: Xvfb is for Linux")
    if absent := [name for name in ("Xvfb", "xdotool") if shutil.which(name) is None]:
        pytest.skip(f"NO DISPLAY: {' and '.join(absent)} not installed (apt-get install xvfb xdotool)")
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{SCREEN[0]}x{SCREEN[1]}x24", "-nolisten", "tcp"],
        pass_fds=(write,),
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    with os.fdopen(read) as pipe:
        number = pipe.readline().strip()
    try:
        if not number:
            pytest.skip("NO DISPLAY: Xvfb does not start here")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait(10)


@pytest.fixture
def screen(x_server: str) -> Screen:
    env = {k: v for k, v in os.environ.items() if k != "WAYLAND_DISPLAY"}
    env |= {"DISPLAY": x_server, "QT_QPA_PLATFORM": "xcb", "LC_ALL": "C.UTF-8"}
    return Screen(x_server, env)


class Program:
    """The program as it runs on the screen, at the upper left of it.

    Only `ask` reaches behind the screen: to learn where to point, and what is written there.
    """

    def __init__(self, screen: Screen, *words: str, size: tuple[int, int] | None = SIZE) -> None:
        self.screen = screen
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.display.runner", *words],
            cwd=REPOSITORY,
            env=screen.env,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        port = self.process.stdout.readline().strip()
        if not port:
            self._tell_death()
        self._line = socket.create_connection(("127.0.0.1", int(port)), timeout=60)
        self._answers = self._line.makefile("r", encoding="utf-8")
        self.window = self._wait_for_window()
        self.screen.xdotool("windowmove", self.window, "0", "0")
        if size is not None:
            self.resize(*size)
        self.focus()

    def _tell_death(self) -> NoReturn:
        error = self.process.communicate()[1]
        if "could not connect to display" in error or "platform plugin" in error:
            pytest.skip(f"NO DISPLAY: Qt's X libraries are not complete here: {error[:200]}")
        pytest.fail(f"the program ended with {self.process.returncode}: {error}")

    def _wait_for_window(self) -> str:
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            if self.process.poll() is not None:
                self._tell_death()
            found = subprocess.run(
                ["xdotool", "search", "--onlyvisible", "--name", "^SeaCruise$"],
                env=self.screen.env,
                capture_output=True,
                text=True,
                check=False,
            ).stdout.split()
            if found:
                return found[0]
            time.sleep(0.1)
        raise AssertionError("no window appeared within 60 s")

    def resize(self, width: int, height: int) -> None:
        self.screen.xdotool("windowsize", "--sync", self.window, str(width), str(height))

    def focus(self, window: str | None = None) -> None:
        """Give a window the keyboard, as a window manager does, which there is none."""
        self.screen.xdotool("windowfocus", "--sync", window or self.window)

    # --- what is there ------------------------------------------------------------------------------

    def ask(self, path: str) -> Any:
        """Where a part of the window is and what it says, see `tests.display.runner`."""
        try:
            self._line.sendall(f"{path}\n".encode())
            answer = json.loads(self._answers.readline())
        except (OSError, ValueError):
            self._tell_death()
        if "error" in answer:
            raise LookupError(answer["error"])
        return answer["is"]

    def wait(self, what: str, condition: Callable[[], object], seconds: float = 60.0) -> Any:
        """Wait until something is so; a part that is not there yet is not so."""
        deadline = time.monotonic() + seconds
        while True:
            try:
                if outcome := condition():
                    return outcome
            except LookupError:
                pass
            assert time.monotonic() < deadline, f"{what}: not within {seconds:.0f} s"
            time.sleep(0.1)

    def wait_for(self, path: str, value: object = True, seconds: float = 60.0) -> None:
        self.wait(f"{path} = {value}", lambda: self.ask(path) == value, seconds)

    # --- what a hand does ---------------------------------------------------------------------------

    def click(self, path: str, button: int = 1) -> None:
        """Click into the middle of a part that can be seen."""
        part = self.wait(f"{path} in sight", lambda: (said := self.ask(path))["visible"] and said)
        self.click_at(part["rect"], button)

    def click_at(self, rect: list[int], button: int = 1) -> None:
        self.screen.click(*middle(rect), button)

    def click_item(self, path: str, text: str) -> None:
        """Click on the entry of a list or a table that has a text, or something behind it."""
        entry = self.wait(f"“{text}” in {path}", lambda: self._item(path, text))
        self.click_at(entry["rect"])

    def _item(self, path: str, text: str) -> dict[str, Any] | None:
        items = self.ask(path)["items"]
        return next((item for item in items if text in {item["text"], item["data"]}), None)

    def write(self, path: str, text: str) -> None:
        """Click into a field and write, in place of what is there."""
        self.click(path)
        self.wait(f"the keyboard in {path}", lambda: self.ask(path)["focus"])
        self.screen.keys("ctrl+a")
        self.screen.type(text)

    def drag(self, begin: tuple[int, int], end: tuple[int, int], steps: int = 8) -> None:
        """Press, move in steps, let go."""
        self.screen.xdotool("mousemove", *map(str, begin), "mousedown", "1")
        for k in range(1, steps + 1):
            at = (round(a + (b - a) * k / steps) for a, b in zip(begin, end, strict=True))
            self.screen.xdotool("mousemove", *map(str, at))
            time.sleep(0.03)
        self.screen.xdotool("mouseup", "1")

    def end(self) -> tuple[int, str]:
        """Close it as Ctrl+Q does, and return its exit code and what it wrote."""
        self.focus()
        self.screen.keys("ctrl+q")
        try:
            _, error = self.process.communicate(timeout=30)
        finally:
            self.kill()
        return self.process.returncode, error

    def kill(self) -> None:
        """End it in any way; after `end` there is nothing left to do."""
        self._answers.close()
        self._line.close()
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()


def middle(rect: list[int]) -> tuple[int, int]:
    """Middle of left, top, width, height."""
    return rect[0] + rect[2] // 2, rect[1] + rect[3] // 2


@pytest.fixture
def home(own_home: None) -> Path:
    return Path(os.environ["SEACRUISE_HOME"])
