"""Goal regions for the checker of certificates: exact, in integers; nothing of the planner's.

Polygons are lists of rings of integer points, outer one first, and closed: their boundary belongs
to them. Boxes are closed too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

Vector = tuple[int, int]
Rings = list[list[Vector]]
Region = tuple[int, int, int, int]  # xmin, ymin, xmax, ymax


class GoalArea(NamedTuple):
    """Every configuration with the reference point in one of the polygons and theta in between."""

    polygons: list[Rings]
    angles: tuple[float, float] | None  # radians, up to whole turns; None: any

    def holds(self, point: Vector) -> bool:
        """Whether a point lies in a polygon."""
        return any(in_polygon(rings, point) for rings in self.polygons)

    def meets(self, box: Region) -> bool:
        """Whether a polygon has a point in common with a box."""
        return any(meets_box(rings, box) for rings in self.polygons)


def in_polygon(rings: Rings, p: Vector) -> bool:
    """Whether a polygon holds a point: on an edge, or an odd number of edges to the right."""
    odd = False
    for a, b in _edges(rings):
        side = _cross(a, b, p)
        if side == 0 and _between(a, b, p):
            return True
        if (a[1] > p[1]) != (b[1] > p[1]):  # the edge crosses the point's horizontal line
            odd ^= (side > 0) == (b[1] > a[1])
    return odd


def meets_box(rings: Rings, box: Region) -> bool:
    """Whether an edge meets the box; else the box is wholly inside or wholly outside."""
    return any(_edge_meets(a, b, box) for a, b in _edges(rings)) or in_polygon(rings, box[:2])


def _edges(rings: Rings) -> Iterator[tuple[Vector, Vector]]:
    for ring in rings:
        yield from zip(ring, [*ring[1:], *ring[:1]], strict=True)


def _edge_meets(a: Vector, b: Vector, box: Region) -> bool:
    """Whether neither a side of the box nor the edge's line has the two strictly apart."""
    xmin, ymin, xmax, ymax = box
    if max(a[0], b[0]) < xmin or xmax < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < ymin or ymax < min(a[1], b[1]):
        return False
    corners: Sequence[Vector] = [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]
    sides = [_cross(a, b, corner) for corner in corners]
    return min(sides) <= 0 <= max(sides)


def _cross(a: Vector, b: Vector, p: Vector) -> int:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _between(a: Vector, b: Vector, p: Vector) -> bool:
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])
