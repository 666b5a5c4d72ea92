"""The one door by which a scene comes in: a built-in name, a file of any format, a mapping.

Geometry is judged later, by `planar_planner.problem`.
"""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias

from planar_planner.errors import SceneError
from planar_planner.formats import registry
from planar_planner.formats.importing import read_scene
from planar_planner.formats.parts import ImportOptions
from planar_planner.scene import fields
from planar_planner.scene.builtin import builtin_scenes
from planar_planner.scene.json_file import file_bytes, parse
from planar_planner.scene.json_form import scene_of_json
from planar_planner.scene.model import Scene, with_ends
from planar_planner.scene.plain import plain

SceneLike: TypeAlias = Scene | str | os.PathLike[str] | Mapping[str, Any]
"""A scene, or anything that `load_scene` makes one of."""


def load_scene(scene: SceneLike, importing: ImportOptions | None = None) -> Scene:
    """Read a scene.

    Parameters
    ----------
    scene : str, path, mapping or Scene
        The name of a built-in scene, the path of a scene file or of a file in another format
        (``docs/formats.md``), or the content of a scene file. A string that names a built-in scene
        is that scene; write ``./name`` for a file called the same. In a mapping, numpy arrays and
        objects with ``__geo_interface__`` (shapely) are welcome. A `Scene` is returned as it is.
    importing : ImportOptions, optional
        Start and goal to use instead of the scene's own, and for files in other formats everything
        that they do not state.

    Returns
    -------
    Scene
        The raw scene. Geometry is checked when it is planned on.

    Raises
    ------
    SceneError
        If there is no such scene, or it is no JSON object with the right fields.
    """
    if isinstance(scene, Scene) and importing is None:
        return scene
    options = importing or ImportOptions()
    if isinstance(scene, Scene):
        return _with_ends(scene, options)
    if isinstance(scene, Mapping):
        try:
            content = plain(scene)
        except SceneError as error:
            raise error.in_source("<dict>") from None
        return _with_ends(scene_of_json(content, "<dict>", "scene"), options)
    if isinstance(scene, str):
        known = builtin_scenes()
        if scene in known:
            content = parse(file_bytes(known[scene], scene), scene)
            return _with_ends(scene_of_json(content, scene, scene), options)
        if not _looks_like_path(scene):
            hint = fields.close_matches(scene, known) or "; the command list shows the names"
            raise SceneError(f"no built-in scene and no file of this name{hint}", source=scene)
    elif not isinstance(scene, os.PathLike):
        raise TypeError(f"a scene is a Scene, name, path or mapping, not {type(scene).__name__}")
    return _from_file(Path(scene), options)


def _from_file(path: Path, options: ImportOptions) -> Scene:
    """Read a file in any format; ends of the command line are in the file's frame."""
    return scene_of_bytes(file_bytes(path, str(path)), path, options)


def scene_of_bytes(data: bytes, path: Path, options: ImportOptions) -> Scene:
    """Return the scene of a file's content in any format; `path` names it and lends its folder.

    Raises
    ------
    SceneError
        If the content is no scene and of no known format, or something in it is wrong.
    """
    source = str(path)
    kind = registry.format_of(path, data)
    if kind is None:
        content = parse(data, source)
        kind = registry.kind_of_json(content)
        if kind is None:
            return _with_ends(scene_of_json(content, source, path.stem), options)
    return read_scene(kind, path, data, options)


def _with_ends(scene: Scene, options: ImportOptions) -> Scene:
    """Put start and goal of the options in place of the scene's own; it leaves no other open."""
    given = replace(options, start=None, goal=None)
    for field in dataclasses.fields(given):
        if getattr(given, field.name) != field.default:
            name = "role" if field.name == "roles" else field.name.replace("_", "-")
            raise SceneError(
                f"is a scene file, and --{name} is for files in other formats", source=scene.source
            )
    return with_ends(scene, options.start, options.goal)


def _looks_like_path(text: str) -> bool:
    """Whether an unknown name is to be opened as a file rather than reported as a misspelling."""
    if "/" in text or os.sep in text or text.endswith(".json") or registry.known_suffix(text):
        return True
    try:
        return text != "" and Path(text).exists()
    except (OSError, ValueError):  # too long, or holds a null character: no such file
        return False
