"""What the menus switch on the chart: layers, meaning of colours, light; and the lines of equal time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from seacruise.desktop.alternatives import OtherWays, line_of
from seacruise.desktop.chart.palette import PALETTES
from seacruise.desktop.chart.schemes import SCHEMES
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer, Planner, plan_passage
from seacruise.desktop.equal_time import find_time_lines
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.members import ForecastMembers
from seacruise.desktop.menus import Menus
from seacruise.progress import Job
from seacruise.settings import Settings

if TYPE_CHECKING:
    from seacruise.desktop.equal_time import TimeLine
    from seacruise.export.beside import Beside


class Layers(QObject):
    """Keeps chart and switches in step.

    Signals: ``light_changed(name)``, one of ``day``, ``dusk`` and ``night``; ``failed(error)`` when lines of
    equal time could not be found; ``members_told(text)`` what the members of an ensemble say of the passage,
    ``noted(text)`` what the line below should say for a while.
    """

    light_changed = Signal(str)
    failed = Signal(object)
    members_told = Signal(str)
    noted = Signal(str)

    def __init__(
        self,
        settings: Settings,
        menus: Menus,
        view: ChartView,
        parent: QObject | None = None,
        *,
        planner: Planner = plan_passage,
    ) -> None:
        super().__init__(parent)
        self._settings, self._menus, self._view = settings, menus, view
        self._answer: Answer | None = None
        self._lines_of: Answer | None = None
        self._light = "day"
        self.jobs = JobRunner("isochrones", self)
        self.jobs.finished.connect(self._lines_found)
        self.jobs.failed.connect(lambda _, error: self.failed.emit(error))
        self.ways = OtherWays(settings, planner, view, self)
        self.ways.failed.connect(self.failed)
        self.ways.noted.connect(self.noted)
        self.ways.list_in(menus.ways)
        self._planner = planner
        self._members: ForecastMembers | None = None
        self._show_ground()

    def show_answer(self, answer: Answer | None) -> None:
        """Show the layers of a passage."""
        self._answer = answer
        self.apply()

    def is_on(self, name: str) -> bool:
        """Whether a layer is switched on."""
        return self._menus.layers[name].isChecked()

    @property
    def light(self) -> str:
        """Light in which the chart is shown: ``day``, ``dusk`` or ``night``."""
        return self._light

    def apply(self) -> None:
        """Show what is switched on."""
        view = self._view
        view.wind.setVisible(self.is_on("wind"))
        view.field.setVisible(self.is_on("field"))
        self._show_ground()
        view.zones.setVisible(self.is_on("zones"))
        view.isochrones.setVisible(self.is_on("isochrones"))
        view.ports.names_shown = self.is_on("ports")
        view.route.nights_shown = self.is_on("nights")
        view.set_measuring(self.is_on("measure"))
        view.show_scheme(SCHEMES[self._menus.chosen("scheme")])
        light = self._menus.chosen("light")
        if light != self._light:
            self._light = light
            view.set_palette(PALETTES[light])
            self.light_changed.emit(light)
        edges = self._answer.passage.lattice_edges if self._answer is not None else None
        view.coast.show_lattice(edges if self.is_on("lattice") else None)
        view.refresh_coast()
        self._demand_lines()
        self.ways.show(self._answer, islands=self.is_on("others"), turns=self.is_on("turns"))
        self._show_members()
        view.viewport().update()

    def _show_ground(self) -> None:
        """Colour the water by wind or by depth, never by both: one would be read for the other."""
        view, field = self._view, self.is_on("field")
        depths = self.is_on("depths") and not field
        view.coast.show_depths(depths)
        if (view.legend.field_shown, view.legend.depths_shown) != (field, depths):
            view.legend.field_shown, view.legend.depths_shown = field, depths
            view.fit_again()

    def _show_members(self) -> None:
        """Show the members of a forecast that has some; of others the switch says that they have none."""
        answer, action = self._answer, self._menus.layers["members"]
        count = len(answer.wind.members) if answer is not None else 0
        self._menus.offer_members(answer is None or count > 0)
        on = action.isChecked() and count > 0
        if self._members is None and on:
            self._members = ForecastMembers(self._settings, self._planner, self._view, self)
            self._members.failed.connect(self.failed)
            self._members.told.connect(self.members_told)
        if self._members is not None:
            self._members.show(answer, on=on)
        legend = self._view.legend
        if legend.members != (count if on else 0):
            legend.members = count if on else 0
            self._view.fit_again()

    def _demand_lines(self) -> None:
        """Find the lines of the passage shown, unless they are there; none while it follows a hand."""
        answer = self._answer
        if answer is None or answer is self._lines_of:
            return
        self._lines_of = None
        self._view.isochrones.show_lines(())
        self.jobs.cancel()
        if answer.rough or not self.is_on("isochrones"):
            return
        self._lines_of, settings = answer, self._settings

        def work(job: Job) -> Any:
            return find_time_lines(answer, settings=settings, job=job)

        self.jobs.run_job(work)

    def _lines_found(self, _generation: int, lines: list[TimeLine]) -> None:
        self._view.isochrones.show_lines(lines)
        self._view.viewport().update()

    def beside(self) -> Beside:
        """Give what lies beside the passage on the chart, for a picture of it."""
        from seacruise.export.beside import Beside

        bundle = self._view.members.bundle
        lines = () if bundle is None else tuple(line_of(passage) for passage in bundle.passages)
        return Beside(lines, tuple((way.plain, way.line) for way in self._view.others.ways))

    def shut_down(self) -> None:
        """End the workers."""
        self.jobs.shut_down()
        self.ways.shut_down()
        if self._members is not None:
            self._members.shut_down()

    # --- memory -------------------------------------------------------------------------------------

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start."""
        kept: dict[str, object] = {
            name: action.isChecked() for name, action in self._menus.layers.items() if name != "measure"
        }
        return kept | {name: self._menus.chosen(name) for name in ("scheme", "light")}

    def restore(self, kept: dict[str, Any]) -> None:
        """Switch as `contents` said; what is not of its kind, as in a damaged file, is passed over."""
        for name, action in self._menus.layers.items():
            if isinstance(kept.get(name), bool):
                action.setChecked(kept[name])
        for name in ("scheme", "light"):
            self._menus.choose(name, str(kept.get(name, "")))
