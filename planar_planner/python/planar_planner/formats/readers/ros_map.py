"""The reader of ROS maps: ``map.yaml`` with a PGM or PNG image of cells, and Nav2's footprint.

Cells are classified as Nav2's map server does. The workspace is the map's rectangle, in which the
whole robot stays, because nothing is known outside it. A footprint may be in the same file or in a
parameter file given with ``--robot``; start and goal come from the command line.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats.outlines.occupancy import GridRing, grid_polygons
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point
from planar_planner.formats.readers.map_image import Image, decoded, summed
from planar_planner.formats.reading import require, text_of
from planar_planner.formats.robots import from_footprint
from planar_planner.scene import fields
from planar_planner.scene.json_file import file_bytes

_MAX_DEPTH = 50  # depth of nested parameters in a parameter file
_MAX_TEXT = 2**20  # bytes of a YAML file; its parser is slow, and such files are small
_MAX_BRACKETS = 1000  # brackets in a YAML file; the parser takes time quadratic in their nesting
_MODES = ("trinary", "scale", "raw")
_EXPONENT = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+$")
"""Numbers such as 1e-05, which YAML 1.2 reads as numbers and PyYAML (YAML 1.1) as text."""


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a map, or a parameter file with a footprint if there is no image."""
    content = fields.mapping(yaml_content(data, "reading a ROS map"), "")
    parts = Parts()
    footprint = _footprint(content)
    if footprint is not None:
        padding = options.padding or footprint[1]
        parts.robot = from_footprint(footprint[0], padding, "footprint", notes)
    if "image" not in content:
        if footprint is None:
            if any("robot_radius" in members for members in _mappings(content, 0)):
                raise SceneError("is a disc; a polygon is needed, see --footprint", "robot_radius")
            raise SceneError("is missing; a map names its image", "image")
        return parts
    occupied = occupied_cells(content, path, notes, unknown=options.unknown)
    place = _Placement(content, occupied.shape)
    rows, columns = occupied.shape
    for polygon in grid_polygons(occupied):
        parts.add_obstacles([[place.ring(r) for r in polygon]], _cells(polygon, rows))
    parts.workspace = [place.ring([(0, 0), (columns, 0), (columns, rows), (0, rows)])]
    kinds = "occupied and unknown" if options.unknown else "occupied"
    notes.say(
        f"{int(occupied.sum())} {kinds} cells of {columns} × {rows}, {place.resolution!r} metres "
        f"wide, make {len(parts.obstacles)} polygons; the workspace is the map's rectangle"
    )
    return parts


def occupied_cells(
    content: Mapping[str, object], path: Path, notes: Notes, *, unknown: bool
) -> NDArray[np.bool_]:
    """Return which cells are obstacles, the lowest row first.

    The rules are those of Nav2's map server up to 2024 (``map_io.cpp``, Humble to Jazzy). The
    shade of a cell is the mean of red, green and blue, in mode ``trinary`` of its opacity too if
    the image has an alpha channel. The occupancy is p = 1 − shade, or the shade if ``negate``. A
    cell is occupied if p > ``occupied_thresh``, free if p < ``free_thresh``, and unknown between.
    In mode ``scale`` values between are partly occupied, which counts as unknown here, and cells
    that are not opaque are unknown. In mode ``raw`` the shade, in 255ths, is the occupancy in
    percent, and above 100 it is unknown.
    """
    name = fields.text(content.get("image"), "image")
    mode = content.get("mode", "trinary")
    if mode not in _MODES:
        raise SceneError(f"must be one of {', '.join(_MODES)}", "mode", shown(mode))
    occupied_at = fields.number(content.get("occupied_thresh", 0.65), "occupied_thresh")
    free_at = fields.number(content.get("free_thresh", 0.25), "free_thresh")
    if not 0 <= free_at < occupied_at <= 1:
        raise SceneError("must be in order: 0 ≤ free_thresh < occupied_thresh ≤ 1", "free_thresh")
    negate = content.get("negate", 0)
    if negate not in (0, 1):
        raise SceneError("must be 0 or 1", "negate", shown(negate))
    image = _image(path.parent / name)
    total, top = summed(image, with_opacity=mode == "trinary")
    known = np.ones(total.shape, dtype=np.bool_)
    if mode == "raw":
        percent = np.rint(total / top * 255)
        known, share = percent <= 100, percent / 100
    else:
        share = (total if negate else top - total) / top
        if mode == "scale" and image.alpha is not None:
            known = image.alpha == image.top
    cells = known & (share >= occupied_at if mode == "raw" else share > occupied_at)
    doubtful = ~known | (share > free_at if mode == "raw" else share >= free_at)
    left = 0 if unknown else int((doubtful & ~cells).sum())
    if left:
        notes.hint(f"{left} unknown cells are taken for free; --unknown makes them obstacles")
    if unknown:
        cells |= doubtful
    _say_rules(image, bool(np.isin(share, (occupied_at, free_at)).any()), mode, notes)
    return np.ascontiguousarray(cells[::-1])


