"""Where to go: the ports that fit into the time there is, as a list, and the water reached on the chart."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import first_sentence, text_label
from seacruise.desktop.compute import Answer
from seacruise.desktop.jobs import Work
from seacruise.desktop.language import sentence
from seacruise.desktop.pages.flow import named
from seacruise.desktop.pages.page import Page, Texts, number_box
from seacruise.desktop.pages.reach_model import (
    Explorer,
    Fetcher,
    Fit,
    Found,
    Outset,
    Row,
    Wish,
    explore_ports,
    fetch_for_outset,
    find_ports,
    home_by,
    matches,
)
from seacruise.desktop.pages.rows import Column, Looks, RowsTable
from seacruise.desktop.pages.words import about, clock, moment_in_short, rounded, short_moment, tr
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import distance_number, distance_text, distance_unit, units_choice
from seacruise.errors import InputError
from seacruise.ports import Port
from seacruise.reach import LONGEST_H

if TYPE_CHECKING:
    from seacruise.settings import Settings

LEAST_H: Final = 1.0
_UNITS_H: Final = (1.0, 24.0)


class ReachPage(Page):
    """Finds the ports in reach; Enter or two clicks plan the passage to one.

    Parameters
    ----------
    ask
        Gives start, departure, yacht and options of the form, or raises `InputError`.
    known
        Gives the passage that is shown, for its wind, or ``None``.
    fetcher, explorer
        What computes; tests put their own in.

    Signals: ``isochrones_ready(list)`` of `TimeLine` for the chart, ``port_chosen(Port)`` when another row
    is chosen, ``adopted(Port)`` to plan the passage there, besides those of `Page`.
    """

    isochrones_ready = Signal(list)
    port_chosen = Signal(object)
    adopted = Signal(object)

    def __init__(
        self,
        settings: Settings,
        *,
        ask: Callable[[], Outset],
        known: Callable[[], Answer | None] = lambda: None,
        fetcher: Fetcher = fetch_for_outset,
        explorer: Explorer = explore_ports,
        parent: QWidget | None = None,
    ) -> None:
        self._settings, self._ask, self._known = settings, ask, known
        self._fetcher, self._explorer = fetcher, explorer
        self._ports: tuple[Port, ...] = ()
        self._found: Found | None = None
        self._unit_h = 1.0
        super().__init__("reach", _texts(), parent)
        self._make_controls()
        self._make_results()

    # --- building -----------------------------------------------------------------------------------

    def _make_controls(self) -> None:
        self.time_box = number_box(
            self.tr("Time there is"), low=LEAST_H, high=LONGEST_H, value=24, decimals=1
        )
        self.unit_box = QComboBox(self)
        self.unit_box.addItems([self.tr("hours"), self.tr("days")])
        self.unit_box.setAccessibleName(self.tr("Hours or days"))
        self.unit_box.activated.connect(self._unit_picked)
        self.back_box = QCheckBox(self.tr("There and back"), self)
        self.back_box.setChecked(True)
        self.back_box.toggled.connect(self._back_toggled)
        self.stay_box = number_box(
            self.tr("Stay in port, hours"), low=0, high=LONGEST_H, value=4, suffix=self.tr(" h")
        )
        for box in (self.time_box, self.stay_box):
            box.lineEdit().returnPressed.connect(self.start)
        self.stay = named(self.tr("&stay"), self.stay_box)
        self.add_controls(named(self.tr("T&ime"), self.time_box, self.unit_box), self.back_box, self.stay)

    def _make_results(self) -> None:
        self.sentence = text_label("", parent=self.body)
        self.sentence.setFont(scaled_font(self.font(), 1.1, bold=True))
        self.notice = text_label("", "hint", self.body)
        self.filter_field = QLineEdit(self.body)
        self.filter_field.setPlaceholderText(self.tr("Filter by name or country"))
        self.filter_field.setAccessibleName(self.tr("Filter ports by name or country"))
        self.filter_field.setClearButtonEnabled(True)
        self.filter_field.setMinimumWidth(150)
        self.fits_box = QCheckBox(self.tr("Only what fits"), self.body)
        self.adopt_button = QPushButton(self.tr("Plan to it"), self.body)
        self.adopt_button.setToolTip(self.tr("Make this port the destination and calculate (Enter)"))
        self.adopt_button.setEnabled(False)
        self.adopt_button.clicked.connect(self._take_current)
        self.none_label = text_label(self.tr("No port like that; clear the filter."), "hint", self.body)
        self.table = RowsTable(self.tr("Ports in reach"), _columns(), _looks(), self.body)
        self.table.sortByColumn(_OUT, Qt.SortOrder.AscendingOrder)
        self.table.chosen.connect(self._row_chosen)
        units_choice().changed.connect(self._show_units)
        self.table.taken.connect(self._take)
        self.filter_field.textChanged.connect(self._filter)
        self.fits_box.toggled.connect(self._filter)
        row = QHBoxLayout()
        row.setSpacing(10)
        row.addWidget(self.filter_field, 1)
        row.addWidget(self.fits_box)
        row.addWidget(self.adopt_button)
        layout = QVBoxLayout(self.body)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.sentence)
        layout.addWidget(self.notice)
        layout.addLayout(row)
        layout.addWidget(self.none_label, 1, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.table, 1)
        self.table.setMinimumHeight(5 * self.table.verticalHeader().defaultSectionSize())

    def set_ports(self, ports: Sequence[Port]) -> None:
        """Take the ports over."""
        self._ports = tuple(ports)

    # --- what is asked ------------------------------------------------------------------------------

    def _unit_picked(self, unit: int) -> None:
        """Keep the time when hours become days or the other way round."""
        hours, self._unit_h = self.hours, _UNITS_H[unit]
        self.time_box.setRange(LEAST_H if unit == 0 else 0.5, LONGEST_H / self._unit_h)
        self.time_box.setValue(hours / self._unit_h)

    @property
    def hours(self) -> float:
        """Time there is [h]."""
        return self.time_box.value() * self._unit_h

    def _back_toggled(self, back: bool) -> None:
        self.stay.setEnabled(back)

    def make_work(self) -> Work:
        """Ask the form, and find the ports.

        Raises
        ------
        InputError
            The form cannot be computed.
        """
        if not self._ports:
            raise InputError(self.tr("The ports are not loaded yet; try again in a moment."))
        wish = Wish(self._ask(), self.hours, self.stay_box.value(), back=self.back_box.isChecked())
        settings, ports, known = self._settings, self._ports, self._known()
        fetcher, explorer = self._fetcher, self._explorer

        def work(job: Any) -> Found:
            return find_ports(
                wish,
                ports=ports,
                settings=settings,
                job=job,
                known=known,
                fetcher=fetcher,
                explorer=explorer,
            )

        return work

    # --- what is found ------------------------------------------------------------------------------

    @property
    def has_results(self) -> bool:
        """Whether ports were looked for."""
        return self._found is not None

    def take_result(self, result: object) -> None:
        """Show the ports."""
        assert isinstance(result, Found)
        self._show_found(result)
        # The chart takes its time too; not in the same breath.
        QTimer.singleShot(0, self.send_lines)

    def _show_found(self, result: Found) -> None:
        self._found = result
        back = result.wish.back
        self.table.show_rows(())
        for column in _WAY_BACK:
            self.table.setColumnHidden(column, not back)
        self.table.setColumnHidden(_ARRIVAL, back)
        self.table.show_rows(result.rows)
        self._show_head(result)
        self._show_whether_any()

    def take_over(self, other: Page) -> None:
        """Go on where the same page of another window is."""
        assert isinstance(other, ReachPage)
        self._unit_picked(other.unit_box.currentIndex())
        if other.found is not None:
            self._show_found(other.found)
        super().take_over(other)
        if (current := other.table.current) is not None:
            self.table.choose(lambda row: row.port == current.port)

    @property
    def found(self) -> Found | None:
        """What is shown."""
        return self._found

    def send_lines(self) -> None:
        """Give the chart the lines of equal time of what is shown."""
        if self._found is not None:
            self.isochrones_ready.emit(list(self._found.lines))

    def _show_units(self) -> None:
        if self._found is not None:
            self._show_head(self._found)

    def _show_head(self, found: Found) -> None:
        reach = found.reach
        time = tr("{time} from {start}, leaving {leaves}, {yacht}").format(
            time=about(reach.hours),
            start=reach.start.name,
            leaves=moment_in_short(reach.departure),
            yacht=reach.yacht,
        )
        self.heading.setText(time)
        self.sentence.setText(reach_sentence(found))
        first, *rest = (sentence(notice) for notice in (*reach.notices, ""))
        self.notice.setText(" ".join((first_sentence(first), *rest)).rstrip())
        self.notice.setVisible(bool(reach.notices))

    def _filter(self) -> None:
        text, fitting = self.filter_field.text(), self.fits_box.isChecked()
        self.table.sorted.show_only(lambda row: matches(row, text, only_fitting=fitting))
        self._show_whether_any()

    def _show_whether_any(self) -> None:
        nothing = self.table.sorted.rowCount() == 0
        self.none_label.setVisible(nothing and bool(self._found and self._found.rows))
        self.table.setVisible(not nothing)

    # --- choosing -----------------------------------------------------------------------------------

    def _row_chosen(self, row: Row | None) -> None:
        self.adopt_button.setEnabled(row is not None)
        if row is not None:
            self.port_chosen.emit(row.port)

    def _take_current(self) -> None:
        self._take(self.table.current)

    def _take(self, row: Row | None) -> None:
        if row is not None:
            self.adopted.emit(row.port)


def reach_sentence(found: Found) -> str:
    """Say how many ports fit, and which of them is farthest."""
    rows, reach = found.rows, found.reach
    fitting = [row for row in rows if row.fit is Fit.FITS]
    until = moment_in_short(home_by(reach))
    if not rows:
        return tr("No port is reached in {time}.").format(time=about(reach.hours))
    if not fitting:
        return tr("{n} ports are reached, but none of them and back by {until}.").format(
            n=len(rows), until=until
        )
    farthest = max(fitting, key=lambda row: row.found.distance_nm)
    if len(fitting) == 1:
        text = tr("One port fits, {port}: {spare} to spare by {until}.")
    elif found.wish.back:
        text = tr("{n} ports fit, back by {until}; the farthest is {port}, with {spare} to spare.")
    else:
        text = tr("{n} ports are reached by {until}; the farthest is {port}, with {spare} to spare.")
    return text.format(
        n=len(fitting), until=until, port=farthest.port.name, spare=about(farthest.spare_h or 0.0)
    )


def fit_text(row: Row) -> str:
    """Say whether a port fits: ``fits, 5 h to spare``."""
    if row.spare_h is None:
        return tr("no time to sail back")
    if row.fit is Fit.FITS:
        return tr("fits, {spare} to spare").format(spare=rounded(max(row.spare_h, 0.0)))
    return tr("{over} too long").format(over=rounded(abs(row.spare_h)))


def _texts() -> Texts:
    return Texts(
        tr("Where to go"),
        tr("Fi&nd ports"),
        tr(
            "Finds every port that you reach from the start of the form in the time you have, and whether "
            "you are back in time. Say how much time there is, and press Find ports."
        ),
    )


_OUT: Final = 2
_ARRIVAL: Final = 3
_WAY_BACK: Final = (4, 5)


def _columns() -> tuple[Column, ...]:
    return (
        Column(
            tr("Port"),
            tr("Port and its country"),
            lambda row: f"{row.port.name} {row.port.country}".strip(),
            lambda row: row.port.name.casefold(),
            "Świnoujście PL",
            left=True,
            takes_rest=True,
        ),
        Column(
            tr("What fits"),
            tr("Time to spare, or how much is missing"),
            fit_text,
            lambda row: row.spare_h,
            "fits, 1 h 00 to spare",
            left=True,
        ),
        Column(
            tr("Out"),
            tr("Time out"),
            lambda row: clock(row.found.out_h),
            lambda row: row.found.out_h,
            "00 h 00",
        ),
        Column(
            tr("Arrives"),
            tr("Arrival"),
            lambda row: short_moment(row.found.arrival),
            lambda row: row.found.arrival,
            "Wed 00 00:00",
        ),
        Column(
            tr("Back"),
            tr("Time back, leaving after the stay"),
            lambda row: "" if row.found.back_h is None else clock(row.found.back_h),
            lambda row: row.found.back_h,
            "00 h 00",
        ),
        Column(
            tr("Leave by"),
            tr("Latest departure from there that is back in time"),
            lambda row: "" if row.found.leave_by is None else short_moment(row.found.leave_by),
            lambda row: row.found.leave_by,
            "Wed 00 00:00",
        ),
        Column(
            distance_unit,
            tr("Length of the way out"),
            lambda row: distance_number(row.found.distance_nm, 0),
            lambda row: row.found.distance_nm,
            "000",
        ),
    )


def _looks() -> Looks:
    def tip(row: Row) -> str:
        parts = [f"{row.port.name}: {fit_text(row)}."]
        if row.found.snapped_nm > 0.5:
            parts.append(
                tr("Its water lies {distance} away.").format(distance=distance_text(row.found.snapped_nm))
            )
        if row.found.beyond_forecast_h >= 0.5:
            parts.append(
                tr("{h:.0f} h of the way are beyond the forecast.").format(h=row.found.beyond_forecast_h)
            )
        return " ".join(parts)

    return Looks(tip=tip)
