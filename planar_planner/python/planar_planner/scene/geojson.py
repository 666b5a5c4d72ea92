"""GeoJSON geometry objects → the polygons in them, with the field path of each for messages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from planar_planner.errors import SceneError, shown
from planar_planner.scene import fields

_MEMBERS = {
    "Polygon": ("type", "coordinates", "bbox"),
    "MultiPolygon": ("type", "coordinates", "bbox"),
    "GeometryCollection": ("type", "geometries", "bbox"),
    "Feature": ("type", "geometry", "properties", "id", "bbox"),
}
_INSIDE = {  # what a wrapper may hold; no kind contains itself, so the depth is bounded
    "Feature": ("Polygon", "MultiPolygon", "GeometryCollection"),
    "GeometryCollection": ("Polygon", "MultiPolygon"),
}


def iter_polygons(
    geometry: object, path: str, allowed: Iterable[str] = _MEMBERS
) -> Iterator[tuple[str, list[object]]]:
    """Yield (path, rings) of each polygon in a geometry; the rings are still unchecked.

    Parameters
    ----------
    geometry : object
        Polygon, MultiPolygon, a Feature around either, or a GeometryCollection of them.
    path : str
        Field path of the geometry, for messages.
    allowed : iterable of str
        Types of geometry that are legal here.

    Raises
    ------
    SceneError
        On another type of geometry, an empty one, or an unknown member.
    """
    members = fields.mapping(geometry, path)
    kind = members.get("type")
    if not isinstance(kind, str) or kind not in allowed:
        hint = fields.suggestion(kind, allowed) if isinstance(kind, str) else ""
        raise SceneError(f"unknown type of geometry{hint}", f"{path}.type", shown(kind))
    fields.only_known(members, _MEMBERS[kind], path)
    if kind == "Feature":
        yield from iter_polygons(members.get("geometry"), f"{path}.geometry", _INSIDE[kind])
    elif kind == "GeometryCollection":
        for i, part in enumerate(_filled_list(members.get("geometries"), f"{path}.geometries")):
            yield from iter_polygons(part, f"{path}.geometries[{i}]", _INSIDE[kind])
    elif kind == "MultiPolygon":
        for i, rings in enumerate(_filled_list(members.get("coordinates"), f"{path}.coordinates")):
            yield f"{path}.coordinates[{i}]", _filled_list(rings, f"{path}.coordinates[{i}]")
    else:
        yield f"{path}.coordinates", _filled_list(members.get("coordinates"), f"{path}.coordinates")


def plain_polygon(geometry: object) -> list[Any] | None:
    """Return the rings of a Polygon that has nothing but its type and a list of rings, else None.

    Nearly every geometry is one, and `iter_polygons` takes five times as long to say so.
    """
    if type(geometry) is not dict or len(geometry) != 2 or geometry.get("type") != "Polygon":
        return None
    rings = geometry.get("coordinates")
    return rings if type(rings) is list and rings else None


def _filled_list(value: object, path: str) -> list[object]:
    if not isinstance(value, list):
        raise SceneError("must be a list", path, shown(value))
    if not value:
        raise SceneError("must not be empty", path, shown(value))
    return value
