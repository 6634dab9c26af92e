"""Colours, type and the style sheet: a calm sea by day, after the day palette of IHO S-52.

Everything that is text stands at 4.5 : 1 or better against its ground by day and at dusk (WCAG 2.2, AA);
by night it is dim and red, so that eyes stay used to the dark.
"""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QIcon, QPalette, QPixmap
from PySide6.QtWidgets import QApplication, QToolButton, QWidget

ICONS: Final = Path(__file__).resolve().parent / "icons"

INK: Final = "#14304A"
MUTED: Final = "#52687B"
GROUND: Final = "#EEF3F7"
CARD: Final = "#FFFFFF"
LINE: Final = "#CFDAE3"
FIELD_LINE: Final = "#A9BAC8"
ACCENT: Final = "#0B5C8A"
ACCENT_HOVER: Final = "#0D6FA6"
ACCENT_PRESSED: Final = "#084566"
FOCUS: Final = "#1C86C4"
TINT: Final = "#E3EFF7"
MAGENTA: Final = "#A8126F"
WARNING_INK: Final = "#6B4700"
WARNING_GROUND: Final = "#FFF4D6"
WARNING_LINE: Final = "#E3B341"
ERROR_INK: Final = "#8A1C1C"
ERROR_GROUND: Final = "#FDECEA"
ERROR_LINE: Final = "#D9746C"
GOOD_INK: Final = "#1D6B45"
PORT_TACK: Final = "#B3261E"
STARBOARD_TACK: Final = "#1D6B45"
"""Wind from port and from starboard, as the sidelights are."""

_RED: Final = 12.0 / 360.0
"""Hue of everything by night."""


def icon(name: str, light: str = "day") -> QIcon:
    """Icon of the window's own set, in the colours of a light; its own suit day and dusk."""
    if light != "night":
        return QIcon(str(ICONS / f"{name}.svg"))
    drawing = (ICONS / f"{name}.svg").read_text(encoding="utf-8")
    picture = QPixmap()
    picture.loadFromData(re.sub(r"#[0-9A-Fa-f]{6}\b", tinted(MUTED, light), drawing).encode(), "SVG")
    return QIcon(picture)


def show_icon(button: QToolButton, name: str) -> None:
    """Give a button an icon that `show_light` finds again."""
    button.setProperty("iconName", name)
    button.setIcon(icon(name, str(button.property("light") or "day")))


def show_light(window: QWidget, light: str) -> None:
    """Give all buttons of a window the icons of a light."""
    for button in window.findChildren(QToolButton):
        button.setProperty("light", light)
        if name := button.property("iconName"):
            button.setIcon(icon(str(name), light))


@lru_cache(maxsize=256)
def tinted(colour: str, light: str) -> str:
    """Turn a colour of the day into what it is at dusk or by night: dark ground, light ink.

    Parameters
    ----------
    light
        ``"day"``, ``"dusk"`` or ``"night"``.
    """
    if light == "day":
        return colour
    given = QColor(colour)
    hue, saturation, lightness = given.hslHueF(), given.hslSaturationF(), given.lightnessF()
    if light == "dusk":
        turned = QColor.fromHslF(max(hue, 0.0), 0.55 * saturation, 0.90 - 0.78 * lightness)
    else:
        turned = QColor.fromHslF(_RED, 0.45, 0.03 + 0.64 * (1.0 - lightness))
    return turned.name()


def begin_style(app: QApplication, light: str = "day") -> None:
    """Give the whole program its look but for the style sheet: Fusion, the same on every system."""
    if not app.property("isFusion"):
        # With a style sheet, the style no longer tells its name, and choosing it anew takes a frame's time.
        app.setStyle("Fusion")
        app.setProperty("isFusion", True)
    apply_palette(app, light)


def apply_style(app: QApplication, light: str = "day") -> None:
    """Give the whole program its look for a light."""
    begin_style(app, light)
    app.setStyleSheet(style_sheet(light))
    app.setProperty("light", light)


def worn(app: QApplication) -> str | None:
    """Tell the light that the whole program has its look for; ``None`` while that changes."""
    light = app.property("light")
    return light if isinstance(light, str) else None


