"""Figures with holes made of outlines: every second one of those inside each other is a hole."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from planar_planner.formats.outlines.curves import (
    Outline,
    control_points,
    first_point,
    flattened,
    last_point,
    straight,
)
from planar_planner.formats.outlines.figure import EVENODD, Figure
from planar_planner.formats.outlines.rings import MIN_RING
from planar_planner.formats.outlines.strands import Traced
from planar_planner.formats.parts import Notes, Point

_ENDS = (min, max)
_NAMED = 3  # entities that a message names at most


@dataclass(frozen=True)
class Nesting:
    """Lengths in the drawing's unit, and the layer for messages.

    Attributes
    ----------
    tolerance : float
        Greatest distance of a flattened outline from its curve.
    reach : float
        Corners that are no farther from the edge of another outline are on it: rounding moves the
        corners of outlines that touch.
    place : str
    """

    tolerance: float
    reach: float
    place: str


def nested_figures(traced: Sequence[Traced], how: Nesting, notes: Notes) -> list[Figure]:
    """Return figures of outlines: one inside another is a hole, and one inside a hole is solid.

    A hole may touch its outline or share edges with it. Outlines that cross become separate
    figures, and their union counts. Outlines that are drawn twice count once.
    """
    import shapely

    areas = _areas(traced, how.tolerance)
    inner, outer = shapely.STRtree(areas).query(areas, predicate="covered_by").tolist()
    inside = {(i, j) for i, j in zip(inner, outer, strict=True) if i != j}
    outlines = [item.outline for item in traced]
    inside |= _inside_within_rounding(areas, outlines, how)
    twice = {i for i, j in inside if j < i and (j, i) in inside}
    notes.count("outlines that are drawn twice taken once", len(twice))
    owners: list[list[int]] = [[] for _ in traced]
    for i, j in sorted(inside):
        if i not in twice and j not in twice:
            owners[i].append(j)
    figures: dict[int, list[int]] = {}
    depth: dict[int, int] = {}
    for i in sorted(range(len(traced)), key=lambda i: len(owners[i])):  # outer outlines come first
        if i in twice:
            continue
        innermost = max(owners[i], key=depth.__getitem__, default=None)
        depth[i] = 0 if innermost is None else depth[innermost] + 1
        if innermost is None or depth[i] % 2 == 0:
            figures[i] = [i]
        else:
            figures[innermost].append(i)
    return [
        Figure(
            tuple(outlines[i] for i in own),
            EVENODD,
            _place(how.place, [name for i in own for name in traced[i].names]),
        )
        for own in figures.values()
    ]


def _place(place: str, names: list[str]) -> str:
    several = "" if len(names) <= _NAMED else f" and {len(names) - _NAMED} more"
    return f"{place}, {', '.join(names[:_NAMED])}{several}" if names else place


def _areas(traced: Sequence[Traced], tolerance: float) -> Any:
    """Return what the outlines enclose, as shapely geometries; those far from all others empty."""
    import numpy as np
    import shapely

    areas = np.array([shapely.Polygon()] * len(traced), dtype=object)
    corners = [control_points(item.outline) for item in traced]
    lows, highs = ([tuple(map(end, zip(*own, strict=True))) for own in corners] for end in _ENDS)
    boxes = shapely.box(*np.array(lows).T, *np.array(highs).T)
    first, second = shapely.STRtree(boxes).query(boxes)
    for i in np.unique(first[first != second]).tolist():
        ring = flattened(traced[i].outline, 1, tolerance)
        if len(ring) >= MIN_RING:
            areas[i] = shapely.Polygon(ring)
    broken = ~shapely.is_valid(areas)
    areas[broken] = shapely.make_valid(areas[broken])
    return areas


def _inside_within_rounding(
    areas: Any, outlines: list[Outline], how: Nesting
) -> set[tuple[int, int]]:
    """Return the pairs (inner, outer) that cross by no more than rounding and flattening.

    Corners of straight outlines that lie on an edge of the other by rounding become its corners.
    """
    import shapely

    found = set()
    first, second = shapely.STRtree(areas).query(areas, predicate="overlaps").tolist()
    for i, j in zip(first, second, strict=True):
        curved = outlines[i].curved or outlines[j].curved
        near = 2 * how.tolerance if curved else how.reach
        if not areas[j].buffer(near, join_style="mitre").covers(areas[i]):
            continue
        found.add((i, j))
        if not curved:
            corners = [first_point(piece) for piece in outlines[i].pieces]
            outlines[j] = _with_corners(outlines[j], corners, how.reach)
            corners = [first_point(piece) for piece in outlines[j].pieces]
            outlines[i] = _with_corners(outlines[i], corners, how.reach)
    return found


def _with_corners(outline: Outline, corners: Sequence[Point], reach: float) -> Outline:
    """Return an outline of straight lines that passes through the corners near its edges."""
    import shapely

    points = shapely.points(corners)
    own = {first_point(piece) for piece in outline.pieces}
    pieces = []
    for piece in outline.pieces:
        begin, end = first_point(piece), last_point(piece)
        edge = shapely.LineString([begin, end])
        near = [
            p
            for p, distance in zip(corners, shapely.distance(points, edge).tolist(), strict=True)
            if distance <= reach and p not in own
        ]
        near.sort(key=lambda p: shapely.line_locate_point(edge, shapely.Point(p)))
        stops = [begin, *dict.fromkeys(near), end]
        pieces += [straight(a, b) for a, b in itertools.pairwise(stops)]
    return Outline(tuple(pieces))
