"""Pictures of scenes and results. The only module that imports matplotlib; it decides nothing.

Uses figure and canvas objects, never pyplot, so no global state and no display is needed.
Colours are those of Okabe and Ito, distinguishable with any common colour blindness; start is
the blue end and goal the vermilion end, and ghosts of the robot fade from one to the other.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from numpy.typing import NDArray

from planar_planner.fields import Box, Configuration
from planar_planner.motion import equal_steps, reach, travel
from planar_planner.problem import Polygons, Problem, make_problem, with_query
from planar_planner.result import Result
from planar_planner.scene import Scene

INK = "#222222"
OBSTACLE = "#8C8C8C"
OUTSIDE = "#E9E9E9"  # where the body may not go, behind the workspace's outline
START = "#0072B2"  # Okabe-Ito blue
GOAL = "#D55E00"  # Okabe-Ito vermilion
MIDWAY = "#CC79A7"  # Okabe-Ito reddish purple: ghosts half way
BOUNDS = "#009E73"  # Okabe-Ito bluish green
TRACE = "#000000"

LONG_SIDE = 8.0  # inches, of the drawing itself
SHORTEST_SIDE = 3.2  # inches; a narrower drawing has no room for its title
PADDING = 0.12  # inches, round drawing, title and legend
DPI = 150
MARGIN = 0.03  # of the greater side, round everything
GHOST_STEP = 0.6  # between ghosts, in robot radii of travel (planar_planner.motion)
MAX_GHOSTS = 160
MANY_OBSTACLES = 300  # from here on outlines would be most of the ink

Floats = NDArray[np.float64]


def draw_scene(
    scene: Scene,
    result: Result | None = None,
    file: str | os.PathLike[str] | None = None,
    *,
    start: Sequence[float] | None = None,
    goal: Sequence[float] | None = None,
) -> Figure:
    """Draw a scene and, if given, what the planner answered.

    Parameters
    ----------
    scene : Scene
        The scene, as loaded.
    result : PathFound, NoPath or Undecided, optional
        The verdict goes into the title; a path is drawn as ghosts of the robot at equal steps of
        motion and as the trace of the reference point.
    file : path, optional
        Where to write the picture; the suffix (.png, .svg, .pdf) gives the format.
    start, goal : (x, y, theta), optional
        Query that was answered, if not the scene's own. Not needed with a path, which tells.

    Returns
    -------
    Figure
        The figure, with an Agg canvas.

    Raises
    ------
    SceneError
        If the scene is not valid.
    """
    problem = with_query(make_problem(scene), start, goal)
    if result is not None and len(result.path):
        problem = with_query(problem, result.path[0], result.path[-1])
    path = result.path if result is not None and len(result.path) else np.empty((0, 3))

    view = view_box(problem, path)
    layout = ConstrainedLayoutEngine(w_pad=PADDING, h_pad=PADDING)
    figure = Figure(figsize=_figure_size(view), layout=layout)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    keys = draw_world(axes, problem)
    keys += _draw_path(axes, problem, path)
    keys += draw_ends(axes, problem)
    frame_axes(axes, view, outlined=_workspace_path(problem) is not None)
    axes.set_title(title_of(problem.name, result), color=INK, fontsize=12)
    figure.legend(handles=keys, loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    if file is not None:
        figure.savefig(file, dpi=DPI)
    return figure


def save_picture(figure: Figure, file: str | os.PathLike[str], suffix: str) -> None:
    """Write a figure to just this file, in the format of `suffix` whatever the file is called.

    Without a format matplotlib would take one from the name, and add it to a name that has none: a
    link's target, a device.
    """
    figure.savefig(file, dpi=DPI, format=suffix.lower().removeprefix("."))


def polygon_paths(polygons: Polygons) -> list[Path]:
    """Return one closed path a polygon; outer rings anticlockwise, holes clockwise, for filling."""
    paths = []
    rings = polygons.ring_starts
    for first, last in zip(polygons.polygon_starts[:-1], polygons.polygon_starts[1:], strict=True):
        vertices: list[Floats] = []
        codes: list[NDArray[np.uint8]] = []
        for r in range(int(first), int(last)):
            ring = polygons.coords[rings[r] : rings[r + 1]]
            anticlockwise = _signed_area(ring) > 0.0
            ring = ring if anticlockwise == (r == first) else ring[::-1]
            vertices.append(np.concatenate([ring, ring[:1]]))
            code = np.full(len(ring) + 1, Path.LINETO, dtype=np.uint8)
            code[0], code[-1] = Path.MOVETO, Path.CLOSEPOLY
            codes.append(code)
        paths.append(Path(np.concatenate(vertices), np.concatenate(codes)))
    return paths


def placed(paths: Sequence[Path], q: Configuration | Floats) -> list[Path]:
    """Return the robot's paths at a configuration."""
    return [Path(_moved(np.asarray(path.vertices), q), path.codes) for path in paths]


