"""Goal regions, decided exactly in integers (docs/certificate.md, "What the checker establishes").

Polygons are closed: their boundary belongs to them. Rectangles are closed too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from planar_planner.checker.arithmetic import (
    TURNS_ERROR,
    Polygon,
    Rectangle,
    Vector,
    angle_of,
    bounding_box,
    cyclic_pairs,
    turns_of,
)

Number = int | Fraction
Point = tuple[Number, Number]


class GoalArea(NamedTuple):
    """Every configuration with the reference point in one of the polygons and theta in between."""

    polygons: list[Polygon]
    angles: tuple[float, float] | None  # radians, up to whole turns; None: any

    def holds(self, point: Vector) -> bool:
        """Whether a point lies in a polygon."""
        return any(in_polygon(polygon, point) for polygon in self.polygons)

    def meets(self, rectangle: Rectangle) -> bool:
        """Whether a polygon has a point in common with a rectangle."""
        return any(meets_rectangle(polygon, rectangle) for polygon in self.polygons)

    def meets_curve(self, curve: Sequence[Point]) -> bool:
        """Whether a closed polyline has a point in common with a polygon.

        It lies wholly outside if one of its points does and no segment meets an edge.
        """
        for polygon in self.polygons:
            if in_polygon(polygon, curve[0]):
                return True
            edges = list(_edges(polygon))
            if any(_segments_meet(s, e) for s in cyclic_pairs(curve) for e in edges):
                return True
        return False

    def may_have_angle(self, first: Fraction, last: Fraction) -> bool:
        """Whether some angle may lie between two in turns, whole turns apart or not."""
        if self.angles is None:
            return True
        low, high = (turns_of(angle_of(theta)) for theta in self.angles)
        low, high = low % 1, high - low + low % 1
        return any(
            low + n - TURNS_ERROR <= last and first <= high + n + TURNS_ERROR for n in (-1, 0, 1)
        )


def in_polygon(polygon: Polygon, point: Point) -> bool:
    """Whether a polygon holds a point: on an edge, or an odd number of edges to the right."""
    odd = False
    for a, b in _edges(polygon):
        side = _side(a, b, point)
        if side == 0 and _in_box_of(a, b, point):
            return True
        if (a[1] > point[1]) != (b[1] > point[1]):  # the edge crosses the point's horizontal line
            odd ^= (side > 0) == (b[1] > a[1])
    return odd


def meets_rectangle(polygon: Polygon, rectangle: Rectangle) -> bool:
    """Whether an edge meets the rectangle; else that is wholly inside or wholly outside."""
    if any(_edge_meets(a, b, rectangle) for a, b in _edges(polygon)):
        return True
    return in_polygon(polygon, rectangle[:2])


def _segments_meet(s: tuple[Point, Point], e: tuple[Point, Point]) -> bool:
    """Whether two closed segments have a common point, or may: their ends' sides do not tell."""
    (a, b), (c, d) = s, e
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    one_side = _turn(a, b, c) * _turn(a, b, d) > 0
    other_side = _turn(c, d, a) * _turn(c, d, b) > 0
    return not one_side and not other_side


def _turn(a: Point, b: Point, p: Point) -> Number:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _edges(polygon: Polygon) -> Iterator[tuple[Vector, Vector]]:
    for ring in polygon:
        yield from cyclic_pairs(ring)


def _edge_meets(a: Vector, b: Vector, rectangle: Rectangle) -> bool:
    """Whether neither a side of the rectangle nor the edge's line has the two strictly apart."""
    xmin, ymin, xmax, ymax = rectangle
    if max(a[0], b[0]) < xmin or xmax < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < ymin or ymax < min(a[1], b[1]):
        return False
    corners = ((xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax))
    sides = [_side(a, b, corner) for corner in corners]
    return min(sides) <= 0 <= max(sides)


def _side(a: Vector, b: Vector, point: Point) -> Number:
    """Return a number that is positive to the left of the line from a to b, and 0 on it."""
    return _turn(a, b, point)


def _in_box_of(a: Vector, b: Vector, point: Point) -> bool:
    xmin, ymin, xmax, ymax = bounding_box((a, b))
    return xmin <= point[0] <= xmax and ymin <= point[1] <= ymax
