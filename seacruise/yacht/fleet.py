"""The yachts one can choose from: the shipped polars and the sailor's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from seacruise.errors import InputError
from seacruise.settings import typed_path
from seacruise.text import did_you_mean, fold, folds, rank_names, same_name, suggestions
from seacruise.yacht.files import read_polar
from seacruise.yacht.polar import Polar

POLAR_SUFFIXES = (".csv", ".pol", ".txt", ".json", ".plr")
"""Files that are taken for polars when they lie in a polar folder."""


@dataclass(frozen=True, slots=True)
class Fleet:
    """Yachts by name, and what is wrong with the files that are none.

    Attributes
    ----------
    yachts
        In the order of their names.
    problems
        One sentence for each file that could not be read, naming file, line and reason.
    """

    yachts: dict[str, Polar] = field(default_factory=dict)
    problems: tuple[str, ...] = ()


def load_fleet(folders: Sequence[Path]) -> Fleet:
    """Read all polars of some folders; a bad file never stops the others.

    Parameters
    ----------
    folders
        The shipped folder first: a yacht of the same name in a later folder takes its place. Folders that
        do not exist are passed over.
    """
    by_key: dict[str, Polar] = {}
    problems: list[str] = []
    for folder in folders:
        here: dict[str, Polar] = {}
        for path in _polar_files(Path(folder), problems):
            try:
                polar = read_polar(path)
            except InputError as error:
                problems.append(str(error))
                continue
            key = fold(polar.name) or polar.name
            if key in here:
                problems.append(
                    f"{path.name}: the yacht {polar.name} is also in {_file(here[key])}; rename one of them."
                )
                continue
            here[key] = polar
        by_key.update(here)
    ordered = sorted(by_key.items(), key=lambda item: item[0])
    return Fleet({polar.name: polar for _, polar in ordered}, tuple(problems))


def _polar_files(folder: Path, problems: list[str]) -> list[Path]:
    try:
        return sorted(
            path
            for path in folder.iterdir()
            if path.suffix.lower() in POLAR_SUFFIXES and not path.name.startswith(".")
        )
    except FileNotFoundError:
        return []
    except OSError as error:
        problems.append(f"The folder {folder} cannot be read: {error.strerror or error}.")
        return []


def _file(polar: Polar) -> str:
    return polar.path.name if polar.path else polar.source


def find_yacht(text: str, fleet: Fleet) -> Polar:
    """Find the yacht that a sailor means, or read the polar file that the text names.

    The name as written; else without case, diacritics and hyphens; else the only one that fits what was
    typed; else a file.

    Raises
    ------
    InputError
        There is no such yacht or file, or several; the sentence offers the closest. A file that is named
        but broken says what is wrong with it.
    """
    text = text.strip()
    if not text:
        raise InputError("No yacht was named; give a name such as Bavaria 46 Cruiser, or a polar file.")
    if text in fleet.yachts:
        return fleet.yachts[text]
    keys = {name: folds(name) for name in fleet.yachts}
    for name, typed_as in keys.items():
        if same_name(text, typed_as):
            return fleet.yachts[name]
    path = typed_path(text)
    if path.suffix.lower() in POLAR_SUFFIXES or "/" in text or "\\" in text or _exists(path):
        return read_polar(path)
    found = rank_names(text, keys) if any(folds(text)) else []
    if len(found) == 1:
        return fleet.yachts[found[0]]
    if found:
        raise InputError(f"More than one yacht fits {text!r}: {did_you_mean(found[:4])}")
    offer = did_you_mean(suggestions(text, keys))
    raise InputError(
        f"There is no yacht {text!r}: {offer}"
        if offer
        else f"There is no yacht {text!r}; see the list of yachts, or give the path of a polar file."
    )


def _exists(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
