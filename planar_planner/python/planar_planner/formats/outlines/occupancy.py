"""Polygons of exactly the same region as the occupied cells of a grid.

The corners of the region are integer points of the grid, and they are joined along rows and
columns. So the work grows with the number of corners, not of cells. Occupied cells that touch only
in a corner are separate there; a robot cannot pass between them in either case. Free cells that
touch only in a corner give two holes that touch in a point.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

GridRing = list[tuple[int, int]]
Corners = NDArray[np.int64]


def grid_polygons(occupied: NDArray[np.bool_]) -> list[list[GridRing]]:
    """Return the polygons of the occupied cells, each with its outer ring first.

    Parameters
    ----------
    occupied : NDArray of bool, shape (rows, columns)
        Row 0 is the lowest; cell (r, c) covers [c, c + 1] × [r, r + 1].

    Returns
    -------
    list of list of GridRing
        Integer points (x, y); all vertices are corners.
    """
    padded = np.pad(occupied, 1)
    labels = _Labels(padded)
    outer: dict[int, list[GridRing]] = {}
    holes: list[tuple[int, GridRing]] = []
    for walk in _walks(_corners(padded)):
        for ring in _simple(walk):
            x, y = min(ring)  # inside the ring, the cell to the upper right of this corner
            if padded[y + 1, x + 1]:
                outer[labels.of(y + 1, x + 1)] = [ring]
            else:
                holes.append((labels.of(y, x + 1), ring))
    for label, ring in holes:
        outer[label].append(ring)
    return list(outer.values())


def _corners(padded: NDArray[np.bool_]) -> Corners:
    """Return (x, y, horizontal, vertical) of each corner, in the unpadded grid's points.

    Horizontal is 1 if the boundary leaves the corner to the right, otherwise 0; vertical is 1 if it
    leaves upwards. A corner in which two cells touch counts twice, once for each cell.
    """
    lower, upper = padded[:-1], padded[1:]
    lower_left, lower_right = lower[:, :-1], lower[:, 1:]
    upper_left, upper_right = upper[:, :-1], upper[:, 1:]
    count = lower_left.astype(np.int8) + lower_right + upper_left + upper_right
    diagonal = (count == 2) & (lower_left == upper_right)
    y, x = np.nonzero((count == 1) | (count == 3))
    right = lower_right[y, x] != upper_right[y, x]
    above = upper_left[y, x] != upper_right[y, x]
    plain = np.stack([x, y, right, above], axis=1).astype(np.int64)
    y, x = np.nonzero(diagonal)
    rising = upper_right[y, x]  # the occupied cells lie to the upper right and lower left
    one = np.stack([x, y, np.ones_like(x), rising], axis=1).astype(np.int64)
    two = np.stack([x, y, np.zeros_like(x), ~rising], axis=1).astype(np.int64)
    return np.concatenate([plain, one, two])


def _walks(corners: Corners) -> list[GridRing]:
    """Join corners along rows and columns, and follow the joints to closed walks."""
    x, y, right, above = corners.T
    along_rows = np.lexsort((right, x, y)).reshape(-1, 2)
    along_columns = np.lexsort((above, y, x)).reshape(-1, 2)
    partners = []
    for pairs in (along_rows, along_columns):
        # the first of each pair leaves forwards and the second backwards; for a corner that counts
        # twice the backward joint is sorted first, and it ends the previous pair
        partner = np.empty(len(corners), dtype=np.int64)
        partner[pairs[:, 0]], partner[pairs[:, 1]] = pairs[:, 1], pairs[:, 0]
        partners.append(partner.tolist())
    points = list(zip(x.tolist(), y.tolist(), strict=True))
    seen = bytearray(len(points))
    walks = []
    for first in range(len(points)):
        if seen[first]:
            continue
        walk, at, axis = [], first, 0
        while not seen[at]:
            seen[at] = 1
            walk.append(points[at])
            at = partners[axis][at]
            axis = 1 - axis
        walks.append(walk)
    return walks


def _simple(walk: GridRing) -> list[GridRing]:
    """Cut a walk into rings that pass through no point twice."""
    if len(set(walk)) == len(walk):
        return [walk]
    rings: list[GridRing] = []
    stack: GridRing = []
    place: dict[tuple[int, int], int] = {}
    for p in walk:
        if p in place:
            start = place[p]
            rings.append(stack[start:])
            for q in stack[start + 1 :]:
                del place[q]
            del stack[start + 1 :]
        else:
            place[p] = len(stack)
            stack.append(p)
    rings.append(stack)
    return rings


class _Labels:
    """Components of occupied cells along edges: runs of a row, joined to those of the row below."""

    def __init__(self, padded: NDArray[np.bool_]) -> None:
        self._columns = padded.shape[1]
        flat = padded.ravel().astype(np.int8)  # the border is free, so no run crosses rows
        steps = np.diff(flat, prepend=0)
        self._begins = np.flatnonzero(steps == 1)
        self._ends = np.flatnonzero(steps == -1)
        self._leader = list(range(len(self._begins)))
        for i, j in self._overlaps():
            a, b = self._find(i), self._find(j)
            self._leader[max(a, b)] = min(a, b)

    def _overlaps(self) -> list[tuple[int, int]]:
        """Return pairs of runs, one above the other, that share part of a column."""
        below_begins, below_ends = self._begins + self._columns, self._ends + self._columns
        first = np.searchsorted(below_ends, self._begins, side="right")
        last = np.searchsorted(below_begins, self._ends, side="left")
        counts = np.maximum(last - first, 0)
        upper = np.repeat(np.arange(len(counts)), counts)
        offsets = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        lower: Any = np.repeat(first, counts) + offsets
        return list(zip(upper.tolist(), lower.tolist(), strict=True))

    def _find(self, i: int) -> int:
        leader = self._leader
        while leader[i] != i:
            leader[i] = leader[leader[i]]
            i = leader[i]
        return i

    def of(self, row: int, column: int) -> int:
        """Return the label of an occupied cell of the padded grid."""
        cell = row * self._columns + column
        return self._find(int(np.searchsorted(self._begins, cell, side="right")) - 1)
