"""Meshes a second time: by trimesh (pycollada), projected and united by shapely.

trimesh leaves the file's unit and upward axis to the caller; both are applied here as OMPL.app's
importer does: x–y plane after turning the upward axis to y. Numbers are single precision.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence

import numpy as np
import shapely
import trimesh

from ..judge import UnreadableError
from ..model import Drawing, Exact, Reading, Region

_UPRIGHT = {
    "Y_UP": np.eye(3),
    "Z_UP": np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "X_UP": np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
}


def read(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of the projected triangles of the world."""
    if "truth" in drawing.hints:
        outlines = [[corner[:2] for corner in outline] for outline in drawing.hints["truth"]]
        region = shapely.union_all([shapely.Polygon(outline) for outline in outlines])
    else:
        region = projected(drawing.files["world.dae"])
    size = max(map(abs, region.bounds)) if not region.is_empty else 1.0
    return [Reading("projection", Exact(region, 1e-5 * size))]


def projected(data: bytes) -> Region:
    """Return what a Collada file covers in the plane."""
    try:
        scene = trimesh.load(io.BytesIO(data), file_type="dae", force="scene")
        mesh = scene.to_geometry()
    except Exception as error:  # whatever the libraries raise on what they do not know
        raise UnreadableError(f"trimesh: {error}") from None
    axis = re.search(rb"<up_axis>\s*(\w+)", data)
    unit = re.search(rb'<unit[^>]*meter="([^"]+)"', data)
    scale = float(unit[1]) if unit else 1.0
    turn = _UPRIGHT[axis[1].decode() if axis else "Y_UP"]
    corners = (np.asarray(mesh.vertices) @ turn.T * scale)[:, :2]
    polygons = shapely.polygons(corners[np.asarray(mesh.faces)])
    return shapely.union_all(polygons[shapely.area(polygons) > 0])
