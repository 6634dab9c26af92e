"""Where to ask next: where the wind differs most between the places that have answered.

Requests are counted, so each should tell as much as it can. Between two answers that agree a third tells
nothing; between two that differ, nobody knows where the wind changes. After the first few answers the next
places are those of the greatest expected error: the disagreement of the answers around, times how far the
nearest of them is, times how much the wind there matters for the passage.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.weather.ground import Ground, distances

Array = NDArray[np.float64]

TOLERANCE_MS: Final = 0.2
"""Expected error that is not worth a request [m/s]."""

_EXPONENT: Final = 1.5
"""Of the variogram: between the roughness of a front and the smoothness of a high."""


def next_places(
    ground: Ground, answered: list[int], wind: tuple[Array, Array], most: int, barred: frozenset[int]
) -> tuple[int, ...]:
    """Choose the places to ask next; none when the answers agree well enough.

    Parameters
    ----------
    answered
        Indices of the ground's places that have an answer, one or more.
    wind
        Their ``u`` and ``v``, ``(t, n)`` each [m/s].
    most
        Places to choose at most.
    barred
        Places that were asked in vain.
    """
    chosen: list[int] = []
    u, v = wind
    open_to = ground.weight.copy()
    open_to[list(barred)] = 0.0
    known = list(answered)
    while len(chosen) < most:
        away = ground.distances(ground.places, ground.places[known])
        near = away.min(axis=1)
        pull = 1.0 / np.maximum(away, 1e-6) ** 2
        pull /= pull.sum(axis=1, keepdims=True)
        error = _disagreement(pull, u, v) * (near / max(float(near.max()), 1e-9)) * open_to
        best = int(error.argmax())
        if error[best] < TOLERANCE_MS:
            break
        chosen.append(best)
        known.append(best)
        # its answer is not there yet: as if it were what its surroundings say
        u = np.column_stack([u, u @ pull[best]])
        v = np.column_stack([v, v @ pull[best]])
    return tuple(chosen)


def _disagreement(pull: Array, u: Array, v: Array) -> Array:
    """Compute how far the answers around differ: the standard deviation of their vectors, by ``pull``."""
    moments = (u.T @ u + v.T @ v) / u.shape[0]
    square = pull @ np.diag(moments) - np.einsum("kn,nm,km->k", pull, moments, pull)
    return np.asarray(np.sqrt(np.maximum(square, 0.0)))


def kriging_weights(known: Array, places: Array, shrink: float) -> Array:
    """Weights with which answers make the wind of other places, by ordinary kriging.

    The variogram is a power of the distance, so the weights need neither a length nor a variance; answers
    are kept exactly, and far from all of them a mean is approached. Of the ways that were compared on a real
    forecast - inverse square distances, thin plates, smooth covariances, this with exponents 1 and 1.5 - it
    leaves the smallest errors of durations; inverse distances leave two to three times as much.

    Parameters
    ----------
    known
        ``(n, 2)`` latitude and longitude [degrees] of the answers, all different.
    places
        ``(k, 2)`` of the places wanted.
    shrink
        Length of a degree of longitude in degrees of latitude.

    Returns
    -------
    ndarray
        ``(k, n)``; each row adds up to 1.

    References
    ----------
    Cressie (1993), Statistics for Spatial Data, 3.2, doi:10.1002/9781119115151.
    """
    count = len(known)
    system = np.zeros((count + 1, count + 1))
    system[:count, :count] = -(distances(known, known, shrink) ** _EXPONENT)
    system[count, :count] = system[:count, count] = 1.0
    wanted = np.ones((len(places), count + 1))
    wanted[:, :count] = -(distances(places, known, shrink) ** _EXPONENT)
    return np.asarray(np.linalg.solve(system, wanted.T).T[:, :count])
