"""The reader of discopygal scenes: JSON with ``robots`` and ``obstacles`` of classes.

Robots translate. One robot is planned for: a ``RobotPolygon`` whose vertices are about its
reference point, or a ``RobotDisc``. Obstacles are each an ``ObstaclePolygon`` or an
``ObstacleDisc``. Discs become polygons on the side that is asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_planner.errors import SceneError, shown
from planar_planner.formats.drawing import Drawing, parts_of
from planar_planner.formats.outlines.curves import Outline, circle, polygon
from planar_planner.formats.outlines.figure import NONZERO, Figure
from planar_planner.formats.outlines.rings import MIN_RING
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point
from planar_planner.scene import fields
from planar_planner.scene.fields import Configuration
from planar_planner.scene.json_file import parse

DISCS = ("ObstacleDisc", "RobotDisc", "RobotBall")
POLYGONS = ("ObstaclePolygon", "RobotPolygon")
OTHERS = {
    "RobotRod": "is a rod, which has no area; give a robot with --robot",
    "RobotSphere": "is a body in space; the planner's are in the plane",
}


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a scene."""
    content = fields.mapping(parse(data, str(path)), "")
    drawing = Drawing(rotation=False)
    for i, obstacle in enumerate(_items(content, "obstacles")):
        place = f"obstacles[{i}]"
        drawing.add("obstacle", Figure((_outline(obstacle, place),), NONZERO, place))
    robots = _items(content, "robots")
    given = options.robot is not None or options.footprint is not None
    if len(robots) > 1:
        raise SceneError(f"has {len(robots)} robots, and one is planned for", "robots")
    for robot in robots:
        drawing.mark("start", _configuration(robot, "start", "robots[0]"), "robots[0].start")
        drawing.mark("goal", _configuration(robot, "end", "robots[0]"), "robots[0].end")
        if not given:
            outline = _outline(robot, "robots[0]")
            drawing.add("robot", Figure((outline,), NONZERO, "robots[0]"))
            drawing.mark("origin", (0.0, 0.0, 0.0), "robots[0]")
    if content.get("metadata"):
        notes.count("members of the scene's metadata passed over", len(_members(content)))
    return parts_of(drawing, options, notes)


def _members(content: Mapping[str, object]) -> Mapping[str, object]:
    return fields.mapping(content["metadata"], "metadata")


def _items(content: Mapping[str, object], name: str) -> list[Mapping[str, object]]:
    items = content.get(name)
    if not isinstance(items, list):
        raise SceneError("must be a list", name, shown(items))
    return [fields.mapping(item, f"{name}[{i}]") for i, item in enumerate(items)]


def _outline(thing: Mapping[str, object], place: str) -> Outline:
    """Return the outline of a polygon, or of a disc about its location or the reference point."""
    kind = thing.get("__class__")
    if kind in POLYGONS:
        return polygon(_ring(thing.get("poly"), f"{place}.poly"))
    if kind in DISCS:
        radius = fields.coordinate(thing.get("radius"), f"{place}.radius")
        if not radius > 0:
            raise SceneError("must be positive", f"{place}.radius", shown(radius))
        centre = _point(thing["location"], f"{place}.location") if "location" in thing else (0, 0)
        return circle(centre, radius)
    problem = OTHERS.get(str(kind), f"must be one of {', '.join((*POLYGONS, *DISCS))}")
    raise SceneError(problem, f"{place}.__class__", shown(kind))


def _ring(value: object, place: str) -> list[Point]:
    if not isinstance(value, list) or len(value) < MIN_RING:
        raise SceneError(f"must be a list of at least {MIN_RING} points", place, shown(value))
    return [_point(each, f"{place}[{i}]") for i, each in enumerate(value)]


def _point(value: object, place: str) -> Point:
    if not isinstance(value, list) or len(value) != 2:
        raise SceneError("must be [x, y]", place, shown(value))
    return fields.coordinate(value[0], f"{place}[0]"), fields.coordinate(value[1], f"{place}[1]")


def _configuration(robot: Mapping[str, object], name: str, place: str) -> Configuration:
    return (*_point(robot.get(name), f"{place}.{name}"), 0.0)