def apply_palette(app: QApplication, light: str) -> None:
    """Give the whole program the colours that are not of the style sheet."""
    hints = app.styleHints()
    if hasattr(hints, "setColorScheme"):
        hints.setColorScheme(Qt.ColorScheme.Light if light == "day" else Qt.ColorScheme.Dark)
    palette = QPalette()
    roles = QPalette.ColorRole
    for role, colour in {
        roles.Window: GROUND,
        roles.WindowText: INK,
        roles.Base: CARD,
        roles.AlternateBase: "#F5F8FB",
        roles.Text: INK,
        roles.Button: CARD,
        roles.ButtonText: INK,
        roles.Highlight: ACCENT,
        roles.HighlightedText: "#FFFFFF",
        roles.ToolTipBase: INK,
        roles.ToolTipText: "#FFFFFF",
        roles.PlaceholderText: "#6F8395",
        roles.Link: ACCENT,
        roles.Mid: LINE,
        roles.Dark: FIELD_LINE,
    }.items():
        palette.setColor(role, QColor(tinted(colour, light)))
    for role in (roles.Text, roles.WindowText, roles.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(tinted("#8496A5", light)))
    app.setPalette(palette)


def scaled_font(base: QFont, factor: float, *, bold: bool = False) -> QFont:
    """Font of the same family in another size of the scale: sizes follow what the system is set to."""
    font = QFont(base)
    if base.pointSizeF() > 0:
        font.setPointSizeF(base.pointSizeF() * factor)
    else:
        font.setPixelSize(round(base.pixelSize() * factor))
    if bold:
        font.setWeight(QFont.Weight.DemiBold)
    return font


def style_sheet(light: str = "day") -> str:
    """Qt style sheet of the window for a light."""
    return re.sub(r"#[0-9A-Fa-f]{6}\b", lambda found: tinted(found[0], light), _sheet())


