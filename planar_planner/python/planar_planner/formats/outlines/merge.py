"""Unions of many pieces, as few polygons of exactly the same region.

Pieces that touch are united if this needs no computed point: every edge of the union then lies on
an edge between points of the file. Otherwise the pieces stay as they are. The scene format allows
this, because obstacles and parts of a robot may overlap.
"""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from typing import Any

from planar_planner.formats.outlines.exact import orientation
from planar_planner.formats.outlines.rings import MIN_RING, polygons_of
from planar_planner.formats.parts import Notes, Point, Ring, Shape


@dataclass(frozen=True)
class Merged:
    """Valid polygons, and the indices of the pieces that they are made of."""

    shapes: list[Shape]
    pieces: list[int]


def merged(pieces: Sequence[Ring], place: str, notes: Notes) -> list[Merged]:
    """Return the union of rings, each a simple polygon of any orientation or without area.

    Returns
    -------
    list of Merged
        Valid polygons with the same union as the pieces that have area, by what hangs together.
    """
    import shapely

    found = _distinct(pieces, notes)
    kept = [ring for ring, _ in found]
    if not kept:
        return []
    polygons = shapely.polygons([shapely.linearrings(ring) for ring in kept])
    groups = _touching(polygons)
    united: list[Merged] = []
    for group in groups:
        union = _united(polygons[group], [kept[i] for i in group]) if len(group) > 1 else None
        if union is None:
            united += [
                Merged(polygons_of([ring], place, notes), pieces)
                for ring, pieces in (found[i] for i in group)
            ]
            if len(group) > 1:
                notes.count(f"overlapping pieces of the {place} kept apart", len(group))
            continue
        shapes = [s for polygon in union for s in polygons_of(polygon, place, notes, "evenodd")]
        united.append(Merged(shapes, [k for i in group for k in found[i][1]]))
        notes.count(f"pieces of the {place} united", len(group))
    return united


def _distinct(pieces: Sequence[Ring], notes: Notes) -> list[tuple[Ring, list[int]]]:
    """Return each piece with area once, with the indices of all its copies."""
    found: dict[Hashable, tuple[Ring, list[int]]] = {}
    flat = copies = 0
    for k, ring in enumerate(pieces):
        turns = [orientation(ring[0], b, c) for b, c in itertools.pairwise(ring[1:])]
        if not any(turns):
            flat += 1
            continue
        same = frozenset(ring) if len(ring) == MIN_RING else tuple(ring)  # larger have an order
        if same in found:
            copies += 1
        found.setdefault(same, (ring, []))[1].append(k)
    notes.count("pieces without area dropped", flat)
    notes.count("copies of other pieces dropped", copies)
    return list(found.values())


def _touching(polygons: Any) -> list[list[int]]:
    """Return the connected groups of polygons, as lists of indices."""
    import shapely

    first, second = shapely.STRtree(polygons).query(polygons, predicate="intersects")
    leader = list(range(len(polygons)))

    def find(i: int) -> int:
        while leader[i] != i:
            leader[i] = leader[leader[i]]
            i = leader[i]
        return i

    for i, j in zip(first.tolist(), second.tolist(), strict=True):
        a, b = find(i), find(j)
        leader[max(a, b)] = min(a, b)
    groups: dict[int, list[int]] = {}
    for i in range(len(polygons)):
        groups.setdefault(find(i), []).append(i)
    return list(groups.values())


def _united(polygons: Any, rings: Sequence[Ring]) -> list[Shape] | None:
    """Return GEOS's union if its boundary runs along edges of the pieces, otherwise None.

    GEOS decides by robust predicates and rounds only computed points. So a union has no rounded
    boundary if each of its edges is an edge of a piece or lies on one.
    """
    import shapely

    if not shapely.is_valid(polygons).all():
        return None  # a face that crosses itself is refused with its place, not united
    try:
        union = shapely.union_all(polygons)
    except shapely.errors.GEOSException:  # GEOS gives up on some overlaps of rounded corners
        return None
    parts = [p for p in shapely.get_parts(union) if p.geom_type == "Polygon"]
    shapes = [
        [[(x, y) for x, y in ring.coords[:-1]] for ring in (part.exterior, *part.interiors)]
        for part in parts
    ]
    points = {p for ring in rings for p in ring}
    edges = [(a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    known = {frozenset(edge) for edge in edges}
    tree = None
    for shape in shapes:
        for ring in shape:
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
                if a not in points or b not in points:
                    return None
                if frozenset((a, b)) in known:
                    continue
                tree = tree or shapely.STRtree([shapely.box(*_box(e)) for e in edges])
                near = tree.query(shapely.box(*_box((a, b)))).tolist()
                if not any(_on(edges[i], a) and _on(edges[i], b) for i in near):
                    return None
    return shapes


def _box(edge: tuple[Point, Point]) -> tuple[float, float, float, float]:
    (ax, ay), (bx, by) = edge
    return min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)


def _on(edge: tuple[Point, Point], p: Point) -> bool:
    """Return whether p lies on an edge; exact."""
    xmin, ymin, xmax, ymax = _box(edge)
    inside = xmin <= p[0] <= xmax and ymin <= p[1] <= ymax
    return inside and orientation(*edge, p) == 0
