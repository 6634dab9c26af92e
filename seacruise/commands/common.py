"""What the sub-commands share: reading arguments, showing progress, stopping on Ctrl+C."""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

from seacruise.errors import InputError
from seacruise.progress import Job
from seacruise.settings import typed_path
from seacruise.text import parse_number


class Parser(argparse.ArgumentParser):
    """Argument parser whose complaint is one sentence, raised as an `InputError`."""

    def __init__(self, **kwargs: Any) -> None:
        # Abbreviated options would change their meaning with every option that is added.
        super().__init__(allow_abbrev=False, **kwargs)

    def error(self, message: str) -> NoReturn:
        """Raise instead of printing the usage and leaving."""
        raise InputError(f"{message[:1].upper()}{message[1:]}; see {self.prog} --help.", reason="usage")


def add_format(parser: argparse.ArgumentParser) -> None:
    """Add ``--format``, which every sub-command has."""
    parser.add_argument(
        "--format",
        choices=("text", "json"),
        default="text",
        help="what is printed on standard output (default: text)",
    )


def parse_time(text: str) -> datetime:
    """Read an ISO 8601 time; UTC unless it has an offset.

    Raises
    ------
    argparse.ArgumentTypeError
        It is none; the sentence shows a good one.
    """
    try:
        time = datetime.fromisoformat(text.strip())
        return time.replace(tzinfo=UTC) if time.tzinfo is None else time.astimezone(UTC)
    except (ValueError, OverflowError):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a time; write it as 2016-11-20T06:00Z or 2016-11-20T07:00+01:00"
        ) from None


def number_between(low: float, high: float, unit: str) -> Callable[[str], float]:
    """Reader of a number within limits, both included, for ``type=`` of an argument."""

    def read(text: str) -> float:
        value = parse_number(text)
        if value is None or not low <= value <= high:
            raise argparse.ArgumentTypeError(f"{text!r} is not a number from {low:g} to {high:g} {unit}")
        return value

    return read


def whole_number_between(low: int, high: int, unit: str) -> Callable[[str], int]:
    """Reader of a whole number within limits, both included, for ``type=`` of an argument."""
    read_number = number_between(low, high, unit)

    def read(text: str) -> int:
        value = read_number(text)
        if value != int(value):
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number of {unit}")
        return int(value)

    return read


def parse_size(text: str) -> tuple[int, int]:
    """Read a window size such as ``1280x800`` [pixels]."""
    parts = [parse_number(part) for part in text.lower().split("x")]
    if len(parts) != 2 or any(p is None or not 100 <= p <= 10_000 or p != int(p) for p in parts):
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 1280x800")
    width, height = (int(p) for p in parts if p is not None)
    return width, height


def parse_path(text: str) -> Path:
    """Read a path; ``~`` is the home folder."""
    if not text.strip():
        raise argparse.ArgumentTypeError("a file name is missing")
    return typed_path(text)


class TerminalReport:
    """Progress on standard error: one line that is rewritten on a terminal, else a line a stage."""

    def __init__(self) -> None:
        self._live = sys.stderr.isatty()
        self._last = ""

    def __call__(self, stage: str, fraction: float | None, message: str) -> None:
        """Show a stage, its share done and its message; see `seacruise.progress.Report`."""
        text = message or stage
        if self._live:
            share = "" if fraction is None else f" {fraction:4.0%}"
            sys.stderr.write(f"\r\x1b[K{text}{share}")
        elif stage != self._last:
            sys.stderr.write(f"{text}\n")
        sys.stderr.flush()
        self._last = stage

    def clear(self) -> None:
        """Leave the line empty for what comes next."""
        if self._live and self._last:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


@contextmanager
def cancellable_job() -> Iterator[Job]:
    """Job that reports to the terminal and ends, without loss, at the first Ctrl+C; the second is harsh."""
    report = TerminalReport()
    job = Job(report=report)

    def interrupt(_signal: int, _frame: FrameType | None) -> None:
        if job.cancel.is_set():
            raise KeyboardInterrupt
        job.cancel.set()

    before = signal.signal(signal.SIGINT, interrupt)
    try:
        yield job
    finally:
        signal.signal(signal.SIGINT, before)
        report.clear()


def say(message: str) -> None:
    """Write a message for the reader to standard error."""
    print(message, file=sys.stderr)
