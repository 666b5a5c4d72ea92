"""What an animation shows: the query, its answer, and cells to look at."""

from __future__ import annotations

from dataclasses import dataclass, replace

from planar_planner.explain.cells import Cells
from planar_planner.planning.options import Options
from planar_planner.planning.planner import Planner
from planar_planner.planning.result import Result
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, with_query

CELLS_TO_SHOW = 100_000
"""Limit of a search that is made only to have cells to show: a second or two."""


@dataclass(frozen=True, eq=False)
class Material:
    """What an animation shows.

    Attributes
    ----------
    problem : Problem
        The scene, with the query that was answered; with a path its ends are those.
    region : GoalSet or None
        The goal, if it is a set of configurations.
    result : PathFound, NoPath or Undecided
        Its answer.
    cells : Cells
        The subdivision; may be empty.
    second_search : bool
        Whether the cells are not those of the answer, which needed none, but of a second search
        without short cuts.
    """

    problem: Problem
    region: GoalSet | None
    result: Result
    cells: Cells
    second_search: bool


def gather(
    planner: Planner,
    result: Result,
    options: Options | None = None,
    *,
    cells_needed: bool = True,
) -> Material:
    """Return what there is to show of the last answer of a planner.

    If the answer needed no cells, a second search by cells only makes some: 100,000 at most.

    Parameters
    ----------
    planner : Planner
        Has answered the query.
    result : PathFound, NoPath or Undecided
        The answer.
    options : Options, optional
        Limits of the query; the second search keeps them too.
    cells_needed : bool, optional
        False: make none, if the answer needed none.
    """
    problem = planner.problem
    region = problem.goal if isinstance(problem.goal, GoalSet) else None
    if len(result.path):
        problem = with_query(problem, result.path[0], result.path[-1])
    cells = planner.cells()
    if len(cells) or not cells_needed:
        return Material(problem, region, result, cells, second_search=False)
    limits = options or Options()
    limits = replace(limits, max_cells=min(limits.max_cells, CELLS_TO_SHOW))
    second = Planner(planner.scene, cells_only=True)
    goal = None if isinstance(problem.goal, GoalSet) else problem.goal  # a region is the scene's
    second.solve(problem.start, goal, limits)
    return Material(problem, region, result, second.cells(), second_search=True)
