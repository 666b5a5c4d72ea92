"""Boxes of the space (x, y, theta) in a 3-D view; theta in degrees."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.gridspec import SubplotSpec
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from mpl_toolkits.mplot3d.axes3d import Axes3D
from numpy.typing import NDArray

from planar_planner.explain.cells import Cells
from planar_planner.pictures.style import END_COLOURS, INK, TRACE
from planar_planner.planning.path_samples import Floats
from planar_planner.problem.make import Problem, ends

ELEVATION, AZIMUTH = 28.0, -62.0  # direction of the eye, in degrees
HEIGHT = 0.8  # height of a whole turn, relative to the greater of the extents of x and y
MOST_BOXES = 3000  # boxes in one view, the largest; more would take seconds and show less
LIGHT = {0: 0.82, 1: 0.68, 2: 1.0}  # brightness of the faces across x, y and theta

# Corners of a box as low (0) or high (1) along each axis, for the three faces towards the eye:
# x high, y low, theta high.
FACES = np.array([
    [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
    [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
    [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
])  # fmt: skip


def space_axes(
    figure: Figure, place: SubplotSpec | tuple[int, int, int], low: Floats, high: Floats
) -> Axes3D:
    """Add a view of the space between two corners; x and y on equal scales, theta from 0 to 360."""
    where = place if isinstance(place, tuple) else (place,)
    axes: Any = figure.add_subplot(*where, projection="3d", computed_zorder=False)
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    axes.set_proj_type("ortho")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(0.0, 360.0))
    extent = high[:2] - low[:2]
    axes.set_box_aspect((*extent, HEIGHT * extent.max()), zoom=0.9)
    axes.set_zticks(range(0, 361, 90), [f"{degrees}°" for degrees in range(0, 361, 90)])
    axes.set_xlabel("x", color=INK)
    axes.set_ylabel("y", color=INK)
    axes.set_zlabel("θ", color=INK)
    axes.tick_params(colors=INK, labelsize=8)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.pane.set_facecolor("white")
        axis.pane.set_edgecolor("#BBBBBB")
        axis._axinfo["grid"].update(color="#EEEEEE")
    return axes


def draw_boxes(axes: Axes3D, cells: Cells, colour: str, alpha: float, zorder: float) -> int:
    """Draw the faces of boxes that look towards the eye, and return the number of boxes drawn.

    At most `MOST_BOXES` boxes are drawn, those of largest volume. Flat boxes (faces, or all boxes
    of a robot that may not turn) are drawn flat.
    """
    volumes = np.prod(cells.upper - cells.lower, axis=1)
    kept = np.sort(np.argsort(-volumes, kind="stable")[:MOST_BOXES])
    if not len(kept):
        return 0
    low, high = _in_degrees(cells.lower[kept]), _in_degrees(cells.upper[kept])
    corners = low[:, None, None, :] + FACES[None] * (high - low)[:, None, None, :]
    faces = corners.reshape(-1, 4, 3)
    shades = np.tile([LIGHT[0], LIGHT[1], LIGHT[2]], len(kept))
    real = np.ptp(faces, axis=1).astype(bool).sum(axis=1) == 2
    faces, shades = faces[real], shades[real]
    rgb = np.array([int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)])
    drawn = Poly3DCollection(
        faces,
        facecolors=np.column_stack([shades[:, None] * rgb, np.full(len(faces), alpha)]),
        edgecolors=[(*(0.5 * rgb), min(1.0, 1.5 * alpha))],
        linewidths=0.25,
        zorder=zorder,
    )
    drawn.set_rasterized(True)  # thousands of faces that overlap
    axes.add_collection3d(drawn, autolim=False)
    return len(kept)


def draw_path(axes: Axes3D, path: Floats, zorder: float, colour: str = TRACE) -> None:
    """Draw a path with theta in one turn; the line is broken where theta wraps around."""
    for piece in one_turn(path):
        x, y, theta = _in_degrees(piece).T
        axes.plot(x, y, theta, color=colour, linewidth=1.6, zorder=zorder)


def draw_end_points(axes: Axes3D, problem: Problem, zorder: float) -> None:
    """Draw start and goal as points; a goal that is a region is left out."""
    for name, q in ends(problem).items():
        colour = END_COLOURS[name]
        theta = np.degrees(q[2]) % 360.0
        axes.plot(
            [q[0]], [q[1]], [theta], "o", color=colour, markeredgecolor="white", zorder=zorder
        )


def one_turn(path: Floats) -> list[Floats]:
    """Return a path as pieces within 0 <= theta <= 2π, cut where it passes a whole turn."""
    pieces: list[list[NDArray[np.float64]]] = []
    for a, b in pairwise(path):
        low, high = sorted((a[2] / _TURN, b[2] / _TURN))
        cuts = np.arange(np.floor(low) + 1.0, np.ceil(high))
        if a[2] > b[2]:
            cuts = cuts[::-1]
        where = [(cut * _TURN - a[2]) / (b[2] - a[2]) for cut in cuts]
        for s, t in zip([0.0, *where], [*where, 1.0], strict=True):
            first, last = a + s * (b - a), a + t * (b - a)
            shift = _TURN * np.floor(0.5 * (first[2] + last[2]) / _TURN)
            first, last = first - [0.0, 0.0, shift], last - [0.0, 0.0, shift]
            if pieces and np.array_equal(pieces[-1][-1], first):
                pieces[-1].append(last)
            else:
                pieces.append([first, last])
    return [np.array(piece) for piece in pieces]


_TURN = 2.0 * np.pi


def _in_degrees(rows: Floats) -> Floats:
    return np.column_stack([rows[:, :2], np.degrees(rows[:, 2])])
