"""Pictures of benchmarks: one palette, one look of axes, one way to write them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lib.provenance import RESULTS
from planar_planner.pictures import comparison, style

DPI = 110
COLOURS = comparison.COLOURS[:6]  # the seventh, yellow, is too pale for lines on white
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = COLOURS
GREY, PALE = "#999999", "#E5E5E5"  # what is set beside a measurement; the grid
INK = style.INK
OURS = comparison.OURS
VERDICT_COLOURS = {"path": BLUE, "no_path": VERMILION}


def new_panels(
    rows: int, columns: int, width: float, height: float, **layout: object
) -> tuple[Figure, list[Axes]]:
    """Return a figure of `width` by `height` inches, and its axes row by row.

    `layout` goes to matplotlib's ``subplots``.
    """
    figure = style.new_figure(width, height)
    axes = figure.subplots(rows, columns, squeeze=False, **layout)  # type: ignore[call-overload]
    return figure, np.ravel(axes).tolist()


def finish(*axes: Axes) -> None:
    """Give axes a pale grid and no frame above and on the right."""
    for each in axes:
        each.grid(visible=True, which="major", color=PALE, linewidth=0.6)
        each.set_axisbelow(True)
        each.spines[["top", "right"]].set_visible(False)


def save(figure: Figure, name: str) -> Path:
    """Write a picture into ``bench/results/``; the same figure gives the same bytes."""
    RESULTS.mkdir(exist_ok=True)
    file = RESULTS / name
    style.save_picture(figure, file, dpi=DPI)
    return file
