"""The reader of Moving AI's grid maps: ``type octile``, height, width, and a letter for each cell.

A cell is one unit wide, and the first row is the uppermost. ``.`` and ``G`` are ground; ``@``,
``O``, ``T`` (trees) and ``W`` (water) are obstacles; ``S`` (swamp) is ground that is slow. Agents
of these maps are points that move along a grid: the robot, start and goal come from the options.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, shown
from planar_planner.formats.outlines.occupancy import GridRing, grid_polygons
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Ring
from planar_planner.formats.reading import text_of, whole

GROUND = ".GS"
BLOCKED = "@OTW"
_MOST = 2**14  # cells along a side


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a map."""
    del path, options
    lines = [line.rstrip() for line in text_of(data).splitlines()]
    height, width, first = _header(lines, notes)
    rows = lines[first : first + height]
    if len(rows) < height or any(lines[first + height :]):
        raise SceneError(f"must have {height} rows of cells after the line 'map'")
    occupied = _occupied(rows, width, first)
    parts = Parts()
    for polygon in grid_polygons(occupied[::-1]):
        parts.add_obstacles([[_ring(each) for each in polygon]], _name(polygon, height))
    parts.workspace = [_ring([(0, 0), (width, 0), (width, height), (0, height)])]
    swamps = sum(row.count("S") for row in rows)
    notes.count("cells of swamp taken as ground", swamps)
    notes.count("cells of water taken as obstacles", sum(row.count("W") for row in rows))
    notes.say(
        f"{int(occupied.sum())} cells of {width} × {height} make {len(parts.obstacles)} polygons; "
        "a cell is one unit wide, y points upwards, and the workspace is the map's rectangle"
    )
    return parts


def _header(lines: list[str], notes: Notes) -> tuple[int, int, int]:
    """Return height, width, and the index of the first row of cells."""
    found: dict[str, str] = {}
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if words == ["map"]:
            missing = [name for name in ("height", "width") if name not in found]
            if missing:
                raise SceneError(f"is missing before the line 'map': {', '.join(missing)}")
            if "type" not in found:
                notes.say("the map states no type and is read as octile")
            elif found["type"] != "octile":
                raise SceneError("must be octile", "type", shown(found["type"]))
            height, width = (whole(found[name], name, 1, _MOST) for name in ("height", "width"))
            return height, width, number
        if len(words) != 2 or words[0] not in ("type", "height", "width"):
            raise SceneError("must be type, height or width and a value", f"line {number}")
        found[words[0]] = words[1]
    raise SceneError("has no line 'map'")


def _occupied(rows: list[str], width: int, first: int) -> NDArray[np.bool_]:
    """Return which cells are obstacles, the uppermost row first."""
    for k, row in enumerate(rows):
        place = f"line {first + k + 1}"
        if len(row) != width:
            raise SceneError(f"must have {width} cells, and has {len(row)}", place)
        unknown = set(row) - {*GROUND, *BLOCKED}
        if unknown:
            raise SceneError(f"must be of {GROUND}{BLOCKED}", place, shown(min(unknown)))
    return np.array([[cell in BLOCKED for cell in row] for row in rows], dtype=np.bool_)


def _ring(ring: GridRing) -> Ring:
    return [(float(x), float(y)) for x, y in ring]


def _name(polygon: list[GridRing], height: int) -> str:
    xs, ys = zip(*polygon[0], strict=True)
    return f"columns {min(xs)} to {max(xs) - 1}, rows {height - max(ys)} to {height - 1 - min(ys)}"
