"""The content of an animation: the query, its answer and the cells."""

from __future__ import annotations

from dataclasses import dataclass, replace

from planar_planner.explain.about_point import about_point, path_of_point
from planar_planner.explain.cells import Cells
from planar_planner.planning.options import Options
from planar_planner.planning.planner import Planner
from planar_planner.planning.result import Result
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, with_query

CELLS_TO_SHOW = 100_000
"""Most cells of a search that is run only to have cells to show; it takes a second or two."""


@dataclass(frozen=True, eq=False)
class Material:
    """The content of an animation.

    Attributes
    ----------
    problem : Problem
        The scene, with the query that was answered; with a path its ends are those.
    region : GoalSet or None
        The goal, if it is a set of configurations.
    result : PathFound, NoPath or Undecided
        The answer.
    cells : Cells
        The subdivision; may be empty.
    second_search : bool
        Whether the cells come from a second search with cells only, because the answer needed none.
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
    """Return the content of an animation of a planner's last answer.

    If the answer needed no cells, a second search with cells only makes at most 100,000 of them.

    Parameters
    ----------
    planner : Planner
        The planner that has answered the query.
    result : PathFound, NoPath or Undecided
        The answer.
    options : Options, optional
        Limits of the query; they apply to the second search too.
    cells_needed : bool, optional
        Whether to run the second search if the answer needed no cells.
    """
    problem = planner.problem
    region = problem.goal if isinstance(problem.goal, GoalSet) else None
    if len(result.path):
        problem = with_query(problem, result.path[0], result.path[-1])
    cells = planner.cells()
    if len(cells) or not cells_needed:
        return _material(problem, region, result, cells, second_search=False)
    limits = options or Options()
    limits = replace(limits, max_cells=min(limits.max_cells, CELLS_TO_SHOW))
    second = Planner(planner.scene, cells_only=True)
    goal = None if isinstance(problem.goal, GoalSet) else problem.goal  # a region is the scene's
    second.solve(problem.start, goal, limits)
    return _material(problem, region, result, second.cells(), second_search=True)


def _material(
    problem: Problem,
    region: GoalSet | None,
    result: Result,
    cells: Cells,
    *,
    second_search: bool,
) -> Material:
    """Return it about the point that the cells are of, so that all of it fits together."""
    result = replace(result, path=path_of_point(result.path, cells.point))
    return Material(about_point(problem, cells.point), region, result, cells, second_search)
