"""`planar-planner list`: the built-in scenes. Reads their files without numpy and the core."""

from __future__ import annotations

from planar_planner.builtin import manifest
from planar_planner.output import emit
from planar_planner.scene import load_scene
from planar_planner.size import scene_size

_HEADINGS = ("scene", "obstacles", "vertices", "robot", "expected", "origin")
_NUMERIC = 3  # columns 1 to 3 are aligned to the right


def run() -> int:
    """Print one line a scene, in the manifest's order."""
    rows = [_HEADINGS]
    for name, entry in manifest().items():
        size = scene_size(load_scene(name))
        rows.append(
            (
                name,
                str(size.obstacle_polygons),
                str(size.obstacle_vertices),
                str(size.robot_vertices),
                entry["expected"].replace("_", " "),
                entry["origin"],
            )
        )
    widths = [max(len(row[column]) for row in rows) for column in range(len(_HEADINGS))]
    emit("\n".join(_aligned(row, widths) for row in rows))
    return 0


def _aligned(row: tuple[str, ...], widths: list[int]) -> str:
    cells = [
        cell.rjust(width) if 1 <= column <= _NUMERIC else cell.ljust(width)
        for column, (cell, width) in enumerate(zip(row, widths, strict=True))
    ]
    return "  ".join(cells).rstrip()
