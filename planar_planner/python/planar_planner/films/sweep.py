"""Frames of slices through the cells at all angles of one turn, for results without a path."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from matplotlib.artist import Artist
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from planar_planner.explain.cells import LABELS
from planar_planner.films.canvas import Backdrop, Frame
from planar_planner.films.material import Material
from planar_planner.films.pace import Pace
from planar_planner.films.slice_image import SliceImage
from planar_planner.films.stage import make_stage
from planar_planner.pictures.shapes import polygon_paths
from planar_planner.pictures.style import INK
from planar_planner.pictures.world import title_of
from planar_planner.problem.make import ends

OBSTACLES_ZORDER = 1.0  # as in planar_planner.pictures; artists below it are background


def sweep_frames(material: Material, pace: Pace, size: tuple[int, int]) -> Iterator[Frame]:
    """Yield frames of the cells at even angles from 0 up to 2π, so that the film repeats smoothly.

    Parameters
    ----------
    material : Material
        Gives the cells, of a robot that may turn.
    pace : Pace
        Its speed is in radians per second; no frame is held, since no frame is an end.
    size : (width, height)
        In pixels.

    Yields
    ------
    (height, width, 3) of uint8
        One frame.
    """
    problem, result = material.problem, material.result
    stage = make_stage(problem, result.path, title_of(problem.name, result), size, material.region)
    axes = stage.axes
    world = sorted([*axes.collections, *axes.patches, *axes.lines], key=Artist.get_zorder)
    over = [artist for artist in world if artist.get_zorder() >= OBSTACLES_ZORDER]
    for collection in axes.collections:
        collection.set_alpha(0.4)  # so that the cells show through bodies
    limits = axes.get_xlim(), axes.get_ylim()
    picture = SliceImage(material.cells, min(size))
    image = axes.imshow(
        picture.at(0.0),
        extent=picture.extent,
        origin="lower",
        interpolation="nearest",
        aspect="equal",
    )
    axes.set(xlim=limits[0], ylim=limits[1])  # imshow has moved them
    shape = Path.make_compound_path(*polygon_paths(problem.robot))
    turning = [
        PathPatch(shape, facecolor="none", edgecolor=INK, linewidth=1.2) for _ in ends(problem)
    ]
    for patch in turning:
        axes.add_patch(patch)
    stage.legend([Patch(facecolor=picture.colour(k), label=LABELS[k]) for k in range(len(LABELS))])
    backdrop = Backdrop(stage.figure, [image, *over, *turning, stage.status])
    count = pace.moving_frames(math.tau)
    for theta in np.linspace(0.0, math.tau, count, endpoint=False):
        image.set_data(picture.at(float(theta)))
        for patch, q in zip(turning, ends(problem).values(), strict=True):
            patch.set_transform(Affine2D().rotate(theta).translate(q[0], q[1]) + axes.transData)
        stage.status.set_text(f"cells at θ = {math.degrees(theta):.0f}°")
        yield backdrop.frame()
