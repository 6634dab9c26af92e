"""The passages asked for lately, in a menu: one click fills the form in and calculates."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from datetime import datetime
from typing import Any, Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMenu

from seacruise.desktop.units_choice import moment_text
from seacruise.ports import Port

KEPT: Final = 10

_LONGEST: Final = 28
"""Characters of a name in the menu."""

_SAME: Final = ("start", "end", "yacht", "forecast", "via")


class RecentPassages(QObject):
    """Keeps the last questions, newest first; ``chosen(values)`` when one is asked again.

    A question is what `PassageForm.contents` gave then, with the place sailed by under ``"via"``. Of
    questions that differ in the departure or the options alone only the newest is kept.

    Parameters
    ----------
    menu
        Shows them.
    """

    chosen = Signal(object)

    def __init__(self, menu: QMenu, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._menu = menu
        self.questions: list[dict[str, Any]] = []
        menu.aboutToShow.connect(self._fill)
        self._fill()

    def note(self, values: Mapping[str, Any], via: Port | None = None) -> None:
        """Keep a question that was asked."""
        question = dict(values)
        if via is not None:
            question["via"] = {"name": via.name, "lat": via.lat, "lon": via.lon}
        others = [q for q in self.questions if any(q.get(name) != question.get(name) for name in _SAME)]
        self.questions = [question, *others][:KEPT]
        self._fill()

    def clear(self) -> None:
        """Forget them all."""
        self.questions = []
        self._fill()

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start."""
        return {"asked": list(self.questions)}

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Take over what `contents` gave; what is no question, as in a damaged file, is passed over."""
        asked = kept.get("asked")
        found = [q for q in asked if isinstance(q, dict)] if isinstance(asked, list) else []
        self.questions = [q for q in found if _is_text(q, "start") and _is_text(q, "end")][:KEPT]
        self._fill()

    def _fill(self) -> None:
        self._menu.clear()
        for number, question in enumerate(self.questions, start=1):
            key = f"&{number % 10} " if number <= 10 else ""
            action = self._menu.addAction(key + self._title(question).replace("&", "&&"))
            action.triggered.connect(lambda _on=False, asked=question: self.chosen.emit(dict(asked)))
        if not self.questions:
            self._menu.addAction(self.tr("None yet: what you calculate appears here")).setEnabled(False)
        self._menu.addSeparator()
        clear = self._menu.addAction(self.tr("&Clear this list"))
        clear.setEnabled(bool(self.questions))
        clear.triggered.connect(lambda _on=False: self.clear())

    def _title(self, question: Mapping[str, Any]) -> str:
        """Say in a line what was asked."""
        ends = self.tr("{start} – {end}").format(start=_short(question, "start"), end=_short(question, "end"))
        via = via_of(question)
        parts = [ends, self.tr("via {place}").format(place=via.name) if via is not None else ""]
        parts.append(_short(question, "yacht"))
        with suppress(ValueError):
            parts.append(moment_text(datetime.fromisoformat(str(question.get("depart")))))
        return ", ".join(part for part in parts if part)


def via_of(question: Mapping[str, Any]) -> Port | None:
    """Give the place that a question is led by."""
    kept = question.get("via")
    if not isinstance(kept, dict):
        return None
    lat, lon = kept.get("lat"), kept.get("lon")
    if not (isinstance(lat, int | float) and isinstance(lon, int | float)):
        return None
    if not (-90.0 <= lat <= 90.0 and -180.0 <= lon <= 180.0):
        return None
    return Port(str(kept.get("name") or ""), "", float(lat), float(lon))


def _is_text(question: Mapping[str, Any], name: str) -> bool:
    return isinstance(question.get(name), str) and bool(str(question[name]).strip())


def _short(question: Mapping[str, Any], name: str) -> str:
    text = str(question.get(name) or "")
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
