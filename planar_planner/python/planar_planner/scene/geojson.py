"""GeoJSON geometry objects → the polygons in them, with the field path of each for messages.

An obstacle may have a name: a geometry has it as a member ``name``, a Feature among its properties
or as an ``id``. Messages, margins and replays use it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from planar_planner.errors import SceneError, cut, shown
from planar_planner.scene import fields

_MEMBERS = {
    "Polygon": ("type", "coordinates", "bbox", "name"),
    "MultiPolygon": ("type", "coordinates", "bbox", "name"),
    "GeometryCollection": ("type", "geometries", "bbox", "name"),
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
    fields.text(members.get("name", ""), f"{path}.name")
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


def named(geometry: dict[str, Any], name: str) -> dict[str, Any]:
    """Return an obstacle's geometry with a name; as it is if the name is empty."""
    return {**geometry, "name": name} if name else geometry


def name_of(geometry: Mapping[str, Any]) -> str:
    """Return the name of an obstacle that the gate has read; empty if it has none."""
    if geometry.get("type") != "Feature":
        return str(geometry.get("name", ""))
    properties = geometry.get("properties")
    found = properties.get("name") if isinstance(properties, Mapping) else None
    if not isinstance(found, str) or not found:
        found = geometry.get("id")
    return str(found) if isinstance(found, (str, int, float)) else ""


def title_of_obstacle(name: str, index: int) -> str:
    """Return how texts refer to an obstacle: by its name, else by its place in the scene."""
    return f"obstacle {shown(cut(name))}" if name else f"obstacles[{index}]"
