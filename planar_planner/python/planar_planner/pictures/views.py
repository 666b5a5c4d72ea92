"""The views of the command line; each draws the result of one query."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from planar_planner.explain.cells import Cells
from planar_planner.pictures.filmstrip import draw_filmstrip
from planar_planner.pictures.pinch import draw_wall
from planar_planner.pictures.slices import draw_slices
from planar_planner.pictures.space import draw_space
from planar_planner.pictures.swept import draw_scene
from planar_planner.planning.options import Options
from planar_planner.planning.planner import Planner
from planar_planner.planning.result import Result


class ViewError(Exception):
    """The query has no result that the view can show; the message states the reason."""


def draw_view(
    planner: Planner,
    result: Result,
    view: str | None = None,
    thetas: Sequence[float] | None = None,
    options: Options | None = None,
) -> Figure:
    """Draw one view of an answer.

    Parameters
    ----------
    planner : Planner
        The planner whose last query, with the scene's own start and goal, gave the result.
    result : PathFound, NoPath or Undecided
        The result.
    view : str, optional
        ``path``: the scene, and the robot along the path; ``filmstrip``: the path in drawings side
        by side; ``slices``: the cells at given angles; ``space``: the cells in 3-D; ``wall``: why
        there is no path. The default is ``wall`` if one separates start from goal, and otherwise
        ``path``.
    thetas : sequence of float, optional
        Angles of the slices, in radians.
    options : Options, optional
        Limits of a second query with cells only, which is made if the first has no cells.

    Raises
    ------
    ViewError
        If the result has nothing to show.
    """
    if view is None:
        return _why_not(planner, result) or draw_scene(planner.scene, result)
    if view == "path":
        return draw_scene(planner.scene, result)
    if view == "filmstrip":
        if not len(result.path):
            raise ViewError("there is no path to show as a filmstrip")
        return draw_filmstrip(planner.scene, result)
    if view == "wall":
        figure = _why_not(planner, result)
        if figure is None:
            raise ViewError("no wall of cells separates start from goal")
        return figure
    cells = _cells(planner, options)
    if view == "slices":
        return draw_slices(planner.scene, cells, thetas, result=result)
    if view == "space":
        if not planner.problem.rotation:
            raise ViewError("the robot may not turn: --view slices shows all of its space")
        return draw_space(planner.scene, cells, result=result)
    raise ValueError(f"no view {view!r}")


def _why_not(planner: Planner, result: Result) -> Figure | None:
    """Draw the wall, if one separates start from goal."""
    if result.verdict != "no_path":
        return None
    wall, bottleneck = planner.wall(), planner.bottleneck()
    if wall is None or bottleneck is None:
        return None
    return draw_wall(planner.scene, wall, bottleneck, result=result)


def _cells(planner: Planner, options: Options | None) -> Cells:
    """Return a planner's cells, or the cells of a second query if an easy answer has none."""
    cells = planner.cells()
    if len(cells):
        return cells
    by_cells = Planner(planner.scene, cells_only=True)
    by_cells.solve(options=options)
    cells = by_cells.cells()
    if not len(cells):
        raise ViewError("the query has made no cells")
    return cells
