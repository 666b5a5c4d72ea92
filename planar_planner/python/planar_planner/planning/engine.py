"""The native core as the package uses it: made from a problem, asked under limits."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from planar_planner._core import Core
from planar_planner.planning.options import Options
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem

Listener = Callable[[dict[str, Any]], bool]
"""Called about ten times a second with running counts; returning False stops the search."""


def make_core(problem: Problem, without: Sequence[str] = (), query: str = "per-normal") -> Core:
    """Return a fresh core for a problem: it has no cells yet.

    Parameters
    ----------
    problem : Problem
        The scene; its start and goal play no part.
    without : sequence of str, optional
        Parts of the method to leave out, by their names in native/ablation.hpp; for experiments.
    query : str, optional
        The C-obstacle query that culls cells, by its name there; for experiments.
    """
    workspace = problem.workspace
    return Core(
        problem.robot.arrays,
        problem.obstacles.arrays,
        problem.workspace_box,
        None if workspace is None else workspace.arrays,
        problem.reference_bounds,
        problem.rotation,
        without=without,
        query=query,
    )


def ask(
    core: Core, problem: Problem, limits: Options, listener: Listener | None = None
) -> dict[str, Any]:
    """Return a core's answer to a problem's own start and goal, as `make_result` takes it."""
    goal = problem.goal
    return core.solve(
        problem.start,
        (goal.polygons.arrays, goal.angles if problem.rotation else None)
        if isinstance(goal, GoalSet)
        else goal,
        limits.resolution,
        limits.max_cells,
        limits.timeout,
        limits.max_memory,
        limits.contact_tolerance,
        listener,
    )
