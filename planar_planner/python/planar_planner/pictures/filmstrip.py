"""The picture of a path as a strip of drawings side by side, at equal parts of its travel."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from planar_planner.load import SceneLike, load_scene
from planar_planner.pictures.panels import label_outer, panel_figure
from planar_planner.pictures.shapes import placed, polygon_paths, workspace_path
from planar_planner.pictures.style import INK, TRACE, fade, rgba, save_picture
from planar_planner.pictures.world import draw_world, frame_axes, title_of, view_box
from planar_planner.planning.path_samples import Floats, equal_parts, reach
from planar_planner.planning.result import Result
from planar_planner.problem.make import Problem, make_problem, with_query

FRAMES = 8


def draw_filmstrip(
    scene: SceneLike,
    result: Result,
    file: str | os.PathLike[str] | None = None,
    *,
    frames: int = FRAMES,
) -> Figure:
    """Draw a path as drawings side by side.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene: anything that `load_scene` takes.
    result : PathFound
        The result whose path is drawn.
    file : path, optional
        File to write; its suffix (.png, .svg, .pdf) gives the format.
    frames : int, optional
        Number of drawings, at least 2. The first shows the start and the last the goal, with equal
        travel between them (`planar_planner.planning.path_samples`).

    Raises
    ------
    ValueError
        If the result has no path, or for less than two frames.
    """
    if not len(result.path):
        raise ValueError("a filmstrip needs a path")
    problem = with_query(make_problem(load_scene(scene)), result.path[0], result.path[-1])
    radius = reach(problem.robot)
    moments = equal_parts(result.path, radius, frames)
    view = view_box(problem, result.path)
    aspect = (view[2] - view[0]) / (view[3] - view[1])
    figure, panels = panel_figure(frames, aspect)
    colours = fade(frames)
    for k, (axes, q) in enumerate(zip(panels, moments, strict=True)):
        keys = draw_world(axes, problem)
        _draw_moment(axes, problem, result.path, q, colours[k])
        frame_axes(axes, view, outlined=workspace_path(problem) is not None)
        axes.set_title(_caption(k, frames, q), color=INK, fontsize=9)
    label_outer(panels, frames, aspect)
    middle = colours[frames // 2]
    keys.append(Patch(facecolor=(*middle, 0.5), edgecolor=middle, label="robot"))
    keys.append(
        Line2D([], [], color=rgba(TRACE, 0.35), linewidth=0.8, label="path of the reference point")
    )
    figure.suptitle(title_of(problem.name, result), color=INK, fontsize=12, parse_math=False)
    figure.legend(handles=keys, loc="outside lower center", ncols=4, frameon=False, fontsize=9)
    if file is not None:
        save_picture(figure, file)
    return figure


def _draw_moment(axes: Axes, problem: Problem, path: Floats, q: Floats, colour: Any) -> None:
    """Draw the robot at one moment, and the trace of its reference point."""
    outlines = placed(polygon_paths(problem.robot), q)
    axes.plot(path[:, 0], path[:, 1], color=rgba(TRACE, 0.35), linewidth=0.8, zorder=3)
    axes.add_collection(
        PathCollection(
            outlines, facecolors=[(*colour, 0.5)], edgecolors=[colour], linewidths=1.2, zorder=4
        ),
        autolim=False,
    )
    axes.plot(*q[:2], marker="o", markersize=3.5, color=colour, markeredgecolor="white", zorder=5)


def _caption(k: int, frames: int, q: Floats) -> str:
    name = {0: "start", frames - 1: "goal"}.get(k, f"{k} of {frames - 1}")
    return f"{name}, θ = {np.degrees(q[2]):.0f}°"
