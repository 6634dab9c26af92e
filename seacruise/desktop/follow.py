"""Which re-routing runs next while something is dragged: decisions only, without Qt or threads.

A drag asks sixty times a second for what takes longer than a frame. The newest wish wins: one that was not
begun is forgotten when another comes. What runs while the hand moves is let run to its end, or else the
chart would show nothing before the hand rests; what was begun at rest is superseded at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Generic, TypeVar

Wish = TypeVar("Wish")

QUICK_S: Final = 0.030
"""A precise re-routing that took longer than this [s] is done coarsely first: painting takes time as well."""


@dataclass(frozen=True, slots=True)
class Turn(Generic[Wish]):
    """One re-routing.

    Attributes
    ----------
    rough
        Coarsely: a precise one of the same wish follows when the hand rests.
    follows
        Begun while the hand moved; it is let run to its end.
    """

    wish: Wish
    rough: bool
    follows: bool


class Follow(Generic[Wish]):
    """Keeps what is wished, what runs, and what is still owed.

    ``ask``, ``rest`` and ``ended`` return the turn to begin now, superseding what runs, or ``None`` when
    there is nothing to begin.
    """

    def __init__(self) -> None:
        self._precise_s: float | None = None
        self.forget()

    def forget(self) -> None:
        """Drop everything but what is known about the pace."""
        self._moving = False
        self._next: Wish | None = None
        self._owed: Wish | None = None
        self._running: Turn[Wish] | None = None

    def took(self, precise_s: float) -> None:
        """Take note of the time [s] of a precise calculation."""
        self._precise_s = precise_s

    @property
    def is_busy(self) -> bool:
        """Whether anything runs, waits or is owed."""
        return not (self._running is None and self._next is None and self._owed is None)

    def ask(self, wish: Wish) -> Turn[Wish] | None:
        """Wish for something else: the hand moves."""
        self._next, self._moving = wish, True
        if self._running is not None and self._running.follows:
            return None
        return self._begin()

    def rest(self) -> Turn[Wish] | None:
        """Tell that the hand rests."""
        self._moving = False
        return self._begin() if self._running is None else None

    def ended(self, seconds: float) -> Turn[Wish] | None:
        """Tell that what ran has ended, with a passage or without."""
        turn, self._running = self._running, None
        if turn is not None:
            if turn.rough:
                self._owed = turn.wish
            else:
                self.took(seconds)
        return self._begin()

    def _begin(self) -> Turn[Wish] | None:
        slow = self._precise_s is None or self._precise_s > QUICK_S
        if self._next is not None:
            wish, rough = self._next, slow and self._moving
        elif self._owed is not None and not self._moving:
            wish, rough = self._owed, False
        else:
            return None
        self._next = self._owed = None
        self._running = Turn(wish, rough, follows=self._moving)
        return self._running
