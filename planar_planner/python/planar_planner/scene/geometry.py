"""Geometry as users hold it → GeoJSON: shapely, GeoJSON mappings, arrays of vertices.

Only forms are told apart here; whether a polygon is one is found out by `planar_planner.problem`.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, Protocol, TypeAlias

from planar_planner.errors import SceneError, shown
from planar_planner.scene.collector import collector_paused
from planar_planner.scene.plain import plain


class GeoObject(Protocol):
    """A geometry object, as shapely and others make them."""

    @property
    def __geo_interface__(self) -> Mapping[str, Any]:
        """The geometry as GeoJSON."""
        ...


class Array(Protocol):
    """An array, as numpy and others make them."""

    def tolist(self) -> Any:
        """Return the values as nested lists."""
        ...


Geometry: TypeAlias = GeoObject | Array | Mapping[str, Any] | Sequence[Sequence[float]]
"""A polygon or several, or the vertices of one ring, shape (n, 2)."""

Numbers: TypeAlias = Array | Sequence[float]
"""A few numbers in a row: a configuration, a box."""

_POLYGON = "a polygon (shapely or GeoJSON) or an array of vertices, shape (n, 2)"


def body(value: Geometry | Sequence[Geometry], field: str) -> dict[str, Any]:
    """Return one geometry; several in a sequence become a GeometryCollection.

    Raises
    ------
    SceneError
        If the value is of none of the forms; without a source.
    """
    found = plain(value, field)
    if isinstance(found, list) and found and not _is_ring(found):
        parts = [_polygon(part, f"{field}[{i}]") for i, part in enumerate(found)]
        return {"type": "GeometryCollection", "geometries": parts}
    return _polygon(found, field)


def geometries(value: Geometry | Sequence[Geometry], field: str) -> list[Any]:
    """Return a list of geometries; a collection, or a polygon of several parts, is split.

    Raises
    ------
    SceneError
        If the value or a part of it is of none of the forms; without a source.
    """
    flat = polygons_of_shapely(value)
    if flat is not None:
        return flat
    found = plain(value, field)
    if isinstance(found, dict):
        return _members(found)
    if _is_ring(found):
        return [_polygon(found, field)]
    if isinstance(found, list):
        return [_polygon(part, f"{field}[{i}]") for i, part in enumerate(found)]
    raise SceneError(f"must be a sequence, each {_POLYGON}", field, shown(found))


def workspace(value: Geometry | Numbers | None, field: str) -> dict[str, Any] | None:
    """Return a box or a polygon as a scene file has it.

    Raises
    ------
    SceneError
        If the value is of none of the forms; without a source.
    """
    found = plain(value, field)
    if found is None:
        return None
    if isinstance(found, list) and len(found) == 4 and not any(map(_holds, found)):
        return {"box": found}
    if isinstance(found, dict) or _is_ring(found):
        return _polygon(found, field)
    raise SceneError(f"must be (xmin, ymin, xmax, ymax), {_POLYGON}", field, shown(found))


def _members(geometry: dict[str, Any]) -> list[Any]:
    for kind, name in (
        ("MultiPolygon", "coordinates"),
        ("GeometryCollection", "geometries"),
        ("FeatureCollection", "features"),
    ):
        members = geometry.get(name)
        if geometry.get("type") == kind and isinstance(members, list):
            if kind == "MultiPolygon":
                return [{"type": "Polygon", "coordinates": rings} for rings in members]
            return members
    return [geometry]


def _polygon(found: Any, field: str) -> dict[str, Any]:
    if isinstance(found, dict):
        return found
    if _is_ring(found):
        return {"type": "Polygon", "coordinates": [found]}
    raise SceneError(f"must be {_POLYGON}", field, shown(found))


def _is_ring(found: Any) -> bool:
    """Whether a list begins as one of positions does: with a list of plain values."""
    if not isinstance(found, list) or not found or not isinstance(found[0], list):
        return False
    return not any(map(_holds, found[0]))


def _holds(value: object) -> bool:
    return isinstance(value, (list, dict))


def polygons_of_shapely(value: object) -> list[dict[str, Any]] | None:
    """Return the polygons of a list or tuple as GeoJSON, as their ``__geo_interface__`` gives them.

    None if it is something else or holds something else: that is for others to read. Asking each
    polygon by itself takes ten times as long.

    Parameters
    ----------
    value : object
        Anything.
    """
    shapely = sys.modules.get("shapely")  # who has not imported it has no polygons of it
    if shapely is None or not isinstance(value, (list, tuple)) or not value:
        return None
    if set(map(type, value)) != {shapely.Polygon}:
        return None
    with collector_paused():
        _, coords, (ring_starts, polygon_starts) = shapely.to_ragged_array(list(value))
        if coords.shape[1] != 2:  # of one with a height all would get one
            return None
        positions = coords.tolist()
        rings = [positions[first:end] for first, end in pairwise(ring_starts.tolist())]
        return [
            {"type": "Polygon", "coordinates": rings[first:end]}
            for first, end in pairwise(polygon_starts.tolist())
        ]
