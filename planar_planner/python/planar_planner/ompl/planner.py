"""OMPL and this planner, either way round: scenes as OMPL problems, and ours as an OMPL planner.

Importing this module imports OMPL (the extra ``planar-planner[ompl]``); nothing else here does.

>>> from planar_planner.ompl import CompletePlanner, set_up
>>> setup = set_up("gear")
>>> planner = CompletePlanner(setup.information, "gear")
>>> planner.setProblemDefinition(setup.problem_definition())
>>> planner.setup()
>>> planner.solve(10.0).asString()
'Exact solution'

States are the reference point's place in the scene's unit and, where the robot may turn, its yaw in
radians: SE2StateSpace, or RealVectorStateSpace(2) at the theta of the scene's start.
"""

from __future__ import annotations

import itertools
import math
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.load import SceneLike, load_scene
from planar_planner.ompl.setup import (
    Setup,
    base,
    configuration_of,
    geometric,
    make_sampler,
    put_configuration,
    set_up,
    waypoints_of,
)
from planar_planner.planning.options import Options
from planar_planner.planning.path_judge import Judge
from planar_planner.planning.planner import Planner
from planar_planner.planning.result import NoPath, PathFound, Result, Undecided
from planar_planner.problem.make import make_problem, point_goal
from planar_planner.scene.fields import Configuration
from planar_planner.scene.model import Scene
from planar_planner.tolerances import SHORTEST_LIMIT

__all__ = ["CompletePlanner", "Setup", "make_sampler", "set_up", "waypoints_of"]

LARGEST_TURN = math.pi / 2
"""Between two states of a path as OMPL gets it: at half a turn it would not know which way."""

EXACT_THRESHOLD = sys.float_info.epsilon
"""OMPL's threshold of a goal that is a state and nothing round it."""

Status = base.PlannerStatus.PlannerStatusType


class CompletePlanner(base.Planner):  # type: ignore[misc]  # OMPL may be absent when types are checked
    """Our planner as one of OMPL's.

    It plans in the scene, not by the space information's validity checker: the two must mean the
    same world. A narrower bound of the space than the scene's own holds for the reference point.

    Parameters
    ----------
    information : ompl.base.SpaceInformation
        Over SE2StateSpace, or over RealVectorStateSpace(2) for a robot that may not turn; it then
        has the theta of the scene's start.
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes. Start and goal come from the problem
        definition.
    options : Options, optional
        Further limits; the time is `solve`'s.

    Attributes
    ----------
    results : list of PathFound, NoPath or Undecided
        Our answers of the last `solve`, one for each pair of start and goal that it tried.
    certificate : dict or None
        Evidence for the path, or, after INFEASIBLE, for its absence (docs/certificate.md).
        OMPL's own SolutionNonExistenceProof cannot be filled in: its class is not bound.
    certificates : list of dict
        The proofs that no start has a path to any goal, one a pair; the first is `certificate`.

    Raises
    ------
    SceneError
        If the scene is not valid.
    TypeError
        If the space is neither of the two.
    """

    results: list[Result]
    certificate: dict[str, Any] | None
    certificates: list[dict[str, Any]]

    def __init__(self, information: Any, scene: SceneLike, options: Options | None = None) -> None:
        super().__init__(information, "CompletePlanner")
        space = information.getStateSpace()
        self._turning = _turns(space)
        self._options = options or Options()
        loaded = load_scene(scene)
        self._planner = Planner(_in_space(loaded, space, turning=self._turning))
        self._judge = Judge(self._planner.problem)
        self._theta = self._planner.problem.start[2]
        self._state = space.allocState()  # to write in; freeing states from Python ends badly
        self._forget()

    def clear(self) -> None:
        """Forget the last answers; the cells stay, they hold for any query."""
        super().clear()
        self._forget()

    def solve(self, limit: Any, interval: float = 0.0) -> Any:
        """Decide the problem definition's query.

        Parameters
        ----------
        limit : float, PlannerTerminationCondition or callable
            Seconds; or what to ask, about ten times a second, whether to stop.
        interval : float
            Taken for OMPL's sake; the asking has its own rhythm.

        Returns
        -------
        ompl.base.PlannerStatus
            EXACT_SOLUTION: a certified path has been added to the problem definition. INFEASIBLE:
            proven that no start has a path to any goal; see `certificates`. TIMEOUT: `limit` or the
            options' timeout came first. INVALID_START, INVALID_GOAL: none is free.
            UNRECOGNIZED_GOAL_TYPE: only goal states can be decided. UNKNOWN: neither could be
            shown, or the goal is wider than the states to which there is no path; see ``reason`` of
            the `results`. APPROXIMATE_SOLUTION: OMPL's copy of the path, its yaws wrapped, could
            not be certified again; the path in `results` is.

        Raises
        ------
        SceneError
            If start and goal differ in yaw and the scene forbids turning.
        """
        del interval
        self._forget()
        return base.PlannerStatus(self._decide(_Clock(limit, self._options.timeout)))

    def _forget(self) -> None:
        self.results = []
        self.certificate = None
        self.certificates = []

    def _decide(self, clock: _Clock) -> Any:
        goal = self.getProblemDefinition().getGoal()
        goal_states = _goal_states(goal)
        if goal_states is None:
            return Status.UNRECOGNIZED_GOAL_TYPE
        starts = self._possible(self._start_states())
        goals = self._possible(goal_states)
        if not starts or not goals:
            return Status.INVALID_GOAL if starts else Status.INVALID_START
        status = self._search(list(itertools.product(starts, goals)), clock)
        if status is Status.INFEASIBLE and goal.getThreshold() > EXACT_THRESHOLD:
            return Status.UNKNOWN
        return status

    def _search(self, pairs: list[tuple[Configuration, Configuration]], clock: _Clock) -> Any:
        """Answer one pair of start and goal after the other until one has a path."""
        for start, goal in pairs:
            if clock.has_run_out():
                return Status.TIMEOUT
            options = replace(self._options, timeout=clock.remaining())
            result = self._planner.solve(
                start, goal, options, listener=clock.goes_on, certificate=True
            )
            self.results.append(result)
            if isinstance(result, PathFound):
                self.certificate = result.certificate
                return self._hand_over(result, goal)
            if isinstance(result, Undecided) and clock.has_run_out():
                return Status.TIMEOUT
        if not all(isinstance(result, NoPath) for result in self.results):
            return Status.UNKNOWN
        self.certificates = [r.certificate for r in self.results if r.certificate is not None]
        self.certificate = self.certificates[0]
        return Status.INFEASIBLE

    def _start_states(self) -> list[Any]:
        """Return the start states that OMPL finds valid.

        Not from the problem definition: its wrappers would free the states that it owns.
        """
        inputs = self.getPlannerInputStates()
        inputs.restart()
        found = []
        while inputs.haveMoreStartStates():
            state = inputs.nextStart()
            if state is not None:
                found.append(state)
        return found

    def _possible(self, states: list[Any]) -> list[Configuration]:
        """Return the states where the robot does not collide, as far as can be told."""
        found = []
        for state in states:
            q = configuration_of(state, self._theta, turning=self._turning)
            place = self._judge.core.placement(q)
            blocked = place["state"] in ("colliding", "outside")
            if not (blocked and place["depth"] > self._options.contact_tolerance):
                found.append(q)
        return found

    def _hand_over(self, result: Result, goal: Configuration) -> Any:
        """Add a path to the problem definition as OMPL can hold it; certify that copy again."""
        information = self.getSpaceInformation()
        points = _with_small_turns(result.path)
        points[-1, 2] = goal[2]  # the same but for whole turns and rounding
        path = geometric.PathGeometric(information)
        for q in points.tolist():
            put_configuration(self._state, q, turning=self._turning)
            information.enforceBounds(self._state)
            path.append(self._state)  # a copy
        copied = waypoints_of(path, self._theta, turning=self._turning)
        exact = self._judge.path(copied) == "sound"
        definition = self.getProblemDefinition()
        definition.addSolutionPath(path, not exact, 0.0, self.getName())
        return Status.EXACT_SOLUTION if exact else Status.APPROXIMATE_SOLUTION


