"""GeoJSON geometry objects → flat arrays of polygons as written.

Nothing is known of the shapes afterwards except that every number is finite and of sane magnitude;
`planar_planner.problem.rings` checks the shapes. Loops run per geometry; per vertex everything is
done by numpy or C-level iteration, with a slow walk only to find the place of an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, shown
from planar_planner.scene import fields
from planar_planner.scene.geojson import iter_polygons, plain_polygon
from planar_planner.scene.input_limits import MAX_COORDINATE, MIN_COORDINATE


@dataclass(frozen=True, eq=False)
class RawPolygons:
    """Polygons as written: rings open or closed, vertices repeated or not, any orientation.

    Attributes
    ----------
    coords : NDArray, shape (N, 2)
        All vertices, ring after ring.
    ring_starts : NDArray, shape (R + 1,)
        Ring r is ``coords[ring_starts[r]:ring_starts[r + 1]]``.
    polygon_starts : NDArray, shape (P + 1,)
        Polygon p has the rings ``polygon_starts[p]:polygon_starts[p + 1]``, the outer one first.
    paths : tuple of str
        Field path of each polygon's list of rings.
    owners : NDArray, shape (P,)
        Index of the geometry that each polygon belongs to.
    """

    coords: NDArray[np.float64]
    ring_starts: NDArray[np.uint32]
    polygon_starts: NDArray[np.uint32]
    paths: tuple[str, ...]
    owners: NDArray[np.uint32]

    def ring_path(self, ring: int) -> str:
        """Return the field path of a ring."""
        polygon = int(np.searchsorted(self.polygon_starts, ring, side="right")) - 1
        return f"{self.paths[polygon]}[{ring - int(self.polygon_starts[polygon])}]"

    def vertex_path(self, vertex: int) -> str:
        """Return the field path of a vertex."""
        ring = int(np.searchsorted(self.ring_starts, vertex, side="right")) - 1
        return f"{self.ring_path(ring)}[{vertex - int(self.ring_starts[ring])}]"


def read_polygons(geometries: Iterable[tuple[str, object]]) -> RawPolygons:
    """Flatten geometries into arrays.

    Parameters
    ----------
    geometries : iterable of (path, geometry)
        GeoJSON objects, each with its field path.

    Raises
    ------
    SceneError
        On a geometry that is none, an empty one, a wrong structure, or a number out of bounds.
    """
    paths: list[str] = []
    owners: list[int] = []
    polygons: list[list[Any]] = []
    for owner, (path, geometry) in enumerate(geometries):
        if (rings := plain_polygon(geometry)) is not None:
            paths.append(f"{path}.coordinates")
            owners.append(owner)
            polygons.append(rings)
            continue
        for polygon_path, polygon in iter_polygons(geometry, path):
            paths.append(polygon_path)
            owners.append(owner)
            polygons.append(polygon)
    all_rings: list[Any] = list(chain.from_iterable(polygons))
    coords = _coordinates(polygons, all_rings, paths)
    raw = RawPolygons(
        coords,
        _starts(map(len, all_rings)),
        _starts(map(len, polygons)),
        tuple(paths),
        np.array(owners, dtype=np.uint32),
    )
    _check_magnitudes(raw)
    return raw


def _starts(lengths: Iterable[int]) -> NDArray[np.uint32]:
    """Return the running sum of lengths, beginning with 0."""
    return np.array([0, *np.cumsum(np.fromiter(lengths, dtype=np.int64))], dtype=np.uint32)


def _coordinates(
    polygons: Sequence[Sequence[Any]], rings: Sequence[Any], paths: Sequence[str]
) -> NDArray[np.float64]:
    """Return all vertices, having checked by type alone that each is a list of two numbers."""
    if set(map(type, rings)) <= {list}:
        positions: list[Any] = list(chain.from_iterable(rings))
        if set(map(type, positions)) <= {list} and set(map(len, positions)) <= {2}:
            numbers: list[Any] = list(chain.from_iterable(positions))
            if set(map(type, numbers)) <= {int, float}:
                try:
                    return np.array(numbers, dtype=np.float64).reshape(-1, 2) + 0.0  # no -0.0
                except OverflowError:
                    pass  # an integer beyond the doubles: the walk below finds it
    raise _misplaced(polygons, paths)


def _misplaced(polygons: Sequence[Sequence[Any]], paths: Sequence[str]) -> SceneError:
    """Return the error for the first value that breaks the structure list of [x, y]."""
    for path, rings in zip(paths, polygons, strict=True):
        for r, ring in enumerate(rings):
            if not isinstance(ring, list):
                return SceneError("a ring must be a list of [x, y]", f"{path}[{r}]", shown(ring))
            for v, position in enumerate(ring):
                place = f"{path}[{r}][{v}]"
                if not isinstance(position, list) or len(position) != 2:
                    return SceneError("a position must be [x, y]", place, shown(position))
                try:
                    for axis in range(2):
                        fields.number(position[axis], f"{place}[{axis}]")
                except SceneError as error:
                    return error
    raise AssertionError("no misplaced value in geometry that failed the check by type")


def _check_magnitudes(raw: RawPolygons) -> None:
    size = np.abs(raw.coords)
    bad = ~(size <= MAX_COORDINATE) | ((size > 0) & (size < MIN_COORDINATE))  # ~(NaN <= x) is true
    if bad.any():
        vertex, axis = (int(i) for i in np.argwhere(bad)[0])
        fields.coordinate(float(raw.coords[vertex, axis]), f"{raw.vertex_path(vertex)}[{axis}]")