def _say_rules(image: Image, at_threshold: bool, mode: object, notes: Notes) -> None:
    """Say which rule of Nav2 is followed where its map servers of 2024 and 2025 differ."""
    if image.alpha is not None and mode == "trinary":
        notes.say(
            "the image has an alpha channel: opacity is averaged in with the colours, as in Nav2's "
            "map server up to 2024; since 2025 it takes cells that are not opaque as unknown"
        )
    elif image.alpha is not None:
        notes.say(f"the image has an alpha channel, taken as Nav2's map server does in mode {mode}")
    if image.coloured:
        notes.say(
            "the image has colours: their mean counts, as in Nav2's map server up to 2024; since "
            "2025 it takes their luminance"
        )
    if at_threshold and mode != "raw":
        notes.say(
            "cells exactly at a threshold are unknown, as in Nav2's map server up to 2024; since "
            "2025 they are occupied or free"
        )


def _image(file: Path) -> Image:
    """Return the image of a map."""
    data = file_bytes(file, str(file))
    try:
        return decoded(data)
    except SceneError as error:
        raise error if error.source else error.in_source(str(file)) from None


def _cells(polygon: list[GridRing], rows: int) -> str:
    """Return which cells a polygon is made of, counted from 0 as in the image, from above."""
    xs, ys = zip(*polygon[0], strict=True)
    return (
        f"cells of columns {min(xs)} to {max(xs) - 1}, rows {rows - max(ys)} to "
        f"{rows - min(ys) - 1}"
    )


class _Placement:
    """The places of the map's corner points in the world."""

    def __init__(self, content: Mapping[str, object], shape: tuple[int, ...]) -> None:
        self.resolution = fields.coordinate(content.get("resolution"), "resolution")
        if self.resolution <= 0:
            raise SceneError("must be positive", "resolution", shown(self.resolution))
        origin = content.get("origin")
        if not isinstance(origin, list) or len(origin) != 3:
            raise SceneError("must be [x, y, yaw]", "origin", shown(origin))
        x, y = (fields.coordinate(origin[k], f"origin[{k}]") for k in (0, 1))
        yaw = fields.angle(origin[2], "origin[2]")
        rows, columns = shape
        # one rounding for the product and one for the sum, the same at every use of a point
        self._along = [k * self.resolution for k in range(max(rows, columns) + 1)]
        self._origin = x, y
        self._turn = (math.cos(yaw), math.sin(yaw)) if yaw else None

    def point(self, column: int, row: int) -> Point:
        (x, y), dx, dy = self._origin, self._along[column], self._along[row]
        if self._turn is None:
            return x + dx, y + dy
        cos, sin = self._turn
        return x + cos * dx - sin * dy, y + sin * dx + cos * dy

    def ring(self, ring: GridRing) -> list[Point]:
        """Return a ring of the grid's points in the world."""
        return [self.point(*p) for p in ring]


def yaml_content(data: bytes, what: str) -> object:
    """Return the content of a YAML file of limited size, without aliases; `what` needs it."""
    yaml: Any = require("yaml", what, "ros")
    if len(data) > _MAX_TEXT:
        raise SceneError(f"is larger than {_MAX_TEXT} bytes")
    text = text_of(data)
    if text.count("[") + text.count("{") > _MAX_BRACKETS:
        raise SceneError(f"has more than {_MAX_BRACKETS} brackets, which no map has")
    loader: Any = type("Loader", (yaml.SafeLoader,), {})
    loader.add_implicit_resolver("tag:yaml.org,2002:float", _EXPONENT, list("-+.0123456789"))
    try:
        aliases = any(isinstance(token, yaml.AliasToken) for token in yaml.scan(text))
        content: object = None if aliases else yaml.load(text, Loader=loader)  # a safe loader
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}" if mark is not None else ""
        reason = getattr(error, "problem", None) or str(error)
        raise SceneError(f"is not YAML: {cut(' '.join(reason.split()))}", place) from None
    except (ValueError, RecursionError) as error:  # an impossible date, or a number too large
        raise SceneError(f"is not YAML: {cut(str(error))}") from None
    if aliases:  # aliases can turn little text into much content
        raise SceneError("uses YAML aliases, which are not read")
    return content


def _footprint(content: Mapping[str, object]) -> tuple[str, float] | None:
    """Return the first footprint in nested parameters, with its padding."""
    for members in _mappings(content, 0):
        if "footprint" in members:
            footprint = members["footprint"]
            text = footprint if isinstance(footprint, str) else repr(footprint)
            padding = members.get("footprint_padding", 0.0)
            return text, fields.coordinate(padding, "footprint_padding")
    return None


def _mappings(value: object, depth: int) -> Iterator[Mapping[str, object]]:
    if isinstance(value, dict) and depth < _MAX_DEPTH:
        yield value
        for inner in value.values():
            yield from _mappings(inner, depth + 1)