class _Clock:
    """The limit of one `solve`: seconds, or a condition to ask."""

    def __init__(self, limit: Any, longest: float) -> None:
        seconds = longest if callable(limit) else min(float(limit), longest)
        self._end = time.monotonic() + seconds
        self._asked: Callable[[], bool] = limit if callable(limit) else lambda: False

    def remaining(self) -> float:
        """Return the seconds left; positive."""
        return max(self._end - time.monotonic(), SHORTEST_LIMIT)

    def has_run_out(self) -> bool:
        return time.monotonic() >= self._end or bool(self._asked())

    def goes_on(self, _: dict[str, Any]) -> bool:
        """Answer the core."""
        return not self.has_run_out()


def _turns(space: Any) -> bool:
    """Whether states of the space have a yaw. Dubins and Reeds-Shepp cars are not ours to plan."""
    if type(space) is base.SE2StateSpace:
        return True
    if type(space) is base.RealVectorStateSpace and space.getDimension() == 2:
        return False
    raise TypeError(
        f"states must be of SE2StateSpace or RealVectorStateSpace(2), not {type(space).__name__}"
    )


def _in_space(scene: Scene, space: Any, *, turning: bool) -> Scene:
    """Return the scene as the space restricts it: no turning, narrower bounds."""
    problem = make_problem(scene)
    if not turning:
        goal = [*point_goal(problem, "OMPL")[:2], problem.start[2]]
        scene = replace(scene, rotation=False, start=list(problem.start), goal=goal)
    own = Judge(problem).check.bounds
    low, high = space.getBounds().low, space.getBounds().high
    if all(low[k] <= own[k] and own[k + 2] <= high[k] for k in (0, 1)):
        return scene
    lower = [max(low[k], own[k]) for k in (0, 1)]
    upper = [min(high[k], own[k + 2]) for k in (0, 1)]
    return replace(scene, bounds=[*lower, *upper])


def _goal_states(goal: Any) -> list[Any] | None:
    """Return the states that a goal consists of; None if it is of another kind."""
    if type(goal) is base.GoalState:
        return [goal.getState()]
    if type(goal) is base.GoalStates:
        return [goal.getState(i) for i in range(goal.getStateCount())]
    return None


def _with_small_turns(path: NDArray[np.float64]) -> NDArray[np.float64]:
    """Add waypoints on the segments until none turns by more than `LARGEST_TURN`."""
    rows = [path[:1]]
    for begin, end in itertools.pairwise(path):
        steps = max(1, math.ceil(abs(end[2] - begin[2]) / LARGEST_TURN))
        inner = np.arange(1, steps)[:, None] / steps
        rows += [begin + inner * (end - begin), end[None]]
    return np.concatenate(rows)
