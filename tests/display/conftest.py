"""A screen of its own for the real program; skips, saying so, where there is none."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
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
        ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24", "-nolisten", "tcp"],
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
    """The program as it runs on the screen."""

    def __init__(self, screen: Screen, *words: str) -> None:
        self.screen = screen
        self.process = subprocess.Popen(
            [sys.executable, "-m", "seacruise", "window", *words],
            cwd=REPOSITORY,
            env=screen.env,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.window = self._wait_for_window()

    def _wait_for_window(self) -> str:
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            if self.process.poll() is not None:
                error = self.process.communicate()[1]
                if "could not connect to display" in error or "platform plugin" in error:
                    pytest.skip(f"NO DISPLAY: Qt's X libraries are not complete here: {error[:200]}")
                pytest.fail(f"the program ended with {self.process.returncode}: {error}")
            found = subprocess.run(
                ["xdotool", "search", "--onlyvisible", "--name", "^SeaCruise$"],
                env=self.screen.env,
                capture_output=True,
                text=True,
                check=False,
            ).stdout.split()
            if found:
                self.screen.xdotool("windowmove", found[0], "0", "0")
                self.screen.xdotool("windowsize", "--sync", found[0], *map(str, SIZE))
                # Without a window manager nobody gives the window the keyboard.
                self.screen.xdotool("windowfocus", found[0])
                return found[0]
            time.sleep(0.1)
        raise AssertionError("no window appeared within 60 s")

    def end(self) -> tuple[int, str]:
        """Close it as Ctrl+Q does, and return its exit code and what it wrote."""
        self.screen.keys("ctrl+q")
        try:
            _, error = self.process.communicate(timeout=30)
        finally:
            self.process.kill()
        return self.process.returncode, error


@pytest.fixture
def home(own_home: None) -> Path:
    return Path(os.environ["SEACRUISE_HOME"])
