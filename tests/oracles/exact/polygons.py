"""Polygons whose coordinates are fractions: turned, measured, dropped on each other."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from fractions import Fraction

from oracles.exact.numbers import sine_cosine

Point = tuple[Fraction, Fraction]
Polygon = list[Point]


def polygon(ring: Sequence[Sequence[float]]) -> Polygon:
    """Return a ring of doubles as the exact numbers that they are."""
    return [(Fraction(p[0]), Fraction(p[1])) for p in ring]


def turned(ring: Polygon, angle: float) -> Polygon:
    """Return a polygon turned about the origin, exactly at angle 0 and to 50 places otherwise."""
    sine, cosine = sine_cosine(angle) if angle else (Fraction(0), Fraction(1))
    return [(cosine * x - sine * y, sine * x + cosine * y) for x, y in ring]


def squared_width(ring: Polygon) -> Fraction:
    """Return the square of a convex polygon's least width: from an edge to the farthest vertex."""
    widths = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        dx, dy = bx - ax, by - ay
        farthest = max(abs(dx * (y - ay) - dy * (x - ax)) for x, y in ring)
        widths.append(farthest**2 / (dx * dx + dy * dy))
    return min(widths)


def squared_diameter(ring: Polygon) -> Fraction:
    """Return the square of the largest distance between two vertices."""
    pairs = itertools.combinations(ring, 2)
    return max((bx - ax) ** 2 + (by - ay) ** 2 for (ax, ay), (bx, by) in pairs)


def drop(upper: Polygon, lower: Polygon) -> Fraction | None:
    """Return how far `upper`, which lies above `lower`, can fall until the two touch.

    None if it misses. The vertical gap is linear between vertices' abscissas, so it is least over
    some vertex of either.
    """
    gaps = [edge - y for x, y in lower for edge in _heights(upper, x)]
    gaps += [y - edge for x, y in upper for edge in _heights(lower, x)]
    return min(gaps, default=None)


def _heights(ring: Polygon, x: Fraction) -> list[Fraction]:
    """Return the ordinates at which the sides of a ring, but upright ones, meet an abscissa."""
    found = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        if ax != bx and min(ax, bx) <= x <= max(ax, bx):
            found.append(ay + (by - ay) * (x - ax) / (bx - ax))
    return found
