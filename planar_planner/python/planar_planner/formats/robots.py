"""The robot that the options name: a file of any format, or Nav2's footprint string."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats import registry
from planar_planner.formats.outlines.rings import polygons_of
from planar_planner.formats.outlines.shapes import shapes_of_geometry
from planar_planner.formats.parts import ImportOptions, Notes, Point, Shape
from planar_planner.scene import fields
from planar_planner.scene.json_file import file_bytes, parse


def chosen_robot(options: ImportOptions, notes: Notes) -> list[Shape] | None:
    """Return the robot that the options name, with Nav2's padding; None if they name none.

    Raises
    ------
    SceneError
        If both options are given, the file has no robot, or the footprint is not an outline.
    """
    if options.robot is not None and options.footprint is not None:
        raise SceneError("robot: give --robot or --footprint, not both", source="--footprint")
    if options.footprint is not None:
        return from_footprint(options.footprint, options.padding or 0.0, "--footprint", notes)
    if options.robot is not None:
        return _from_file(options.robot, options, notes)
    return None


def from_footprint(text: str, padding: float, place: str, notes: Notes) -> list[Shape]:
    """Return the polygon of Nav2's ``footprint`` string, padded as Nav2 does.

    Each coordinate moves away from 0 by the padding (Nav2, ``padFootprint``). A footprint that
    contains its reference point grows along both axes by this.
    """
    try:
        content = json.loads(text)
    except (ValueError, RecursionError):
        content = None
    if not isinstance(content, list):
        raise SceneError("must be a list of points [[x, y], …]", place, cut(text))
    ring: list[Point] = []
    for i, position in enumerate(content):
        if not isinstance(position, list) or len(position) != 2:
            raise SceneError("must be [x, y]", f"{place}[{i}]", cut(str(position)))
        x, y = (fields.coordinate(v, f"{place}[{i}][{k}]") for k, v in enumerate(position))
        ring.append((_padded(x, padding), _padded(y, padding)))
    if padding:
        notes.say(f"the footprint is padded by {padding!r}, each coordinate away from 0 as in Nav2")
    shapes = polygons_of([ring], place, notes)
    if not shapes:
        raise SceneError("must be an outline with area", place, cut(text))
    return shapes


def _padded(value: float, padding: float) -> float:
    return value + ((value > 0) - (value < 0)) * padding


def _from_file(path: Path, options: ImportOptions, notes: Notes) -> list[Shape]:
    """Return the robot of a file, or its only shape if no shape has the role of the robot."""
    data = file_bytes(path, str(path))
    kind = registry.format_of(path, data)
    if kind is None:
        content = parse(data, str(path))
        if not registry.is_geojson(content):
            return _of_scene(content, path)
        kind = registry.GEOJSON
    parts = registry.read_parts(
        kind, path, data, replace(options, only_robot=True), notes, as_robot=True
    )
    if parts.robot:
        return parts.robot
    if len(parts.obstacles) != 1:
        raise SceneError(
            f"has no robot, and {len(parts.obstacles)} shapes where one alone could be it",
            source=str(path),
        )
    notes.say(
        f"the only shape of {path.name} is the robot; its reference point is the file's origin"
    )
    return parts.obstacles


def _of_scene(content: Any, path: Path) -> list[Shape]:
    robot = content.get("robot") if isinstance(content, dict) else None
    if robot is None:
        raise SceneError("is neither a scene nor GeoJSON with a robot", source=str(path))
    try:
        return [shape for _, shape in shapes_of_geometry(robot, "robot")]
    except SceneError as error:
        raise error.in_source(str(path)) from None
