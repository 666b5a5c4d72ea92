"""Pictures of the sweeps: the models with a free placement, and the bounds along the motion."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import shapely
from matplotlib.axes import Axes

from lib.pictures import BLUE, GREEN, GREY, INK, PALE, PURPLE, VERMILION, finish, new_panels, save
from parts.depth_sweep.sweep import Sample
from worlds.bodies.paper_models import Model, Pose

SHOWN = 0.4  # of the motion, where the upper row shows the bodies


def draw(models: Sequence[Model], samples: Sequence[Sample], name: str) -> Path:
    """Draw a column a model into ``bench/results/``."""
    count = len(models)
    figure, axes = new_panels(2, count, 4.2 * count, 7.2)
    for column, model in enumerate(models):
        own = [sample for sample in samples if sample.model == model.name]
        draw_bodies(axes[column], model, min(own, key=lambda s: abs(s.t - SHOWN)))
        draw_bounds(axes[count + column], own)
    axes[count].set_ylabel("depth under DISP (length)")
    axes[count].legend(frameon=False, fontsize=8)
    return save(figure, name)


def draw_bodies(axes: Axes, model: Model, sample: Sample) -> None:
    """Draw the fixed body, and the moving one where it is and where UB1 puts it."""
    _fill(axes, model.fixed, PALE, GREY, 1.0)
    _fill(axes, _placed(model.moving, (sample.x, sample.y, sample.theta)), "none", VERMILION, 1.2)
    free = (sample.free_x, sample.free_y, sample.free_theta)
    _fill(axes, _placed(model.moving, free), f"{BLUE}40", BLUE, 1.2)
    axes.set_title(f"{model.name}: t = {sample.t:.2f} (orange), freed (blue)", fontsize=9)
    axes.set_aspect("equal")
    axes.set_axis_off()


def draw_bounds(axes: Axes, samples: Sequence[Sample]) -> None:
    """Draw the bounds along the motion."""
    t = [sample.t for sample in samples]
    axes.plot(t, [s.ub2 for s in samples], "--", color=VERMILION, label="UB2, hulls")
    axes.plot(
        t,
        [s.ub1 for s in samples],
        "-",
        color=BLUE,
        linewidth=2.6,
        alpha=0.6,
        label="UB1, separators",
    )
    axes.fill_between(
        t, [s.lo for s in samples], [s.hi for s in samples], color=INK, label="PD^g, bracketed"
    )
    axes.plot(t, [0.5 * (s.lo + s.hi) for s in samples], "-", color=INK, linewidth=0.8)
    axes.plot(t, [s.best for s in samples], ":", color=PURPLE, label="best, drawn back")
    axes.plot(t, [s.lb for s in samples], "-.", color=GREEN, label="LB, pieces")
    axes.set(xlabel="t", xlim=(0.0, 1.0))
    axes.set_ylim(bottom=0.0)
    finish(axes)


def _placed(body: shapely.Geometry, pose: Pose) -> shapely.Geometry:
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return shapely.transform(body, lambda p: p @ np.array([[c, s], [-s, c]]) + (x, y))


def _fill(axes: Axes, body: shapely.Polygon, face: str, edge: str, width: float) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    rings = [shapely.get_coordinates(ring) for ring in (body.exterior, *body.interiors)]
    outline = Outline.make_compound_path(*(Outline(ring, closed=True) for ring in rings))
    axes.add_patch(PathPatch(outline, facecolor=face, edgecolor=edge, linewidth=width))
    axes.autoscale_view()
