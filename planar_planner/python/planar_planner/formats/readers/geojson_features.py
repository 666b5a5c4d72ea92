"""The reader of GeoJSON: a FeatureCollection whose features state roles in ``properties.role``.

The roles are ``robot`` (in its own frame), ``obstacle`` (also the default), ``workspace``,
``start`` and ``goal`` (Points with ``properties.theta`` in radians), and ``reference_bounds`` (a
rectangle). A bare geometry or a Feature without a role is an obstacle, or the robot if the file is
read for a robot.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, shown
from planar_planner.formats.outlines.shapes import position, repaired
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Shape
from planar_planner.scene import fields
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.json_file import parse

ROLES = ("robot", "obstacle", "workspace", "start", "goal", "reference_bounds")
_WITHOUT_AREA = ("Point", "MultiPoint", "LineString", "MultiLineString")
_AREAL = ("Polygon", "MultiPolygon")


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a FeatureCollection, a Feature or a geometry."""
    del options
    return parts_of(parse(data, str(path)), notes)


def parts_of(content: object, notes: Notes) -> Parts:
    """Return the parts of GeoJSON content."""
    members = fields.mapping(content, "")
    if members.get("type") != "FeatureCollection":
        features: Any = [members]
        places = [""]
    else:
        features = members.get("features")
        if not isinstance(features, list):
            raise SceneError("must be a list", "features", shown(features))
        places = [f"features[{i}]" for i in range(len(features))]
    parts = Parts(name=_text(members, "name"), description=_text(members, "description"))
    if "crs" in members:
        notes.say(
            f"the coordinate system that the file states ({shown(members['crs'])}) is not used: "
            "coordinates are taken as they are"
        )
    parts.rotation = fields.truth(members.get("rotation", True), "rotation")
    for place, feature in zip(places, features, strict=True):
        _take(fields.mapping(feature, place), place, parts, notes)
    return parts


def _text(members: Mapping[str, object], name: str) -> str:
    return fields.text(members.get(name, ""), name)


def _take(feature: Mapping[str, object], place: str, parts: Parts, notes: Notes) -> None:
    """Add one feature to the part that its role names."""
    dot = f"{place}." if place else ""
    geometry: object = feature
    properties: Mapping[str, object] = {}
    if feature.get("type") == "Feature":
        geometry = feature.get("geometry")
        given = feature.get("properties")
        properties = fields.mapping(given, f"{dot}properties") if given is not None else {}
        dot += "geometry."
    role = properties.get("role")
    if role is None:
        role = "obstacle"
        notes.count("features without a role taken as obstacles")
    where = dot.rstrip(".")
    if role not in ROLES:
        hint = fields.suggestion(role, ROLES) if isinstance(role, str) else ""
        raise SceneError(f"unknown role{hint}", f"{place}.properties.role", shown(role))
    if role in ("start", "goal"):
        if getattr(parts, role) is not None:
            raise SceneError(f"a second {role}", where)
        setattr(parts, role, _mark(geometry, properties, place, where))
        return
    areal = _areal(geometry, where, notes if role == "obstacle" else None)
    shapes = [s for part, at in areal for s in repaired(part, at or "geometry", notes)]
    if role == "obstacle":
        parts.add_obstacles(shapes, _name(feature, properties) or place)
    elif role == "robot":
        parts.robot = [*(parts.robot or []), *shapes]
    elif role == "workspace":
        if parts.workspace is not None or len(shapes) != 1:
            raise SceneError("the workspace must be one polygon", where)
        parts.workspace = shapes[0]
    else:
        parts.reference_bounds = _rectangle(shapes, where)


def _name(feature: Mapping[str, object], properties: Mapping[str, object]) -> str:
    """Return what a feature is called: its name, else its id; empty if it has neither."""
    for value in (properties.get("name"), feature.get("id"), properties.get("id")):
        if isinstance(value, (str, int, float)) and value != "":
            return str(value)
    return ""


def _areal(geometry: object, where: str, notes: Notes | None) -> list[tuple[object, str]]:
    """Return the geometries with area, without members that other programs add, and their places.

    Geometries without area are counted in the notes and left out; without notes nothing is left
    out, so that what reads them refuses them.
    """
    if notes is not None and geometry is None:
        notes.pass_over("features without geometry (null) left out")
        return []
    members = fields.mapping(geometry, where)
    if notes is not None and members.get("type") in _WITHOUT_AREA:
        notes.pass_over(f"{members['type']} geometries left out, which have no area")
        return []
    if notes is not None and members.get("type") in _AREAL and members.get("coordinates") == []:
        notes.pass_over("empty geometries left out")
        return []
    inner = members.get("geometries")
    if (
        notes is not None
        and members.get("type") == "GeometryCollection"
        and isinstance(inner, list)
    ):
        dot = f"{where}." if where else ""
        return [
            found
            for i, part in enumerate(inner)
            for found in _areal(part, f"{dot}geometries[{i}]", notes)
        ]
    kept = ("type", "coordinates", "geometries")
    return [({k: v for k, v in members.items() if k in kept}, where)]


def _mark(
    geometry: object, properties: Mapping[str, object], place: str, where: str
) -> Configuration:
    members = fields.mapping(geometry, where)
    if members.get("type") != "Point":
        raise SceneError(
            "start and goal must be Points", f"{where}.type", shown(members.get("type"))
        )
    x, y = position(members.get("coordinates"), f"{where}.coordinates")
    return x, y, fields.angle(properties.get("theta", 0.0), f"{place}.properties.theta")


def _rectangle(shapes: list[Shape], where: str) -> Box:
    points = {p for shape in shapes for ring in shape for p in ring}
    xs, ys = sorted({x for x, _ in points}), sorted({y for _, y in points})
    if len(shapes) != 1 or len(points) != 4 or len(xs) != 2 or len(ys) != 2:
        raise SceneError("reference_bounds must be an axis-parallel rectangle", where)
    return xs[0], ys[0], xs[1], ys[1]
