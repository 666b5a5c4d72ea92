"""As Fig. 3 of [GFE]: W^a of rows (a1)–(a5) and the largest multiple of Q in it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from lib.pictures import BLUE, VERMILION, save
from pdg.sets import ConvexSet

OUTER, INNER = BLUE, VERMILION
SHARP = 0.9  # cosine of the angle between normals from which an edge is drawn
AXES = ("$f_x$", "$f_z$", "$\\tau_y$")


def draw(panels: Sequence[tuple[str, ConvexSet, ConvexSet, float]], name: str) -> Path:
    """Draw sets of three dimensions: title, W^a, Q in its space, and d_Q(W^a)."""
    figure = Figure(figsize=(2.9 * len(panels), 2.7))
    figure.subplots_adjust(left=0.0, right=0.96, bottom=0.02, top=0.98, wspace=0.12)
    for k, (title, outer, inner, factor) in enumerate(panels):
        axes: Any = figure.add_subplot(1, len(panels), k + 1, projection="3d")
        corners = surface(outer)
        solid(axes, surface(inner) * factor, INNER, 0.9)
        solid(axes, corners, OUTER, 0.12)
        reach = np.abs(corners).max(axis=0)
        for set_limits, set_ticks, r in zip(
            (axes.set_xlim, axes.set_ylim, axes.set_zlim),
            (axes.set_xticks, axes.set_yticks, axes.set_zticks),
            reach,
            strict=True,
        ):
            set_limits(-r, r)
            set_ticks([-round(float(r), 2), round(float(r), 2)])
        axes.set_xlabel(AXES[0], labelpad=-6)
        axes.set_ylabel(AXES[1], labelpad=-6)
        axes.set_zlabel(AXES[2], labelpad=-8)
        axes.set_box_aspect(reach, zoom=0.85)
        axes.view_init(elev=22, azim=-62)
        axes.tick_params(labelsize=6, pad=-3)
        axes.set_title(title, fontsize=10, y=0.86)
    return save(figure, name)


def surface(inner: ConvexSet, count: int = 1500) -> NDArray[np.float64]:
    """Return support points in evenly spread directions (a Fibonacci lattice)."""
    k = np.arange(count) + 0.5
    height, turn = 1 - 2 * k / count, np.pi * (1 + 5**0.5) * k
    ring = np.sqrt(1 - height**2)
    u = np.column_stack([ring * np.cos(turn), ring * np.sin(turn), height])
    return np.unique(np.round(inner.supports(u)[1], 12), axis=0)


def solid(axes: Any, points: NDArray[np.float64], colour: str, opacity: float) -> None:
    """Draw the hull of points with its sharp edges, or the segment that they are."""
    if np.linalg.matrix_rank(points - points[0], tol=1e-9) < 3:
        axes.plot(*points.T, color=colour, linewidth=3)
        return
    hull = ConvexHull(points)
    light = np.array([-0.4, -0.7, 0.6])
    bright = 0.75 + 0.25 * (hull.equations[:, :3] @ (light / np.linalg.norm(light)))
    faces = np.outer(bright, to_rgb(colour)).clip(0, 1)
    axes.add_collection3d(
        Poly3DCollection(points[hull.simplices], facecolors=faces, alpha=opacity, linewidths=0)
    )
    edges = [
        points[[v for v in hull.simplices[f] if v in hull.simplices[g]]]
        for f, row in enumerate(hull.neighbors)
        for g in row
        if f < g and hull.equations[f, :3] @ hull.equations[g, :3] < SHARP
    ]
    if edges:
        axes.add_collection3d(Line3DCollection(edges, colors=colour, linewidths=0.8))
