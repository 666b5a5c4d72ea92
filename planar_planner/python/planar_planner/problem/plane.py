"""The same problem with another robot, also in the unbounded plane."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, ends
from planar_planner.problem.polygons import Polygons
from planar_planner.scene.fields import Box
from planar_planner.scene.plane import bounds_of_plane


def with_robot(problem: Problem, robot: Polygons) -> Problem:
    """Return the problem with another robot, whose bounds are its own if they were chosen.

    Chosen reference bounds contain all obstacles, the start and the goal. Grown by more than the
    new robot's reach they stand for the unbounded plane for this robot too (`bounds_of_plane`).
    Reference bounds that the user stated stay as they are.
    """
    bounds = problem.reference_bounds
    if problem.bounds_are_chosen and bounds is not None:
        reach = float(np.hypot(*robot.coords.T).max())
        bounds = bounds_of_plane(_with_ends(problem, bounds), reach)
    return replace(problem, robot=robot, reference_bounds=bounds)


def _with_ends(problem: Problem, box: Box) -> Box:
    """Return the least box that contains a box, the start and the goal."""
    points = [np.array(box).reshape(2, 2), np.array([q[:2] for q in ends(problem).values()])]
    if isinstance(problem.goal, GoalSet):
        points.append(problem.goal.polygons.coords)
    corners = np.concatenate(points)
    (xmin, ymin), (xmax, ymax) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    return xmin, ymin, xmax, ymax
