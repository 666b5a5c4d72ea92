"""Scenes as OMPL problems: space, bounds, metric, validity check, planners by name.

Importing this module imports OMPL. Public names: `planar_planner.ompl.planner`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner._core import StateCheck
from planar_planner.load import SceneLike, load_scene
from planar_planner.ompl.samplers import check_samplers, import_ompl
from planar_planner.planning.path_judge import Judge, unwrapped
from planar_planner.problem.make import Problem, make_problem, point_goal
from planar_planner.scene.fields import Configuration

base: Any = import_ompl("base")
geometric: Any = import_ompl("geometric")

RESOLUTION = 0.002
"""Of OMPL's motion validation, as a fraction of the space's extent. At OMPL's own default of 0.01 a
third of the paths that it calls exact collide between the states that it looks at."""


@dataclass(frozen=True, eq=False)
class Setup:
    """A scene as an OMPL problem.

    Attributes
    ----------
    problem : Problem
        What the scene states.
    judge : Judge
        Holds the compiled state validity check, which also counts, and judges whole paths.
    information : ompl.base.SpaceInformation
        Set up, with the check and the resolution.
    """

    problem: Problem
    judge: Judge
    information: Any

    def state(self, q: Configuration) -> Any:
        """Return an OMPL state; it belongs to the caller."""
        space = self.information.getStateSpace()
        state = space.allocState()
        put_configuration(state, q, turning=self.problem.rotation)
        space.enforceBounds(state)
        return state

    def problem_definition(self) -> Any:
        """Return an OMPL ProblemDefinition with the scene's start and goal."""
        definition = base.ProblemDefinition(self.information)
        definition.setStartAndGoalStates(
            self.state(self.problem.start), self.state(point_goal(self.problem, "OMPL"))
        )
        return definition


def set_up(scene: SceneLike, *, resolution: float = RESOLUTION) -> Setup:
    """Make an OMPL problem of a scene.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    resolution : float
        Of OMPL's motion validation, as a fraction of the space's extent.

    Returns
    -------
    Setup
        The space is bounded for the reference point by the same rectangle that our own search has.
        A turn weighs as much as the farthest point of the robot moves in it: OMPL's default weight
        of 0.5 would depend on the scene's unit.

    Raises
    ------
    SceneError
        If the scene is not valid.
    """
    return set_up_problem(
        make_problem(load_scene(scene)),
        resolution=resolution,
    )


def set_up_problem(problem: Problem, *, resolution: float = RESOLUTION) -> Setup:
    """Make an OMPL problem, as `set_up`, of what a scene states."""
    judge = Judge(problem)
    check = judge.check
    space = base.SE2StateSpace() if problem.rotation else base.RealVectorStateSpace(2)
    bounds = base.RealVectorBounds(2)
    for axis in (0, 1):
        bounds.setLow(axis, check.bounds[axis])
        bounds.setHigh(axis, check.bounds[axis + 2])
    space.setBounds(bounds)
    if problem.rotation:
        space.setSubspaceWeight(1, check.robot_radius)
    information = base.SpaceInformation(space)
    information.setStateValidityChecker(validity_checker(check, problem))
    information.setStateValidityCheckingResolution(resolution)
    information.setup()
    return Setup(problem, judge, information)


def validity_checker(check: StateCheck, problem: Problem) -> Callable[[Any], bool]:
    """Return the check as OMPL calls it: a plain function costs it least."""
    is_free = check.is_free
    if problem.rotation:
        return lambda state: is_free(state.getX(), state.getY(), state.getYaw())
    theta = problem.start[2]
    return lambda state: is_free(state[0], state[1], theta)


def make_sampler(name: str, information: Any) -> Any:
    """Return one of OMPL's planners (`planar_planner.ompl.samplers.SAMPLERS`) by name."""
    (known,) = check_samplers([name])
    return getattr(geometric, known)(information)


def put_configuration(state: Any, q: Configuration, *, turning: bool) -> None:
    """Write a configuration into a state of SE2 (`turning`) or of the plane."""
    if turning:
        state.setXY(q[0], q[1])
        state.setYaw(q[2])
    else:
        state[0], state[1] = q[0], q[1]


def configuration_of(state: Any, theta: float, *, turning: bool) -> Configuration:
    """Read a state; one of the plane has the given theta."""
    if turning:
        return state.getX(), state.getY(), state.getYaw()
    return state[0], state[1], theta


def waypoints_of(path: Any, theta: float, *, turning: bool) -> NDArray[np.float64]:
    """Return the waypoints of an OMPL path, shape (N, 3), theta unwrapped."""
    states = path.getStates()
    return unwrapped(np.array([configuration_of(s, theta, turning=turning) for s in states]))
