"""Frames of a robot that drives along its path."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from planar_planner.explain.about_point import path_label
from planar_planner.films.canvas import Backdrop, Frame
from planar_planner.films.material import Material
from planar_planner.films.pace import Pace
from planar_planner.films.stage import make_stage
from planar_planner.pictures.shapes import polygon_paths
from planar_planner.pictures.style import INK, MIDWAY, TRACE
from planar_planner.pictures.world import title_of
from planar_planner.planning.path_samples import Floats, configurations_at, reach, travel


def drive_frames(material: Material, pace: Pace, size: tuple[int, int]) -> Iterator[Frame]:
    """Yield frames equally spaced in travel; the first and last show the exact ends and are held.

    Parameters
    ----------
    material : Material
        Gives the path.
    pace : Pace
        Number of frames.
    size : (width, height)
        In pixels.

    Yields
    ------
    (height, width, 3) of uint8
        One frame; held frames are repeated.
    """
    problem, result = material.problem, material.result
    path = result.path
    radius = reach(problem.robot)
    along = travel(path, radius)
    total = float(along[-1])
    where = np.linspace(0.0, total, pace.moving_frames(total))
    placed = configurations_at(path, radius, where)
    placed[-1] = path[-1]

    stage = make_stage(problem, path, title_of(problem.name, result), size, material.region)
    axes = stage.axes
    axes.plot(path[:, 0], path[:, 1], color=TRACE, linewidth=0.8, alpha=0.35, zorder=3)
    robot = PathPatch(
        Path.make_compound_path(*polygon_paths(problem.robot)),
        facecolor=MIDWAY,
        edgecolor=INK,
        linewidth=1.2,
        alpha=0.9,
    )
    axes.add_patch(robot)
    (trail,) = axes.plot([], [], color=TRACE, linewidth=1.6)
    (point,) = axes.plot([], [], "o", markersize=5, color=TRACE, markeredgecolor="white")
    stage.legend(
        [Line2D([], [], color=TRACE, linewidth=1.6, label=path_label(material.cells.point))]
    )
    backdrop = Backdrop(stage.figure, [trail, robot, point, stage.status])

    for k, (q, done) in enumerate(zip(placed, where, strict=True)):
        robot.set_transform(Affine2D().rotate(q[2]).translate(q[0], q[1]) + axes.transData)
        behind = np.vstack([path[along < done, :2], q[:2]])
        trail.set_data(behind[:, 0], behind[:, 1])
        point.set_data(q[:1], q[1:2])
        stage.status.set_text(_status(q, done, total))
        frame = backdrop.frame()
        held = pace.held_frames() if k in (0, len(placed) - 1) else 0
        for _ in range(held + 1):
            yield frame


def _status(q: Floats, done: float, total: float) -> str:
    share = 100.0 * done / total if total > 0.0 else 100.0
    return f"{share:3.0f} % of travel {total:.4g},  θ = {np.degrees(q[2]):.0f}°"
