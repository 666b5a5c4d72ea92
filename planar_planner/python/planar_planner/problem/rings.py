"""Shapes: rings and polygons as written → clean, valid ones, or the place where they are broken.

A ring may touch itself or another ring where the OGC simple-features rules (as shapely checks
them) allow it: a hole may touch the outer ring or another hole in single points, as long as the
interior stays connected; a ring may not pass through a point twice. Polygons may overlap each
other: each is checked on its own.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError
from planar_planner.scene.raw_polygons import RawPolygons

_UNIT_ROUNDOFF = 2.0**-53

Defect = tuple[int, str]  # index of the first polygon that is not valid, and what is wrong where
Judge = Callable[[RawPolygons], Defect | None]  # of rings with area, without repeated vertices


def clean_polygons(raw: RawPolygons, judge: Judge) -> RawPolygons:
    """Return the same shapes without repeated vertices, having checked every one.

    The repeated last vertex of a closed ring is dropped like any vertex equal to its successor.
    Collinear vertices and orientations stay as they are.

    Parameters
    ----------
    raw : RawPolygons
        As written.
    judge : callable
        Finds the first polygon that is invalid as a simple feature.

    Raises
    ------
    SceneError
        On a ring with fewer than three distinct points or without area, and on a polygon that
        intersects itself; with the path of the ring or polygon in the scene.
    """
    clean = _without_repeats(raw)
    _check_area(clean)
    defect = judge(clean) if clean.paths else None
    if defect is not None:
        polygon, problem = defect
        raise SceneError(f"polygon is not valid: {problem}", clean.paths[polygon])
    return clean


def _without_repeats(raw: RawPolygons) -> RawPolygons:
    """Drop each vertex that equals its cyclic successor in the ring."""
    successor = _successors(raw.ring_starts)
    differs = raw.coords != raw.coords[successor]
    kept = differs[:, 0] | differs[:, 1]  # np.any along so short an axis takes ten times as long
    before = np.concatenate(([0], np.cumsum(kept)))  # kept vertices before each vertex
    return RawPolygons(
        np.ascontiguousarray(raw.coords[kept]),
        before[raw.ring_starts].astype(np.uint32),
        raw.polygon_starts,
        raw.paths,
        raw.owners,
    )


def _successors(ring_starts: NDArray[np.uint32]) -> NDArray[np.int64]:
    """Return for each vertex the index of the next one round its ring."""
    starts = ring_starts.astype(np.int64)
    successor = np.arange(1, starts[-1] + 1)
    filled = starts[1:] > starts[:-1]
    successor[starts[1:][filled] - 1] = starts[:-1][filled]
    return successor


def _check_area(polygons: RawPolygons) -> None:
    """Reject rings whose vertices all lie on one line.

    A ring that encloses no area either lies on a line or intersects itself; the judge of shapes
    finds the second kind. The doubled area a = Σ dᵢ × dᵢ₊₁, d the vertices from the ring's first,
    is computed with an error below (n + 8)·u·Σ(|xᵢyᵢ₊₁| + |yᵢxᵢ₊₁|): u for each difference and
    product, n for the sum, the rest to spare. Only rings within it need the exact test.
    """
    starts = polygons.ring_starts.astype(np.int64)
    counts = np.diff(starts)
    offsets = polygons.coords - polygons.coords[np.repeat(starts[:-1], counts)]
    following = offsets[_successors(polygons.ring_starts)]
    left, right = offsets[:, 0] * following[:, 1], offsets[:, 1] * following[:, 0]
    filled = counts > 0  # a ring of equal points has no vertex left: area 0 within bound 0
    doubled, bound = np.zeros(len(counts)), np.zeros(len(counts))
    doubled[filled] = np.add.reduceat(left - right, starts[:-1][filled])
    bound[filled] = np.add.reduceat(np.abs(left) + np.abs(right), starts[:-1][filled])
    doubtful = np.abs(doubled) <= (counts + 8) * _UNIT_ROUNDOFF * bound
    for ring in np.flatnonzero(doubtful):
        _check_not_flat(
            polygons.coords[starts[ring] : starts[ring + 1]], polygons.ring_path(int(ring))
        )


def _check_not_flat(ring: NDArray[np.float64], path: str) -> None:
    """Reject a ring without three distinct points, or with all of them on a line; exact."""
    points = list(dict.fromkeys(map(tuple, ring.tolist())))
    if len(points) < 3:
        found = f"{max(len(points), 1)} distinct point{'s' if len(points) > 1 else ''}"
        raise SceneError(f"ring must have at least three distinct points, not {found}", path)
    (x0, y0), (x1, y1) = ((Fraction(x), Fraction(y)) for x, y in points[:2])
    for x, y in points[2:]:
        if (x1 - x0) * (Fraction(y) - y0) != (y1 - y0) * (Fraction(x) - x0):
            return
    raise SceneError("ring has zero area: all its points lie on one line", path)


def judged_exactly(polygons: RawPolygons) -> Defect | None:
    """Judge by `pdg`, in exact arithmetic: what the planner takes is valid for the very doubles."""
    from pdg import polygon_defect

    found = polygon_defect(polygons.coords, polygons.ring_starts, polygons.polygon_starts)
    return None if found is None else (found.polygon, str(found))


def judged_by_geos(polygons: RawPolygons) -> Defect | None:
    """Judge by shapely, for who wants nothing of the planner's own; wrong within rounding only."""
    import shapely  # a tenth of a second: only where it is asked

    ring_of_vertex = np.repeat(
        np.arange(len(polygons.ring_starts) - 1), np.diff(polygons.ring_starts)
    )
    polygon_of_ring = np.repeat(np.arange(len(polygons.paths)), np.diff(polygons.polygon_starts))
    rings = shapely.linearrings(polygons.coords, indices=ring_of_vertex)
    shapes = shapely.polygons(rings, indices=polygon_of_ring)
    bad = np.flatnonzero(~shapely.is_valid(shapes))
    if not len(bad):
        return None
    return int(bad[0]), _readable(str(shapely.is_valid_reason(shapes[bad[0]])))


def _readable(reason: str) -> str:
    """Turn GEOS's ``Self-intersection[1 2]`` into ``self-intersection at (1, 2)``."""
    match = re.fullmatch(r"(.*)\[(\S+) (\S+)\]", reason)
    if match is None:
        return reason.lower()
    what, x, y = match.groups()
    return f"{what.lower()} at ({x}, {y})"
