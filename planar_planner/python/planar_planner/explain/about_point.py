"""A scene and its paths about another point of the robot than the reference point.

Cells of a robot whose reference point lies far from its body are of a point of the body. Pictures
that show cells show the whole scene about that point: the bodies stand in the same places.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Configuration

Point = tuple[float, float]
"""Of the robot's frame, in the scene's unit."""

LONGEST_TURN = 0.01
"""Radians from one configuration to the next on a path about another point. Between them the point
is off its chord by at most an eighth of the square of this times its distance from the origin."""


def path_of_point(path: NDArray[np.float64], point: Point) -> NDArray[np.float64]:
    """Return the way of a point of the robot, rounded, along a path of its reference point.

    Parameters
    ----------
    path : NDArray, shape (N, 3)
        Waypoints (x, y, theta) of the reference point.
    point : (x, y)
        In the robot's frame.

    Returns
    -------
    NDArray, shape (M, 3)
        Places of the point, with theta; the path itself for the reference point.
    """
    if point == (0.0, 0.0) or not len(path):
        return path
    parts = [path[:1]]
    for start, end in pairwise(path):
        count = max(1, math.ceil(abs(end[2] - start[2]) / LONGEST_TURN))
        parts.append(start + np.arange(1, count + 1)[:, None] / count * (end - start))
    out = np.concatenate(parts)
    c, s = np.cos(out[:, 2]), np.sin(out[:, 2])
    x, y = point
    out[:, 0] += c * x - s * y
    out[:, 1] += s * x + c * y
    return out


def path_label(point: Point) -> str:
    """Return what a drawn path is of."""
    whose = "the reference point" if point == (0.0, 0.0) else "a point of the body"
    return f"path of {whose}"


def about_point(problem: Problem, point: Point) -> Problem:
    """Return a problem about a point of the robot, rounded; for pictures.

    Its robot's frame has its origin at the point, and its ends are where the point is. Bounds of
    the reference point are left out.
    """
    if point == (0.0, 0.0):
        return problem
    goal = problem.goal
    return replace(
        problem,
        robot=replace(problem.robot, coords=problem.robot.coords - np.array(point)),
        start=_placed(problem.start, point),
        reference_bounds=None,
        goal=goal if isinstance(goal, GoalSet) else _placed(goal, point),
    )


def _placed(q: Configuration, point: Point) -> Configuration:
    x, y, theta = path_of_point(np.array([q]), point)[0].tolist()
    return (x, y, theta)
