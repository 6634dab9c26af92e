"""What the colours of the route mean."""

from __future__ import annotations

import math

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QLinearGradient, QPainter, QPen, QPixmap, QTransform

from seacruise.desktop.chart.depth_layer import band_name
from seacruise.desktop.chart.field_layer import FIELD_STOPS
from seacruise.desktop.chart.layer import Layer, draw_dot, text_width
from seacruise.desktop.chart.members_layer import DOT_PX, LINE_PX
from seacruise.desktop.chart.palette import dimmed
from seacruise.desktop.chart.schemes import SCHEMES, Scheme
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import units_choice, wind_ticks, wind_unit

_SWATCH_PX = 38.0
_MARGIN_PX = 10.0
_SIZE = 0.85
_CHART_PX = 210.0
_SAMPLE_PX = 34.0


class LegendLayer(Layer):
    """Swatches with their classes, at the lower right; above them the colour field's or the depth tints'."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._scheme = SCHEMES["tws"]
        self.field_shown = False
        self.depths_shown = False
        self.members = 0
        self._picture: tuple[tuple[object, ...], QPixmap] | None = None

    def show_scheme(self, scheme: Scheme) -> None:
        """Explain another meaning of the colours."""
        self._scheme = scheme
        self.update()

    def _swatch_px(self, font: QFont) -> float:
        widest = max(text_width(font, name) for name in self._scheme.names())
        return max(_SWATCH_PX, math.ceil(widest) + 7.0)

    def card(self, view: QRectF, base: QFont) -> QRectF:
        """Where the legend is in a view [pixels], in a smaller size of a font."""
        font = scaled_font(base, _SIZE)
        width = len(self._scheme.colours) * self._swatch_px(font) + 2 * _MARGIN_PX
        height = (2 * QFontMetricsF(font).height() + 18) * (
            2 if self.field_shown or self.depths_shown else 1
        ) + 6
        if self.members:
            height += QFontMetricsF(font).height() + 6
            width = max(width, text_width(font, self._members_text()) + _SAMPLE_PX + 2 * _MARGIN_PX)
        return QRectF(view.right() - width - 12, view.bottom() - height - 26, width, height)

    def has_room(self, view: QRectF, base: QFont) -> bool:
        """Whether there is more chart than legend: beside an open page the passage comes first."""
        return view.height() >= self.card(view, base).height() + _CHART_PX

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the legend, from a picture that is made anew when it says something else."""
        del to_pixels
        if not self.has_room(view, painter.font()):
            return
        card = self.card(view, painter.font())
        font, density = scaled_font(painter.font(), _SIZE), painter.device().devicePixelRatio()
        units = units_choice().units
        key = (
            units,
            self._scheme.key,
            self.colours.name,
            self.field_shown,
            self.depths_shown,
            self.members,
            font.key(),
            density,
        )
        if self._picture is None or self._picture[0] != key:
            size = (card.size() + QSizeF(2, 2)) * density
            picture = QPixmap(size.toSize())
            picture.setDevicePixelRatio(density)
            picture.fill(Qt.GlobalColor.transparent)
            on = QPainter(picture)
            on.setRenderHint(QPainter.RenderHint.Antialiasing)
            on.setFont(font)
            self._draw_card(on, QRectF(QPointF(1, 1), card.size()))
            on.end()
            self._picture = (key, picture)
        painter.drawPixmap(QPointF(round(card.left() - 1), round(card.top() - 1)), self._picture[1])

    def _draw_card(self, painter: QPainter, card: QRectF) -> None:
        line = painter.fontMetrics().height()
        painter.setPen(QPen(self.colours.card_line, 1.0))
        painter.setBrush(self.colours.card)
        painter.drawRoundedRect(card, 8, 8)
        painter.setPen(self.colours.ink)
        top = card.top() + 2
        if self.field_shown or self.depths_shown:
            (self._draw_field if self.field_shown else self._draw_depths)(painter, card, top, line)
            top += 2 * line + 18
        left, wide = card.left() + _MARGIN_PX, self._swatch_px(painter.font())
        painter.drawText(QPointF(left, top + line), self._scheme.title())
        for number, (colour, name) in enumerate(zip(self._scheme.colours, self._scheme.names(), strict=True)):
            swatch = QRectF(left + number * wide, top + line + 6, wide, 7)
            painter.fillRect(swatch, dimmed(colour, self.colours))
            _write_under(painter, swatch.center().x(), swatch.bottom(), name)
        if self.members:
            self._draw_members(painter, left, top + 2 * line + 18)

    def _members_text(self) -> str:
        text = QCoreApplication.translate("legend", "Fastest in each of {n} members")
        return text.format(n=self.members)

    def _draw_members(self, painter: QPainter, left: float, top: float) -> None:
        """Draw a line with a dot as the members have them, and what they are."""
        middle = top + painter.fontMetrics().height() / 2
        painter.drawText(
            QPointF(left + _SAMPLE_PX, top + painter.fontMetrics().ascent()), self._members_text()
        )
        painter.setPen(QPen(self.colours.member, LINE_PX))
        painter.drawLine(QPointF(left, middle), QPointF(left + _SAMPLE_PX - 8, middle))
        at = QPointF(left + (_SAMPLE_PX - 8) / 2, middle)
        draw_dot(painter, at, DOT_PX, self.colours.member, self.colours.casing)

    def _draw_field(self, painter: QPainter, card: QRectF, top: float, line: int) -> None:
        left, width = card.left() + _MARGIN_PX, card.width() - 2 * _MARGIN_PX
        title = QCoreApplication.translate("legend", "Wind on the chart ({unit})").format(unit=wind_unit())
        painter.drawText(QPointF(left, top + line), title)
        bar = QRectF(left, top + line + 6, width, 7)
        ramp = QLinearGradient(bar.topLeft(), bar.topRight())
        most = FIELD_STOPS[-1][0]
        for knots, colour in FIELD_STOPS:
            ramp.setColorAt(knots / most, dimmed(QColor(colour), self.colours))
        painter.fillRect(bar, ramp)
        for knots, figure in wind_ticks(most):
            _write_under(painter, left + knots / most * width, bar.bottom(), figure)

    def _draw_depths(self, painter: QPainter, card: QRectF, top: float, line: int) -> None:
        left, width = card.left() + _MARGIN_PX, card.width() - 2 * _MARGIN_PX
        title = QCoreApplication.translate("legend", "Depth (m), coarse: not for navigation")
        painter.drawText(QPointF(left, top + line), title)
        wide = width / len(self.colours.depths)
        for number, colour in enumerate(self.colours.depths):
            swatch = QRectF(left + number * wide, top + line + 6, wide, 7)
            painter.fillRect(swatch, colour)
            _write_under(painter, swatch.center().x(), swatch.bottom(), band_name(number))
        painter.setPen(QPen(self.colours.card_line, 1.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(left, top + line + 6, width, 7))
        painter.setPen(self.colours.ink)


def _write_under(painter: QPainter, x: float, y: float, text: str) -> None:
    room = QRectF(x - 2 * _SWATCH_PX, y + 1, 4 * _SWATCH_PX, painter.fontMetrics().height() + 3)
    painter.drawText(room, Qt.AlignmentFlag.AlignCenter, text)
