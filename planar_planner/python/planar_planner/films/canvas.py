"""A figure that is drawn once, and on which the moving parts alone are drawn for each frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from planar_planner.errors import OptionsError

Frame = NDArray[np.uint8]
"""A picture: (height, width, 3), red, green, blue."""

PIXELS_PER_INCH = 100
SMALLEST, LARGEST = 160, 4096  # pixels a side; below, titles and axes leave no room for the drawing


def blank_figure(size: tuple[int, int]) -> Figure:
    """Return a white figure of just this many pixels.

    Raises
    ------
    OptionsError
        If a side is not between 160 and 4096 pixels.
    """
    check_size(size)
    inches = (size[0] / PIXELS_PER_INCH, size[1] / PIXELS_PER_INCH)
    figure = Figure(figsize=inches, dpi=PIXELS_PER_INCH, layout="constrained", facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def check_size(size: tuple[int, int]) -> None:
    """Refuse a size that is too small to see anything, or large by a slip.

    Raises
    ------
    OptionsError
        If a side is not between 160 and 4096 pixels.
    """
    if not all(SMALLEST <= side <= LARGEST for side in size):
        raise OptionsError(
            f"size must be from {SMALLEST} to {LARGEST} pixels a side, not {size[0]}x{size[1]}"
        )


class Backdrop:
    """The still part of a figure as pixels, on which moving artists are drawn.

    Parameters
    ----------
    figure : Figure
        Of `blank_figure`, complete, with the moving artists in it.
    moving : sequence of Artist
        What changes; drawn in this order.
    """

    def __init__(self, figure: Figure, moving: Sequence[Artist]) -> None:
        self._moving = moving
        for artist in moving:
            artist.set_animated(True)  # so that drawing the figure leaves them out
        canvas: Any = figure.canvas  # Agg's; its methods have no types
        canvas.draw()
        figure.set_layout_engine("none")
        self._canvas = canvas
        self._still = canvas.copy_from_bbox(figure.bbox)

    def frame(self) -> Frame:
        """Return the picture with the moving artists as they are now."""
        self._canvas.restore_region(self._still)
        for artist in self._moving:
            artist.draw(self._canvas.renderer)
        return np.asarray(self._canvas.buffer_rgba())[:, :, :3].copy()
