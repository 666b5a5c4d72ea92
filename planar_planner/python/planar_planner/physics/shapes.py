"""Convex shapes for Chipmunk: pieces of robot, obstacles and the outside of the workspace.

`pdg` computes the pieces exactly, with the polygons' own vertices. They are scaled by a power of
two, which is exact too. So Chipmunk gets the shapes of the scene to the last bit.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

import pdg
from planar_planner.planning.path_samples import reach
from planar_planner.problem.make import Polygons, Problem, obstacle_title
from planar_planner.scene.fields import Box

Floats = NDArray[np.float64]

MOST_VERTICES = 128
"""Most vertices of a shape. Chipmunk keeps a vertex's number in 8 bits of its collision id, and its
search for the depth ends where an id occurs again (cpCollision.c): with more than 256 vertices it
would end too early."""


@dataclass(frozen=True)
class Shape:
    """A convex shape, counter-clockwise, and what it belongs to."""

    what: str
    vertices: Floats


def scale_of(problem: Problem) -> float:
    """Return the power of two that scales the robot's reach into [1/2, 1); scaling is exact."""
    return math.ldexp(1.0, -math.frexp(reach(problem.robot))[1])


def robot_shapes(problem: Problem, scale: float) -> list[Shape]:
    """Return the robot's shapes in its own frame."""
    polygons = list(shapely_polygons(problem.robot))
    return [Shape("robot", piece * scale) for piece in _pieces(polygons)]


def obstacle_shapes(problem: Problem, scale: float) -> list[Shape]:
    """Return the shapes of the obstacles and of the workspace's outside, in the world frame."""
    named = [
        (obstacle_title(problem, i), polygon)
        for i, polygon in enumerate(shapely_polygons(problem.obstacles))
    ]
    shapes = [Shape(what, p * scale) for what, polygon in named for p in _pieces([polygon])]
    if problem.workspace_box is not None:
        thickness = _thickness(problem, problem.workspace_box)
        walls = slabs(problem.workspace_box, thickness)
        shapes += [Shape("workspace", wall * scale) for wall in walls]
    elif problem.workspace is not None:
        outside = _outside(problem, problem.workspace)
        shapes += [Shape("workspace", piece * scale) for piece in _pieces(outside)]
    return shapes


def slabs(box: Box, thickness: float) -> list[Floats]:
    """Return four rectangles around a box, overlapping at its corners."""
    x0, y0, x1, y1 = box
    u0, v0, u1, v1 = x0 - thickness, y0 - thickness, x1 + thickness, y1 + thickness
    rectangles = ((u0, v0, x0, v1), (x1, v0, u1, v1), (u0, v0, u1, y0), (u0, y1, u1, v1))
    return [np.array([(a, b), (c, b), (c, d), (a, d)]) for a, b, c, d in rectangles]


def least_width(shapes: list[Shape]) -> float:
    """Return the least width of any of the shapes; it is infinite if there are no shapes.

    A convex polygon is narrowest across one of its edges.
    """
    return min((_width(shape.vertices) for shape in shapes), default=math.inf)


def _width(vertices: Floats) -> float:
    edges = np.roll(vertices, -1, axis=0) - vertices
    normals = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.hypot(*edges.T)[:, None]
    heights = normals @ vertices.T
    return float((heights.max(axis=1) - heights.min(axis=1)).min())


def _thickness(problem: Problem, box: Box) -> float:
    """Return the thickness of walls: the robot, twice its reach wide, cannot span half of one."""
    return max(4.0 * reach(problem.robot), (box[2] - box[0]) / 8.0, (box[3] - box[1]) / 8.0)


def _outside(problem: Problem, workspace: Polygons) -> list[shapely.Polygon]:
    """Return a thick frame around a polygonal workspace, and its holes."""
    xmin, ymin = map(float, workspace.coords.min(axis=0))
    xmax, ymax = map(float, workspace.coords.max(axis=0))
    thickness = _thickness(problem, (xmin, ymin, xmax, ymax))
    frame = (xmin - thickness, ymin - thickness, xmax + thickness, ymax + thickness)
    (polygon,) = shapely_polygons(workspace)
    around = shapely.Polygon(shapely.box(*frame).exterior, [polygon.exterior])
    return [around, *(shapely.Polygon(hole) for hole in polygon.interiors)]


def shapely_polygons(polygons: Polygons) -> Iterator[shapely.Polygon]:
    """Yield the polygons as objects of shapely."""
    rings, starts = polygons.ring_starts, polygons.polygon_starts
    for first, last in itertools.pairwise(starts.tolist()):
        outer, *holes = (polygons.coords[rings[r] : rings[r + 1]] for r in range(first, last))
        yield shapely.Polygon(outer, holes)


def _pieces(polygons: list[shapely.Polygon]) -> Iterator[Floats]:
    """Yield convex pieces; a piece with too many vertices is cut along diagonals."""
    for piece in pdg.convex_pieces(polygons):
        for first in range(1, len(piece) - 1, MOST_VERTICES - 2):
            yield np.concatenate([piece[:1], piece[first : first + MOST_VERTICES - 1]])