def draw_world(axes: Axes, problem: Problem) -> list[Artist]:
    """Draw workspace, bounds and obstacles, and return their legend entries."""
    keys: list[Artist] = []
    room = _workspace_path(problem)
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
        bounds = _box_path(problem.reference_bounds)
        axes.add_patch(PathPatch(bounds, facecolor="none", zorder=2, **style))
        keys.append(Patch(facecolor="none", label="bounds of the reference point", **style))
    return keys


def _draw_path(axes: Axes, problem: Problem, path: Floats) -> list[Artist]:
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


def draw_ends(axes: Axes, problem: Problem) -> list[Artist]:
    """Draw the robot at start and goal, with its reference point and its heading."""
    robot = polygon_paths(problem.robot)
    keys: list[Artist] = []
    for label, colour, q in (("start", START, problem.start), ("goal", GOAL, problem.goal)):
        outlines = placed(robot, q)
        style: dict[str, Any] = {"facecolors": _rgba(colour, 0.45), "edgecolors": colour}
        axes.add_collection(
            PathCollection(outlines, linewidths=1.6, zorder=4, **style), autolim=False
        )
        tip = np.array(q[:2]) + 0.5 * reach(problem.robot) * np.array([np.cos(q[2]), np.sin(q[2])])
        axes.plot([q[0], tip[0]], [q[1], tip[1]], color=colour, linewidth=1.4, zorder=6)
        axes.plot(*q[:2], marker="o", markersize=5, color=colour, markeredgecolor="white", zorder=7)
        face = _rgba(colour, 0.45)
        keys.append(Patch(facecolor=face, edgecolor=colour, linewidth=1.6, label=label))
    return keys


def frame_axes(axes: Axes, view: Box, *, outlined: bool) -> None:
    """Set limits, equal scales and labels; a frame only where no workspace is outlined."""
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
    if result is None:
        return name
    verdicts = {"path": "path found", "no_path": "no path: proven"}
    return f"{name} – {verdicts.get(result.verdict, f'undecided: {result.reason}')}"


def view_box(problem: Problem, path: Floats) -> Box:
    """Return the box that the picture shows: where the robot may be, and a margin."""
    points: list[Floats] = [path[:, :2]]
    if problem.workspace_box is not None:
        points.append(_corners(problem.workspace_box))
    elif problem.workspace is not None:
        points.append(problem.workspace.coords)
    elif problem.reference_bounds is not None:  # the body may stick out of these
        corners = _corners(problem.reference_bounds)
        points += [corners - reach(problem.robot), corners + reach(problem.robot)]
    ends = [problem.start, problem.goal]
    points += [_moved(problem.robot.coords, q) for q in ends]
    cloud = np.concatenate(points)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    margin = MARGIN * float((high - low).max())
    return (low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin)


def _figure_size(view: Box) -> tuple[float, float]:
    """Return width and height in inches, with room for title, labels and legend."""
    width, height = view[2] - view[0], view[3] - view[1]
    scale = LONG_SIDE / max(width, height)
    return max(SHORTEST_SIDE, width * scale) + 0.7, max(SHORTEST_SIDE, height * scale) + 1.3


def _workspace_path(problem: Problem) -> Path | None:
    if problem.workspace is not None:
        return polygon_paths(problem.workspace)[0]
    return None if problem.workspace_box is None else _box_path(problem.workspace_box)


def _box_path(box: Box) -> Path:
    return Path(np.concatenate([_corners(box), [box[:2]]]), closed=True)


def _corners(box: Box) -> Floats:
    xmin, ymin, xmax, ymax = box
    return np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)])


def _moved(points: Floats, q: Configuration | Floats) -> Floats:
    """Points (N, 2) of the robot's frame in the world: p -> R(theta) p + (x, y)."""
    c, s = np.cos(q[2]), np.sin(q[2])
    turn = np.array([[c, s], [-s, c]])  # rows are points: p R^T
    return np.asarray(points @ turn + np.array(q[:2]))


def _signed_area(ring: Floats) -> float:
    """Shoelace formula, about the first vertex; only its sign is used, for filling."""
    x, y = (ring - ring[0]).T
    return float(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def _rgb(colour: str) -> tuple[float, float, float]:
    r, g, b = (int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    return r, g, b


def _rgba(colour: str, alpha: float) -> tuple[float, float, float, float]:
    return (*_rgb(colour), alpha)


def fade(count: int) -> Floats:
    """Colours (count, 3) from START by MIDWAY to GOAL."""
    stops = np.array([_rgb(START), _rgb(MIDWAY), _rgb(GOAL)])
    where = np.linspace(0.0, 2.0, count)
    return np.column_stack([np.interp(where, [0.0, 1.0, 2.0], stops[:, k]) for k in range(3)])
