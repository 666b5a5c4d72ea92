"""The planner's side: a drawing imported through the public door. Nothing else imports it here."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import shapely

from planar_planner.errors import SceneError
from planar_planner.formats.parts import ImportOptions
from planar_planner.load import load_scene
from planar_planner.problem.make import make_problem

from .model import Drawing, Region

ROBOT = "[[-0.01,-0.01],[0.01,-0.01],[0.01,0.01],[-0.01,0.01]]"
"""A footprint for files without a robot; only the obstacles are compared."""


@dataclass(frozen=True)
class Import:
    """What the planner made of a file; `refusal` is its message if it refused."""

    region: Region
    notes: tuple[str, ...] = ()
    refusal: str = ""


def imported(drawing: Drawing) -> Import:
    """Import a drawing; other exceptions than SceneError are passed on."""
    given: dict[str, Any] = {"start": [0.0, 0.0, 0.0], "goal": [1.0, 0.0, 0.0], "footprint": ROBOT}
    given.update(drawing.options)
    if "robot" in given:
        del given["footprint"]
    with tempfile.TemporaryDirectory() as folder:
        for name, data in drawing.files.items():
            (Path(folder) / name).write_bytes(data)
        if "robot" in given:
            given["robot"] = Path(folder) / given["robot"]
        return imported_file(Path(folder) / drawing.name, given)


def imported_file(path: Path, given: dict[str, Any]) -> Import:
    """Import a file with options."""
    try:
        scene = load_scene(path, ImportOptions(**given))
        make_problem(scene)
    except SceneError as error:
        return Import(None, (), str(error))
    region = shapely.union_all([_region(obstacle) for obstacle in scene.obstacles])
    return Import(region, tuple(scene.notes))


def _region(geometry: Any) -> Region:
    """Return a scene's Polygon or MultiPolygon; the planner's gate has found it valid."""
    polygons = geometry["coordinates"]
    if geometry["type"] == "Polygon":
        polygons = [polygons]
    return shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in polygons])
