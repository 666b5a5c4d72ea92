"""The core as a judge of what others found: configurations and whole paths on a scene."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from planar_planner._core import StateCheck
from planar_planner.planning.engine import make_core
from planar_planner.problem.make import Problem, point_goal
from planar_planner.tolerances import END_SLACK

Soundness = Literal["sound", "collides", "unknown"]

SAMPLES = 2000
"""Configurations looked at on each segment for a collision to show, once a path is not certified.
They only tell ``collides`` from ``unknown``; no claim that a path is free rests on them."""


class Judge:
    """Says what is free on a scene. Not thread-safe.

    Parameters
    ----------
    problem : Problem
        The scene; its start and goal play a part in `joins` only.

    Attributes
    ----------
    core : Core
        Fresh: it has no cells yet.
    check : StateCheck
        ``check.is_free(x, y, theta)`` is True only if the robot is free there, in exact arithmetic
        for these very doubles; nearer to contact than the rounding error it is False.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.core = make_core(problem)
        self.check = StateCheck(self.core)

    def path(self, waypoints: NDArray[np.float64]) -> Soundness:
        """Judge a path, linear in (x, y, theta) between waypoints, along its whole length.

        Parameters
        ----------
        waypoints : NDArray, shape (N, 3)
            N >= 1; theta in radians and unwrapped.

        Returns
        -------
        str
            ``sound``: certified free, continuously. ``collides``: a configuration on it overlaps an
            obstacle or leaves the workspace. ``unknown``: neither could be shown, as for a path
            that touches.
        """
        verdict = self.core.check_path(waypoints)
        if verdict["valid"]:
            return "sound"
        first = max(int(verdict["segment"]), 0)
        for begin, end in zip(waypoints[first:-1], waypoints[first + 1 :], strict=True):
            places = begin + np.linspace(0.0, 1.0, SAMPLES)[:, None] * (end - begin)
            doubtful = places[~self.check.are_free(places)]
            for x, y, theta in doubtful.tolist():
                if self.core.placement((x, y, theta))["state"] in ("colliding", "outside"):
                    return "collides"
        return "unknown"

    def joins(self, waypoints: NDArray[np.float64]) -> bool:
        """Whether a path runs from the problem's start to its goal, whole turns apart."""
        ends = (self.problem.start, point_goal(self.problem, "a comparison with samplers"))
        return all(_same(tuple(q), end) for q, end in zip(waypoints[[0, -1]], ends, strict=True))


def _same(q: tuple[float, ...], end: tuple[float, float, float]) -> bool:
    largest = max(abs(value) for value in (*q, *end))
    slack = END_SLACK * max(largest, math.tau)
    turned = math.remainder(q[2] - end[2], math.tau)
    return math.dist(q[:2], end[:2]) <= slack and abs(turned) <= slack


def unwrapped(waypoints: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a path of OMPL's as we read paths: theta runs on instead of jumping by whole turns.

    OMPL turns the shorter way between two yaws, so each theta is brought to within half a turn of
    the one before.
    """
    points = np.array(waypoints, dtype=np.float64).reshape(-1, 3)
    for i in range(1, len(points)):
        turns = round((points[i - 1, 2] - points[i, 2]) / math.tau)
        points[i, 2] += turns * math.tau
    return points
