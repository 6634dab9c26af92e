"""Indexed 4-ary heap in arrays, for the searches: the vertex with the least key on top.

``heap`` holds vertices and ``keys`` their keys in the same order, so the four below one lie side by side;
``place`` tells where in the heap each vertex stands. Of equal keys the smaller vertex comes first, so that a
search settles vertices in one order everywhere.
"""

from __future__ import annotations

from seacruise.compiled import inlined


@inlined
def sift_up(heap, keys, place, k, vertex, key):
    """Put a vertex into the hole at ``k`` of the heap or above it; ``keys`` stand in the heap's order."""
    while k > 0:
        above = (k - 1) >> 2
        other = heap[above]
        if keys[above] < key or (keys[above] == key and other < vertex):
            break
        heap[k], keys[k] = other, keys[above]
        place[other] = k
        k = above
    heap[k], keys[k] = vertex, key
    place[vertex] = k


@inlined
def sift_down(heap, keys, place, size):
    """Put the vertex after the last one into the hole at the top, or below it."""
    k = 0
    vertex, key = heap[size], keys[size]
    while True:
        first = 4 * k + 1
        if first >= size:
            break
        best = first
        for child in range(first + 1, min(first + 4, size)):
            if keys[child] < keys[best] or (keys[child] == keys[best] and heap[child] < heap[best]):
                best = child
        other = heap[best]
        if key < keys[best] or (key == keys[best] and vertex < other):
            break
        heap[k], keys[k] = other, keys[best]
        place[other] = k
        k = best
    heap[k], keys[k] = vertex, key
    place[vertex] = k
