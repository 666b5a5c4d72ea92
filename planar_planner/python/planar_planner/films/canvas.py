"""A figure that is drawn once; for each frame only its moving parts are drawn again."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from planar_planner.errors import OptionsError

Frame = NDArray[np.uint8]
"""A picture of shape (height, width, 3): red, green, blue."""

PIXELS_PER_INCH = 100
SMALLEST, LARGEST = 160, 4096  # pixels per side; in less, titles and axes leave no room to draw


def blank_figure(size: tuple[int, int]) -> Figure:
    """Return a white figure of exactly this many pixels.

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
    """Refuse a size that is too small for the drawing, or so large that it must be a mistake.

    Raises
    ------
    OptionsError
        If a side is not between 160 and 4096 pixels.
    """
    if not all(SMALLEST <= side <= LARGEST for side in size):
        raise OptionsError(
            f"size must be from {SMALLEST} to {LARGEST} pixels per side, not {size[0]}x{size[1]}"
        )


class Backdrop:
    """The still part of a figure as pixels, on which moving artists are drawn.

    Parameters
    ----------
    figure : Figure
        A complete figure from `blank_figure` that contains the moving artists.
    moving : sequence of Artist
        The artists that change, in the order in which they are drawn.
    """

    def __init__(self, figure: Figure, moving: Sequence[Artist]) -> None:
        self._moving = moving
        for artist in moving:
            artist.set_animated(True)  # drawing the figure then leaves them out
        canvas: Any = figure.canvas  # Agg's; its methods have no types
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "Glyph .* missing")  # a name may be in any script
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
