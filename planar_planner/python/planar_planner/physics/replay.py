"""The robot put along a path, and what Chipmunk says it touches there."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from planar_planner.errors import OptionsError
from planar_planner.load import load_scene
from planar_planner.physics.contacts import find_contacts
from planar_planner.physics.goals import travel_between, travel_to_goal
from planar_planner.physics.report import Replay
from planar_planner.physics.world import engine_name, make_world, rounding
from planar_planner.planning.path_samples import equal_steps, reach, travel
from planar_planner.problem.make import Problem, make_problem
from planar_planner.scene.fields import Box

if TYPE_CHECKING:
    from planar_planner.load import SceneLike

STEPS_PER_REACH = 256
"""Configurations for each reach of the robot that it travels. Between two of them a penetration of
up to 1/512 of the reach can hide, from Chipmunk and not from the planner."""

MOST_STEPS = 10_000_000
"""Configurations of a replay: some hours of Chipmunk. A smaller step is a mistake."""

Floats = NDArray[np.float64]


def replay(
    scene: SceneLike | Problem,
    path: ArrayLike,
    *,
    step: float | None = None,
    tolerance: float = 0.0,
) -> Replay:
    """Put the robot along a path, and report what Chipmunk says it touches.

    The robot is a kinematic body: it is where the path says, and nothing pushes it off. At each
    configuration Chipmunk's own collision detection is asked for contacts with every shape of
    obstacles and workspace.

    Parameters
    ----------
    scene : Scene, str, path, mapping or Problem
        A valid problem, a loaded scene, or anything that `load_scene` takes.
    path : array_like of shape (N, 3)
        Waypoints (x, y, theta) in scene units and radians, theta unwrapped; N >= 1.
    step : float, optional
        Most travel between two configurations: a bound on how far any point of the robot moves. By
        default 1/256 of the robot's reach.
    tolerance : float
        Depth that passes as contact, in scene units; below Chipmunk's own accuracy it has no say.

    Returns
    -------
    Replay
        Contacts, and the deepest penetration.

    Raises
    ------
    SceneError
        If the scene is not valid.
    ValueError
        If the path has another shape or is not finite.
    OptionsError
        If step or tolerance is out of range, or pymunk is missing.
    """
    problem = problem_of(scene)
    radius = reach(problem.robot)
    waypoints = np.asarray(path, dtype=np.float64)
    length = float(travel(waypoints, radius)[-1])
    spacing = radius / STEPS_PER_REACH if step is None else step
    if not (0.0 < spacing < math.inf and length / spacing <= MOST_STEPS):
        raise OptionsError(f"the step must be at least {length / MOST_STEPS:g} (got {spacing:g})")
    if not 0.0 <= tolerance < math.inf:
        raise OptionsError(f"the tolerance must be a length of at least 0 (got {tolerance:g})")
    world = make_world(problem, dynamic=False)
    where = equal_steps(waypoints, radius, spacing)
    found = find_contacts(world, where)
    (x0, y0, theta0), (x1, y1, theta1) = waypoints[[0, -1]].tolist()
    return Replay(
        scene=problem.name,
        configurations=where,
        depths=found.depths,
        step=length / (len(where) - 1),
        length=length,
        contacts=found.contacts,
        deepest=found.deepest,
        doubted=found.doubted,
        accuracy=rounding(problem, where),
        tolerance=tolerance,
        outside=outside(problem.reference_bounds, waypoints),
        start_gap=travel_between(problem, (x0, y0, theta0), problem.start),
        goal_gap=travel_to_goal(problem, (x1, y1, theta1)),
        engine=engine_name(),
    )


def problem_of(scene: SceneLike | Problem) -> Problem:
    """Return the valid problem behind whatever names a scene."""
    if isinstance(scene, Problem):
        return scene
    return make_problem(load_scene(scene))


def outside(bounds: Box | None, waypoints: Floats) -> float:
    """Return how far the reference point leaves its bounds; at waypoints, since between is less."""
    if bounds is None:
        return 0.0
    x, y = waypoints[:, 0], waypoints[:, 1]
    excess = (bounds[0] - x, x - bounds[2], bounds[1] - y, y - bounds[3])
    return max(0.0, *(float(side.max()) for side in excess))
