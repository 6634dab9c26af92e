"""Compiled loops over compressed sparse rows: edges packed into them, and what hangs together."""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel


@kernel
def sort_rows(source, count):
    """Stable order of edges by their source vertex, and the first edge of each: a counting sort."""
    first = np.zeros(count + 1, dtype=np.int64)
    for k in range(source.size):
        first[source[k] + 1] += 1
    for k in range(count):
        first[k + 1] += first[k]
    free = first[:-1].copy()
    order = np.empty(source.size, dtype=np.int64)
    for k in range(source.size):
        order[free[source[k]]] = k
        free[source[k]] += 1
    return first, order


@kernel
def pack_rows(a, b, source, target, count):
    """Put edges into rows: ``a`` to ``b`` and back, and those from ``source`` to ``target``.

    Returns
    -------
    first, to
        Compressed sparse rows of ``count`` vertices.
    """
    first = np.zeros(count + 1, dtype=np.int64)
    for k in range(a.size):
        first[a[k] + 1] += 1
        first[b[k] + 1] += 1
    for k in range(source.size):
        first[source[k] + 1] += 1
    for k in range(count):
        first[k + 1] += first[k]
    free = first[:-1].copy()
    to = np.empty(2 * a.size + source.size, dtype=np.int32)
    for k in range(a.size):
        to[free[a[k]]] = b[k]
        free[a[k]] += 1
    for k in range(a.size):
        to[free[b[k]]] = a[k]
        free[b[k]] += 1
    for k in range(source.size):
        to[free[source[k]]] = target[k]
        free[source[k]] += 1
    return first, to


@kernel
def reachable(first, target, start):
    """Vertices that hang together with ``start``, whatever the wind."""
    seen = np.zeros(first.size - 1, dtype=np.bool_)
    stack = np.empty(first.size - 1, dtype=np.int64)
    seen[start] = True
    stack[0] = start
    top = 1
    while top > 0:
        top -= 1
        a = stack[top]
        for e in range(first[a], first[a + 1]):
            b = target[e]
            if not seen[b]:
                seen[b] = True
                stack[top] = b
                top += 1
    return seen
