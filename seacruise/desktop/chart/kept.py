"""The things used last, as long as they are not too large together."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Kept(Generic[Key, Value]):
    """Keeps values by key, and lets go of those that were not asked for the longest.

    Parameters
    ----------
    most
        Size of all of them together; the one that was put last stays, however large it is.
    size
        Tells the size of one.
    """

    def __init__(self, most: int, size: Callable[[Value], int]) -> None:
        self._most, self._size = most, size
        self._values: OrderedDict[Key, Value] = OrderedDict()
        self.total = 0

    def __len__(self) -> int:
        return len(self._values)

    def get(self, key: Key) -> Value | None:
        """Give what was put, unless it is gone."""
        value = self._values.get(key)
        if value is not None:
            self._values.move_to_end(key)
        return value

    def put(self, key: Key, value: Value) -> Value:
        """Keep a value for a key that has none, and give it back."""
        self._values[key] = value
        self.total += self._size(value)
        while self.total > self._most and len(self._values) > 1:
            _, gone = self._values.popitem(last=False)
            self.total -= self._size(gone)
        return value
