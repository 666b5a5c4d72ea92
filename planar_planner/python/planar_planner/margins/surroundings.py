"""The edges that the robot may touch, for distances in plain doubles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely

from planar_planner.margins.body import UNIT_ROUNDOFF, Floats, shapes_of
from planar_planner.margins.segments import edges_of
from planar_planner.problem.make import Polygons, Problem
from planar_planner.scene.fields import Configuration

WORKSPACE = -1
"""Index of the workspace's outline, in the place of an obstacle's index."""


@dataclass(frozen=True)
class NearestPoints:
    """The nearest points of the robot and of an edge that it must not cross.

    Attributes
    ----------
    obstacle : int
        Index in the scene's list of obstacles; -1 for the workspace's outline.
    name : str
        The obstacle's name; empty if it has none.
    robot_point, obstacle_point : (x, y)
        Points in the world frame, in the scene's unit.
    distance : float
        Distance between the two.
    """

    obstacle: int
    name: str
    robot_point: tuple[float, float]
    obstacle_point: tuple[float, float]
    distance: float


class Surroundings:
    """Edges of the obstacles and of the workspace's outline.

    The error of a placed vertex is at most 8 u (|a| + |t|) per coordinate: sine and cosine to 1
    ulp, two products, two sums. The distance of a point from a segment adds at most 16 u of the
    largest coordinate (a cross product of differences, divided by a length). `rounding` is 64 u of
    the largest coordinate, which is more than both for either coordinate.
    """

    def __init__(self, problem: Problem) -> None:
        shapes = shapes_of(problem.obstacles) if len(problem.obstacles) else []
        outlines = [(int(i), s) for i, s in zip(problem.obstacle_indices, shapes, strict=True)]
        if problem.workspace_box is not None:
            xmin, ymin, xmax, ymax = problem.workspace_box
            box = np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)])
            outlines.append((WORKSPACE, [box]))
        elif problem.workspace is not None:
            outlines.append((WORKSPACE, shapes_of(problem.workspace)[0]))
        ends = [np.stack(edges_of(shape), axis=1) for _, shape in outlines]
        edges = np.concatenate(ends) if ends else np.empty((0, 2, 2))
        self._names = problem.obstacle_names
        self._owners = np.repeat([i for i, _ in outlines], [len(e) for e in ends])
        self._edges = shapely.linestrings(edges)
        self._tree = shapely.STRtree(self._edges)
        self._extent = float(np.abs(edges).max()) if len(edges) else 0.0

    def rounding(self, robot: Polygons, q: Configuration) -> float:
        """Return a bound on the error of `clearance`, a length."""
        reach = float(np.hypot(*robot.coords.T).max()) + max(abs(q[0]), abs(q[1]))
        return 64.0 * UNIT_ROUNDOFF * max(reach, self._extent)

    def clearance(self, body: shapely.Geometry) -> float:
        """Return the distance of a placed body from all edges; infinite if there are none."""
        if len(self._edges) == 0:
            return math.inf
        found = self._tree.query_nearest(body, return_distance=True, all_matches=False)
        return float(found[1][0])

    def contacts(self, body: shapely.Geometry, within: float) -> tuple[NearestPoints, ...]:
        """Return the nearest points of edges within a distance, nearest first.

        If several edges meet in the nearest point, the result has only one of them.
        """
        found: dict[tuple[int, float, float], NearestPoints] = {}
        for i in sorted(self._tree.query(body, predicate="dwithin", distance=within).tolist()):
            line = shapely.shortest_line(body, self._edges[i])
            (ax, ay), (bx, by) = line.coords
            owner = int(self._owners[i])
            name = "" if owner == WORKSPACE else self._names[owner]
            contact = NearestPoints(owner, name, (ax, ay), (bx, by), float(line.length))
            found.setdefault((owner, bx, by), contact)
        return tuple(sorted(found.values(), key=lambda c: (c.distance, c.obstacle)))


def shape_of(robot: Polygons) -> shapely.Geometry:
    """Return a robot's polygons, which may overlap, in its own frame."""
    shapes = [shapely.Polygon(rings[0], rings[1:]) for rings in shapes_of(robot)]
    return shapely.GeometryCollection(shapes)


def placed(shape: shapely.Geometry, q: Configuration | Floats) -> shapely.Geometry:
    """Return a robot's shape at a configuration."""
    c, s = math.cos(q[2]), math.sin(q[2])
    turn = np.array([[c, s], [-s, c]])  # rows are points: p R^T
    return shapely.transform(shape, lambda points: points @ turn + np.asarray(q[:2]))