def _sheet() -> str:
    icons = ICONS.as_posix()
    return f"""
QToolTip {{ background: {INK}; color: #FFFFFF; border: 0; padding: 4px 6px; }}
QMenuBar {{ background: {CARD}; border-bottom: 1px solid {LINE}; padding: 1px 6px; }}
QMenuBar::item {{ padding: 4px 9px; border-radius: 4px; background: transparent; }}
QMenuBar::item:selected {{ background: {TINT}; }}
QMenu {{ background: {CARD}; border: 1px solid {LINE}; padding: 4px; }}
QMenu::item {{ padding: 5px 26px 5px 24px; border-radius: 4px; }}
QMenu::item:selected {{ background: {TINT}; color: {INK}; }}
QMenu::item:disabled {{ color: #8496A5; }}
QMenu::separator {{ height: 1px; background: {LINE}; margin: 4px 8px; }}
QStatusBar {{ background: {CARD}; border-top: 1px solid {LINE}; color: {MUTED}; }}
QStatusBar::item {{ border: 0; }}
QStatusBar QLabel {{ color: {MUTED}; padding: 0 6px; }}
QScrollArea#side {{ background: {GROUND}; border: 0; border-right: 1px solid {LINE}; }}
QWidget#sideBody {{ background: {GROUND}; }}
QFrame#card {{ background: {CARD}; border: 1px solid {LINE}; border-radius: 10px; }}
QFrame#bar {{ background: {CARD}; border-top: 1px solid {LINE}; }}
QFrame#legs {{ background: {CARD}; border-top: 1px solid {LINE}; }}
QFrame#rule {{ background: {LINE}; border: 0; max-height: 1px; min-height: 1px; }}
QLabel#fieldName, QLabel#factName {{ color: {MUTED}; }}
QLabel#hint {{ color: {MUTED}; }}
QLabel#fault {{ color: {ERROR_INK}; }}
QLabel#fineprint {{ color: {MUTED}; }}
QLabel#good {{ color: {GOOD_INK}; }}
QLabel[stage="ahead"] {{ color: {MUTED}; }}
QLabel[stage="runs"] {{ color: {ACCENT}; font-weight: 600; }}
QLabel[stage="done"] {{ color: {GOOD_INK}; }}
QLabel#ribbon {{ background: {WARNING_GROUND}; color: {WARNING_INK}; border: 1px solid {WARNING_LINE};
    border-radius: 6px; padding: 5px 12px; }}
QLineEdit, QComboBox, QDateEdit, QTimeEdit, QDoubleSpinBox {{
    background: {CARD}; color: {INK}; border: 1px solid {FIELD_LINE}; border-radius: 6px;
    padding: 4px 7px; min-height: 21px; selection-background-color: {ACCENT}; }}
QLineEdit:hover, QComboBox:hover, QDateEdit:hover, QTimeEdit:hover, QDoubleSpinBox:hover {{
    border-color: #7F98AB; }}
QLineEdit:focus, QComboBox:focus, QDateEdit:focus, QTimeEdit:focus, QDoubleSpinBox:focus {{
    border: 2px solid {FOCUS}; padding: 3px 6px; }}
QLineEdit[wrong="true"], QDateEdit[wrong="true"], QTimeEdit[wrong="true"] {{
    border: 2px solid {ERROR_LINE}; padding: 3px 6px; }}
QLineEdit:disabled, QComboBox:disabled, QDateEdit:disabled, QTimeEdit:disabled, QDoubleSpinBox:disabled {{
    background: #F4F7F9; color: #8496A5; }}
QComboBox {{ combobox-popup: 0; }}
QComboBox::drop-down {{ border: 0; width: 24px; }}
QComboBox::down-arrow {{ image: url({icons}/chevron-down.svg); width: 12px; height: 12px; }}
QComboBox QAbstractItemView, QListView#completions {{
    background: {CARD}; border: 1px solid {FIELD_LINE}; padding: 3px; outline: 0;
    selection-background-color: {TINT}; selection-color: {INK}; }}
QListView#completions::item {{ padding: 4px 6px; }}
QAbstractSpinBox QLineEdit, QAbstractSpinBox QLineEdit:focus, QAbstractSpinBox QLineEdit:hover {{
    border: 0; padding: 0 0 0 6px; min-height: 0; background: transparent; }}
QAbstractSpinBox::up-button {{ subcontrol-origin: border; border: 0; width: 20px; margin: 2px 2px 0 0; }}
QAbstractSpinBox::down-button {{ subcontrol-origin: border; border: 0; width: 20px; margin: 0 2px 2px 0; }}
QAbstractSpinBox::up-arrow {{
    image: url({icons}/chevron-up.svg); width: 9px; height: 9px; }}
QAbstractSpinBox::down-arrow {{
    image: url({icons}/chevron-down.svg); width: 9px; height: 9px; }}
QPushButton {{ background: {CARD}; color: {ACCENT}; border: 1px solid {FIELD_LINE}; border-radius: 6px;
    padding: 5px 12px; min-height: 20px; }}
QPushButton:hover {{ background: {TINT}; border-color: {ACCENT}; }}
QPushButton:pressed {{ background: #CFE2EF; }}
QPushButton:focus {{ border: 2px solid {FOCUS}; padding: 4px 11px; }}
QPushButton:disabled {{ color: #8496A5; background: #F4F7F9; border-color: {LINE}; }}
QPushButton#primary {{ background: {ACCENT}; color: #FFFFFF; border: 1px solid {ACCENT}; font-weight: 600; }}
QPushButton#primary:hover {{ background: {ACCENT_HOVER}; }}
QPushButton#primary:pressed {{ background: {ACCENT_PRESSED}; }}
QPushButton#primary:focus {{ border: 2px solid #8CC7EA; }}
QPushButton#primary:disabled {{ background: #B9CBD8; border-color: #B9CBD8; color: #F4F8FA; }}
QPushButton#flat {{ border: 0; background: transparent; padding: 2px 4px; text-align: left;
    color: {ACCENT}; }}
QPushButton#flat:hover {{ text-decoration: underline; background: transparent; }}
QPushButton#flat:focus {{ border: 2px solid {FOCUS}; border-radius: 4px; padding: 0 2px; }}
QToolButton {{ background: {CARD}; border: 1px solid {FIELD_LINE}; border-radius: 6px; padding: 4px; }}
QToolButton:hover {{ background: {TINT}; border-color: {ACCENT}; }}
QToolButton:pressed, QToolButton:checked {{ background: #CFE2EF; border-color: {ACCENT}; color: {INK}; }}
QToolButton:focus {{ border: 2px solid {FOCUS}; padding: 3px; }}
QToolButton:disabled {{ background: #F4F7F9; border-color: {LINE}; color: #8496A5; }}
QToolButton#chip {{ padding: 3px 10px; border-radius: 12px; }}
QToolButton#chip:focus {{ padding: 2px 9px; }}
QCheckBox {{ spacing: 7px; padding-right: 4px; }}
QCheckBox::indicator {{ width: 15px; height: 15px; border: 1px solid {FIELD_LINE}; border-radius: 4px;
    background: {CARD}; }}
QCheckBox::indicator:focus {{ border: 2px solid {FOCUS}; }}
QCheckBox::indicator:checked {{ background: {ACCENT}; border-color: {ACCENT};
    image: url({icons}/check.svg); }}
QProgressBar {{ background: #DCE7EF; border: 0; border-radius: 3px; max-height: 6px; min-height: 6px; }}
QProgressBar::chunk {{ background: {ACCENT}; border-radius: 3px; }}
QSlider {{ min-height: 24px; }}
QSlider::groove:horizontal {{ height: 4px; background: #C7D6E1; border-radius: 2px; }}
QSlider::sub-page:horizontal {{ background: {ACCENT}; border-radius: 2px; }}
QSlider::sub-page:horizontal:disabled {{ background: #C7D6E1; }}
QSlider::handle:horizontal {{ width: 16px; height: 16px; margin: -7px 0; border-radius: 9px;
    background: {CARD}; border: 2px solid {ACCENT}; }}
QSlider::handle:horizontal:hover {{ background: {TINT}; }}
QSlider::handle:horizontal:focus {{ border: 3px solid {FOCUS}; }}
QSlider::handle:horizontal:disabled {{ border-color: {FIELD_LINE}; }}
QTableView {{ background: {CARD}; border: 2px solid {CARD}; gridline-color: #E4EBF0;
    alternate-background-color: #F6F9FB; selection-background-color: #D5E8F4;
    selection-color: {INK}; outline: 0; }}
QTableView:focus {{ border-color: {FOCUS}; }}
QHeaderView {{ background: {CARD}; }}
QHeaderView::section {{ background: {CARD}; color: {MUTED}; border: 0; border-bottom: 1px solid {LINE};
    padding: 4px 8px; }}
QTabBar {{ background: transparent; }}
QTabBar::tab {{ background: transparent; color: {MUTED}; border: 0; border-bottom: 3px solid transparent;
    padding: 5px 12px 3px 12px; }}
QTabBar::tab:selected {{ color: {ACCENT}; border-bottom-color: {ACCENT}; }}
QTabBar::tab:hover:!selected {{ color: {INK}; border-bottom-color: {LINE}; }}
QTabBar:focus {{ background: {TINT}; }}
QSplitter::handle {{ background: {LINE}; }}
QSplitter::handle:hover {{ background: {FOCUS}; }}
QFrame#banner[kind="info"] {{ background: {TINT}; border: 1px solid #A9CDE4; border-radius: 8px; }}
QFrame#banner[kind="warning"] {{ background: {WARNING_GROUND}; border: 1px solid {WARNING_LINE};
    border-radius: 8px; }}
QFrame#banner[kind="error"] {{ background: {ERROR_GROUND}; border: 1px solid {ERROR_LINE};
    border-radius: 8px; }}
QFrame#banner[kind="info"] QLabel {{ color: {INK}; }}
QFrame#banner[kind="warning"] QLabel {{ color: {WARNING_INK}; }}
QFrame#banner[kind="error"] QLabel {{ color: {ERROR_INK}; }}
QCalendarWidget QWidget#qt_calendar_navigationbar {{ background: {CARD}; }}
QCalendarWidget QToolButton {{ border: 0; color: {INK}; font-weight: 600; }}
QCalendarWidget QToolButton#qt_calendar_prevmonth {{ qproperty-icon: url({icons}/chevron-left.svg); }}
QCalendarWidget QToolButton#qt_calendar_nextmonth {{ qproperty-icon: url({icons}/chevron-right.svg); }}
QCalendarWidget QAbstractItemView {{ selection-background-color: {ACCENT}; selection-color: #FFFFFF; }}
QCalendarWidget QTableView, QCalendarWidget QTableView:focus {{ border: 0; }}
QScrollBar:vertical {{ background: transparent; width: 11px; margin: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 11px; margin: 0; }}
QScrollBar::handle {{ background: #B7C7D3; border-radius: 4px; margin: 2px;
    min-height: 28px; min-width: 28px; }}
QScrollBar::handle:hover {{ background: #8FA6B6; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}
"""
