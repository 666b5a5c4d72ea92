"""The JSON object of a scene file → the raw scene."""

from __future__ import annotations

from collections.abc import Mapping

from planar_planner.errors import SceneError, shown
from planar_planner.scene import fields
from planar_planner.scene.import_report import NOT_IMPORTED
from planar_planner.scene.model import DECIMALS, FORMAT, VERSION, Scene, scene_of_values

_REQUIRED = ("format", "version", "robot", "obstacles", "start", "goal")
_OPTIONAL = (
    "name",
    "description",
    "workspace",
    "reference_bounds",
    "bounds_are_chosen",
    "rotation",
    "numbers",
)


def scene_of_json(content: object, source: str, default_name: str) -> Scene:
    """Check format, version and the names of the fields, the raw scene's only guarantees.

    Parameters
    ----------
    content : object
        In JSON's own types; becomes part of the scene.
    source : str
        For messages.
    default_name : str
        Name for a scene that has none.

    Raises
    ------
    SceneError
        If it is no object, or has the wrong fields.
    """
    try:
        members = fields.mapping(content, "")
        _check_header(members)
        fields.only_known(members, _REQUIRED + _OPTIONAL, "")
        fields.require(members, _REQUIRED)
        return scene_of_values(
            {
                "robot": members["robot"],
                "obstacles": members["obstacles"],
                "start": members["start"],
                "goal": members["goal"],
                "workspace": members.get("workspace"),
                "bounds": members.get("reference_bounds"),
                "rotation": members.get("rotation", True),
                "name": fields.text(members.get("name", default_name), "name"),
                "description": fields.text(members.get("description", ""), "description"),
                "source": source,
                "bounds_are_chosen": members.get("bounds_are_chosen", False),
                "imported": NOT_IMPORTED,
                "numbers": members.get("numbers", DECIMALS),
            }
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
