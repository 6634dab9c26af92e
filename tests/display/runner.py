"""Opens the window as ``seacruise window`` does, and tells on a loopback socket where its parts are.

The tests drive it with a real mouse and real keys; what they ask here is only where to point, and what can be
read. A request is a line: ``form.start_field``, attributes from the main window on, ``menus.exports.0`` with
numbers for members of a list, ``@dialog.#fileNameEdit`` with the name of a widget, ``place 54.5 18.6`` for
the pixel of a position on the chart, ``shoot FILE`` for a picture of the screen. The answer is a line of
JSON.
"""

from __future__ import annotations

import json
import sys
from enum import Enum
from typing import Any

from PySide6.QtCore import QAbstractItemModel, QRect, Qt
from PySide6.QtGui import QAction
from PySide6.QtNetwork import QHostAddress, QTcpServer, QTcpSocket
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QMainWindow,
    QMenu,
    QMenuBar,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QTabBar,
    QWidget,
)

from seacruise.cli import main


def main_window() -> QMainWindow:
    windows = [w for w in QApplication.topLevelWidgets() if isinstance(w, QMainWindow)]
    # One that another takes the place of is hidden, and gone soon.
    return next((w for w in windows if w.isVisible()), windows[0])


def find(path: str) -> Any:
    """What a path names: from the main window, or ``@popup``, ``@menu`` and ``@dialog``, those on top."""
    first, *names = path.split(".")
    thing: Any
    if first == "@popup":
        thing = QApplication.activePopupWidget()
    elif first == "@dialog":
        dialogs = [w for w in QApplication.topLevelWidgets() if w.isWindow() and w.isVisible()]
        thing = next((w for w in dialogs if w is not main_window() and not isinstance(w, QMenu)), None)
    else:
        thing, names = main_window(), [first, *names]
    for name in names:
        if name.startswith("#"):
            thing = thing.findChild(QWidget, name[1:])
        elif name.lstrip("-").isdigit():
            thing = thing[int(name)]
        else:
            thing = getattr(thing, name)
            thing = thing() if callable(thing) and not isinstance(thing, Enum) else thing
    return thing


def rect_of(widget: QWidget, rect: QRect | None = None) -> list[int]:
    """Left, top, width, height on the screen."""
    rect = widget.rect() if rect is None else rect
    at = widget.mapToGlobal(rect.topLeft())
    return [at.x(), at.y(), rect.width(), rect.height()]


def items_of(view: QAbstractItemView) -> list[dict[str, Any]]:
    """Cells that are in sight."""
    model: QAbstractItemModel = view.model()
    cells = []
    for row in range(min(model.rowCount(view.rootIndex()), 400)):
        for column in range(model.columnCount(view.rootIndex())):
            index = model.index(row, column, view.rootIndex())
            rect = view.visualRect(index).intersected(view.viewport().rect())
            if not rect.isEmpty():
                texts = [
                    str(index.data(role)) for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.UserRole)
                ]
                cells.append({"text": texts[0], "data": texts[1], "row": row, "column": column})
                cells[-1]["rect"] = rect_of(view.viewport(), rect)
    return cells


def describe(thing: Any) -> Any:
    """Where a thing is and what it says."""
    if thing is None or isinstance(thing, str | int | float | bool):
        return thing
    if isinstance(thing, Enum):
        return thing.value
    if isinstance(thing, QAction):
        return {"text": thing.text(), "enabled": thing.isEnabled(), "on": thing.isChecked()}
    if not isinstance(thing, QWidget):
        return str(thing)
    said: dict[str, Any] = {
        "kind": type(thing).__name__,
        "name": thing.objectName(),
        "rect": rect_of(thing),
        "visible": thing.isVisible(),
        "enabled": thing.isEnabled(),
        "focus": thing.hasFocus(),
        "window": int(thing.window().winId()),
    }
    for name in ("text", "currentText", "value", "isChecked"):
        if callable(ask := getattr(thing, name, None)):
            said[name] = ask()
    if isinstance(thing, QMenu | QMenuBar):
        said["items"] = [
            {"text": a.text(), "enabled": a.isEnabled(), "rect": rect_of(thing, thing.actionGeometry(a))}
            for a in thing.actions()
            if not a.isSeparator()
        ]
    elif isinstance(thing, QTabBar):
        said["items"] = [
            {"text": thing.tabText(k), "rect": rect_of(thing, thing.tabRect(k))} for k in range(thing.count())
        ]
    elif isinstance(thing, QAbstractItemView):
        said["items"] = items_of(thing)
    elif isinstance(thing, QSlider):
        option = QStyleOptionSlider()
        thing.initStyleOption(option)
        control, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        said["handle"] = rect_of(thing, thing.style().subControlRect(control, option, part, thing))
    return said


class Teller(QTcpServer):
    """Answers one line with one line, on the window's own thread."""

    def __init__(self) -> None:
        super().__init__()
        self.newConnection.connect(self._meet)
        self.listen(QHostAddress(QHostAddress.SpecialAddress.LocalHost), 0)

    def _meet(self) -> None:
        socket = self.nextPendingConnection()
        socket.readyRead.connect(lambda: self._answer(socket))
        socket.disconnected.connect(socket.deleteLater)

    def _answer(self, socket: QTcpSocket) -> None:
        while socket.canReadLine():
            path = bytes(socket.readLine().data()).decode().strip()
            try:
                answer = {"is": answer_to(path)}
            except (AttributeError, LookupError, TypeError, ValueError, RuntimeError, StopIteration) as error:
                answer = {"error": f"{path}: {error!r}"}
            socket.write(json.dumps(answer).encode() + b"\n")


def place(lat: float, lon: float) -> list[int]:
    """Pixel of a position on the chart."""
    from seacruise.desktop.chart.plane import point

    view: Any = find("chart.view")
    at = view.viewport().mapToGlobal(view.mapFromScene(point(lat, lon)))
    return [at.x(), at.y()]


def shoot(target: str) -> bool:
    """Picture of the screen within the window's frame, whatever lies over it."""
    size = main_window().size()
    return QApplication.primaryScreen().grabWindow(0, 0, 0, size.width(), size.height()).save(target)


def answer_to(request: str) -> Any:
    """What a line asks for."""
    word, _, rest = request.partition(" ")
    if word == "place":
        return place(*map(float, rest.split()))
    return shoot(rest) if word == "shoot" else describe(find(request))


if __name__ == "__main__":
    app = QApplication(sys.argv[:1])
    teller = Teller()
    sys.stdout.write(f"{teller.serverPort()}\n")
    sys.stdout.flush()
    sys.exit(main(["window", *sys.argv[1:]]))
