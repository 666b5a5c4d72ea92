"""Exact answers for axis-parallel scenes without turning, by a flood fill of their coordinates.

The translations at which two rectangles overlap are an open rectangle. All sides of these cut the
plane into points, open edges and open faces, and each of them is free as a whole or not at all.
Neighbours in that complex are joined if both are free, because the free set is closed. Numbers are
fractions, so this shares neither arithmetic nor method with the planner.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple


class Rectangle(NamedTuple):
    """xmin, ymin, xmax, ymax."""

    x0: Fraction
    y0: Fraction
    x1: Fraction
    y1: Fraction


def rectangles_of(ring: Sequence[Sequence[float]]) -> list[Rectangle]:
    """Return rectangles whose union is a rectilinear polygon; they may overlap.

    Each is as high as a row of the polygon and as wide as it goes on along that row and, for the
    seams between rows, as one row and the next together.
    """
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    if points[0] == points[-1]:
        points = points[:-1]
    ys = sorted({y for _, y in points})
    rows = [(low, high, _spans(points, (low + high) / 2)) for low, high in pairwise(ys)]
    found = [Rectangle(a, low, b, high) for low, high, spans in rows for a, b in spans]
    for (low, _, below), (_, high, above) in pairwise(rows):
        common = [(max(a, c), min(b, d)) for a, b in below for c, d in above]
        found += [Rectangle(a, low, b, high) for a, b in common if a < b]
    return found


def _spans(
    points: Sequence[tuple[Fraction, Fraction]], y: Fraction
) -> list[tuple[Fraction, Fraction]]:
    xs = sorted(
        ax
        for (ax, ay), (_, by) in zip(points, [*points[1:], points[0]], strict=True)
        if (ay < y) != (by < y)
    )
    return list(zip(xs[::2], xs[1::2], strict=True))


def is_joined(scene: Mapping[str, Any], places: int = 0) -> bool | None:
    """Return whether start and goal are joined; None if one of them is not free.

    The goal may be a region of rectilinear polygons, free or not.
    Lengths are read as decimals of so many places, or as doubles if that is 0.
    """
    read = _reader(places)
    robot = rectangles_of(read(scene["robot"]["coordinates"][0]))
    obstacles = [r for o in scene["obstacles"] for r in rectangles_of(read(o["coordinates"][0]))]
    low_x, low_y, high_x, high_y = read(scene["workspace"]["box"])
    domain = Rectangle(
        max(low_x - r.x0 for r in robot),
        max(low_y - r.y0 for r in robot),
        min(high_x - r.x1 for r in robot),
        min(high_y - r.y1 for r in robot),
    )
    blocked = [
        Rectangle(o.x0 - r.x1, o.y0 - r.y1, o.x1 - r.x0, o.y1 - r.y0)
        for o in obstacles
        for r in robot
    ]
    start, region = read(scene["start"][:2]), _region(scene["goal"], read)
    ends = [start, *((x, y) for r in region for x, y in ((r.x0, r.y0), (r.x1, r.y1)))]
    xs = _halves(domain.x0, domain.x1, [v for b in blocked for v in (b.x0, b.x1)], ends, 0)
    ys = _halves(domain.y0, domain.y1, [v for b in blocked for v in (b.y0, b.y1)], ends, 1)
    free = _free(xs, ys, blocked)
    if start[0] not in xs or start[1] not in ys:
        return None
    begin = xs.index(start[0]), ys.index(start[1])
    goals = {
        (i, k)
        for r in region
        for i, x in enumerate(xs)
        for k, y in enumerate(ys)
        if r.x0 <= x <= r.x1 and r.y0 <= y <= r.y1
    }
    point_is_covered = isinstance(scene["goal"], list) and not any(free[i][k] for i, k in goals)
    if not free[begin[0]][begin[1]] or point_is_covered:
        return None
    return not goals.isdisjoint(_flood(free, begin))


def _region(goal: Any, read: Any) -> list[Rectangle]:
    """Return a goal as closed rectangles; a configuration is one without extent."""
    if isinstance(goal, list):
        x, y = read(goal[:2])
        return [Rectangle(x, y, x, y)]
    geometry = goal["region"]
    rings = geometry["coordinates"]
    if geometry["type"] == "MultiPolygon":
        rings = [polygon[0] for polygon in rings]
    return [r for ring in rings for r in rectangles_of(read(ring))]


def _reader(places: int) -> Any:
    def read(value: Any) -> Any:
        if isinstance(value, (list, tuple)):
            return [read(each) for each in value]
        if not places:
            return Fraction(value)
        return Fraction(round(Fraction(value) * 10**places), 10**places)

    return read


def _halves(
    low: Fraction,
    high: Fraction,
    sides: Sequence[Fraction],
    ends: Sequence[Sequence[Fraction]],
    axis: int,
) -> list[Fraction]:
    """Return coordinates within bounds, and the middles between neighbours."""
    given = {low, high, *sides, *(end[axis] for end in ends)}
    own = sorted(v for v in given if low <= v <= high)
    return sorted({*own, *((a + b) / 2 for a, b in pairwise(own))})


def _free(
    xs: Sequence[Fraction], ys: Sequence[Fraction], blocked: Sequence[Rectangle]
) -> list[list[bool]]:
    free = [[True] * len(ys) for _ in xs]
    for b in blocked:
        columns = [i for i, x in enumerate(xs) if b.x0 < x < b.x1]
        rows = [k for k, y in enumerate(ys) if b.y0 < y < b.y1]
        for i in columns:
            for k in rows:
                free[i][k] = False
    return free


def _flood(free: list[list[bool]], start: tuple[int, int]) -> set[tuple[int, int]]:
    found, open_ends = {start}, [start]
    while open_ends:
        i, k = open_ends.pop()
        for near in ((i + 1, k), (i - 1, k), (i, k + 1), (i, k - 1)):
            inside = 0 <= near[0] < len(free) and 0 <= near[1] < len(free[0])
            if inside and near not in found and free[near[0]][near[1]]:
                found.add(near)
                open_ends.append(near)
    return found
