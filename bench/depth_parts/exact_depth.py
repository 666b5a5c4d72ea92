"""Depths and displacements of the doubles as given, to 50 places, and other ways to find them."""

from __future__ import annotations

import decimal
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

import numpy as np
import shapely
from numpy.typing import NDArray
from stress_parts.exact import PLACES, polygon, turned

Array = NDArray[np.float64]
Pose = tuple[float, float, float]


def number(value: Fraction) -> Decimal:
    """Return a fraction to the context's precision."""
    return Decimal(value.numerator) / value.denominator


def placed_exactly(ring: Array, pose: Pose) -> list[tuple[Decimal, Decimal]]:
    """Return a body at a configuration, sine and cosine to 50 places."""
    x, y = Fraction(pose[0]), Fraction(pose[1])
    points = turned(polygon(ring.tolist()), pose[2])
    return [(number(px + x), number(py + y)) for px, py in points]


def exact_depth(a: Array, b: Array, pose: Pose) -> Decimal:
    """Return PD^t of two convex polygons that overlap.

    It is the origin's least distance from an edge of B minus A, and every edge of that is parallel
    to one of B or of A: the least way out over the outward normals of either's edges.
    """
    with decimal.localcontext() as context:
        context.prec = PLACES + 10
        moved, fixed = placed_exactly(a, pose), placed_exactly(b, (0.0, 0.0, 0.0))
        return min(_escape(moved, fixed), _escape(fixed, moved))


def _escape(
    ring: Sequence[tuple[Decimal, Decimal]], other: Sequence[tuple[Decimal, Decimal]]
) -> Decimal:
    ways = []
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
        nx, ny = by - ay, ax - bx
        deepest = max(nx * (ax - x) + ny * (ay - y) for x, y in other)
        ways.append(deepest / (nx * nx + ny * ny).sqrt())
    return min(ways)


def exact_displacement(ring: Array, q0: Pose, q1: Pose) -> Decimal:
    """Return the largest distance that a vertex moves."""
    with decimal.localcontext() as context:
        context.prec = PLACES + 10
        ends = zip(placed_exactly(ring, q0), placed_exactly(ring, q1), strict=True)
        return max((bx - ax) ** 2 + (by - ay) ** 2 for (ax, ay), (bx, by) in ends).sqrt()


def placed(ring: Array, pose: Pose) -> Array:
    """Return a body at a configuration in doubles."""
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.asarray(ring @ np.array([[c, s], [-s, c]]) + pose[:2])


def minkowski_depth(a: Array, b: Array, pose: Pose) -> float:
    """Return PD^t as the origin's distance from the boundary of the hull of all b - a (shapely)."""
    moved = placed(a, pose)
    sums = (b[:, None, :] - moved[None, :, :]).reshape(-1, 2)
    difference = shapely.MultiPoint(sums).convex_hull
    return float(difference.exterior.distance(shapely.Point(0, 0)))


def sampled_depth(a: Array, b: Array, pose: Pose, directions: int) -> float:
    """Return the least way out over evenly spread directions: an upper bound of PD^t."""
    angles = 2 * np.pi * np.arange(directions) / directions
    normals = np.stack([np.cos(angles), np.sin(angles)])
    return float(np.min((b @ normals).max(axis=0) - (placed(a, pose) @ normals).min(axis=0)))
