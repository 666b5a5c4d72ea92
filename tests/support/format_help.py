"""Shared by the tests of formats: convert by the command line, compare scenes and verdicts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from planar_planner.cli.main import main
from planar_planner.formats.parts import ImportOptions
from planar_planner.load import load_scene
from planar_planner.scene.model import Scene


def read(path: Path, text: str | bytes, **options: Any) -> Scene:
    """Write a file, and load the scene in it."""
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return load_scene(path, ImportOptions(**options))


def convert(*arguments: str | Path) -> int:
    return main(["convert", *map(str, arguments)])


def rings(geometry: Any) -> list[list[list[float]]]:
    """Return all rings of a geometry, open and beginning with the least vertex."""
    polygons = geometry["coordinates"]
    if geometry["type"] == "Polygon":
        polygons = [polygons]
    return sorted(_canonical(ring) for polygon in polygons for ring in polygon)


def _canonical(ring: list[list[float]]) -> list[list[float]]:
    points = ring[:-1] if ring[0] == ring[-1] else ring
    first = points.index(min(points))
    turned = points[first:] + points[:first]
    return min(turned, [turned[0], *turned[:0:-1]])


def same_geometry(a: Scene, b: Scene) -> None:
    """Assert that two scenes state the same doubles."""
    assert rings(a.robot) == rings(b.robot)
    assert sorted(map(rings, a.obstacles)) == sorted(map(rings, b.obstacles))
    assert a.start == b.start
    assert a.goal == b.goal
    assert a.rotation == b.rotation
