"""The step from the content of a scene file to files in another format."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.registry import FORMATS, Writer, kind_of_suffix


def write_scene(content: Mapping[str, Any], path: Path) -> Mapping[Path, bytes]:
    """Return the files, by name, that represent a scene in the format that the name states.

    Raises
    ------
    SceneError
        If no writer has this ending, or the format cannot represent the scene.
    """
    from planar_planner.formats.export import parts_of

    kind = kind_of_suffix(path)
    if kind is None or not kind.writer:
        endings = ", ".join([".json", *(s for k in FORMATS if k.writer for s in k.suffixes)])
        raise SceneError(
            f"cannot tell the format to write; the name must end in {endings}", source=str(path)
        )
    writer: Writer = importlib.import_module(f"planar_planner.formats.writers.{kind.writer}").write
    try:
        return writer(parts_of(content), path)
    except SceneError as error:
        raise error if error.source else error.in_source(str(path)) from None
