"""From what instruments say each second to what a yacht does: means over some seconds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

import numpy as np

from seacruise.yacht.logs.log import Array, Log, Vectors, angle_of, joined, signed_angle, vector

SPAN_S: Final = 10.0
"""Length of a mean [s]: longer than a wave, shorter than a gust."""


def averaged(blocks: Iterable[Log], *, span_s: float = SPAN_S) -> Log:
    """Average a log over even spans of time.

    Speeds are averaged as they are, a course with its speed and a wind with its angle as vectors, so that
    no direction jumps through north. A span's time is that of its middle; spans without rows are left out.

    Parameters
    ----------
    blocks
        Parts of a log in the order of time; one after the other is taken and let go.
    span_s
        Length of a span [s].

    Returns
    -------
    Log
        A row a span, in the order of time.
    """
    means = joined(_means(blocks, span_s))
    # A clock that was set back in the middle of a log puts later rows before earlier ones.
    return means.rows(np.argsort(means.time, kind="stable"))


def _means(blocks: Iterable[Log], span_s: float) -> Iterator[Log]:
    left: Log | None = None
    for block in blocks:
        log = block if left is None else joined((left, block))
        number = np.floor(log.time / span_s)
        # The last span may go on in the next block.
        ends = np.flatnonzero(np.diff(number)) + 1
        if ends.size:
            yield _mean(log.rows(slice(None, ends[-1])), span_s)
            left = log.rows(slice(ends[-1], None))
        else:
            left = log
    if left is not None and len(left):
        yield _mean(left, span_s)


def _mean(log: Log, span_s: float) -> Log:
    """Average the spans of a block; a clock that was set back begins a new span."""
    number = np.floor(log.time / span_s)
    first = np.concatenate(([0], np.flatnonzero(np.diff(number)) + 1))

    def mean(values: Array) -> Array:
        known = ~np.isnan(values)
        total = np.add.reduceat(np.where(known, values, 0.0), first)
        count = np.add.reduceat(known.astype(np.float64), first)
        return np.asarray(np.divide(total, count, out=np.full(first.size, np.nan), where=count > 0))

    def vectors(length: Array, angle: Array) -> Vectors:
        each = vector(length, angle)
        return np.asarray(mean(each.real) + 1j * mean(each.imag))

    ground = vectors(log.sog, log.cog)
    heading = vectors(np.ones(len(log)), log.heading)
    apparent, true = vectors(log.aws, log.awa), vectors(log.tws, log.twa)
    return Log(
        time=(number[first] + 0.5) * span_s,
        # A mean of longitudes would be nowhere near at the 180th meridian.
        lat=log.lat[first],
        lon=log.lon[first],
        sog=np.abs(ground),
        cog=angle_of(ground) % 360.0,
        stw=mean(log.stw),
        heading=angle_of(heading) % 360.0,
        awa=signed_angle(angle_of(apparent)),
        aws=np.abs(apparent),
        twa=signed_angle(angle_of(true)),
        tws=np.abs(true),
        rpm=mean(log.rpm),
    )
