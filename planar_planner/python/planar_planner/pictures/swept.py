"""The picture of a scene and a path: the robot at equal steps, and its reference point's trace."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from planar_planner.load import SceneLike, load_scene
from planar_planner.pictures.goal_region import draw_goal_region
from planar_planner.pictures.shapes import placed, polygon_paths, workspace_path
from planar_planner.pictures.style import INK, TRACE, fade, new_figure, save_picture
from planar_planner.pictures.world import (
    draw_ends,
    draw_world,
    figure_size,
    frame_axes,
    title_of,
    view_box,
)
from planar_planner.planning.path_samples import Floats, equal_steps, reach, travel
from planar_planner.planning.result import Result
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, make_problem, with_query

GHOST_STEP = 0.6  # step between ghosts, in robot radii of travel (planning/path_samples.py)
MAX_GHOSTS = 160


def draw_scene(
    scene: SceneLike,
    result: Result | None = None,
    file: str | os.PathLike[str] | None = None,
    *,
    start: Sequence[float] | None = None,
    goal: Sequence[float] | None = None,
) -> Figure:
    """Draw a scene and, if given, the planner's result.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene: anything that `load_scene` takes.
    result : PathFound, NoPath or Undecided, optional
        The verdict goes into the title; a path is drawn as ghosts of the robot at equal steps of
        motion and as the trace of the reference point.
    file : path, optional
        File to write; its suffix (.png, .svg, .pdf) gives the format.
    start, goal : (x, y, theta), optional
        The query, if it is not the scene's own. A path already states both.

    Returns
    -------
    Figure
        The figure, with an Agg canvas.

    Raises
    ------
    SceneError
        If the scene is not valid.
    """
    problem = with_query(make_problem(load_scene(scene)), start, goal)
    region = problem.goal
    if result is not None and len(result.path):
        problem = with_query(problem, result.path[0], result.path[-1])
    path = result.path if result is not None and len(result.path) else np.empty((0, 3))

    view = view_box(problem, path)
    figure = new_figure(*figure_size(view))
    axes = figure.add_subplot()
    keys = draw_world(axes, problem)
    if isinstance(region, GoalSet):
        keys += draw_goal_region(axes, region)
    keys += draw_path(axes, problem, path)
    keys += draw_ends(axes, problem)
    frame_axes(axes, view, outlined=workspace_path(problem) is not None)
    axes.set_title(title_of(problem.name, result), color=INK, fontsize=12, parse_math=False)
    figure.legend(handles=keys, loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    if file is not None:
        save_picture(figure, file)
    return figure


def draw_path(axes: Axes, problem: Problem, path: Floats) -> list[Artist]:
    """Draw ghosts of the robot and the trace of its reference point; return legend entries."""
    if len(path) < 2:
        return []
    robot = polygon_paths(problem.robot)
    radius = reach(problem.robot)
    total = float(travel(path, radius)[-1])
    ghosts = equal_steps(path, radius, max(GHOST_STEP * radius, total / MAX_GHOSTS))
    shades = fade(len(ghosts))
    outlines = [outline for q in ghosts for outline in placed(robot, q)]
    colours = np.repeat(shades, len(robot), axis=0)
    filled = np.column_stack([colours, np.full(len(colours), 0.10)])
    edged = np.column_stack([colours, np.full(len(colours), 0.75)])
    axes.add_collection(
        PathCollection(outlines, facecolors=filled, edgecolors=edged, linewidths=0.7, zorder=3),
        autolim=False,
    )
    axes.plot(path[:, 0], path[:, 1], color=TRACE, linewidth=1.1, zorder=5)
    middle = shades[len(shades) // 2]
    ghost = Patch(facecolor=(*middle, 0.10), edgecolor=(*middle, 0.75), label="robot on its way")
    return [ghost, Line2D([], [], color=TRACE, linewidth=1.1, label="path of the reference point")]
