"""The picture of the weather along a passage: wind, boat and sea over time, drawn once and kept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QDate, QLocale, QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from seacruise.desktop.daylight import Light
from seacruise.desktop.language import fill
from seacruise.desktop.meteogram_series import ENGINE, PORT, Series
from seacruise.desktop.pages.plot import HOURS_PER_DAY, Scale, ticks_h
from seacruise.desktop.style import (
    ACCENT,
    CARD,
    INK,
    LINE,
    MAGENTA,
    MUTED,
    PORT_TACK,
    STARBOARD_TACK,
    WARNING_INK,
    tinted,
)
from seacruise.desktop.units_choice import (
    height_unit,
    height_value,
    in_zone,
    wind_unit,
    wind_value,
)
from seacruise.units import SECONDS_PER_HOUR

Array = NDArray[np.float64]

_SIDE_PX: Final = 42.0
_TOP_PX: Final = 4.0
_GAP_PX: Final = 7.0
_ARROWS_PX: Final = 20.0
_RIBBON_PX: Final = 5.0
_TICK_PX: Final = 78.0
_ARROW_EVERY_PX: Final = 34.0
_BOAT_FROM_PX: Final = 84.0
_SEA_FROM_PX: Final = 150.0
"""Below these heights another panel would leave nothing of those above it."""

_MOST_TICKS: Final = 5
_STEPS: Final = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0)
_SHADES: Final = {Light.TWILIGHT: 20, Light.NIGHT: 46}


def _tr(text: str) -> str:
    return QCoreApplication.translate("meteogram", text)


@dataclass(frozen=True, slots=True)
class Frame:
    """Where the picture's time runs.

    Attributes
    ----------
    hours
        Hours since 1970 in the chosen zone to pixels.
    shift_h
        What the zone is ahead of UTC [h].
    plot
        Everything between the axes.
    """

    hours: Scale
    shift_h: float
    plot: QRectF

    def x(self, time: float) -> float:
        """Pixel of a time [s since 1970]."""
        return self.hours.to_px(time / SECONDS_PER_HOUR + self.shift_h)

    def time(self, x: float) -> float:
        """Time [s since 1970] at a pixel, within the passage."""
        scale = self.hours
        share = min(max((x - scale.begin) / (scale.end - scale.begin), 0.0), 1.0)
        return (scale.low + share * (scale.high - scale.low) - self.shift_h) * SECONDS_PER_HOUR


def frame_of(series: Series, room: QRectF, font: QFont) -> Frame:
    """Lay the axes out in some room."""
    offset = in_zone(datetime.fromtimestamp(series.begin, UTC)).utcoffset()
    shift_h = offset.total_seconds() / SECONDS_PER_HOUR if offset is not None else 0.0
    foot = QFontMetricsF(font).height() + 3.0
    plot = room.adjusted(_SIDE_PX, _TOP_PX, -_SIDE_PX, -foot)
    low = series.begin / SECONDS_PER_HOUR + shift_h
    high = max(series.end / SECONDS_PER_HOUR + shift_h, low + 1e-3)
    return Frame(Scale(low, high, plot.left(), plot.right()), shift_h, plot)


class Picture:
    """Draws a series into a frame.

    Parameters
    ----------
    light
        ``day``, ``dusk`` or ``night``.
    """

    def __init__(self, painter: QPainter, series: Series, frame: Frame, *, font: QFont, light: str) -> None:
        self._painter, self._series, self._frame, self._light = painter, series, frame, light
        self._metrics = QFontMetricsF(font)
        painter.setFont(font)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._x = np.interp(
            series.time,
            [series.begin, max(series.end, series.begin + 1.0)],
            [frame.plot.left(), frame.plot.right()],
        )

    def _colour(self, name: str, alpha: int = 255) -> QColor:
        colour = QColor(tinted(name, self._light))
        colour.setAlpha(alpha)
        return colour

    def draw(self) -> None:
        """Draw everything but what moves."""
        series, plot = self._series, self._frame.plot
        shares = [1.15, 1.0] if plot.height() >= _BOAT_FROM_PX else [1.0]
        has_sea = series.weather.wave_m is not None or series.weather.current_kn is not None
        if has_sea and plot.height() >= _SEA_FROM_PX:
            shares.append(0.6)
        unit = (plot.height() - _ARROWS_PX - _GAP_PX * (len(shares) - 1)) / sum(shares)
        panels, top = [], plot.top() + _ARROWS_PX
        for share in shares:
            panels.append(QRectF(plot.left(), top, plot.width(), max(unit * share, 8.0)))
            top += unit * share + _GAP_PX
        self._shade()
        self._times(panels)
        self._arrows()
        self._wind(panels[0])
        if len(panels) > 1:
            self._boat(panels[1])
        if len(panels) > 2:
            self._sea(panels[2])

    # --- ground ---------------------------------------------------------------------------------------

    def _shade(self) -> None:
        """Shade twilight and night; hatch what is beyond the end of the forecast."""
        frame, plot = self._frame, self._frame.plot
        for light, begin, end in self._series.lights:
            if light is not Light.DAY:
                left, right = frame.x(begin), frame.x(end)
                box = QRectF(left, plot.top(), right - left, plot.height())
                # By night the ground is nearly black already: the dark is told by what is a little lighter.
                colour = QColor("#203060" if self._light == "day" else "#000000")
                colour = QColor("#5A2A20") if self._light == "night" else colour
                colour.setAlpha(_SHADES[light] * (2 if self._light == "dusk" else 1))
                self._painter.fillRect(box, colour)
        if self._series.horizon < self._series.end:
            left = max(frame.x(self._series.horizon), plot.left())
            box = QRectF(left, plot.top(), plot.right() - left, plot.height())
            self._painter.fillRect(box, QBrush(self._colour(MUTED, 90), Qt.BrushStyle.BDiagPattern))
            text = _tr("after the forecast")
            if box.width() > self._metrics.horizontalAdvance(text) + 8:
                self._text(box.right() - 4, plot.bottom() - 3, text, MUTED, Qt.AlignmentFlag.AlignRight)

    def _times(self, panels: list[QRectF]) -> None:
        frame, plot, painter = self._frame, self._frame.plot, self._painter
        most = max(2, int(plot.width() / _TICK_PX))
        for panel in panels:
            painter.setPen(QPen(self._colour(LINE), 1.0))
            painter.drawLine(panel.bottomLeft(), panel.bottomRight())
        for n, hour in enumerate(ticks_h(frame.hours.low, frame.hours.high, most)):
            x = frame.hours.to_px(hour)
            painter.setPen(QPen(self._colour(LINE), 1.0))
            painter.drawLine(QPointF(x, plot.top() + _ARROWS_PX), QPointF(x, plot.bottom() + 3))
            moment = datetime(1970, 1, 1, tzinfo=UTC) + timedelta(hours=hour)
            text = f"{moment:%H:%M}"
            if n == 0 or hour % HOURS_PER_DAY == 0.0:
                day = QLocale().toString(QDate(moment.year, moment.month, moment.day), "ddd")
                text = f"{day} {text}"
            half = self._metrics.horizontalAdvance(text) / 2
            middle = min(max(x, half + 2), plot.right() + _SIDE_PX - half - 2)
            self._text(middle - half, plot.bottom() + self._metrics.ascent() + 2, text, MUTED)

    # --- wind, boat, sea ------------------------------------------------------------------------------

    def _arrows(self) -> None:
        """Arrows that fly with the wind, evenly in time."""
        plot, series, painter = self._frame.plot, self._series, self._painter
        count = max(2, int(plot.width() / _ARROW_EVERY_PX))
        painter.setPen(QPen(self._colour(INK), 1.4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        for n in range(count):
            x = plot.left() + (n + 0.5) / count * plot.width()
            k = series.sample(self._frame.time(x))
            painter.save()
            painter.translate(x, plot.top() + _ARROWS_PX / 2 - 1)
            painter.rotate(float(series.twd_deg[k]) + 180.0)
            painter.drawLine(QPointF(0, 7), QPointF(0, -7))
            painter.drawLine(QPointF(0, -7), QPointF(-3.2, -2.6))
            painter.drawLine(QPointF(0, -7), QPointF(3.2, -2.6))
            painter.restore()

    def _wind(self, panel: QRectF) -> None:
        series = self._series
        speed = _converted(series.tws_kn, wind_value)
        gust = None if series.weather.gust_kn is None else _converted(series.weather.gust_kn, wind_value)
        top = max(float(speed.max()), 0.0 if gust is None else float(gust.max()))
        scale = self._axis(panel, top, least=4.0)
        y = _pixels(speed, scale)
        area = self._line(y)
        area.append(QPointF(panel.right(), panel.bottom()))
        area.append(QPointF(panel.left(), panel.bottom()))
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(self._colour(ACCENT, 50))
        self._painter.drawPolygon(area)
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._stroke(self._line(y), ACCENT, 1.8)
        names = [(_tr("Wind, {unit}").format(unit=wind_unit()), ACCENT)]
        if gust is not None:
            self._stroke(self._line(_pixels(gust, scale)), WARNING_INK, 1.2, Qt.PenStyle.DashLine)
            names.append((_tr("gusts"), WARNING_INK))
        self._names(panel, names)

    def _boat(self, panel: QRectF) -> None:
        """Draw boat speed, the angle of the wind in the tack's colour, and the tack at the foot."""
        series = self._series
        ribbon = QRectF(panel.left(), panel.bottom() - _RIBBON_PX, panel.width(), _RIBBON_PX)
        room = panel.adjusted(0, 0, 0, -_RIBBON_PX - 2)
        scale = self._axis(room, float(series.boat_speed_kn.max()), least=4.0)
        angles = Scale(0.0, 180.0 * self._headroom(room), room.bottom(), room.top())
        apart = angles.to_px(0.0) - angles.to_px(60.0) >= self._metrics.height()
        for degrees in (60, 120, 180) if apart else (90, 180):
            foot = angles.to_px(degrees) + self._metrics.ascent() / 2 - 1
            self._text(panel.right() + 5, foot, f"{degrees}°", MUTED)
        y = _pixels(series.twa_deg, angles)
        for tack, begin, end in series.tacks():
            colour, style = _tack_stroke(tack)
            box = QRectF(self._x[begin], ribbon.top(), self._x[end] - self._x[begin], ribbon.height())
            # Not by colour alone, which is all red by night: port is hatched, the engine is a line.
            if tack == ENGINE:
                box = box.adjusted(0, 2, 0, -2)
            full = tack != PORT or self._light != "night"
            brush = Qt.BrushStyle.SolidPattern if full else Qt.BrushStyle.Dense5Pattern
            self._painter.fillRect(box, QBrush(self._colour(colour, 210), brush))
            part = QPolygonF([QPointF(self._x[k], y[k]) for k in range(begin, end + 1)])
            self._stroke(part, colour, 1.3, style)
        self._stroke(self._line(_pixels(series.boat_speed_kn, scale)), INK, 1.8)
        names = [
            (_tr("Boat speed, kn"), INK),
            (_tr("TWA: port"), PORT_TACK),
            (_tr("starboard"), STARBOARD_TACK),
        ]
        if (series.tack == ENGINE).any():
            names.append((_tr("engine"), MUTED))
        self._names(room, names)

    def _sea(self, panel: QRectF) -> None:
        weather, names = self._series.weather, []
        if weather.wave_m is not None:
            waves = _converted(weather.wave_m, height_value)
            scale = self._axis(panel, float(waves.max()), least=1.0)
            self._stroke(self._line(_pixels(waves, scale)), ACCENT, 1.5)
            names.append((_tr("Waves, {unit}").format(unit=height_unit()), ACCENT))
        if weather.current_kn is not None:
            most = max(float(weather.current_kn.max()), 0.5)
            scale = Scale(0.0, most * self._headroom(panel), panel.bottom(), panel.top())
            foot = scale.to_px(most) + self._metrics.ascent() / 2 - 1
            self._stroke(self._line(_pixels(weather.current_kn, scale)), MAGENTA, 1.3, Qt.PenStyle.DashLine)
            self._text(panel.right() + 5, foot, fill("{n:.1f}", n=most), MAGENTA)
            names.append((_tr("current, kn"), MAGENTA))
        self._names(panel, names)

    # --- strokes --------------------------------------------------------------------------------------

    def _axis(self, panel: QRectF, top: float, *, least: float) -> Scale:
        """Mark even values at the left, and give the scale from nothing to some way above ``top``."""
        scale = Scale(0.0, max(top, least) * self._headroom(panel), panel.bottom(), panel.top())
        most = min(max(1, int(panel.height() / (self._metrics.height() * 1.15))), _MOST_TICKS)
        step = next((s for s in _STEPS if scale.high / s <= most), _STEPS[-1])
        for n in range(1, int(scale.high / step) + 1):
            y = scale.to_px(n * step)
            self._painter.setPen(QPen(self._colour(LINE), 1.0, Qt.PenStyle.DotLine))
            self._painter.drawLine(QPointF(panel.left(), y), QPointF(panel.right(), y))
            text = f"{n * step:g}".replace(".", QLocale().decimalPoint())
            left = panel.left() - 6 - self._metrics.horizontalAdvance(text)
            self._text(left, y + self._metrics.ascent() / 2 - 1, text, MUTED)
        return scale

    def _headroom(self, panel: QRectF) -> float:
        """Say how far a scale goes beyond the greatest value: no curve should run through the names."""
        names = self._metrics.height() + 3.0
        return panel.height() / max(panel.height() - names, 0.5 * panel.height())

    def _line(self, y: Array) -> QPolygonF:
        return QPolygonF([QPointF(a, b) for a, b in zip(self._x.tolist(), y.tolist(), strict=True)])

    def _stroke(
        self, line: QPolygonF, colour: str, width: float, style: Qt.PenStyle = Qt.PenStyle.SolidLine
    ) -> None:
        pen = QPen(self._colour(colour), width, style, Qt.PenCapStyle.FlatCap, Qt.PenJoinStyle.RoundJoin)
        self._painter.setPen(pen)
        self._painter.drawPolyline(line)

    def _names(self, panel: QRectF, names: list[tuple[str, str]]) -> None:
        """Write names of the curves at the upper left, each in its curve's colour."""
        x, y = panel.left() + 6, panel.top() + self._metrics.ascent() + 1
        wide = sum(self._metrics.horizontalAdvance(text) + 12 for text, _ in names)
        ground = self._colour(CARD, 170)
        self._painter.fillRect(QRectF(x - 3, panel.top() + 1, wide - 4, self._metrics.height()), ground)
        for text, colour in names:
            self._text(x, y, text, colour)
            x += self._metrics.horizontalAdvance(text) + 12

    def _text(
        self,
        x: float,
        y: float,
        text: str,
        colour: str,
        side: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignLeft,
    ) -> None:
        self._painter.setPen(self._colour(colour))
        left = x - self._metrics.horizontalAdvance(text) if side == Qt.AlignmentFlag.AlignRight else x
        self._painter.drawText(QPointF(left, y), text)


def _tack_stroke(tack: int) -> tuple[str, Qt.PenStyle]:
    """Give colour and stroke of a tack: not the colour alone, which is all red by night."""
    if tack == ENGINE:
        return MUTED, Qt.PenStyle.DotLine
    return (PORT_TACK, Qt.PenStyle.DashLine) if tack == PORT else (STARBOARD_TACK, Qt.PenStyle.SolidLine)


def _converted(values: Array, convert: Callable[[float], float]) -> Array:
    return np.array([convert(value) for value in values.tolist()])


def _pixels(values: Array, scale: Scale) -> Array:
    slope = (scale.end - scale.begin) / (scale.high - scale.low)
    return np.asarray(scale.begin + (np.nan_to_num(values) - scale.low) * slope)
