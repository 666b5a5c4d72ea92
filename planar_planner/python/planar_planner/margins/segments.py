"""Distances of points from segments with their rounding error, and exact inclusion in a ring."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np

from planar_planner.margins.body import UNIT_ROUNDOFF, Floats

BLOCK = 2**20
"""Point-segment pairs that are in memory at a time; the number does not affect the values."""


def edges_of(rings: Sequence[Floats]) -> tuple[Floats, Floats]:
    """Return the ends, (n, 2) each, of all edges of closed rings."""
    return np.concatenate(rings), np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])


def distances(points: Floats, start: Floats, end: Floats) -> Iterator[Floats]:
    """Yield, for blocks of points, their distances (block, n) from all segments.

    The nearest point of each segment is at a fraction of it that is clamped to [0, 1].
    `rounding_of` bounds the error.
    """
    e = end - start
    squared = np.maximum(np.einsum("ij,ij->i", e, e), np.finfo(np.float64).tiny)
    rows = max(1, BLOCK // max(1, len(start)))
    for first in range(0, len(points), rows):
        d = points[first : first + rows, np.newaxis] - start
        along = np.clip(np.einsum("ijk,jk->ij", d, e) / squared, 0.0, 1.0)
        gap = d - along[..., np.newaxis] * e
        yield np.hypot(gap[..., 0], gap[..., 1])


def rounding_of(*clouds: Floats) -> float:
    """Return a bound on the error of `distances` among these points.

    M is the largest |coordinate|, so |d|, |e| <= 2 sqrt(2) M. An error f of the fraction t moves
    the foot by f |e| along the segment. t = d.e / e.e: each difference carries one rounding, a sum
    of two products two more and the quotient one, so the error of t is at most 8 u |d| / |e| and
    that of the foot 8 u |d| < 23 u M. The errors of the differences d and e are 2 u M per
    coordinate, and t e and d - t e add 2 u and 4 u of M; that is at most 2 sqrt(2) 8 u M < 23 u M
    for the vector. hypot errs by at most 2 u of at most 3 M. The sum is below 64 u M.
    """
    return 64.0 * UNIT_ROUNDOFF * max(float(np.abs(cloud).max()) for cloud in clouds if len(cloud))


def inside_ring(point: Floats, ring: Floats) -> bool:
    """Return whether a point that is on no edge is inside a ring; exact, by a ray's crossings."""
    x, y = Fraction(float(point[0])), Fraction(float(point[1]))
    inside = False
    corners = [(Fraction(px), Fraction(py)) for px, py in ring.tolist()]
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
        if (ay > y) != (by > y) and ((bx - ax) * (y - ay) > (by - ay) * (x - ax)) == (by > ay):
            inside = not inside
    return inside
