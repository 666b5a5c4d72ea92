"""Scene files: reading, and the raw scene as its file states it.

A `Scene` has the right fields and nothing else is known of it; `planar_planner.problem` turns it
into a valid problem. Format: ``scene.schema.json`` beside this file.
"""

from __future__ import annotations

import dataclasses
import gc
import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from planar_planner import fields
from planar_planner.builtin import builtin_scenes
from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats import registry
from planar_planner.formats.parts import ImportOptions
from planar_planner.limits import MAX_FILE_BYTES

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


def load_scene(
    scene: str | os.PathLike[str] | Mapping[str, Any], importing: ImportOptions | None = None
) -> Scene:
    """Read a scene.

    Parameters
    ----------
    scene : str, path or mapping
        The name of a built-in scene, the path of a scene file or of a file in an outside format
        (``docs/formats.md``), or the content of a scene file. A string that names a built-in scene
        is that scene; write ``./name`` for a file called the same. In a mapping, numpy arrays and
        objects with ``__geo_interface__`` (shapely) are welcome.
    importing : ImportOptions, optional
        Start and goal to use instead of the scene's own, and for files in outside formats all that
        they do not say.

    Returns
    -------
    Scene
        The raw scene. Geometry is checked when it is planned on.

    Raises
    ------
    SceneError
        If there is no such scene, or it is no JSON object with the right fields.
    """
    options = importing or ImportOptions()
    if isinstance(scene, Mapping):
        return _with_ends(_checked(plain_json(scene), "<dict>", "scene"), options)
    if isinstance(scene, str):
        known = builtin_scenes()
        if scene in known:
            content = parse(file_bytes(known[scene], scene), scene)
            return _with_ends(_checked(content, scene, scene), options)
        if not _looks_like_path(scene):
            hint = fields.close_matches(scene, known) or "; the command list shows the names"
            raise SceneError(f"no built-in scene and no file of this name{hint}", source=scene)
    elif not isinstance(scene, os.PathLike):
        raise TypeError(f"a scene is a name, a path or a mapping, not {type(scene).__name__}")
    return _from_file(Path(scene), options)


def _from_file(path: Path, options: ImportOptions) -> Scene:
    """Read a file in any format; ends of the command line are in the file's frame."""
    source = str(path)
    data = file_bytes(path, source)
    kind = registry.format_of(path, data)
    if kind is None:
        content = parse(data, source)
        if not registry.is_geojson(content):
            return _with_ends(_checked(content, source, path.stem), options)
        kind = registry.GEOJSON
    imported = registry.read_scene(kind, path, data, options)
    scene = _checked(imported.content, source, path.stem)
    return replace(scene, notes=imported.notes, holds_for=imported.holds_for)


def _with_ends(scene: Scene, options: ImportOptions) -> Scene:
    """Put start and goal of the options in place of the scene's own; it leaves no other open."""
    given = replace(options, start=None, goal=None)
    for field in dataclasses.fields(given):
        if getattr(given, field.name) != field.default:
            name = "role" if field.name == "roles" else field.name
            raise SceneError(
                f"is a scene, and --{name} is for files in outside formats", source=scene.source
            )
    return replace(
        scene,
        start=scene.start if options.start is None else options.start,
        goal=scene.goal if options.goal is None else options.goal,
    )


def _looks_like_path(text: str) -> bool:
    """Whether an unknown name is to be opened as a file rather than reported as a misspelling."""
    if "/" in text or os.sep in text or text.endswith(".json") or registry.known_suffix(text):
        return True
    try:
        return text != "" and Path(text).exists()
    except (OSError, ValueError):  # too long, or holds a null character: no such file
        return False


def file_bytes(path: Path, source: str) -> bytes:
    """Return a file's content, up to the largest that is read."""
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(f"cannot read the scene: {reason}", source=source) from None
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(f"is larger than {MAX_FILE_BYTES} bytes", source=source)
    return data


def parse(data: bytes, source: str) -> object:
    """Return the JSON content of a scene file named `source` in errors, not yet checked."""
    try:
        with _collector_paused():
            return json.loads(data, object_pairs_hook=_without_duplicates)
    except SceneError as error:
        raise error.in_source(source) from None
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        raise SceneError(f"is not JSON: {error.msg} at {where}", source=source) from None
    except UnicodeDecodeError as error:
        raise SceneError(f"is not UTF-8 text: byte {error.start}", source=source) from None
    except RecursionError:
        raise SceneError("is nested too deeply", source=source) from None
    except ValueError as error:  # an integer of thousands of digits
        raise SceneError(f"is not usable JSON: {error}", source=source) from None


@contextmanager
def _collector_paused() -> Iterator[None]:
    """Keep the garbage collector from walking a growing tree that holds no garbage.

    It takes two thirds of the reading time of 20,000 polygons.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def _without_duplicates(pairs: list[tuple[str, object]]) -> dict[str, object]:
    """Build an object, refusing a field that stands twice: JSON leaves open which one counts."""
    result = dict(pairs)
    if len(result) != len(pairs):
        seen: set[str] = set()
        for name, _ in pairs:
            if name in seen:
                raise SceneError("field appears more than once", cut(name))
            seen.add(name)
    return result


def plain_json(content: Mapping[str, Any]) -> object:
    """Return a copy of `content` in lists, dicts and numbers, as if it were read from a file."""
    try:
        text = json.dumps(dict(content), default=_plain_value)
        return json.loads(text)
    except RecursionError:
        raise SceneError("is nested too deeply", source="<dict>") from None
    except (TypeError, ValueError) as error:
        raise SceneError(f"is not a JSON object: {error}", source="<dict>") from None


def _plain_value(value: object) -> object:
    if isinstance(value, Mapping):
        return dict(value)
    for attribute in ("__geo_interface__", "tolist"):  # geometry objects; numpy arrays and scalars
        found = getattr(value, attribute, None)
        if found is not None:
            return found() if callable(found) else found
    raise TypeError(f"{type(value).__name__} {shown(value)} has no JSON form")


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
