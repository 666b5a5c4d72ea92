"""The picture of cells at given angles: the subdivision of the plane at a fixed angle."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch

from planar_planner.explain.about_point import about_point, path_label, path_of_point
from planar_planner.explain.cells import LABEL_COLOURS, LABELS, Cells, theta_slice
from planar_planner.load import SceneLike, load_scene
from planar_planner.pictures.panels import label_outer, panel_figure
from planar_planner.pictures.shapes import placed, polygon_paths, rectangles, workspace_path
from planar_planner.pictures.style import END_COLOURS, INK, TRACE, save_picture
from planar_planner.pictures.world import frame_axes, title_of, view_box
from planar_planner.planning.path_samples import Floats, equal_parts, reach
from planar_planner.planning.result import Result
from planar_planner.problem.make import Problem, ends, make_problem, with_query

COUNT = 6  # number of slices if no angles are given
LINED_UP_TO = 4000  # cells in one slice; with more cells, lines would hide the colours


def draw_slices(
    scene: SceneLike,
    cells: Cells,
    thetas: Sequence[float] | None = None,
    file: str | os.PathLike[str] | None = None,
    *,
    result: Result | None = None,
) -> Figure:
    """Draw the cells that contain each of some angles.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene: anything that `load_scene` takes.
    cells : Cells
        Cells of a planner that has answered a query about the scene.
    thetas : sequence of float, optional
        Angles in radians. The default is six angles of the path, or six even ones, or the only
        angle that the robot may have.
    file : path, optional
        File to write; its suffix (.png, .svg, .pdf) gives the format.
    result : PathFound, NoPath or Undecided, optional
        The result, for the title and for the path; the robot is drawn where it has each angle.

    Raises
    ------
    ValueError
        If there are no cells, no angles, or an angle that is not finite.
    """
    problem = make_problem(load_scene(scene))
    path = np.empty((0, 3)) if result is None else result.path
    if len(path):
        problem = with_query(problem, path[0], path[-1])
    problem, path = about_point(problem, cells.point), path_of_point(path, cells.point)
    angles = default_thetas(problem, path) if thetas is None else [float(theta) for theta in thetas]
    if not len(cells):
        raise ValueError("there are no cells to slice")
    if not angles:
        raise ValueError("slices need at least one angle")
    low, high = cells.lower[:, :2].min(axis=0), cells.upper[:, :2].max(axis=0)
    view = view_box(problem, path)
    view = (
        min(view[0], low[0]), min(view[1], low[1]), max(view[2], high[0]), max(view[3], high[1])
    )  # fmt: skip
    aspect = (view[2] - view[0]) / (view[3] - view[1])
    figure, panels = panel_figure(len(angles), aspect)
    for axes, theta in zip(panels, angles, strict=True):
        _draw_cells(axes, theta_slice(cells, theta))
        _draw_outlines(axes, problem)
        _draw_robot(axes, problem, path, theta)
        frame_axes(axes, view, outlined=workspace_path(problem) is not None)
        axes.set_title(f"θ = {math.degrees(theta):.4g}°", color=INK, fontsize=9)
    label_outer(panels, len(angles), aspect)
    figure.suptitle(title_of(problem.name, result), color=INK, fontsize=12, parse_math=False)
    figure.legend(
        handles=_keys(problem, path, path_label(cells.point)),
        loc="outside lower center",
        ncols=4,
        frameon=False,
        fontsize=9,
    )
    if file is not None:
        save_picture(figure, file)
    return figure


def default_thetas(problem: Problem, path: Floats) -> list[float]:
    """Return the angles of a path at equal parts of its travel, or even angles without a path.

    They are rounded to degrees and distinct. A robot that may not turn has only its own angle.
    """
    if not problem.rotation:
        return [problem.start[2]]
    if not len(path):
        return [math.tau * k / COUNT for k in range(COUNT)]
    moments = equal_parts(path, reach(problem.robot), COUNT)
    degrees = np.rint(np.degrees(moments[:, 2])).astype(int) % 360
    return [math.radians(angle) for angle in dict.fromkeys(degrees.tolist())]


def _draw_cells(axes: Axes, cells: Cells) -> None:
    colours = np.array([LABEL_COLOURS[name] for name in LABELS])[cells.label]
    lined = len(cells) <= LINED_UP_TO
    axes.add_collection(
        PolyCollection(
            list(rectangles(cells)),
            facecolors=colours.tolist(),
            edgecolors="#00000055" if lined else "face",
            linewidths=0.3,
            zorder=0.5,
        ),
        autolim=False,
    )


def _draw_outlines(axes: Axes, problem: Problem) -> None:
    """Draw the obstacles' and the workspace's outlines over the cells."""
    walls = PathCollection(
        polygon_paths(problem.obstacles), facecolors="none", edgecolors=INK, linewidths=0.7
    )
    walls.set_zorder(1)
    axes.add_collection(walls, autolim=False)
    room = workspace_path(problem)
    if room is not None:
        walls.set_clip_path(PathPatch(room, transform=axes.transData))
        axes.add_patch(PathPatch(room, facecolor="none", edgecolor=INK, linewidth=1.2, zorder=2))


def _draw_robot(axes: Axes, problem: Problem, path: Floats, theta: float) -> None:
    """Draw the trace, start and goal as points, and the robot where the path has this angle."""
    axes.plot(path[:, 0], path[:, 1], color=TRACE, linewidth=0.8, zorder=3)
    for name, q in ends(problem).items():
        colour = END_COLOURS[name]
        axes.plot(*q[:2], marker="o", markersize=4, color=colour, markeredgecolor="white", zorder=5)
    robot = polygon_paths(problem.robot)
    there = passes(path, theta, turning=problem.rotation)
    outlines = [outline for q in there for outline in placed(robot, q)]
    drawn = PathCollection(outlines, facecolors="#FFFFFFAA", edgecolors=TRACE, linewidths=1.0)
    drawn.set_zorder(4)
    axes.add_collection(drawn, autolim=False)


def passes(path: Floats, theta: float, *, turning: bool) -> Floats:
    """Return the configurations (M, 3) at which a path has an angle, up to whole turns.

    If a segment keeps the angle, its first configuration counts; if the robot may not turn, the
    path's ends count.
    """
    if not turning or len(path) < 2:
        return path[[0, -1]] if len(path) else path
    found = []
    for a, b in pairwise(path):
        low, high = min(a[2], b[2]), max(a[2], b[2])
        first = math.ceil((low - theta) / math.tau)
        last = math.floor((high - theta) / math.tau)
        for turns in range(first, last + 1):
            wanted = theta + math.tau * turns
            s = 0.0 if a[2] == b[2] else (wanted - a[2]) / (b[2] - a[2])
            found.append(a + s * (b - a))
    return np.array(found).reshape(-1, 3)


def _keys(problem: Problem, path: Floats, label: str) -> list[Patch | Line2D]:
    keys: list[Patch | Line2D] = [
        Patch(facecolor=LABEL_COLOURS[name], edgecolor="#00000055", label=name) for name in LABELS
    ]
    for name in ends(problem):
        colour = END_COLOURS[name]
        keys.append(Line2D([], [], color=colour, marker="o", linestyle="none", label=name))
    if len(path):
        keys.append(Line2D([], [], color=TRACE, linewidth=0.8, label=label))
        keys.append(Patch(facecolor="white", edgecolor=TRACE, label="robot where it has the angle"))
    return keys
