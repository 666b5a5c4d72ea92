"""Error against time: of PD^t by several methods, and of PD^g by our bound and by refinement."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from matplotlib.axes import Axes

from lib.pictures import COLOURS as KINDS
from lib.pictures import GREY, INK, finish, new_panels, save
from parts.depth_accuracy import generalized, translational
from parts.depth_accuracy.common import UNIT, Row

COLOURS = (*KINDS, GREY, INK)
MARKERS = "osD^v<>P*"


def draw(rows: Sequence[Row], name: str) -> Path:
    """Draw both panels into ``bench/results/``."""
    figure, (left, right) = new_panels(1, 2, 11, 4.6)
    draw_translational(left, [row for row in rows if row.quantity == "PD^t"])
    draw_generalized(right, [row for row in rows if row.quantity == "PD^g"])
    for axes in (left, right):
        axes.set(xscale="log", yscale="log", xlabel="time (µs)", ylabel="relative error")
        axes.legend(frameon=False, fontsize=7)
    finish(left, right)
    return save(figure, name)


def draw_translational(axes: Axes, rows: Sequence[Row]) -> None:
    """Draw the methods' errors for bodies of one size: errors of 0 at half a rounding."""
    size = f"{translational.SAMPLED_VERTICES} vertices each"
    chosen = [row for row in rows if row.case == size]
    sampled = [row for row in chosen if row.method.startswith(translational.SAMPLED)]
    axes.plot(
        [row.microseconds for row in sampled],
        [row.largest for row in sampled],
        "o-",
        markersize=3,
        color=COLOURS[1],
        label=f"{sampled[0].method.split()[-1]} to {sampled[-1].method.split()[-1]} directions",
    )
    others = [row for row in chosen if row not in sampled]
    for row, colour, marker in zip(others, COLOURS[::2], MARKERS, strict=False):
        error = max(row.largest, 0.5 * UNIT)
        axes.plot([row.microseconds], [error], marker, color=colour, label=row.method)
    axes.set_title(f"PD^t, convex, {size}: largest error")


def draw_generalized(axes: Axes, rows: Sequence[Row]) -> None:
    """Draw the oracle's narrowing bracket and our bound, a colour a pair of bodies."""
    cases = list(dict.fromkeys(row.case for row in rows))
    for k, case in enumerate(cases):
        colour, dashes = COLOURS[k % len(COLOURS)], "-" if k < len(COLOURS) else "--"
        bracket = [r for r in rows if r.case == case and r.method.startswith(generalized.ORACLE)]
        axes.plot(
            [row.microseconds for row in bracket],
            [row.error for row in bracket],
            dashes,
            color=colour,
            linewidth=1.2,
        )
        (bound,) = (r for r in rows if r.case == case and r.method == generalized.LOWER_BOUND)
        error = max(bound.error, 0.5 * UNIT)
        axes.plot([bound.microseconds], [error], MARKERS[k % 9], color=colour, label=case)
    axes.set_title("PD^g: our lower bound (points), the oracle's bracket (lines)")
