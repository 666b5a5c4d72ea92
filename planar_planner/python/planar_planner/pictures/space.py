"""The picture of the configuration space in 3-D: cells of each label, and the path."""

from __future__ import annotations

import os

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from planar_planner.explain.about_point import about_point, path_of_point
from planar_planner.explain.cells import FREE, FULL, LABEL_COLOURS, LABELS, MIXED, STAR, Cells
from planar_planner.load import SceneLike, load_scene
from planar_planner.pictures.boxes3d import draw_boxes, draw_end_points, draw_path, space_axes
from planar_planner.pictures.style import END_COLOURS, INK, TRACE, new_figure, save_picture
from planar_planner.pictures.world import title_of
from planar_planner.planning.result import Result
from planar_planner.problem.make import ends, make_problem, with_query

SIZE = (12.0, 6.6)  # inches
# Opacity of a label drawn alone, and in the overview, in which FULL cells would hide the others.
ALONE = {FREE: 0.5, STAR: 0.5, FULL: 0.3, MIXED: 0.12}
TOGETHER = {FULL: 0.06, FREE: 0.3, STAR: 0.3}


def draw_space(
    scene: SceneLike,
    cells: Cells,
    file: str | os.PathLike[str] | None = None,
    *,
    result: Result | None = None,
) -> Figure:
    """Draw the cells as boxes in (x, y, theta): an overview, and each label alone.

    The overview leaves out MIXED cells, since they fill the space, and shows FULL ones faintly.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene: anything that `load_scene` takes.
    cells : Cells
        Cells of a planner that has answered a query about the scene; at least one.
    file : path, optional
        File to write; its suffix (.png, .svg, .pdf) gives the format. Boxes are pixels in vector
        formats too.
    result : PathFound, NoPath or Undecided, optional
        The result, for the title and the path.

    Raises
    ------
    ValueError
        If there are no cells, or if the robot may not turn, because slices then show everything.
    """
    problem = make_problem(load_scene(scene))
    if not len(cells):
        raise ValueError("there are no cells to draw")
    if not problem.rotation:
        raise ValueError("the robot may not turn: its space is flat, and slices show all of it")
    path = np.empty((0, 3)) if result is None else result.path
    if len(path):
        problem = with_query(problem, path[0], path[-1])
    problem, path = about_point(problem, cells.point), path_of_point(path, cells.point)
    low, high = cells.lower.min(axis=0), cells.upper.max(axis=0)
    figure = new_figure(*SIZE)
    grid = figure.add_gridspec(2, 3, width_ratios=[2.1, 1, 1])
    overview = space_axes(figure, grid[:, 0], low, high)
    for layer, (label, alpha) in enumerate(TOGETHER.items()):
        chosen = cells[cells.label == label]
        draw_boxes(overview, chosen, LABEL_COLOURS[LABELS[label]], alpha, 1.0 + layer)
    draw_path(overview, path, 5.0)
    draw_end_points(overview, problem, 6.0)
    for k, label in enumerate((FREE, STAR, FULL, MIXED)):
        axes = space_axes(figure, grid[k // 2, 1 + k % 2], low, high)
        chosen = cells[cells.label == label]
        drawn = draw_boxes(axes, chosen, LABEL_COLOURS[LABELS[label]], ALONE[label], 1.0)
        draw_path(axes, path, 5.0)
        draw_end_points(axes, problem, 6.0)
        axes.set_title(_count(LABELS[label], drawn, len(chosen)), color=INK, fontsize=9)
        axes.set(xlabel="", ylabel="", zlabel="")
        axes.tick_params(labelbottom=False, labelleft=False, labelright=False)
    figure.suptitle(title_of(problem.name, result), color=INK, fontsize=12, parse_math=False)
    keys: list[Patch | Line2D] = [
        Patch(facecolor=LABEL_COLOURS[name], edgecolor="#00000055", label=name) for name in LABELS
    ]
    for name in ends(problem):
        colour = END_COLOURS[name]
        keys.append(Line2D([], [], color=colour, marker="o", linestyle="none", label=name))
    if len(path):
        keys.append(Line2D([], [], color=TRACE, linewidth=1.6, label="path"))
    figure.legend(handles=keys, loc="outside lower center", ncols=7, frameon=False, fontsize=9)
    if file is not None:
        save_picture(figure, file)
    return figure


def _count(name: str, drawn: int, present: int) -> str:
    if drawn < present:
        return f"{name}: the largest {drawn:,} of {present:,}"
    return f"{name}: {present:,}"
