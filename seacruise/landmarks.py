"""Headlands, lights and islands by name: what a passage is told by, see ``assets/landmarks``."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from typing import Literal, cast

from seacruise.resources import resource_path
from seacruise.text import read_text

Kind = Literal["cape", "light", "island"]


@dataclass(frozen=True, slots=True)
class Landmark:
    """Something on the shore that a log names.

    Attributes
    ----------
    name
        Native spelling.
    country
        ISO 3166 alpha-2 code.
    rank
        1 for what is seen from far and has a turning course, 2 for the rest.
    lat, lon
        Degrees.
    """

    name: str
    country: str
    kind: Kind
    rank: int
    lat: float
    lon: float


@cache
def load_landmarks() -> tuple[Landmark, ...]:
    """Read the landmarks that come with the program, in the order of their file."""
    text = read_text(resource_path("assets/landmarks/baltic.csv"), "list of landmarks")
    return tuple(
        Landmark(
            row["name"],
            row["country"],
            cast("Kind", row["kind"]),
            int(row["rank"]),
            float(row["lat"]),
            float(row["lon"]),
        )
        for row in csv.DictReader(text.splitlines(), strict=True)
    )
