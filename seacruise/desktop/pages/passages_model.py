"""Saved passages for the window, without Qt: from its question and answer to the shelf, and back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from seacruise.desktop.compute import Answer, Question
from seacruise.passages import Asked, Entry, Listing, Opened, SavedPassages

if TYPE_CHECKING:
    from datetime import datetime
    from pathlib import Path

    from seacruise.ports import Port


def asked_of(question: Question) -> Asked:
    """Put the window's question into a saved passage's words."""
    return Asked(
        start=question.start,
        end=question.end,
        departure=question.departure,
        yacht=question.yacht,
        forecast=question.forecast,
        options=question.options,
        via=question.via,
        avoid=question.avoid,
        weights=question.weights,
    )


def answer_of(opened: Opened) -> Answer:
    """Give the answer that the window shows as if it had just been found."""
    asked = opened.asked
    question = Question(
        start=asked.start,
        end=asked.end,
        departure=asked.departure,
        yacht=asked.yacht,
        forecast=asked.forecast,
        options=asked.options,
        via=asked.via,
        avoid=asked.avoid,
        weights=asked.weights,
    )
    return Answer(opened.passage, opened.wind, question)


def form_values(asked: Asked) -> dict[str, Any]:
    """Give what fills the form in, by the names of the command line's options."""
    return {
        **asdict(asked.options),
        "start": _written(asked.start),
        "end": _written(asked.end),
        "depart": asked.departure,
        "yacht": asked.yacht.name,
        "forecast": asked.forecast,
        "weights": asked.weights,
    }


def _written(port: Port) -> str:
    return port.name or f"{port.lat:.4f}, {port.lon:.4f}"


@dataclass(frozen=True, slots=True)
class Done:
    """What became of something that was done on the shelf, and what is on it now.

    Attributes
    ----------
    value
        The `Entry` saved, the `Opened` passage, the new name, the number deleted or brought back.
    """

    value: Entry | Opened | str | int | None
    listing: Listing


def on_the_shelf(database: Path, do: Callable[[SavedPassages], Entry | Opened | str | int | None]) -> Done:
    """Do something with the saved passages and look at them again; for a worker.

    Raises
    ------
    SeaCruiseError
        In one sentence, why it was not done.
    """
    shelf = SavedPassages(database)
    value = do(shelf)
    return Done(value, shelf.listing())


def brought_back(shelf: SavedPassages, numbers: tuple[int, ...]) -> int:
    """Undo a deletion; gives how many came back."""
    return sum(shelf.restore(number) for number in numbers)


def deleted(shelf: SavedPassages, numbers: tuple[int, ...], now: datetime) -> int:
    """Take passages off the list; gives how many."""
    for number in numbers:
        shelf.delete(number, now=now)
    return len(numbers)
