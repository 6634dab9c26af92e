"""What is still being loaded, and what waits until it is there."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal


class Loading(QObject):
    """Names of what is awaited; ``ready()`` once, when everything has been loaded for the first time.

    Parameters
    ----------
    awaited
        What is loaded first.
    """

    ready = Signal()

    def __init__(self, *awaited: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._awaited = set(awaited)
        self._was_ready = False
        self._then: Callable[[], object] | None = None

    @property
    def is_done(self) -> bool:
        """Whether nothing is awaited."""
        return not self._awaited

    @property
    def holds(self) -> bool:
        """Whether something waits for it."""
        return self._then is not None

    def begin(self, what: str) -> None:
        """Await something, maybe again."""
        self._awaited.add(what)

    def end(self, what: str) -> None:
        """Note that something is there, or will not come; what waited for the last one is done now."""
        if what not in self._awaited:
            return
        self._awaited.discard(what)
        if self._awaited:
            return
        if not self._was_ready:
            self._was_ready = True
            self.ready.emit()
        then, self._then = self._then, None
        if then is not None:
            then()

    def then(self, do: Callable[[], object]) -> None:
        """Do something as soon as nothing is awaited; only the last wish counts."""
        self._then = do

    def forget(self) -> bool:
        """Let nothing wait any more; False when nothing did."""
        held, self._then = self._then is not None, None
        return held
