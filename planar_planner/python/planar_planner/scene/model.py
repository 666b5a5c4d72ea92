"""The raw scene, as its file states it.

A `Scene` has the right fields and nothing else is known of it; `planar_planner.problem` turns it
into a valid problem. Format: ``scene.schema.json`` beside this file.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from planar_planner.errors import SceneError, shown
from planar_planner.scene import fields

FORMAT = "planar-planner/scene"


VERSION = 1


_REQUIRED = ("format", "version", "robot", "obstacles", "start", "goal")


_OPTIONAL = ("name", "description", "workspace", "reference_bounds", "rotation")


@dataclass(frozen=True, eq=False)
class Scene:
    """A scene as in the file; fields without a type are unchecked JSON values.

    Attributes
    ----------
    name, description : str
        For people; the name also stands in results.
    workspace : Any
        ``{"box": [xmin, ymin, xmax, ymax]}`` or a GeoJSON Polygon, world frame; None if absent.
    reference_bounds : Any
        ``[xmin, ymin, xmax, ymax]`` for the robot's reference point; None if absent.
    robot : Any
        GeoJSON Polygon or MultiPolygon in the robot's frame.
    obstacles : Any
        List of GeoJSON geometries, world frame.
    start : Any
        ``[x, y, theta]``, theta in radians.
    goal : Any
        The same, or a set of configurations: ``{"region": Polygon, "theta": [lo, hi]}``,
        ``{"escape": Polygon}`` or ``"escape"``.
    rotation : Any
        False forbids turning; start and goal then have the same theta.
    source : str
        Where the scene came from, for messages.
    notes : tuple of str
        What an importer did to the geometry of a file in an outside format.
    holds_for : str
        The verdict that carries over to the curves of such a file, ``path`` or ``no_path``; empty
        if both do.
    """

    name: str
    description: str
    workspace: Any
    reference_bounds: Any
    robot: Any
    obstacles: Any
    start: Any
    goal: Any
    rotation: Any
    source: str
    notes: tuple[str, ...] = ()
    holds_for: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return the scene as a JSON object that `load_scene` reads back."""
        content: dict[str, Any] = {"format": FORMAT, "version": VERSION, "name": self.name}
        if self.description:
            content["description"] = self.description
        if self.workspace is not None:
            content["workspace"] = self.workspace
        if self.reference_bounds is not None:
            content["reference_bounds"] = self.reference_bounds
        content["robot"] = self.robot
        content["obstacles"] = self.obstacles
        content["start"] = self.start
        content["goal"] = self.goal
        if self.rotation is not True:
            content["rotation"] = self.rotation
        return content


def _checked(content: object, source: str, default_name: str) -> Scene:
    """Check format, version and the names of the fields, the raw scene's only guarantees."""
    try:
        members = fields.mapping(content, "")
        _check_header(members)
        fields.only_known(members, _REQUIRED + _OPTIONAL, "")
        fields.require(members, _REQUIRED)
        return Scene(
            name=fields.text(members.get("name", default_name), "name"),
            description=fields.text(members.get("description", ""), "description"),
            workspace=members.get("workspace"),
            reference_bounds=members.get("reference_bounds"),
            robot=members["robot"],
            obstacles=members["obstacles"],
            start=members["start"],
            goal=members["goal"],
            rotation=members.get("rotation", True),
            source=source,
        )
    except SceneError as error:
        raise error.in_source(source) from None


def _check_header(content: Mapping[str, object]) -> None:
    if "format" not in content:
        raise SceneError(f"field is missing; a scene states {FORMAT!r}", "format")
    if content["format"] != FORMAT:
        raise SceneError(f"unknown format; expected {FORMAT!r}", "format", shown(content["format"]))
    if "version" not in content:
        raise SceneError(f"field is missing; this program reads version {VERSION}", "version")
    version = content["version"]
    if isinstance(version, bool) or version != VERSION:
        raise SceneError(
            f"unknown version; this program reads version {VERSION}", "version", shown(version)
        )
