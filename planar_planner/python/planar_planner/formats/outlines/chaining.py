"""Closed outlines made of loose lines and arcs, and figures with holes made of outlines."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.curves import (
    Outline,
    Piece,
    first_point,
    flattened,
    last_point,
    reversed_piece,
    straight,
)
from planar_planner.formats.outlines.exact import contains
from planar_planner.formats.outlines.figure import EVENODD, Figure
from planar_planner.formats.parts import Notes, Point, Ring

Run = list[Piece]
Key = tuple[int, int]


def closed_outlines(runs: Sequence[Run], reach: float, place: str, notes: Notes) -> list[Outline]:
    """Join runs end to end, in either direction, until each is closed.

    A straight line joins ends that are no farther apart than `reach`.

    Raises
    ------
    SceneError
        If an end has no other end near it, or more than one.
    """
    whole = [run for run in runs if first_point(run[0]) == last_point(run[-1])]
    runs = [run for run in runs if first_point(run[0]) != last_point(run[-1])]
    outlines = [Outline(tuple(run)) for run in whole]
    ends = _Ends(runs, reach)
    used = [False] * len(runs)
    widest = 0.0
    for first, run in enumerate(runs):
        if used[first]:
            continue
        used[first] = True
        chain = list(run)
        while True:
            end, begin = last_point(chain[-1]), first_point(chain[0])
            found = ends.other_near(end, used)
            gap = math.dist(end, begin)
            if gap <= reach and not found:
                if gap > 0:
                    chain.append(straight(end, begin))
                break
            if len(found) != 1:
                what = "is open" if not found else "has more than two ends that meet"
                raise SceneError(f"outline {what}", place, f"at {end!r}")
            ((index, backwards),) = found
            used[index] = True
            following = runs[index]
            if backwards:
                following = [reversed_piece(piece) for piece in reversed(following)]
            gap = math.dist(end, first_point(following[0]))
            if gap > 0:
                chain.append(straight(end, first_point(following[0])))
            widest = max(widest, gap)
            chain += following
        widest = max(widest, gap)
        outlines.append(Outline(tuple(chain)))
    if widest > 0:
        notes.say(f"{place}: ends that do not meet were joined; the widest gap is {widest!r}")
    return outlines


class _Ends:
    """An index of the runs' ends by place: a grid of cells as wide as the reach."""

    def __init__(self, runs: Sequence[Run], reach: float) -> None:
        self._reach = reach
        self._cells: dict[Key, list[tuple[int, bool, Point]]] = defaultdict(list)
        for index, run in enumerate(runs):
            for backwards, p in ((False, first_point(run[0])), (True, last_point(run[-1]))):
                self._cells[self._key(p)].append((index, backwards, p))

    def _key(self, p: Point) -> Key:
        return math.floor(p[0] / self._reach), math.floor(p[1] / self._reach)

    def other_near(self, p: Point, used: Sequence[bool]) -> list[tuple[int, bool]]:
        """Return (run, whether it has to be reversed) of each unused end near a point."""
        i, j = self._key(p)
        found = []
        for di in (-1, 0, 1):
            for dj in (-1, 0, 1):
                for index, backwards, q in self._cells.get((i + di, j + dj), ()):
                    if not used[index] and math.dist(p, q) <= self._reach:
                        found.append((index, backwards))
        return found


def nested_figures(outlines: Sequence[Outline], tolerance: float, place: str) -> list[Figure]:
    """Return figures of outlines: one inside another is a hole, and one inside a hole is solid.

    Outlines that cross become separate figures, and their union counts.
    """
    import shapely

    rings = [flattened(outline, 1, tolerance) for outline in outlines]
    boxes = shapely.box(*np.array([_box(ring) for ring in rings]).reshape(-1, 4).T)
    owners: list[list[int]] = [[] for _ in rings]
    inner, outer = shapely.STRtree(boxes).query(boxes, predicate="within")
    for i, j in zip(inner.tolist(), outer.tolist(), strict=True):
        if _lies_inside(rings[i], rings[j]):
            owners[i].append(j)
    figures: dict[int, list[Outline]] = {}
    depth: dict[int, int] = {}
    for i in sorted(range(len(rings)), key=lambda i: len(owners[i])):  # outer rings come first
        innermost = max(owners[i], key=depth.__getitem__, default=None)
        depth[i] = 0 if innermost is None else depth[innermost] + 1
        if innermost is None or depth[i] % 2 == 0:
            figures[i] = [outlines[i]]
        else:
            figures[innermost].append(outlines[i])
    return [Figure(tuple(own), EVENODD, place) for own in figures.values()]


def _lies_inside(inner: Ring, outer: Ring) -> bool:
    """Return whether a ring is inside another and touches none of its bounding box's sides."""
    a, b = _box(inner), _box(outer)
    if not (b[0] < a[0] and b[1] < a[1] and b[2] > a[2] and b[3] > a[3]):
        return False
    return all(contains(outer, p) for p in inner)


def _box(ring: Ring) -> tuple[float, ...]:
    xs, ys = zip(*ring, strict=True) if ring else ((0.0,), (0.0,))
    return min(xs), min(ys), max(xs), max(ys)
