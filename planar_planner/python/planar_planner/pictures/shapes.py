"""Polygons as matplotlib's paths, in the robot's frame and placed in the world."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.path import Path
from numpy.typing import NDArray

from planar_planner.explain.cells import Cells
from planar_planner.planning.path_samples import Floats
from planar_planner.problem.make import Polygons, Problem
from planar_planner.scene.fields import Box, Configuration


def polygon_paths(polygons: Polygons) -> list[Path]:
    """Return one closed path per polygon: outer rings anticlockwise and holes clockwise."""
    paths = []
    rings = polygons.ring_starts
    for first, last in zip(polygons.polygon_starts[:-1], polygons.polygon_starts[1:], strict=True):
        vertices: list[Floats] = []
        codes: list[NDArray[np.uint8]] = []
        for r in range(int(first), int(last)):
            ring = polygons.coords[rings[r] : rings[r + 1]]
            anticlockwise = _signed_area(ring) > 0.0
            ring = ring if anticlockwise == (r == first) else ring[::-1]
            vertices.append(np.concatenate([ring, ring[:1]]))
            code = np.full(len(ring) + 1, Path.LINETO, dtype=np.uint8)
            code[0], code[-1] = Path.MOVETO, Path.CLOSEPOLY
            codes.append(code)
        paths.append(Path(np.concatenate(vertices), np.concatenate(codes)))
    return paths


def placed(paths: Sequence[Path], q: Configuration | Floats) -> list[Path]:
    """Return the robot's paths at a configuration."""
    return [Path(moved(np.asarray(path.vertices), q), path.codes) for path in paths]


def workspace_path(problem: Problem) -> Path | None:
    """Return the outline of the workspace, if the scene has one."""
    if problem.workspace is not None:
        return polygon_paths(problem.workspace)[0]
    return None if problem.workspace_box is None else box_path(problem.workspace_box)


def box_path(box: Box) -> Path:
    """Return the closed outline of a box."""
    return Path(np.concatenate([corners(box), [box[:2]]]), closed=True)


def corners(box: Box) -> Floats:
    """Return the corners (4, 2) of a box, anticlockwise."""
    xmin, ymin, xmax, ymax = box
    return np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)])


def rectangles(cells: Cells) -> Floats:
    """Return the corners (N, 4, 2) of cells in the plane, anticlockwise."""
    (x0, y0), (x1, y1) = cells.lower[:, :2].T, cells.upper[:, :2].T
    turns = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return np.stack([np.stack(corner, axis=1) for corner in turns], axis=1)


def moved(points: Floats, q: Configuration | Floats) -> Floats:
    """Return points (N, 2) of the robot's frame in the world: p -> R(theta) p + (x, y)."""
    c, s = np.cos(q[2]), np.sin(q[2])
    turn = np.array([[c, s], [-s, c]])  # rows are points: p R^T
    return np.asarray(points @ turn + np.array(q[:2]))


def _signed_area(ring: Floats) -> float:
    """Return the area by the shoelace formula about the first vertex; only its sign is used."""
    x, y = (ring - ring[0]).T
    return float(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
