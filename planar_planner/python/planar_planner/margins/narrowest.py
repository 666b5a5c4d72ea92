"""The narrowest place of a way: a saddle of the clearance, searched along a path.

A certified path runs closer to obstacles than it must, so the place of its least clearance says
little. At the narrow place no sideways motion helps. So from every configuration of the path the
clearance is climbed within the plane across the path (in x, y and reach times theta), and the
lowest summit is the narrow place. The computation uses plain doubles and claims nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from planar_planner.margins.body import Floats
from planar_planner.margins.surroundings import NearestPoints, Surroundings, placed, shape_of
from planar_planner.problem.make import Polygons, Problem
from planar_planner.tolerances import LAST_STEP

SAMPLES = 200
"""Most configurations of the path from which a climb starts."""

DIRECTIONS = 8
"""Directions tried at each step of a climb; they turn between steps, so narrow ridges are found."""

FIRST_STEP = 0.05
"""First step of a climb, relative to the robot's reach; `LAST_STEP` ends the climb."""

MOST_STEPS = 100
"""Most steps of a climb: five reaches up, which ends a climb into open space."""

CLOSE = 0.02
"""Contacts are edges that are at most this part of the reach farther than the nearest edge. A climb
ends a little beside the exact summit, where all contacts of a narrow place are equally near."""

Clearance = Callable[[Floats], float]
Climbed = tuple[float, Floats]
Found = tuple[Floats, float, tuple[NearestPoints, ...]]


def find_narrow_place(
    path: Floats, robot: Polygons, around: Surroundings, problem: Problem
) -> Found | None:
    """Return configuration, clearance and contacts of a path's narrow place, or None.

    Parameters
    ----------
    path : (N, 3)
        Waypoints; a single one is measured without a climb.
    robot : Polygons
        The robot whose clearance counts.
    around : Surroundings
        The edges that it may touch.
    problem : Problem
        Gives the bounds of the reference point, and whether the robot may turn.
    """
    reach = float(np.hypot(*robot.coords.T).max())
    shape = shape_of(robot)

    def clearance(q: Floats) -> float:
        return around.clearance(placed(shape, q)) if _in_bounds(problem, q) else -math.inf

    if len(path) == 1:
        lowest: Climbed | None = clearance(path[0]), path[0]
    else:
        lowest = _lowest_summit(clearance, *_samples(path, reach), reach, problem.rotation)
    if lowest is None or not math.isfinite(lowest[0]):
        return None
    height, q = lowest
    return q, height, around.contacts(placed(shape, q), height + CLOSE * reach)


def _lowest_summit(
    clearance: Clearance, samples: Floats, tangents: Floats, reach: float, rotation: bool
) -> Climbed | None:
    """Climb from each sample, the lowest first, until no other sample can have a lower summit."""
    heights = np.array([clearance(q) for q in samples])
    lowest: Climbed | None = None
    for i in np.argsort(heights, kind="stable").tolist():
        bound = math.inf if lowest is None else lowest[0]
        if heights[i] >= bound:
            break
        across = _across(tangents[i], reach, rotation=rotation)
        top, q = _climb(clearance, samples[i], float(heights[i]), across * reach, bound)
        if top < bound:
            lowest = (top, q)
    return lowest


def _in_bounds(problem: Problem, q: Floats) -> bool:
    box = problem.reference_bounds
    if box is None or problem.bounds_are_chosen:
        return True
    return bool(box[0] <= q[0] <= box[2] and box[1] <= q[1] <= box[3])


def _samples(path: Floats, reach: float) -> tuple[Floats, Floats]:
    """Return configurations at equal steps of motion, and the path's direction at each."""
    scaled = path * (1.0, 1.0, reach)
    steps = np.diff(scaled, axis=0)
    lengths = np.hypot(np.hypot(steps[:, 0], steps[:, 1]), steps[:, 2])
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    wanted = np.linspace(0.0, along[-1], SAMPLES)
    samples = np.column_stack([np.interp(wanted, along, path[:, k]) for k in range(3)])
    segment = np.clip(np.searchsorted(along, wanted, side="right") - 1, 0, len(steps) - 1)
    return samples, steps[segment] / np.maximum(lengths[segment], np.finfo(float).tiny)[:, None]


def _across(tangent: Floats, reach: float, *, rotation: bool) -> Floats:
    """Return an orthonormal basis (k, 3) of the motions across a direction, theta in radians."""
    free = np.eye(3) if rotation else np.eye(3)[:2]
    basis: list[Floats] = []
    for axis in free[np.argsort(np.abs(free @ tangent), kind="stable")][: len(free) - 1]:
        v = axis - (axis @ tangent) * tangent
        for other in basis:
            v = v - (v @ other) * other
        basis.append(v / np.linalg.norm(v))
    return np.array(basis) / (1.0, 1.0, reach)


def _climb(
    clearance: Clearance, q: Floats, height: float, across: Floats, enough: float
) -> Climbed:
    """Climb until the clearance exceeds `enough`; steps are halved when no direction helps."""
    step = FIRST_STEP
    for turn in range(MOST_STEPS):  # in radians, so not a multiple of the spacing of directions
        if step < LAST_STEP or height >= enough:
            break
        angles = turn + np.arange(DIRECTIONS) * (math.tau / DIRECTIONS)
        weights = np.column_stack([np.cos(angles), np.sin(angles)])[:, : len(across)]
        tried = q + step * (weights @ across)
        heights = [clearance(candidate) for candidate in tried]
        best = int(np.argmax(heights))
        if heights[best] > height:
            q, height = tried[best], heights[best]
        else:
            step *= 0.5
    return height, q
