"""The reader of dynobench problems: YAML with an ``environment`` of boxes, and ``robots``.

The environment's ``min`` and ``max`` bound the position of the robot's reference point. A robot is
named by its model, whose shape and motions are not in the file: the shape comes from the options,
and the planner's robot may move in every direction.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_planner.errors import SceneError, shown
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point, Ring
from planar_planner.formats.readers.ros_map import yaml_content
from planar_planner.scene import fields
from planar_planner.scene.fields import Configuration

_POSE = 3  # numbers of a planar pose at the beginning of a state
PLANAR = ("unicycle1", "unicycle2")
"""Models whose states begin with x, y, theta; what follows are speeds."""


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a problem."""
    del path, options
    content = fields.mapping(yaml_content(data, "reading a dynobench problem"), "")
    environment = fields.mapping(content.get("environment"), "environment")
    parts = Parts(name=fields.text(content.get("name", ""), "name"))
    low, high = (_pair(environment.get(name), f"environment.{name}") for name in ("min", "max"))
    parts.reference_bounds = (*low, *high)
    obstacles = environment.get("obstacles") or []
    if not isinstance(obstacles, list):
        raise SceneError("must be a list", "environment.obstacles", shown(obstacles))
    for i, obstacle in enumerate(obstacles):
        place = f"environment.obstacles[{i}]"
        parts.add_obstacles([[_box(fields.mapping(obstacle, place), place)]], place)
    _add_ends(content.get("robots"), parts, notes)
    return parts


def _box(obstacle: Mapping[str, object], place: str) -> Ring:
    if obstacle.get("type") != "box":
        kind = shown(obstacle.get("type"))
        raise SceneError("must be a box; others are bodies in space", f"{place}.type", kind)
    x, y = _pair(obstacle.get("center"), f"{place}.center")
    width, height = _pair(obstacle.get("size"), f"{place}.size")
    if not (width > 0 and height > 0):
        raise SceneError("must be positive", f"{place}.size", shown(obstacle.get("size")))
    left, right, low, high = x - width / 2, x + width / 2, y - height / 2, y + height / 2
    return [(left, low), (right, low), (right, high), (left, high)]


def _add_ends(robots: object, parts: Parts, notes: Notes) -> None:
    if not isinstance(robots, list) or len(robots) != 1:
        count = f"{len(robots)} robots" if isinstance(robots, list) else shown(robots)
        raise SceneError("must be a list of one robot: one is planned for", "robots", count)
    robot = fields.mapping(robots[0], "robots[0]")
    model = fields.text(robot.get("type"), "robots[0].type")
    if not model.startswith(PLANAR):
        raise SceneError(
            f"is no single body in the plane; models of these are {' and '.join(PLANAR)}",
            "robots[0].type",
            shown(model),
        )
    parts.start = _pose(robot.get("start"), "robots[0].start", notes)
    parts.goal = _pose(robot.get("goal"), "robots[0].goal", notes)
    notes.say(
        f"the model {model} gives the robot no shape here, and its steering is not modelled: the "
        "shape comes from --robot or --footprint, about the model's reference point"
    )


def _pose(value: object, place: str, notes: Notes) -> Configuration:
    if not isinstance(value, list) or len(value) < _POSE:
        raise SceneError("must begin with x, y, theta", place, shown(value))
    notes.count("speeds of states passed over", len(value) - _POSE)
    return fields.configuration(value[:_POSE], place)


def _pair(value: object, place: str) -> Point:
    if not isinstance(value, list) or len(value) != 2:
        raise SceneError("must be a pair; others are bodies in space", place, shown(value))
    return fields.coordinate(value[0], f"{place}[0]"), fields.coordinate(value[1], f"{place}[1]")
