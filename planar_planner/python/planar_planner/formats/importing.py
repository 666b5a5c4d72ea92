"""The step from a file in another format to a scene."""

from __future__ import annotations

from pathlib import Path

from planar_planner.errors import SceneError
from planar_planner.formats.assemble import scene_of_parts
from planar_planner.formats.parts import ImportOptions, Notes
from planar_planner.formats.registry import Format, read_parts
from planar_planner.scene.model import Scene


def read_scene(kind: Format, path: Path, data: bytes, options: ImportOptions) -> Scene:
    """Return the scene of a file in another format.

    Raises
    ------
    SceneError
        If the file is wrong, or if file and options together do not state everything.
    """
    from planar_planner.formats.robots import chosen_robot

    notes = Notes()
    parts = read_parts(kind, path, data, options, notes)
    parts.name = parts.name or path.stem
    parts.description = parts.description or f"Imported from {path.name} ({kind.title})"
    robot = chosen_robot(options, notes)
    if robot and parts.robot:
        notes.say("the robot in the file gives way to the one of the options")
    parts.robot = robot or parts.robot
    try:
        return scene_of_parts(parts, options, notes, str(path))
    except SceneError as error:
        raise error.in_source(str(path)) from None
