"""How far a goal is, be it a configuration or a region."""

from __future__ import annotations

import math
from functools import lru_cache

import shapely
import shapely.ops

from planar_planner.physics.shapes import shapely_polygons
from planar_planner.planning.path_samples import reach
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Configuration


def nearest_goal(problem: Problem, q: Configuration) -> Configuration:
    """Return the goal's configuration that is nearest in travel, theta within half a turn of q's.

    The two parts of travel are least independently: the reference point goes straight to the region
    and theta turns the shorter way to the interval.
    """
    goal = problem.goal
    if not isinstance(goal, GoalSet):
        return goal[0], goal[1], q[2] + math.remainder(goal[2] - q[2], math.tau)
    region, point = _union(goal), shapely.Point(q[:2])
    x, y = q[:2]
    if not region.covers(point):
        nearest = shapely.ops.nearest_points(region, point)[0]
        x, y = nearest.x, nearest.y
    return x, y, q[2] + _turn_into(goal.angles, q[2])


def travel_between(problem: Problem, q: Configuration, end: Configuration) -> float:
    """Return the travel between two configurations on a straight line, up to whole turns."""
    turn = abs(math.remainder(q[2] - end[2], math.tau))
    return math.hypot(q[0] - end[0], q[1] - end[1]) + reach(problem.robot) * turn


def travel_to_goal(problem: Problem, q: Configuration) -> float:
    """Return the least travel from q into the goal on a straight line."""
    return travel_between(problem, q, nearest_goal(problem, q))


def _turn_into(angles: tuple[float, float] | None, theta: float) -> float:
    """Return the least turn that brings theta into an interval, up to whole turns."""
    if angles is None:
        return 0.0
    middle, half = 0.5 * (angles[0] + angles[1]), 0.5 * (angles[1] - angles[0])
    off = math.remainder(middle - theta, math.tau)
    return 0.0 if abs(off) <= half else off - math.copysign(half, off)


@lru_cache(maxsize=8)
def _union(goal: GoalSet) -> shapely.Geometry:
    return shapely.union_all(list(shapely_polygons(goal.polygons)))
