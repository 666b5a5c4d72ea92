"""What is wrong with polygons, decided exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg.aliases import Point, RealArray, Rows
from pdg.errors import PdgError


@dataclass(frozen=True, slots=True)
class PolygonDefect:
    """What makes a polygon invalid; its string says so in words.

    Attributes
    ----------
    polygon : int
        Index of the polygon.
    problem : str
        What is wrong, after OGC 06-103r4, 6.1.11: "self-intersection", "ring self-intersection",
        and so on.
    where : tuple of float or None
        A point at which it is wrong, rounded; None if there is no such point.
    """

    polygon: int
    problem: str
    where: Point | None

    def __str__(self) -> str:
        if self.where is None:
            return self.problem
        x, y = self.where
        return f"{self.problem} at ({x:.15g}, {y:.15g})"


def polygon_defect(
    coords: RealArray | Rows,
    ring_starts: RealArray | Sequence[int],
    polygon_starts: RealArray | Sequence[int],
) -> PolygonDefect | None:
    """Return the first polygon that is not valid as a simple feature, and what is wrong with it.

    A polygon is valid if no ring meets itself, rings touch each other in single points only, holes
    lie within the outer ring and outside each other, and the interior is connected. This is decided
    exactly, for the very doubles given. Polygons may overlap: each is looked at on its own.

    Parameters
    ----------
    coords : array_like of shape (n, 2)
        The vertices of all rings, ring after ring, without a repeated last vertex.
    ring_starts : array_like of int, shape (r + 1,)
        Ring i has the vertices ``ring_starts[i]`` to ``ring_starts[i + 1]``. These are the offsets
        of `shapely.to_ragged_array`, whose rings are closed, however.
    polygon_starts : array_like of int, shape (p + 1,)
        Polygon k has the rings ``polygon_starts[k]`` to ``polygon_starts[k + 1]``, the outer one
        first.

    Returns
    -------
    PolygonDefect or None
        None if all polygons are valid.

    Raises
    ------
    PdgError
        For arrays of other shapes or types, and for starts that do not fit together.
    """
    points = _gate.numbers(coords, "coords")
    if points.ndim != 2 or points.shape[1] != 2:
        raise PdgError("expected an array of shape (n, 2)", "coords", value=points.shape)
    points = np.ascontiguousarray(points)
    rings = _gate.starts(ring_starts, "ring_starts", len(points))
    polygons = _gate.starts(polygon_starts, "polygon_starts", len(rings) - 1)
    early = _evident_defect(points, rings, polygons)
    if early is not None:  # the core looks at the polygons before that one
        polygons = polygons[: early.polygon + 1]
        rings = rings[: int(polygons[-1]) + 1]
        points = points[: int(rings[-1])]
    found = _core.first_defect(points, rings, polygons)
    if found is None:
        return early
    polygon, problem, where = found
    return PolygonDefect(polygon, problem, where)


def _evident_defect(
    points: NDArray[np.float64], rings: NDArray[np.uint32], polygons: NDArray[np.uint32]
) -> PolygonDefect | None:
    """Return the first defect that the core takes for granted not to be there."""
    found = []
    wrong = np.flatnonzero(~_gate.in_range(points).all(axis=1))
    if len(wrong):
        ring = int(np.searchsorted(rings, wrong[0], side="right")) - 1
        x, y = points[wrong[0]].tolist()
        problem = "coordinate outside the range of exact arithmetic"
        found.append(PolygonDefect(_polygon_of(ring, polygons), problem, (x, y)))
    short = np.flatnonzero(np.diff(rings.astype(np.int64)) < _gate.LEAST_VERTICES)
    if len(short):
        problem = "ring with fewer than three vertices"
        found.append(PolygonDefect(_polygon_of(int(short[0]), polygons), problem, None))
    return min(found, key=lambda defect: defect.polygon, default=None)


def _polygon_of(ring: int, polygons: NDArray[np.uint32]) -> int:
    return int(np.searchsorted(polygons, ring, side="right")) - 1
