"""What is loaded beside the window: ports, yachts, a forecast's range, today's quota, the compiler."""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QObject, Signal

from seacruise.atomic import write_atomically
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.state import Horizon
from seacruise.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from seacruise.ports import Port
    from seacruise.progress import Job
    from seacruise.sea.zones import Zones
    from seacruise.settings import Settings
    from seacruise.yacht.polar import Polar


DEFAULT_YACHT: Final = "Bavaria 46 Cruiser"


@dataclass(frozen=True, slots=True)
class Catalogue:
    """What the form offers; ``yacht`` is the wanted one, and ``problems`` is what is wrong with files."""

    ports: Sequence[Port]
    yachts: Mapping[str, Polar]
    yacht: str
    problems: tuple[str, ...]


def load_catalogue(settings: Settings, wanted: str) -> Catalogue:
    """Read ports and polars.

    Parameters
    ----------
    wanted
        The yacht to be chosen, in any spelling that the command line takes, or a path of a polar file.
    """
    from seacruise.ports import load_ports
    from seacruise.resources import resource_path
    from seacruise.yacht.fleet import find_yacht, load_fleet

    fleet = load_fleet([resource_path("polars"), settings.user_polars])
    problems, yachts = fleet.problems, dict(fleet.yachts)
    yacht = wanted or DEFAULT_YACHT
    try:
        polar = find_yacht(yacht, fleet)
        yachts.setdefault(polar.name, polar)
        yacht = polar.name
    except InputError as error:
        problems = (*problems, str(error))
        yacht = DEFAULT_YACHT
    return Catalogue(load_ports(), yachts, yacht, problems)


def load_horizon(forecast: tuple[str, ...], settings: Settings, now: datetime) -> Horizon:
    """Range of a forecast."""
    from seacruise.weather.source import horizon

    return Horizon(*horizon(forecast, settings, now))


def load_quota(settings: Settings, now: datetime) -> tuple[int, int] | None:
    """Tell the requests left today, and a day's number; ``None`` without a key."""
    from seacruise.weather.source import weather_info

    quota = weather_info(settings, now).quota
    return None if quota is None else (quota.left, quota.daily)


def load_layers(settings: Settings) -> Zones:
    """Read the zones that the sailor keeps in the folder of layers."""
    from seacruise.sea.zones import layer_files, load_zones

    return load_zones(layer_files(settings.layers))


def add_polar(path: Path, settings: Settings) -> str:
    """Check a polar file and copy it to the sailor's own; returns the yacht's name.

    Raises
    ------
    InputError
        It is not a polar, or one of that file name is there already, or it cannot be copied.
    """
    from seacruise.yacht.files import read_polar

    name = read_polar(path).name
    target = settings.user_polars / path.name
    if target.exists() and not target.samefile(path):
        raise InputError(f"There is already a polar file {path.name} of yours; rename one of them.")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists():
            write_atomically(target, path.read_bytes(), what="polar")
    except OSError as error:
        raise InputError(f"{path.name} cannot be copied to {target.parent}: {error.strerror}.") from error
    return name


class Background(QObject):
    """Runs these loads; each has a runner of its own, so that none waits for another.

    Signals: ``catalogue_loaded(Catalogue)``, ``catalogue_failed(error)``, ``horizon_loaded(Horizon)``,
    ``horizon_failed(error)``, ``quota_loaded(tuple or None)``, ``layers_loaded(Zones)``,
    ``polar_added(name)``, ``troubled(error)``, ``warmed_up()``.
    """

    catalogue_loaded = Signal(object)
    catalogue_failed = Signal(object)
    horizon_loaded = Signal(object)
    horizon_failed = Signal(object)
    quota_loaded = Signal(object)
    layers_loaded = Signal(object)
    polar_added = Signal(str)
    troubled = Signal(object)
    warmed_up = Signal()

    def __init__(self, settings: Settings, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self._runners = {
            name: JobRunner(name, self)
            for name in ("catalogue", "horizon", "quota", "layers", "polar", "warmup")
        }
        self.found: dict[str, Any] = {}
        runners = self._runners
        for name, runner in runners.items():
            runner.finished.connect(partial(self._note, name))
        runners["catalogue"].finished.connect(lambda _, found: self.catalogue_loaded.emit(found))
        runners["catalogue"].failed.connect(lambda _, error: self.catalogue_failed.emit(error))
        runners["horizon"].finished.connect(lambda _, found: self.horizon_loaded.emit(found))
        runners["horizon"].failed.connect(lambda _, error: self.horizon_failed.emit(error))
        runners["quota"].finished.connect(lambda _, found: self.quota_loaded.emit(found))
        runners["layers"].finished.connect(lambda _, found: self.layers_loaded.emit(found))
        runners["layers"].failed.connect(lambda _, error: self.troubled.emit(error))
        runners["polar"].finished.connect(lambda _, name: self.polar_added.emit(name))
        runners["polar"].failed.connect(lambda _, error: self.troubled.emit(error))
        runners["warmup"].finished.connect(lambda *_: self.warmed_up.emit())

    def _note(self, name: str, _generation: int, found: Any) -> None:
        self.found[name] = found

    def load(self, yacht: str, forecast: tuple[str, ...], known: Mapping[str, Any]) -> None:
        """Load what the window needs; what is known from another window is told at once.

        Parameters
        ----------
        yacht, forecast
            As the form has them.
        known
            `found` of that window's.
        """
        self.found.update(known)
        if "catalogue" in known:
            self.catalogue_loaded.emit(replace(known["catalogue"], yacht=yacht, problems=()))
        else:
            self.load_catalogue(yacht)
        if "horizon" in known:
            self.horizon_loaded.emit(known["horizon"])
        else:
            self.load_horizon(forecast)
        if "layers" in known:
            self.layers_loaded.emit(known["layers"])
        else:
            self.load_layers()
        if "quota" in known:
            self.quota_loaded.emit(known["quota"])
        else:
            self.load_quota()

    def load_catalogue(self, wanted: str) -> None:
        """Read ports and yachts."""
        self._runners["catalogue"].run_job(lambda _job: load_catalogue(self._settings, wanted))

    def load_horizon(self, forecast: tuple[str, ...]) -> None:
        """Find out what a forecast covers."""
        self._runners["horizon"].run_job(
            lambda _job: load_horizon(forecast, self._settings, datetime.now(UTC))
        )

    def load_quota(self) -> None:
        """Look up today's quota."""
        self._runners["quota"].run_job(lambda _job: load_quota(self._settings, datetime.now(UTC)))

    def load_layers(self) -> None:
        """Read the zones to keep out of."""
        self._runners["layers"].run_job(lambda _job: load_layers(self._settings))

    def add_polar(self, path: Path) -> None:
        """Take a polar file over."""
        self._runners["polar"].run_job(lambda _job: add_polar(path, self._settings))

    def warm_up(self) -> None:
        """Compile the kernels before the first calculation asks for them."""

        def work(_job: Job) -> Any:
            from seacruise.warmup import warm_up

            warm_up(self._settings)

        self._runners["warmup"].run_job(work)

    def shut_down(self) -> None:
        """End all loads."""
        for runner in self._runners.values():
            runner.shut_down(patience_s=0.2)
