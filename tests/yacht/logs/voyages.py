"""Logs of a yacht whose truth is known: what she can do, and what her instruments add to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import reduce
from operator import xor

import numpy as np

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.log import Log, angle_of, log_of, signed_angle, vector
from seacruise.yacht.polar import Polar

BEGIN = datetime(2026, 7, 1, 8, 0, tzinfo=UTC).timestamp()


@dataclass(frozen=True, slots=True)
class Faults:
    """What the instruments and the water add; speeds [m/s], angles [degrees]."""

    log_factor: float = 1.0
    compass_deg: float = 0.0
    vane_deg: float = 0.0
    current_set: float = 0.0
    current_drift: float = 0.0
    noise: float = 0.02


def voyage(polar: Polar, *, hours: float, seed: int = 1, faults: Faults | None = None) -> Log:
    """Sail legs of four minutes at all angles on both tacks, beats among them, at 1 Hz.

    The wind goes from 6 to 16 kn and back every hour and veers a little. She turns at 5 degrees a second and
    takes half a minute to reach a new speed, as yachts do.
    """
    wrong = faults or Faults()
    rng = np.random.default_rng(seed)
    seconds = np.arange(int(hours * 3600), dtype=float)
    tws = (11.0 - 5.0 * np.cos(seconds * 2 * np.pi / 3600.0)) * MS_PER_KNOT
    twd = 260.0 + 8.0 * np.sin(seconds / 900.0)
    angles = rng.choice((42, 42, 42, 55, 75, 95, 115, 135, 150, 165), size=seconds.size // 240 + 1)
    sides = np.where(np.arange(angles.size) % 2 == 0, 1.0, -1.0)
    wanted = np.repeat(sides * angles, 240)[: seconds.size]
    twa, speed = np.empty(seconds.size), np.empty(seconds.size)
    now, going = float(wanted[0]), 0.0
    for k, aim in enumerate(wanted.tolist()):
        turn = (aim - now + 180.0) % 360.0 - 180.0
        now = (now + min(max(turn, -5.0), 5.0) + 180.0) % 360.0 - 180.0
        twa[k] = now
    for k, able in enumerate(polar.speed(tws, twa).tolist()):
        going += (able - going) / 12.0
        speed[k] = going
    heading = (twd - twa) % 360.0
    ground = vector(speed, heading) + vector(wrong.current_drift, wrong.current_set)
    apparent = vector(tws, twa) + speed
    noise = rng.normal(size=(4, seconds.size)) * wrong.noise
    return log_of(
        BEGIN + seconds,
        lat=54.5 + seconds * 1e-5,
        lon=10.5 + seconds * 1e-5,
        sog=np.abs(ground) + noise[0],
        cog=angle_of(ground) % 360.0,
        stw=np.maximum(speed / wrong.log_factor + noise[1], 0.0),
        heading=(heading - wrong.compass_deg + 20 * noise[2]) % 360.0,
        awa=signed_angle(angle_of(apparent) - wrong.vane_deg + 20 * noise[3]),
        aws=np.abs(apparent),
    )


def sentence(body: str) -> str:
    """A sentence with its checksum."""
    return f"${body}*{reduce(xor, body.encode(), 0):02X}"


def minutes(degrees: float, width: int) -> str:
    """A latitude or longitude as NMEA writes it."""
    return f"{int(degrees):0{width}d}{degrees % 1 * 60:07.4f}"


def nmea(log: Log, *, variation: str = ",") -> Sequence[str]:
    """The log as its instruments would have sent it."""
    lines = []
    for k in range(len(log)):
        when = datetime.fromtimestamp(float(log.time[k]), UTC)
        place = f"{minutes(log.lat[k], 2)},N,{minutes(log.lon[k], 3)},E"
        over_ground = f"{log.sog[k] / MS_PER_KNOT:.3f},{log.cog[k]:.2f}"
        lines += [
            sentence(f"GPRMC,{when:%H%M%S},A,{place},{over_ground},{when:%d%m%y},{variation},A"),
            sentence(f"IIVHW,,,{log.heading[k]:.2f},M,{log.stw[k] / MS_PER_KNOT:.3f},N,,"),
            sentence(f"IIMWV,{log.awa[k] % 360:.2f},R,{log.aws[k] / MS_PER_KNOT:.3f},N,A"),
        ]
    return lines
