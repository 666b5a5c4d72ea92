"""The list of formats: how to recognise each by a name's ending or a content, and its modules.

The module is light to import: a reader and its libraries are imported only to read such a file.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from planar_planner.errors import SceneError
from planar_planner.formats.parts import ImportOptions, Notes, Parts

Reader = Callable[[bytes, Path, ImportOptions, Notes], Parts]
Writer = Callable[[Parts, Path], Mapping[Path, bytes]]


@dataclass(frozen=True)
class Format:
    """One file format other than scene files.

    Attributes
    ----------
    title : str
        Name of the format, for people.
    suffixes : tuple of str
        Endings of file names, in lower case.
    reader, writer : str
        Module in this package with a function ``read`` or ``write``; empty if there is none.
    robot_reader : str
        Function of the reader for a file that is named as the robot.
    """

    title: str
    suffixes: tuple[str, ...]
    reader: str
    writer: str = ""
    robot_reader: str = "read"


OMPL_APP = Format("OMPL.app 2-D problem", (".cfg",), "ompl_app")
COLLADA = Format("Collada mesh", (".dae",), "collada", robot_reader="read_robot")
ROS_MAP = Format("ROS map", (".yaml", ".yml"), "ros_map")
YAP = Format("Yap-style environment", (".txt", ".env"), "yap", "yap")
YAP_ROBOT = Format("Yap-style robot", (".rob",), "yap")
TPCAP = Format("parking-competition case", (".csv",), "tpcap", "tpcap")
WKT = Format("well-known text", (".wkt",), "wkt", "wkt")
GEOJSON = Format("GeoJSON", (".geojson",), "geojson_features", "geojson")
SVG = Format("SVG drawing", (".svg",), "svg", "svg")
DISCOPYGAL = Format("discopygal scene", (), "discopygal")
DYNOBENCH = Format("dynobench problem", (), "dynobench")
OCTILE_MAP = Format("Moving AI map", (".map",), "octile_map")
SCENARIO = Format("Moving AI scenario", (".scen",), "scenario")
DXF = Format("DXF drawing", (".dxf",), "dxf", "dxf")


FORMATS = (
    *(OMPL_APP, COLLADA, ROS_MAP, YAP, YAP_ROBOT, TPCAP, WKT, GEOJSON, SVG, DXF),
    *(DISCOPYGAL, DYNOBENCH, OCTILE_MAP, SCENARIO),
)

_BY_SUFFIX = {suffix: kind for kind in FORMATS for suffix in kind.suffixes}
_GEOJSON_TYPES = ("FeatureCollection", "Feature", "GeometryCollection", "Polygon", "MultiPolygon")
_SNIFFED = (  # marks in the beginnings of files whose names do not determine the format
    (b"[problem]", OMPL_APP),
    (b"<COLLADA", COLLADA),
    (b"<svg", SVG),
)
_DXF_MARK = re.compile(rb"(?:999[^\n]*\n[^\n]*\n\s*)*0\s*\n\s*SECTION\b|AutoCAD Binary DXF")
_WKT_MARKS = (b"POLYGON", b"GEOMETRYCOLLECTION")  # in any case of letters
_SNIFFED_BYTES = 4096
_PMPL = (b"Boundary", b"MultiBodies", b"Multibodies")
_DYNOBENCH = (b"environment:", b"obstacles:")
_MESHES = (".stl", ".obj", ".ply", ".off", ".3mf", ".glb", ".gltf")
_PICTURES = (b"\x89PNG\r\n", b"P5", b"P2", b"BM", b"GIF8", b"\xff\xd8\xff")


def known_suffix(name: str) -> bool:
    """Return whether a name ends like a file in one of the formats."""
    return Path(name).suffix.lower() in _BY_SUFFIX


def kind_of_suffix(path: Path) -> Format | None:
    """Return the format whose files end like a name; None if there is none."""
    return _BY_SUFFIX.get(path.suffix.lower())


def format_of(path: Path, data: bytes) -> Format | None:
    """Return the format of a file; None if it is to be read as JSON."""
    known = kind_of_suffix(path)
    lines = data[:_SNIFFED_BYTES].splitlines()
    if known is YAP and any(line.lstrip().startswith(_PMPL) for line in lines):
        raise SceneError(
            "is a pmpl environment, whose bodies are meshes in space (.g, .obj) that other files "
            "hold; draw their outlines in the plane, as SVG, DXF or WKT",
            source=str(path),
        )
    if known is ROS_MAP and all(mark in data[:_SNIFFED_BYTES] for mark in _DYNOBENCH):
        return DYNOBENCH
    if known is not None:
        return known
    if path.suffix.lower() in _MESHES:
        raise SceneError(
            "is a mesh in a format that is not read; save it as Collada (.dae) or draw the outline "
            "as SVG, DXF or WKT",
            source=str(path),
        )
    if data.startswith(_PICTURES):
        raise SceneError(
            "is a picture without scale; a ROS map.yaml states image, resolution and origin",
            source=str(path),
        )
    beginning = data[:_SNIFFED_BYTES].lstrip(b"\xef\xbb\xbf \t\r\n")
    if path.suffix.lower() == ".json" or beginning.startswith(b"{"):
        return None
    kind = next((kind for mark, kind in _SNIFFED if mark in beginning), None)
    if kind is None and _DXF_MARK.match(beginning):
        return DXF
    if kind is None and any(mark in beginning.upper() for mark in _WKT_MARKS):
        return WKT
    return kind


def is_geojson(content: object) -> bool:
    """Return whether JSON content is GeoJSON rather than a scene."""
    return (
        isinstance(content, dict)
        and "format" not in content
        and content.get("type") in _GEOJSON_TYPES
    )


def kind_of_json(content: object) -> Format | None:
    """Return the format of JSON content; None if it is to be read as a scene."""
    if is_geojson(content):
        return GEOJSON
    if isinstance(content, dict) and "format" not in content and "robots" in content:
        return DISCOPYGAL
    return None


def read_parts(
    kind: Format,
    path: Path,
    data: bytes,
    options: ImportOptions,
    notes: Notes,
    *,
    as_robot: bool = False,
) -> Parts:
    """Read a file's content; `as_robot` if the options name the file as the robot.

    Raises
    ------
    SceneError
        If the file is wrong; the message states file, place and value.
    """
    module = importlib.import_module(f"planar_planner.formats.readers.{kind.reader}")
    reader: Reader = getattr(module, kind.robot_reader if as_robot else "read")
    try:
        return reader(data, path, options, notes)
    except SceneError as error:
        raise error if error.source else error.in_source(str(path)) from None
    except RecursionError:
        raise SceneError("is nested too deeply", source=str(path)) from None
