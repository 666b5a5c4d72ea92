"""The picture of a proof of no path: the wall of FULL cells, and the overlap at its bottleneck."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, PathPatch
from matplotlib.path import Path
from numpy.typing import NDArray

from planar_planner.explain.about_point import Point, about_point, path_of_point
from planar_planner.explain.cells import LABEL_COLOURS, Cells, cells_on_path
from planar_planner.explain.thinnest_place import Bottleneck
from planar_planner.load import SceneLike, load_scene
from planar_planner.pictures.boxes3d import draw_boxes, draw_end_points, draw_path, space_axes
from planar_planner.pictures.goal_region import draw_goal_region
from planar_planner.pictures.shapes import (
    box_path,
    moved,
    placed,
    polygon_paths,
    rectangles,
    workspace_path,
)
from planar_planner.pictures.style import INK, MIDWAY, OVERLAP, new_figure, rgba, save_picture
from planar_planner.pictures.world import draw_ends, draw_world, frame_axes, title_of, view_box
from planar_planner.planning.path_samples import Floats, equal_parts, reach
from planar_planner.planning.result import Result
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, ends, make_problem, with_query

SIZE = (14.0, 5.4)  # inches
GHOSTS = 7  # drawings of the robot on its way through the wall
MARK: dict[str, Any] = {
    "marker": "D",
    "markersize": 6,
    "color": MIDWAY,
    "markeredgecolor": INK,
    "linestyle": "none",
}
ROOM = 1.35  # half-width of the close-up, in robot radii about the reference point


def draw_wall(
    scene: SceneLike,
    wall: Cells,
    bottleneck: Bottleneck,
    file: str | os.PathLike[str] | None = None,
    *,
    result: Result | None = None,
    start: Sequence[float] | None = None,
    goal: Sequence[float] | None = None,
) -> Figure:
    """Draw why there is no path: in the plane, enlarged, and in the configuration space.

    The left drawing shows the scene, with the place where the wall was found thinnest. The middle
    one shows the robot there, and what it overlaps. The right one shows the wall of cells that
    separates start from goal, with the cells that this way crosses.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        The scene: anything that `load_scene` takes.
    wall : Cells
        `Planner.wall` of a planner that has proven that there is no path.
    bottleneck : Bottleneck
        The bottleneck of the same planner.
    file : path, optional
        File to write; its suffix (.png, .svg, .pdf) gives the format.
    result : NoPath, optional
        The result, for the title.
    start, goal : (x, y, theta), optional
        The query, if it is not the scene's own.

    Raises
    ------
    ValueError
        If the wall is empty.
    """
    problem = with_query(make_problem(load_scene(scene)), start, goal)
    if not len(wall):
        raise ValueError("there is no wall to draw")
    if not problem.rotation:
        bottleneck = _at_angle(bottleneck, problem.start[2])
    problem, bottleneck = about_point(problem, wall.point), _about_point(bottleneck, wall.point)
    figure = new_figure(*SIZE)
    grid = figure.add_gridspec(1, 3, width_ratios=[1.0, 1.0, 1.15])
    whole, close = figure.add_subplot(grid[0]), figure.add_subplot(grid[1])
    keys = draw_world(whole, problem)
    keys += draw_ends(whole, problem)
    if isinstance(problem.goal, GoalSet):
        keys += draw_goal_region(whole, problem.goal)
    keys += _draw_pinch(whole, problem, bottleneck)
    outlined = workspace_path(problem) is not None
    frame_axes(whole, view_box(problem, _body(problem, bottleneck.at)), outlined=outlined)
    whole.set_title("where the wall was found thinnest", color=INK, fontsize=9)
    _draw_close_up(close, problem, bottleneck)
    whole.add_patch(_lens(problem, bottleneck))
    if problem.rotation:
        keys += _draw_wall_in_space(figure, grid[2], problem, wall, bottleneck)
    else:
        keys += _draw_wall_in_plane(figure.add_subplot(grid[2]), problem, wall, bottleneck)
    figure.suptitle(title_of(problem.name, result), color=INK, fontsize=12, parse_math=False)
    figure.legend(handles=keys, loc="outside lower center", ncols=5, frameon=False, fontsize=9)
    if file is not None:
        save_picture(figure, file)
    return figure


def _about_point(bottleneck: Bottleneck, point: Point) -> Bottleneck:
    way = [path_of_point(q, point) for q in np.split(bottleneck.way, len(bottleneck.way))]
    return Bottleneck(np.concatenate(way), bottleneck.collides, bottleneck.index)


def _body(problem: Problem, q: Floats) -> Floats:
    """Return the robot's vertices at a configuration as rows (x, y, 0) for the extent of a view."""
    corners = moved(problem.robot.coords, q)
    return np.column_stack([corners, np.zeros(len(corners))])


def _draw_close_up(axes: Axes, problem: Problem, bottleneck: Bottleneck) -> None:
    """Draw the robot on its way through the wall, and mark the bottleneck."""
    draw_world(axes, problem)
    robot = polygon_paths(problem.robot)
    ghosts = equal_parts(bottleneck.crossing, reach(problem.robot), GHOSTS)
    axes.add_collection(
        PathCollection(
            [outline for q in ghosts for outline in placed(robot, q)],
            facecolors="none",
            edgecolors=rgba(MIDWAY, 0.45),
            linewidths=0.7,
            zorder=3,
        ),
        autolim=False,
    )
    _draw_pinch(axes, problem, bottleneck)
    x, y = bottleneck.at[:2]
    room = ROOM * reach(problem.robot)
    frame_axes(axes, (x - room, y - room, x + room, y + room), outlined=False)
    axes.set_title("enlarged: what the robot overlaps there", color=INK, fontsize=9)


