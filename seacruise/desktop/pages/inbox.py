"""What a worker hands over before it is done: a plain box, so that no worker touches the window."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

Item = TypeVar("Item")


class Inbox(Generic[Item]):
    """Items in the order they were put in; one thread fills it, another one empties it.

    Put an item in *before* reporting progress: the report wakes the window, which then empties the box.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._items: list[Item] = []

    def put(self, item: Item) -> None:
        """Hand an item over."""
        with self._lock:
            self._items.append(item)

    def take(self) -> list[Item]:
        """Take out what is there."""
        with self._lock:
            items, self._items = self._items, []
        return items
