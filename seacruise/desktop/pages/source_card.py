"""A source of wind as a card: whether it can be used, what it gives, its terms, and its part in a mean."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.language import fill, sentence
from seacruise.desktop.messages import format_age
from seacruise.desktop.pages.page import number_box
from seacruise.desktop.pages.weather_model import HOMEPAGES, ONLINE, SERVICES, FileInfo, Source
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import format_moment, moment_text

_LEAST_WEIGHT: Final = 0.1
_MOST_WEIGHT: Final = 10.0


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("weather", text)


def title_of(name: str) -> str:
    """Name of a source for the sailor."""
    return {
        "auto": tr("Automatic"),
        "stormglass": tr("Storm Glass"),
        "open-meteo": tr("Open-Meteo"),
        "open-meteo-ensemble": tr("Open-Meteo ensemble"),
        "metno": tr("MET Norway"),
        "practice": tr("Practice weather"),
        "sample": tr("Sample of November 2016"),
    }.get(name, name.replace("\\", "/").rsplit("/", maxsplit=1)[-1])


def gives_text(gives: tuple[str, ...]) -> str:
    """Say what a source gives."""
    words = {
        "wind": tr("wind"),
        "gusts": tr("gusts"),
        "waves": tr("waves"),
        "current": tr("current"),
        "members": tr("members of an ensemble"),
        "spread": tr("spread"),
    }
    return tr("Gives {what}").format(what=", ".join(words.get(one, one) for one in gives))


def file_text(info: FileInfo) -> str:
    """Say what a file covers, in lines."""
    span = f"{format_moment(info.first)} – {moment_text(info.last)}"
    steps = [fill(tr("every {n:g} h"), n=info.step_h)] if info.step_h else []
    steps += [fill(tr("{n:g}° grid"), n=info.resolution_deg)] if info.resolution_deg else []
    issued = [tr("run of {moment}").format(moment=moment_text(info.issued))] if info.issued else []
    lines = [span, sentence(info.area), ", ".join([*steps, *issued])]
    return "\n".join(filter(None, lines))


class Card(QFrame):
    """A card with a title, a state, sentences, and the controls to use it alone or in a mean.

    Signals: ``used()`` by its button; ``mixed()`` when it is taken into the mean, left out or weighed
    otherwise; ``removed()`` of a file.
    """

    used = Signal()
    mixed = Signal()
    removed = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self.name = name
        title = title_of(name)
        self.setAccessibleName(title)
        self.title = QLabel(title, self)
        self.title.setTextFormat(Qt.TextFormat.PlainText)
        self.title.setFont(scaled_font(self.font(), 1.08, bold=True))
        self.title.setWordWrap(True)
        self.status = text_label("", "hint", self)
        self.status.setWordWrap(False)
        self.use_button = QPushButton(tr("Use"), self)
        self.use_button.setAccessibleName(tr("Use {name}").format(name=title))
        self.use_button.clicked.connect(self.used)
        head = QHBoxLayout()
        head.setSpacing(10)
        head.addWidget(self.title, 1)
        head.addWidget(self.status)
        head.addWidget(self.use_button)
        self.remark, self.gives = text_label("", "", self), text_label("", "hint", self)
        self.kept, self.terms = text_label("", "hint", self), text_label("", "fineprint", self)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(14, 10, 14, 11)
        self._layout.setSpacing(4)
        self._layout.addLayout(head)
        for label in (self.remark, self.gives, self.kept, self.terms):
            label.hide()
            self._layout.addWidget(label)
        self._make_mixing(title)
        self.show_in_use(in_use=False)

    def _make_mixing(self, title: str) -> None:
        self.mix_box = QCheckBox(tr("In the mean, with weight"), self)
        self.mix_box.setAccessibleName(tr("{name} in the mean").format(name=title))
        self.weight_box = number_box(
            tr("Weight of {name}").format(name=title),
            low=_LEAST_WEIGHT,
            high=_MOST_WEIGHT,
            value=1.0,
            decimals=1,
        )
        self.weight_box.setEnabled(False)
        self.mix_box.toggled.connect(self._mix_toggled)
        self.weight_box.valueChanged.connect(self.mixed)
        self.mixing = QWidget(self)
        row = QHBoxLayout(self.mixing)
        row.setContentsMargins(0, 2, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.mix_box)
        row.addWidget(self.weight_box)
        row.addStretch()
        self.remove_button = QPushButton(tr("Take off the list"), self.mixing)
        self.remove_button.setObjectName("flat")
        self.remove_button.setAccessibleName(tr("Take {name} off the list").format(name=title))
        self.remove_button.clicked.connect(self.removed)
        self.remove_button.hide()
        row.addWidget(self.remove_button)
        self._layout.addWidget(self.mixing)
        self.mixing.setVisible(self.name in SERVICES)

    def _mix_toggled(self, on: bool) -> None:
        self.weight_box.setEnabled(on)
        self.mixed.emit()

    def add_row(self, widget: QWidget) -> None:
        """Put a further row above the mean."""
        self._layout.insertWidget(self._layout.indexOf(self.mixing), widget)

    @property
    def in_mean(self) -> bool:
        """Whether it is in the mean."""
        return self.mix_box.isChecked() and not self.mixing.isHidden()

    @property
    def weight(self) -> float:
        """Its weight there."""
        return round(self.weight_box.value(), 1)

    def set_mixed(self, weight: float | None) -> None:
        """Take it into the mean, or leave it out, without a word."""
        for box in (self.mix_box, self.weight_box):
            box.blockSignals(True)
        self.mix_box.setChecked(weight is not None)
        self.weight_box.setEnabled(weight is not None)
        if weight is not None:
            self.weight_box.setValue(weight)
        for box in (self.mix_box, self.weight_box):
            box.blockSignals(False)

    def show_in_use(self, *, in_use: bool) -> None:
        """Tell whether passages are planned with it."""
        self.use_button.setText(tr("In use") if in_use else tr("Use"))
        self.use_button.setObjectName("primary" if in_use else "")
        self.use_button.style().polish(self.use_button)
        self.use_button.setAccessibleDescription(tr("in use") if in_use else "")

    def show_source(self, source: Source, *, offline: bool, keyless: bool = False) -> None:
        """Show what is known of a source; ``keyless`` one that waits for a key."""
        unreached = offline and self.name in ONLINE
        why_not = tr("needs a key") if keyless else tr("not now")
        state = tr("not reached") if unreached else tr("ready") if source.usable else why_not
        self._say_status(state, good=source.usable and not unreached)
        remark = sentence(source.remark)
        self._tell(self.remark, remark[:1].upper() + remark[1:])
        self._tell(self.gives, gives_text(source.gives) if source.gives else "")
        kept = ""
        if source.kept is not None:
            kept = tr("Kept: answers for {n} places, the latest {age} old").format(
                n=source.kept.places, age=format_age(source.kept.age_h)
            )
        elif self.name in ONLINE - {"auto"}:
            kept = tr("Nothing kept yet")
        self._tell(self.kept, kept)
        self._show_terms(sentence(source.terms))

    def _show_terms(self, terms: str) -> None:
        page = HOMEPAGES.get(self.name, "")
        text = " ".join(filter(None, [terms, page.removeprefix("https://")]))
        if page and text:
            # The only rich text here, and none of it from outside.
            self.terms.setTextFormat(Qt.TextFormat.RichText)
            self.terms.setOpenExternalLinks(True)
            self.terms.setTextInteractionFlags(Qt.TextInteractionFlag.TextBrowserInteraction)
            text = f'{terms} <a href="{page}">{page.removeprefix("https://")}</a>'.strip()
        self._tell(self.terms, text)

    def show_reading(self) -> None:
        """Tell that a file is being read."""
        self._say_status(tr("reading…"), good=False)
        self.use_button.setEnabled(False)
        self._show_file_controls(usable=False)

    def show_file(self, info: FileInfo) -> None:
        """Show what a file covers."""
        self._say_status(tr("ready"), good=True)
        self.use_button.setEnabled(True)
        self._tell(self.remark, file_text(info))
        self._tell(self.gives, gives_text(("wind", *info.brings)))
        self._tell(self.kept, sentence(info.notice))
        self._show_file_controls(usable=True)

    def show_fault(self, why: str) -> None:
        """Show why a file cannot be used."""
        self._say_status(tr("cannot be used"), good=False)
        self.remark.setObjectName("fault")
        self.remark.style().polish(self.remark)
        self._tell(self.remark, sentence(why))
        self._show_file_controls(usable=False)

    def _show_file_controls(self, *, usable: bool) -> None:
        self.mixing.show()
        self.mix_box.setVisible(usable)
        self.weight_box.setVisible(usable)
        self.use_button.setVisible(usable)
        self.remove_button.show()

    def _say_status(self, text: str, *, good: bool) -> None:
        self.status.setText(text)
        self.status.setObjectName("good" if good else "hint")
        self.status.style().polish(self.status)

    @staticmethod
    def _tell(label: QLabel, text: str) -> None:
        label.setText(text)
        label.setVisible(bool(text))