def _draw_pinch(axes: Axes, problem: Problem, bottleneck: Bottleneck) -> list[Any]:
    """Draw the robot at the bottleneck, with its overlap hatched."""
    outlines = placed(polygon_paths(problem.robot), bottleneck.at)
    axes.add_collection(
        PathCollection(
            outlines,
            facecolors=rgba(MIDWAY, 0.35),
            edgecolors=MIDWAY,
            linewidths=1.4,
            zorder=4,
        ),
        autolim=False,
    )
    style: dict[str, Any] = {
        "facecolor": OVERLAP,
        "edgecolor": INK,
        "linewidth": 0.4,
        "hatch": "/////",
    }
    body = Path.make_compound_path(*outlines)
    for forbidden in _forbidden(problem, body):
        patch = PathPatch(forbidden, zorder=5, **style)
        axes.add_patch(patch)
        patch.set_clip_path(PathPatch(body, transform=axes.transData))
    return [
        Patch(facecolor=rgba(MIDWAY, 0.35), edgecolor=MIDWAY, label="robot at the bottleneck"),
        Patch(label="overlap", **style),
    ]


def _forbidden(problem: Problem, body: Path) -> list[Path]:
    """Return what the body can overlap: obstacles whose boxes meet its box, and the outside."""
    box = body.get_extents()
    near = [path for path in polygon_paths(problem.obstacles) if path.get_extents().overlaps(box)]
    room = workspace_path(problem)
    if room is not None:
        margin = max(box.width, box.height)
        outside = box_path((box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin))
        span = np.concatenate([outside.vertices, room.vertices])
        low, high = span.min(axis=0), span.max(axis=0)
        frame = box_path((low[0], low[1], high[0], high[1]))
        near.append(Path.make_compound_path(frame, _reversed(room)))
    return near


def _reversed(path: Path) -> Path:
    """Return a closed path, outline and holes, with the opposite orientation."""
    rings = [np.asarray(ring)[::-1] for ring in path.to_polygons(closed_only=True)]
    return Path.make_compound_path(*(Path(ring, closed=True) for ring in rings))


def _lens(problem: Problem, bottleneck: Bottleneck) -> Circle:
    """Return a circle round the bottleneck, as large as the close-up."""
    return Circle(
        tuple(bottleneck.at[:2]),
        ROOM * reach(problem.robot),
        fill=False,
        edgecolor=INK,
        linestyle="--",
        linewidth=1.0,
        zorder=8,
    )


def _draw_wall_in_space(
    figure: Figure, place: Any, problem: Problem, wall: Cells, bottleneck: Bottleneck
) -> list[Any]:
    points = np.array([*ends(problem).values(), bottleneck.at])
    low = np.minimum(wall.lower.min(axis=0), points.min(axis=0))
    high = np.maximum(wall.upper.max(axis=0), points.max(axis=0))
    axes = space_axes(figure, place, low, high)
    thinnest = _thinnest(wall, bottleneck)
    draw_boxes(axes, wall[~thinnest], LABEL_COLOURS["FULL"], 0.12, 1.0)
    draw_boxes(axes, wall[thinnest], OVERLAP, 0.9, 2.0)
    draw_path(axes, bottleneck.crossing, 3.0)
    x, y, theta = bottleneck.at
    axes.plot([x], [y], [np.degrees(theta) % 360.0], zorder=4.0, **MARK)
    draw_end_points(axes, problem, 4.0)
    axes.set_title(f"the wall: {len(wall):,} boxes and faces", color=INK, fontsize=9)
    return _wall_keys()


def _draw_wall_in_plane(
    axes: Axes, problem: Problem, wall: Cells, bottleneck: Bottleneck
) -> list[Any]:
    thinnest = _thinnest(wall, bottleneck)
    for chosen, colour in ((wall[~thinnest], LABEL_COLOURS["FULL"]), (wall[thinnest], OVERLAP)):
        axes.add_collection(
            PolyCollection(
                list(rectangles(chosen)),
                facecolors=rgba(colour, 0.6),
                edgecolors=INK,
                linewidths=1.2,
            ),
            autolim=False,
        )
    axes.plot(*bottleneck.crossing[:, :2].T, color=INK, linewidth=1.2)
    axes.plot(*bottleneck.at[:2], **MARK)
    draw_ends(axes, problem)
    frame_axes(axes, view_box(problem, wall.lower), outlined=False)
    axes.set_title(f"the wall: {len(wall):,} boxes and faces", color=INK, fontsize=9)
    return _wall_keys()


def _thinnest(wall: Cells, bottleneck: Bottleneck) -> NDArray[np.bool_]:
    """Return which boxes of the wall contain the bottleneck, or otherwise those on the way."""
    of_origin = replace(wall, point=(0.0, 0.0))  # the bottleneck is of the wall's point by now
    here = cells_on_path(of_origin, np.array([bottleneck.at, bottleneck.at]))
    return here if here.any() else cells_on_path(of_origin, bottleneck.crossing)


def _wall_keys() -> list[Any]:
    return [
        Patch(facecolor=LABEL_COLOURS["FULL"], alpha=0.4, label="wall of FULL cells"),
        Patch(facecolor=rgba(OVERLAP, 0.6), label="wall where it is thinnest"),
        Line2D([], [], color=INK, linewidth=1.4, label="way through it"),
        Line2D([], [], label="bottleneck", **MARK),
    ]


def _at_angle(bottleneck: Bottleneck, theta: float) -> Bottleneck:
    """Return the bottleneck at another angle; a disc and its wall are the same at any angle."""
    way: Floats = bottleneck.way.copy()
    way[:, 2] = theta
    return Bottleneck(way, bottleneck.collides, bottleneck.index)
