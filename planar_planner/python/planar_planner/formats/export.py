"""From a scene's content to parts for the writers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_planner.errors import SceneError, one_line
from planar_planner.formats.outlines.shapes import shapes_of_geometry
from planar_planner.formats.parts import Parts
from planar_planner.problem.goal import is_region
from planar_planner.scene import fields
from planar_planner.scene.geojson import name_of


def parts_of(content: Mapping[str, Any]) -> Parts:
    """Return the parts of a scene that the gate would accept.

    Raises
    ------
    SceneError
        If the gate would refuse the scene too, or its goal is a region; without a source.
    """
    if is_region(content["goal"]):
        raise SceneError("is a region; only scene files can state regions", "goal")
    parts = Parts(
        robot=[shape for _, shape in shapes_of_geometry(content["robot"], "robot")],
        start=fields.configuration(content["start"], "start"),
        goal=fields.configuration(content["goal"], "goal"),
        rotation=content.get("rotation", True),
        name=one_line(content.get("name", "")),  # no format but JSON can hold every character
        description="\n".join(map(one_line, content.get("description", "").splitlines())),
    )
    for i, geometry in enumerate(content["obstacles"]):
        path = f"obstacles[{i}]"
        shapes = [shape for _, shape in shapes_of_geometry(geometry, path)]
        parts.add_obstacles(shapes, one_line(name_of(geometry)))
    workspace = content.get("workspace")
    if workspace is not None and "box" in workspace:
        parts.workspace_box = fields.box(workspace["box"], "workspace.box")
    elif workspace is not None:
        shapes = [shape for _, shape in shapes_of_geometry(workspace, "workspace")]
        if len(shapes) != 1:
            raise SceneError("must be one polygon", "workspace", f"{len(shapes)} polygons")
        parts.workspace = shapes[0]
    bounds = content.get("reference_bounds")
    if bounds is not None and content.get("bounds_are_chosen") is not True:
        parts.reference_bounds = fields.box(bounds, "reference_bounds")
    return parts
