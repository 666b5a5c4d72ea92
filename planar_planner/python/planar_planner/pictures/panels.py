"""Figures with several drawings of the same size, in a grid."""

from __future__ import annotations

import math

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_planner.pictures.style import new_figure

WIDTH = 11.0  # inches of all columns
HEIGHT = 7.6  # inches of all rows, at most
TALLEST = 4.6  # inches of one drawing
HEADINGS = 1.3  # inches of title and legend
CAPTION = 0.45  # inches of the caption and labels of a row
LABELS = 0.45  # inches of the labels of a column


def columns_for(count: int, aspect: float) -> int:
    """Return the smallest number of columns, with the largest drawings, whose rows fit the page."""
    for columns in range(1, count):
        if math.ceil(count / columns) * (_height(columns, aspect) + CAPTION) <= HEIGHT:
            return columns
    return count


def _height(columns: int, aspect: float) -> float:
    """Return the height in inches of a drawing whose width over height is `aspect`."""
    return min(TALLEST, (WIDTH / columns - LABELS) / aspect)


def panel_figure(count: int, aspect: float) -> tuple[Figure, list[Axes]]:
    """Return a figure with `count` drawings, whose width over height is `aspect`."""
    columns = columns_for(count, aspect)
    rows = math.ceil(count / columns)
    height = _height(columns, aspect)
    width = columns * (height * aspect + LABELS)
    figure = new_figure(max(width, 4.0), rows * (height + CAPTION) + HEADINGS)
    panels = [figure.add_subplot(rows, columns, k + 1) for k in range(count)]
    for k, axes in enumerate(panels):  # labels at the outer sides only
        if k % columns:
            axes.tick_params(labelleft=False)
        if k + columns < count:
            axes.tick_params(labelbottom=False)
    return figure, panels


def label_outer(panels: list[Axes], count: int, aspect: float) -> None:
    """Remove the names of axes where a neighbour shows the same names."""
    columns = columns_for(count, aspect)
    for k, axes in enumerate(panels):
        if k % columns:
            axes.set_ylabel("")
        if k + columns < count:
            axes.set_xlabel("")
