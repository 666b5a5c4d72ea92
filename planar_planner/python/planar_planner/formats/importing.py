"""A file in an outside format becomes the content of a scene file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.assemble import scene_content
from planar_planner.formats.parts import ImportOptions, Notes
from planar_planner.formats.registry import Format, read_parts


@dataclass(frozen=True)
class Imported:
    """The content of a scene file, what was done to get it, and what carries over to curves."""

    content: dict[str, Any]
    notes: tuple[str, ...]
    holds_for: str


def read_scene(kind: Format, path: Path, data: bytes, options: ImportOptions) -> Imported:
    """Make a scene of a file in an outside format.

    Raises
    ------
    SceneError
        If the file is wrong, or does not say everything and the options do not either.
    """
    from planar_planner.formats.robots import chosen_robot

    notes = Notes()
    parts = read_parts(kind, path, data, options, notes)
    parts.name = parts.name or path.stem
    parts.description = parts.description or f"Imported from {path.name} ({kind.title})"
    parts.robot = chosen_robot(options, notes) or parts.robot
    try:
        content = scene_content(parts, options, notes)
    except SceneError as error:
        raise error.in_source(str(path)) from None
    return Imported(content, notes.as_lines(), parts.holds_for)
