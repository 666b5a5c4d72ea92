"""The reader of OMPL.app's 2-D problems: an INI file with two Collada meshes, ends and bounds."""

from __future__ import annotations

import configparser
from collections.abc import Mapping
from pathlib import Path

from planar_planner.errors import SceneError, cut
from planar_planner.formats.parts import ImportOptions, Notes, Parts
from planar_planner.formats.readers.collada import Mesh, add_region, centred, mesh_of
from planar_planner.formats.reading import angle, coordinate, text_of
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.json_file import file_bytes

_BOUNDS = ("volume.min.x", "volume.min.y", "volume.max.x", "volume.max.y")
_SPATIAL = ("start.z", "goal.z", "volume.min.z", "volume.max.z")


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a problem and its meshes, which lie in the same folder."""
    parser = configparser.ConfigParser(strict=False, interpolation=None)
    try:
        parser.read_string(text_of(data))
    except configparser.Error as error:
        raise SceneError(f"is not an INI file: {' '.join(str(error).split())}") from None
    if not parser.has_section("problem"):
        raise SceneError("section is missing", "[problem]")
    problem = parser["problem"]
    for key in _SPATIAL:
        if key in problem:
            raise SceneError("belongs to a problem in space; only planar ones are read", key)
    others = [cut(repr(name)) for name in parser.sections() if name != "problem"]
    if others:
        notes.say(f"sections without a part in the problem ignored: {', '.join(others)}")
    parts = Parts(name=problem.get("name", ""))
    add_region(_mesh(problem, "world", path), parts, notes)
    if options.robot is None and options.footprint is None:
        parts.robot = centred(_mesh(problem, "robot", path), notes)
    parts.start, parts.goal = (_configuration(problem, name) for name in ("start", "goal"))
    parts.reference_bounds = _bounds(problem)
    return parts


def _mesh(problem: Mapping[str, str], key: str, path: Path) -> Mesh:
    name = (problem.get(key) or "").strip()
    if not name:
        raise SceneError("is missing", f"[problem] {key}")
    file = path.parent / name
    try:
        return mesh_of(file_bytes(file, str(file)))
    except SceneError as error:
        raise error if error.source else error.in_source(str(file)) from None


def _configuration(problem: Mapping[str, str], name: str) -> Configuration | None:
    """Return start or goal; None if the file states none, so that the options can."""
    keys = [f"{name}.{part}" for part in ("x", "y", "theta")]
    if not any(key in problem for key in keys):
        return None
    for key in keys[:2]:
        if key not in problem:
            raise SceneError("is missing", f"[problem] {key}")
    x, y = (coordinate(problem[key], f"[problem] {key}") for key in keys[:2])
    return x, y, angle(problem.get(keys[2], "0"), f"[problem] {keys[2]}")


def _bounds(problem: Mapping[str, str]) -> Box | None:
    given = [key for key in _BOUNDS if key in problem]
    if not given:
        return None
    if len(given) < len(_BOUNDS):
        missing = next(key for key in _BOUNDS if key not in problem)
        raise SceneError("is missing", f"[problem] {missing}")
    xmin, ymin, xmax, ymax = (coordinate(problem[key], f"[problem] {key}") for key in _BOUNDS)
    return xmin, ymin, xmax, ymax
