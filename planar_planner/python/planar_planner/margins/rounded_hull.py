"""A convex polygon grown by a distance, between an inner and an outer polygon's radius.

K is a convex polygon, or a segment. K + D_r, the sum with a disc, has round corners; Q is the
polygon circumscribed about it whose edges touch each round corner in equal steps of angle. What is
claimed of Q is measured on its rounded vertices, not assumed of their construction:

- K + D_inner is inside Q: for every edge of Q all of K is to its left by at least `inner`. So
  K + D_inner is in the intersection of these half-planes, which is in the simple polygon Q.
- Q is inside K + D_outer: every vertex of Q is within `outer` of a vertex of K, and K + D_outer is
  convex, so it holds the hull of Q's vertices.

Rounding (u = 2^-53). The distance of p from the line a b is c / l, c = e_x d_y - e_y d_x with
e = b - a, d = p - a. Both differences carry one rounding, each product two of these and its own, so
c is off by at most (3 u + O(u^2)) (|e_x d_y| + |e_y d_x|) + u |c|; division by l, itself right to
2 u, adds 3 u relative. 8 u (|e_x d_y| + |e_y d_x|) / l bounds all of it, since |c| is at most that
sum. A distance of two points is right to 4 u of itself.
"""

from __future__ import annotations

import math

import numpy as np

from planar_planner.margins.body import UNIT_ROUNDOFF, ClaimError, Floats

MOST_STEPS = 4096
"""Edges that a full turn may take. excess / radius = (tau / MOST_STEPS)^2 / 8 = 3e-7, so tolerances
from about two millionths of the margin can be met; queries about larger bodies take too long."""


def circumscribed(ring: Floats, radius: float, excess: float) -> Floats:
    """Return a polygon round K + D_radius, within about radius + excess of K.

    Parameters
    ----------
    ring : (n, 2)
        K, anticlockwise and strictly convex, or the two ends of a segment.
    radius, excess : float
        Positive lengths.

    Raises
    ------
    ClaimError
        If that takes more than `MOST_STEPS` edges a turn.
    """
    edges = np.roll(ring, -1, axis=0) - ring
    angles = np.arctan2(-edges[:, 0], edges[:, 1])  # of the outward normals
    before = np.roll(angles, 1)  # of the edge that ends in a vertex
    turns = np.mod(angles - before, math.tau)
    step = 2.0 * math.acos(radius / (radius + excess))
    if step * MOST_STEPS < math.tau:
        raise ClaimError("the width is too small beside the margin: a body has too many edges")
    points: list[Floats] = []
    for vertex, first, turn in zip(ring, before, turns, strict=True):
        count = max(1, math.ceil(turn / step))
        middle = first + (np.arange(count) + 0.5) * (turn / count)
        reach = radius / math.cos(0.5 * turn / count)
        points.append(vertex + reach * np.column_stack([np.cos(middle), np.sin(middle)]))
    return np.concatenate(points)


def inner_radius(core: Floats, around: Floats) -> float:
    """Return a radius r, rounded down, such that K + D_r is inside the polygon `around`."""
    start = around[:, np.newaxis]
    e = np.roll(around, -1, axis=0)[:, np.newaxis] - start
    d = core[np.newaxis] - start
    left, right = e[..., 0] * d[..., 1], e[..., 1] * d[..., 0]
    length = np.hypot(e[..., 0], e[..., 1])
    error = 8.0 * UNIT_ROUNDOFF * (np.abs(left) + np.abs(right)) / length
    return float(((left - right) / length - error).min())


def outer_radius(core: Floats, around: Floats) -> float:
    """Return a radius r, rounded up, such that every vertex of `around` is within r of K's."""
    gap = around[:, np.newaxis] - core[np.newaxis]
    nearest = np.hypot(gap[..., 0], gap[..., 1]).min(axis=1)
    return float(nearest.max()) * (1.0 + 8.0 * UNIT_ROUNDOFF)
