"""Distances of points from segments with their rounding error, and exact inclusion in a ring."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np

from planar_planner.margins.body import UNIT_ROUNDOFF, Floats

BLOCK = 2**20
"""Point-segment pairs that are in memory at a time; of no influence on the values."""


def edges_of(rings: Sequence[Floats]) -> tuple[Floats, Floats]:
    """Return the ends, (n, 2) each, of all edges of closed rings."""
    return np.concatenate(rings), np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])


def distances(points: Floats, start: Floats, end: Floats) -> Iterator[Floats]:
    """Yield, for blocks of points, their distances (block, n) from all segments.

    The foot is clamped to the segment and computed from the nearer of roundings' side: what comes
    out is the distance to a point within 6 u M of the segment, M the largest coordinate, computed
    with a relative error of 4 u; `rounding_of` bounds the sum.
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

    M is the largest |coordinate|. d and e are differences: off by at most 2 u M in each
    coordinate. A clamped parameter t that is off by f moves the foot along the segment, to a
    point of it all the same, which changes the least distance by second order only upwards: the
    foot stays a point of the segment, so the value is never too small, and too large by at most
    f |e|. t is off by at most 8 u |d| / |e| (a sum of two products and a quotient, each factor right
    to 2 u), so f |e| <= 8 u |d| <= 24 u M. The product t e and the difference add 3 u M each
    coordinate, hypot 4 u of at most 3 M. All in all below 24 + 2 * 8 + 12 < 64.
    """
    return 64.0 * UNIT_ROUNDOFF * max(float(np.abs(cloud).max()) for cloud in clouds if len(cloud))


def inside_ring(point: Floats, ring: Floats) -> bool:
    """Whether a point that is on no edge is inside a ring; exact, by crossings of a ray."""
    x, y = Fraction(float(point[0])), Fraction(float(point[1]))
    inside = False
    corners = [(Fraction(px), Fraction(py)) for px, py in ring.tolist()]
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
        if (ay > y) != (by > y) and ((bx - ax) * (y - ay) > (by - ay) * (x - ax)) == (by > ay):
            inside = not inside
    return inside
