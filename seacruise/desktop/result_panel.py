"""The answer in words: how long, when, how far, in what wind, by which forecast, and how far to trust it."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QVBoxLayout, QWidget

from seacruise.desktop.banner import Banner, text_label
from seacruise.desktop.language import fill, sentence
from seacruise.desktop.messages import Message, age_h, format_age, is_forecast, notices_of
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import distance_text, moment_text, wind_text
from seacruise.desktop.verdict import verdict_on
from seacruise.export.textform import format_duration, to_minute
from seacruise.sun import night_hours
from seacruise.units import beaufort

if TYPE_CHECKING:
    from seacruise.passage import Passage
    from seacruise.weather.wind import Wind


STRONG_FORCE: Final = 7
"""From this force on the strongest wind is told in the colour of faults: a near gale is no cruise."""


class ResultPanel(QFrame):
    """Shows one passage; everything is text that can be selected and read out."""

    way_out_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self.heading = text_label("", "hint", self)
        self.duration = QLabel(self)
        self.duration.setFont(scaled_font(self.font(), 2.1, bold=True))
        self.verdict = text_label("", "good", self)
        self.verdict.setFont(scaled_font(self.font(), 1.05, bold=True))
        self.arrival = text_label("", "", self)
        self.members = text_label("", "", self)
        self.members.hide()
        self._facts = QGridLayout()
        self._facts.setHorizontalSpacing(10)
        self._facts.setVerticalSpacing(3)
        self._facts.setColumnStretch(1, 1)
        self._rows: list[tuple[QLabel, QLabel]] = []
        self._banners: list[Banner] = []
        # What must be known before the figures, and what explains them, stand on either side of them.
        self._warnings, self._notices = QVBoxLayout(), QVBoxLayout()
        for column in (self._warnings, self._notices):
            column.setSpacing(6)
        self.checks = text_label("", "good", self)
        self.source = text_label("", "hint", self)
        self.fine_print = text_label(
            self.tr(
                "A planning aid, not for navigation: shoals, traffic schemes and local rules are not in it. "
                "Check the passage on an official chart."
            ),
            "fineprint",
            self,
        )
        self.fine_print.setFont(scaled_font(self.font(), 0.9))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 10, 16, 12)
        layout.setSpacing(6)
        for widget in (self.heading, self.duration, self.verdict, self.arrival):
            layout.addWidget(widget)
        layout.addLayout(self._warnings)
        layout.addWidget(_rule(self))
        layout.addLayout(self._facts)
        layout.addWidget(self.members)
        layout.addLayout(self._notices)
        layout.addWidget(_rule(self))
        for widget in (self.checks, self.source, self.fine_print):
            layout.addWidget(widget)

    def show_passage(
        self,
        passage: Passage,
        now: datetime,
        *,
        earlier: bool,
        rough: bool = False,
        via: str = "",
        wind: Wind | None = None,
    ) -> None:
        """Show a passage.

        Parameters
        ----------
        earlier
            It is not of the latest calculation.
        rough
            It was found coarsely, while a hand moves.
        via
            Place that it is led through.
        wind
            It was found in; its gusts are told when it has them.
        """
        head = f"{passage.start.name} – {passage.end.name}, {passage.yacht}"
        if earlier:
            self.heading.setText(self.tr("Earlier passage: {head}").format(head=head))
        else:
            self.heading.setText(self.tr("Roughly so far: {head}").format(head=head) if rough else head)
        self.duration.setText(format_duration(passage.duration_h))
        verdict = verdict_on(passage)
        self.verdict.setText(verdict.text)
        _dress(self.verdict, verdict.dress)
        leaves, arrives = (moment_text(to_minute(m)) for m in (passage.departure, passage.arrival))
        self.arrival.setText(
            self.tr("Departs {leaves}\nArrives {arrives}").format(arrives=arrives, leaves=leaves)
        )
        self.setAccessibleName(f"{head}: {self.duration.text()}, {verdict.text} {self.arrival.text()}")
        self._show_notices(notices_of(passage, now))
        self._show_facts(facts_of(passage, via, wind))
        self._show_trust(passage, now)

    def show_members(self, text: str) -> None:
        """Say what the members of an ensemble make of the passage, or nothing."""
        self.members.setText(text)
        self.members.setVisible(bool(text))

    def _show_notices(self, messages: list[Message]) -> None:
        """Make banners anew only when they take another form: each costs the style sheet milliseconds."""
        banners = self._banners
        if len(messages) == len(banners) and all(b.say(m) for b, m in zip(banners, messages, strict=True)):
            return
        _clear(self._warnings)
        _clear(self._notices)
        self._banners = [Banner(message, self) for message in messages]
        for banner in self._banners:
            banner.way_out_chosen.connect(self.way_out_chosen)
            (self._notices if banner.message.kind == "info" else self._warnings).addWidget(banner)

    def _show_facts(self, facts: list[Fact]) -> None:
        while len(self._rows) < len(facts):
            self._add_row()
        for row, (left, right) in enumerate(self._rows):
            shown = row < len(facts)
            left.setVisible(shown)
            right.setVisible(shown)
            if shown:
                left.setText(facts[row].name)
                right.setText(facts[row].value)
                _dress(right, "fault" if facts[row].warns else "")
                for label in (left, right):
                    label.setToolTip(facts[row].tip)

    def _add_row(self) -> None:
        left, right = QLabel(self), QLabel(self)
        left.setObjectName("factName")
        right.setFont(scaled_font(self.font(), 1.0, bold=True))
        right.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        right.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._facts.addWidget(left, len(self._rows), 0)
        self._facts.addWidget(right, len(self._rows), 1)
        self._rows.append((left, right))

    def _show_trust(self, passage: Passage, now: datetime) -> None:
        checks = passage.checks
        passed = [
            text
            for ok, text in (
                (checks.land_free, self.tr("clear of land")),
                (checks.within_limits, self.tr("within your limits")),
            )
            if ok
        ]
        failed = not (checks.land_free and checks.zones_free and checks.within_limits)
        sentence = self.tr("Checked leg by leg: {what}.").format(what=", ".join(passed) or "–")
        if failed:
            sentence += " " + self.tr("A check failed: do not sail it as it is.")
        if passage.lower_bound_h > 0:
            sentence += " " + self.tr("No passage of hers in this wind takes less than {t}.").format(
                t=format_duration(passage.lower_bound_h)
            )
        self.checks.setText(sentence)
        _dress(self.checks, "fault" if failed else "good")
        self.source.setText(source_text(passage, now))


def _tr(text: str) -> str:
    return QCoreApplication.translate("ResultPanel", text)


@dataclass(frozen=True, slots=True)
class Fact:
    """A line of the summary: a name, a value, and more about it for who asks."""

    name: str
    value: str
    tip: str = ""
    warns: bool = False


def facts_of(passage: Passage, via: str, wind: Wind | None) -> list[Fact]:
    """Collect what is seen of a passage at one glance, most important first."""
    from seacruise.along import UPWIND_DEG, upwind_share, weather_along

    track = passage.track
    gusts = weather_along(track, wind).gust_kn
    strongest = wind_text(passage.max_tws_kn)
    if gusts is not None:
        strongest = _tr("{wind}, gusts {gusts}").format(wind=strongest, gusts=wind_text(float(gusts.max())))
    direct = distance_text(passage.direct_distance_nm)
    dark = night_hours(track.time, track.lat, track.lon)
    beating, night = _tr("{percent:.0f} %"), _tr("{hours:.0f} h")
    facts = [
        Fact(
            _tr("Distance"),
            distance_text(passage.distance_nm),
            _tr("{direct} in a straight line").format(direct=direct),
        ),
        Fact(_tr("Mean speed"), fill(_tr("{n:.1f} kn"), n=passage.mean_speed_kn)),
        Fact(
            _tr("Strongest wind"),
            strongest,
            _tr("Force {force} on the Beaufort scale").format(force=beaufort(passage.max_tws_kn)),
            warns=beaufort(passage.max_tws_kn) >= STRONG_FORCE,
        ),
        Fact(
            _tr("Against the wind"),
            beating.format(percent=100.0 * upwind_share(track)),
            _tr("Part of the time closer than {angle:.0f}° to the true wind").format(angle=UPWIND_DEG),
        ),
        Fact(
            _tr("In the dark"),
            night.format(hours=dark),
            _tr("Hours with the sun more than 6° below the horizon"),
        ),
        Fact(_tr("Tacks and gybes"), _tr("{t} and {g}").format(t=passage.tacks, g=passage.gybes)),
    ]
    if via:
        facts.insert(0, Fact(_tr("By way of"), via))
    if passage.motor_h > 0:
        used = fill(_tr("{t}, {f:.0f} l"), t=format_duration(passage.motor_h), f=passage.fuel_l)
        facts.append(Fact(_tr("Under engine"), used))
    if passage.beyond_forecast_h > 0:
        facts.append(Fact(_tr("Beyond the forecast"), format_duration(passage.beyond_forecast_h)))
    return facts


def source_text(passage: Passage, now: datetime) -> str:
    """Source of the forecast, its age and its grid."""
    forecast = passage.forecast
    parts = [sentence(forecast.source)]
    if forecast.issued is not None and is_forecast(forecast):
        parts.append(
            _tr("issued {moment}, {age} ago").format(
                moment=moment_text(forecast.issued), age=format_age(age_h(forecast.issued, now))
            )
        )
    parts.append(
        fill(_tr("{deg:g}° grid, every {step:g} h"), deg=forecast.resolution_deg, step=forecast.step_h)
    )
    return _tr("Wind: {parts}.").format(parts="; ".join(parts))


def _dress(label: QLabel, name: str) -> None:
    """Dress a label as the style sheet has it by a name; polishing costs milliseconds, so not in vain."""
    if name != label.objectName():
        label.setObjectName(name)
        label.style().unpolish(label)
        label.style().polish(label)


def _rule(parent: QWidget) -> QFrame:
    rule = QFrame(parent)
    rule.setObjectName("rule")
    return rule


def _clear(layout: QVBoxLayout) -> None:
    while (item := layout.takeAt(0)) is not None:
        if (widget := item.widget()) is not None:
            widget.hide()
            widget.deleteLater()
