"""Lengths as the decimals that they are written as: integers of a smaller unit.

On a grid of 0.1 the doubles of things that are drawn touching overlap by a last place, or are apart
by one. In a unit of 0.1 the same scene is one of integers, which doubles hold exactly.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from planar_planner.problem.goal import Goal, GoalSet
from planar_planner.problem.make import Problem
from planar_planner.problem.polygons import Polygons
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.input_limits import MAX_COORDINATE

MOST_PLACES = 12
"""Most decimal places, of lengths below 1."""
_DYADIC = 2.0**20
"""Multiples of its inverse are decimals that doubles hold exactly."""


def decimal_places(problem: Problem) -> int | None:
    """Return how many decimal places the lengths of a problem have.

    Every length is then the double nearest to an integer over 10^places, and that integer is at
    most `MAX_COORDINATE`, so that no other decimal of so many places is near enough to be meant.

    Returns
    -------
    int or None
        None if the problem means doubles, if doubles hold its numbers exactly anyhow, or if they
        are not short decimals.
    """
    if not problem.decimals:
        return None
    lengths = np.concatenate([np.ravel(part) for part in _lengths(problem)])
    if (np.rint(lengths * _DYADIC) == lengths * _DYADIC).all():
        return None
    largest = float(np.abs(lengths).max())
    for places in range(1, MOST_PLACES + 1):
        unit = 10.0**places
        if largest * unit > MAX_COORDINATE:
            return None
        if (np.rint(lengths * unit) / unit == lengths).all():
            return places
    return None


def rounding_of_decimals(problem: Problem) -> float:
    """Return by how much a length may differ from the decimal that it means; 0 if it means none."""
    if not problem.decimals:
        return 0.0
    return (
        0.5
        * sys.float_info.epsilon
        * max(float(np.abs(part).max()) for part in map(np.asarray, _lengths(problem)) if part.size)
    )


def in_small_units(problem: Problem, places: int) -> Problem:
    """Return the problem in a unit 10^places times smaller; its lengths are integers."""
    unit = 10.0**places

    def box(given: Box | None) -> Box | None:
        return None if given is None else _four(np.rint(np.array(given) * unit))

    return replace(
        problem,
        robot=_polygons(problem.robot, unit),
        obstacles=_polygons(problem.obstacles, unit),
        workspace_box=box(problem.workspace_box),
        workspace=None if problem.workspace is None else _polygons(problem.workspace, unit),
        reference_bounds=box(problem.reference_bounds),
        start=_configuration(problem.start, unit),
        goal=_goal(problem.goal, unit),
    )


def _lengths(problem: Problem) -> Iterator[NDArray[np.float64] | tuple[float, ...]]:
    yield problem.robot.coords
    yield problem.obstacles.coords
    yield problem.workspace_box or ()
    yield () if problem.workspace is None else problem.workspace.coords
    yield problem.reference_bounds or ()
    yield problem.start[:2]
    goal = problem.goal
    yield goal.polygons.coords if isinstance(goal, GoalSet) else goal[:2]


def _four(values: NDArray[np.float64]) -> Box:
    xmin, ymin, xmax, ymax = values.tolist()
    return xmin, ymin, xmax, ymax


def _polygons(polygons: Polygons, unit: float) -> Polygons:
    coords = np.rint(polygons.coords * unit)
    return Polygons(coords, polygons.ring_starts, polygons.polygon_starts)


def _configuration(q: Configuration, unit: float) -> Configuration:
    return float(np.rint(q[0] * unit)), float(np.rint(q[1] * unit)), q[2]


def _goal(goal: Goal, unit: float) -> Goal:
    if not isinstance(goal, GoalSet):
        return _configuration(goal, unit)
    left = None if goal.left is None else _polygons(goal.left, unit)
    return replace(goal, polygons=_polygons(goal.polygons, unit), left=left)
