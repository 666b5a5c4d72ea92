"""Parts that most pictures share: workspace, bounds, obstacles, start, goal, axes, title."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.patches import Patch, PathPatch

from planar_planner.errors import one_line
from planar_planner.pictures.shapes import (
    box_path,
    corners,
    moved,
    placed,
    polygon_paths,
    workspace_path,
)
from planar_planner.pictures.style import BOUNDS, GOAL, INK, OBSTACLE, OUTSIDE, START, rgba
from planar_planner.planning.path_samples import Floats, reach
from planar_planner.planning.result import Result
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, ends
from planar_planner.scene.fields import Box

LONG_SIDE = 8.0  # inches of the drawing itself
SHORTEST_SIDE = 3.2  # inches; a narrower drawing has no room for its title
MARGIN = 0.03  # margin round everything, as a share of the greater side
MANY_OBSTACLES = 300  # with more obstacles, outlines would hide the colours


def draw_world(axes: Axes, problem: Problem) -> list[Artist]:
    """Draw workspace, bounds and obstacles, and return their legend entries."""
    keys: list[Artist] = []
    room = workspace_path(problem)
    if room is not None:
        axes.set_facecolor(OUTSIDE)
        axes.add_patch(PathPatch(room, facecolor="white", edgecolor="none", zorder=0))
    if len(problem.obstacles):
        crowded = len(problem.obstacles) > MANY_OBSTACLES
        drawn = PathCollection(
            polygon_paths(problem.obstacles),
            facecolors=OBSTACLE,
            edgecolors="none" if crowded else INK,
            linewidths=0.0 if crowded else 0.6,
            zorder=1,
        )
        axes.add_collection(drawn, autolim=False)
        if room is not None:
            drawn.set_clip_path(PathPatch(room, transform=axes.transData))
        keys.append(Patch(facecolor=OBSTACLE, edgecolor=INK, linewidth=0.6, label="obstacles"))
    if room is not None:
        outline = PathPatch(room, facecolor="none", edgecolor=INK, linewidth=1.4, zorder=2)
        axes.add_patch(outline)
        keys.append(Patch(facecolor="white", edgecolor=INK, linewidth=1.4, label="workspace"))
    if problem.reference_bounds is not None:
        style: dict[str, Any] = {"edgecolor": BOUNDS, "linestyle": "--", "linewidth": 1.4}
        bounds = box_path(problem.reference_bounds)
        axes.add_patch(PathPatch(bounds, facecolor="none", zorder=2, **style))
        keys.append(Patch(facecolor="none", label="bounds of the reference point", **style))
    return keys


def draw_ends(axes: Axes, problem: Problem) -> list[Artist]:
    """Draw the robot at start and goal, with its reference point and its heading."""
    robot = polygon_paths(problem.robot)
    keys: list[Artist] = []
    colours = {"start": START, "goal": GOAL}
    for label, q in ends(problem).items():
        colour = colours[label]
        outlines = placed(robot, q)
        style: dict[str, Any] = {"facecolors": rgba(colour, 0.45), "edgecolors": colour}
        axes.add_collection(
            PathCollection(outlines, linewidths=1.6, zorder=4, **style), autolim=False
        )
        tip = np.array(q[:2]) + 0.5 * reach(problem.robot) * np.array([np.cos(q[2]), np.sin(q[2])])
        axes.plot([q[0], tip[0]], [q[1], tip[1]], color=colour, linewidth=1.4, zorder=6)
        axes.plot(*q[:2], marker="o", markersize=5, color=colour, markeredgecolor="white", zorder=7)
        face = rgba(colour, 0.45)
        keys.append(Patch(facecolor=face, edgecolor=colour, linewidth=1.6, label=label))
    return keys


def frame_axes(axes: Axes, view: Box, *, outlined: bool) -> None:
    """Set limits, equal scales and labels; draw a frame only if no workspace is outlined."""
    axes.set_xlim(view[0], view[2])
    axes.set_ylim(view[1], view[3])
    axes.set_aspect("equal")
    axes.set_xlabel("x", color=INK)
    axes.set_ylabel("y", color=INK)
    axes.tick_params(colors=INK, labelsize=9)
    for spine in axes.spines.values():
        spine.set_visible(not outlined)
        spine.set_color(OUTSIDE)


def title_of(name: str, result: Result | None) -> str:
    """Return a picture's title: the scene's name and, if known, the verdict."""
    shown = one_line(name)
    if result is None:
        return shown
    verdicts = {"path": "path found", "no_path": "no path: proven"}
    return f"{shown} – {verdicts.get(result.verdict, f'undecided: {result.reason}')}"


def view_box(problem: Problem, path: Floats) -> Box:
    """Return the box that the picture shows: the places of the robot, and a margin."""
    points: list[Floats] = [path[:, :2]]
    if problem.workspace_box is not None:
        points.append(corners(problem.workspace_box))
    elif problem.workspace is not None:
        points.append(problem.workspace.coords)
    elif problem.reference_bounds is not None:  # the body may extend beyond these
        limits = corners(problem.reference_bounds)
        points += [limits - reach(problem.robot), limits + reach(problem.robot)]
    points += [moved(problem.robot.coords, q) for q in ends(problem).values()]
    if isinstance(problem.goal, GoalSet):
        points.append((problem.goal.left or problem.goal.polygons).coords)
    cloud = np.concatenate(points)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    margin = MARGIN * float((high - low).max())
    return (low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin)


def figure_size(view: Box) -> tuple[float, float]:
    """Return width and height in inches, with room for title, labels and legend."""
    width, height = view[2] - view[0], view[3] - view[1]
    scale = LONG_SIDE / max(width, height)
    return max(SHORTEST_SIDE, width * scale) + 0.7, max(SHORTEST_SIDE, height * scale) + 1.3
