"""Target speeds and angles: what to steer and what to expect, up and down the wind."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import sail_at


@dataclass(frozen=True, slots=True)
class Target:
    """The best angle up or down one wind.

    Attributes
    ----------
    twa
        True wind angle to steer [degrees].
    boat_speed_kn
        Speed through the water there [kn].
    vmg_kn
        What is made good against or with the wind [kn].
    awa, aws_kn
        The wind that the masthead shows there: apparent angle [degrees] and speed [kn].
    sail
        The sail to set, where the polar knows.
    """

    twa: float
    boat_speed_kn: float
    vmg_kn: float
    awa: float
    aws_kn: float
    sail: str | None = None


@dataclass(frozen=True, slots=True)
class Targets:
    """What to aim for in one wind [kn]."""

    tws_kn: float
    beat: Target
    run: Target


def targets(polar: Polar, tws_kn: Iterable[float]) -> tuple[Targets, ...]:
    """Find the best beat and the best run at some true wind speeds [kn]."""
    return tuple(
        Targets(kn, _target(polar, kn, upwind=True), _target(polar, kn, upwind=False)) for kn in tws_kn
    )


def _target(polar: Polar, tws_kn: float, *, upwind: bool) -> Target:
    wind = tws_kn * MS_PER_KNOT
    twa, vmg = (float(v) for v in polar.best_vmg(wind, upwind))
    speed = float(polar.speed(wind, twa))
    ahead = wind * np.cos(np.radians(twa)) + speed
    abeam = wind * np.sin(np.radians(twa))
    return Target(
        twa=twa,
        boat_speed_kn=speed / MS_PER_KNOT,
        vmg_kn=vmg / MS_PER_KNOT,
        awa=float(np.degrees(np.arctan2(abeam, ahead))),
        aws_kn=float(np.hypot(abeam, ahead)) / MS_PER_KNOT,
        sail=sail_at(polar, wind, twa),
    )
