"""The picture of a margin: the scene with its narrow place, and a close-up of the narrow place."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch, Rectangle
from matplotlib.path import Path

from planar_planner.errors import one_line
from planar_planner.load import SceneLike, load_scene
from planar_planner.margins.result import Margin, NarrowPlace
from planar_planner.margins.surroundings import placed, shape_of
from planar_planner.margins.text import margin_headline, touched
from planar_planner.pictures.shapes import workspace_path
from planar_planner.pictures.style import INK, TRACE, new_figure
from planar_planner.pictures.world import draw_ends, draw_world, frame_axes, view_box
from planar_planner.problem.make import Problem, make_problem
from planar_planner.scene.fields import Box

ROBOT = "#E69F00"  # Okabe-Ito orange
OTHER = "#882255"  # wine (Tol), for the robot of the other size
CONTACT = "#000000"

SIDE = 5.6  # inches of a panel's longer side
ROOM = 0.25  # margin round the robot in the close-up, as a share of its greater extent


def draw_margin(scene: SceneLike, margin: Margin) -> Figure:
    """Draw a scene with the place where the largest robot that passes has the least room.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene of the margin: anything that `load_scene` takes.
    margin : Margin
        The result of `planar_planner.margin`.

    Returns
    -------
    Figure
        The figure, with an Agg canvas. Without a narrow place the close-up is left out.
    """
    problem = make_problem(load_scene(scene))
    view = view_box(problem, margin.path)
    place = margin.narrow_place
    panels = 1 if place is None else 2
    height = SIDE * min(1.0, (view[3] - view[1]) / (view[2] - view[0]))
    figure = new_figure(SIDE * panels + 1.0, (height if panels == 1 else SIDE) + 1.4)
    axes = figure.subplots(1, panels, squeeze=False)[0]
    outlined = workspace_path(problem) is not None
    keys = draw_world(axes[0], problem)
    keys += _draw_trace(axes[0], margin)
    keys += draw_ends(axes[0], problem)
    frame_axes(axes[0], view, outlined=outlined)
    if place is not None:
        draw_world(axes[1], problem)
        near = _close_up(problem, place)
        _clip(axes[1], problem, near)
        keys += _draw_robots(axes[1], problem, margin, place)
        keys += _draw_contacts(axes[1], place)
        _draw_robots(axes[0], problem, margin, place)
        axes[0].add_patch(
            Rectangle(
                near[:2],
                near[2] - near[0],
                near[3] - near[1],
                fill=False,
                edgecolor=INK,
                linewidth=1.0,
                linestyle=":",
                zorder=9,
            )
        )
        frame_axes(axes[1], near, outlined=False)
        pinch = one_line(f"narrowest: {touched(place)}")
        axes[1].set_title(pinch, color=INK, fontsize=11, parse_math=False)
    headline = margin_headline(margin).replace("; ", "\n", 1)
    figure.suptitle(headline, color=INK, fontsize=12, parse_math=False)
    figure.legend(handles=keys, loc="outside lower center", ncols=4, frameon=False, fontsize=9)
    return figure


def _draw_trace(axes: Axes, margin: Margin) -> list[Artist]:
    if len(margin.path) < 2:
        return []
    axes.plot(margin.path[:, 0], margin.path[:, 1], color=TRACE, linewidth=1.1, zorder=5)
    return [Line2D([], [], color=TRACE, linewidth=1.1, label="path of the reference point")]


def _draw_robots(axes: Axes, problem: Problem, margin: Margin, place: NarrowPlace) -> list[Artist]:
    """Draw the robot filled, and the outline of the robot that just passes."""
    style: dict[str, Any] = {"facecolor": ROBOT, "edgecolor": "none", "alpha": 0.6}
    axes.add_patch(
        PathPatch(_outline(placed(shape_of(problem.robot), place.configuration)), zorder=7, **style)
    )
    keys: list[Artist] = [Patch(label="robot as it is", **style)]
    if margin.robot_lower is not None and margin.lower != margin.neutral:
        body = placed(shapely.geometry.shape(margin.robot_lower), place.configuration)
        line: dict[str, Any] = {"edgecolor": OTHER, "facecolor": "none", "linewidth": 1.4}
        axes.add_patch(PathPatch(_outline(body), zorder=8, **line))
        size = "larger" if margin.lower > margin.neutral else "smaller"
        keys.append(Patch(label=f"{size} robot that still passes", **line))
    return keys


def _draw_contacts(axes: Axes, place: NarrowPlace) -> list[Artist]:
    """Draw the shortest segments from the robot to its nearest obstacles."""
    for contact in place.contacts:
        (ax, ay), (bx, by) = contact.robot_point, contact.obstacle_point
        axes.plot([ax, bx], [ay, by], color=CONTACT, linewidth=1.6, zorder=10)
        axes.plot(bx, by, marker="o", markersize=4, color=CONTACT, zorder=10)
    if not place.contacts:
        return []
    label = "nearest points"
    return [Line2D([], [], color=CONTACT, linewidth=1.6, marker="o", markersize=4, label=label)]


def _close_up(problem: Problem, place: NarrowPlace) -> Box:
    """Return a square round the robot at the narrow place."""
    low_x, low_y, high_x, high_y = placed(shape_of(problem.robot), place.configuration).bounds
    extent = max(high_x - low_x, high_y - low_y)
    half = (0.5 + ROOM) * extent
    x, y = 0.5 * (low_x + high_x), 0.5 * (low_y + high_y)
    return (x - half, y - half, x + half, y + half)


def _clip(axes: Axes, problem: Problem, view: Box) -> None:
    """Clip obstacles at the view too: they are clipped at the workspace, which may be larger."""
    room = shapely.box(*view)
    if problem.workspace_box is not None:
        room &= shapely.box(*problem.workspace_box)
    elif problem.workspace is not None:
        room &= shape_of(problem.workspace).geoms[0]
    for obstacles in axes.collections:
        obstacles.set_clip_path(PathPatch(_outline(room), transform=axes.transData))


def _outline(body: shapely.Geometry) -> Path:
    """Return the union of a body's polygons as one path."""
    union = shapely.union_all(shapely.get_parts(body))
    rings = [
        np.array(ring.coords)
        for part in shapely.get_parts(union)
        for ring in (part.exterior, *part.interiors)
    ]
    return Path.make_compound_path(*(Path(ring, closed=True) for ring in rings))
