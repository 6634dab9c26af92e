"""The weather along the passage: a picture over time that is moved through with mouse and keys."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
)
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from seacruise.desktop.language import fill
from seacruise.desktop.log_words import day_and_time
from seacruise.desktop.meteogram_picture import Frame, Picture, frame_of
from seacruise.desktop.meteogram_series import Moment, Series, series_of
from seacruise.desktop.style import FOCUS, MAGENTA, scaled_font, tinted
from seacruise.desktop.units_choice import height_text, units_choice, wind_text
from seacruise.export.textform import format_course

if TYPE_CHECKING:
    from seacruise.passage import Passage
    from seacruise.weather.wind import Wind

_STEPS_MIN: Final = {
    Qt.Key.Key_Left: -6,
    Qt.Key.Key_Right: 6,
    Qt.Key.Key_Down: -6,
    Qt.Key.Key_Up: 6,
    Qt.Key.Key_PageDown: 60,
    Qt.Key.Key_PageUp: -60,
}


def _tr(text: str) -> str:
    return QCoreApplication.translate("meteogram", text)


def moment_words(moment: Moment) -> list[str]:
    """Say everything about a moment under way: wind, boat, sea, each in a line."""
    wind = _tr("wind {speed} from {direction}").format(
        speed=wind_text(moment.tws_kn), direction=format_course(moment.twd_deg)
    )
    if moment.gust_kn is not None:
        wind += _tr(", gusts {speed}").format(speed=wind_text(moment.gust_kn))
    side = {"port": _tr("port"), "starboard": _tr("starboard"), "engine": _tr("engine")}[moment.tack]
    boat = fill(
        _tr("{speed:.1f} kn, TWA {angle:.0f}° {side}"),
        speed=moment.boat_speed_kn,
        angle=moment.twa_deg,
        side=side,
    )
    lines = [wind, boat]
    if moment.wave_m is not None:
        lines.append(_tr("waves {height}").format(height=height_text(moment.wave_m)))
    if moment.current_kn is not None and moment.current_to_deg is not None:
        lines.append(
            fill(
                _tr("current {speed:.1f} kn setting {direction}"),
                speed=moment.current_kn,
                direction=format_course(moment.current_to_deg),
            )
        )
    if moment.beyond_forecast:
        lines.append(_tr("after the end of the forecast"))
    return lines


class Meteogram(QWidget):
    """The picture, and in it the moment that slider and chart show.

    Left and right go six minutes, Page Up and Page Down an hour, Home and End to departure and arrival; a
    click or a drag goes anywhere. ``moment_chosen(datetime)`` when it is done here.
    """

    moment_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumHeight(70)
        self.setAccessibleName(self.tr("Weather along the passage"))
        self._series: Series | None = None
        self._moment: datetime | None = None
        self._light = "day"
        self._font = scaled_font(self.font(), 0.88)
        self._kept: tuple[QPixmap, Frame] | None = None
        units_choice().changed.connect(self._forget)

    def show_passage(self, passage: Passage | None, wind: Wind | None = None) -> None:
        """Show a passage and the wind it was found in, or none."""
        self._series = None if passage is None else series_of(passage, wind)
        self._forget()
        self._tell()

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light: ``day``, ``dusk`` or ``night``."""
        self._light = light
        self._forget()

    def show_time(self, moment: datetime) -> None:
        """Move the line to a moment, without a word to anybody."""
        self._moment = moment
        self._tell()
        self.update()

    @property
    def moment(self) -> Moment | None:
        """Everything at the moment that is marked."""
        if self._series is None:
            return None
        return self._series.at(self._moment or datetime.fromtimestamp(self._series.begin, UTC))

    def words(self) -> str:
        """Say the moment that is marked in one line; empty while there is no passage."""
        moment = self.moment
        if moment is None:
            return ""
        return ", ".join([day_and_time(self._moment or moment.time), *moment_words(moment)])

    def brief_words(self) -> str:
        """Say wind and boat at the moment that is marked; empty while there is no passage."""
        moment = self.moment
        if moment is None:
            return ""
        return ", ".join([day_and_time(self._moment or moment.time), *moment_words(moment)[:2]])

    def sizeHint(self) -> QSize:
        """Room for two panels."""
        return QSize(640, 180)

    def _forget(self) -> None:
        self._kept = None
        self.update()

    def _tell(self) -> None:
        self.setAccessibleDescription(self.words())

    # --- moving ---------------------------------------------------------------------------------------

    def _go(self, time: float) -> None:
        series = self._series
        if series is None:
            return
        moment = datetime.fromtimestamp(min(max(time, series.begin), series.end), UTC)
        self.show_time(moment)
        self.moment_chosen.emit(moment)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go through the passage."""
        key, series = Qt.Key(event.key()), self._series
        if series is None or event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
            super().keyPressEvent(event)
            return
        now = self._moment.timestamp() if self._moment else series.begin
        if key in _STEPS_MIN:
            self._go(now + timedelta(minutes=_STEPS_MIN[key]).total_seconds())
        elif key == Qt.Key.Key_Home:
            self._go(series.begin)
        elif key == Qt.Key.Key_End:
            self._go(series.end)
        else:
            super().keyPressEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Go where the pointer is."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._follow(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go where the pointer is dragged."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._follow(event.position())

    def _follow(self, at: QPointF) -> None:
        if self._series is not None:
            self._go(self._frame().time(at.x()))

    def event(self, event: QEvent) -> bool:
        """Tell what is under the pointer."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent) and self._series is not None:
            time = datetime.fromtimestamp(self._frame().time(event.pos().x()), UTC)
            lines = [day_and_time(time), *moment_words(self._series.at(time))]
            QToolTip.showText(event.globalPos(), "\n".join(lines), self)
            return True
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show where the keys go."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Show that the keys go elsewhere."""
        super().focusOutEvent(event)
        self.update()

    # --- drawing --------------------------------------------------------------------------------------

    def _frame(self) -> Frame:
        assert self._series is not None
        return self._kept[1] if self._kept else frame_of(self._series, QRectF(self.rect()), self._font)

    def _picture(self) -> QPixmap:
        """Give the picture, drawn anew only when it would be another one."""
        density = self.devicePixelRatioF()
        size = QSize(round(self.width() * density), round(self.height() * density))
        if self._kept is not None and self._kept[0].size() == size:
            return self._kept[0]
        assert self._series is not None
        pixmap = QPixmap(size)
        pixmap.setDevicePixelRatio(density)
        pixmap.fill(Qt.GlobalColor.transparent)
        frame = frame_of(self._series, QRectF(self.rect()), self._font)
        painter = QPainter(pixmap)
        Picture(painter, self._series, frame, font=self._font, light=self._light).draw()
        painter.end()
        self._kept = (pixmap, frame)
        return pixmap

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the picture, and the moment on it."""
        del event
        if self._series is None or self.width() < 200:
            return
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._picture())
        if self._moment is not None:
            frame = self._frame()
            x = frame.x(min(max(self._moment.timestamp(), self._series.begin), self._series.end))
            painter.setPen(QPen(QColor(tinted(MAGENTA, self._light)), 1.6))
            painter.drawLine(QPointF(x, frame.plot.top()), QPointF(x, frame.plot.bottom()))
        if self.hasFocus():
            painter.setPen(QPen(QColor(tinted(FOCUS, self._light)), 1.5))
            painter.drawRect(self.rect().adjusted(1, 1, -2, -2))
        painter.end()
