"""Slices of cells as small pictures: one colour per label, and a line round larger cells."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from planar_planner.explain.cells import LABEL_COLOURS, LABELS, Cells, theta_slice
from planar_planner.films.canvas import Frame

OUTLINED_FROM = 5  # pixels of a cell's shorter side; in a smaller cell a line would hide the colour
_EMPTY = 255  # the pixel shows no cell: it is outside the configuration space
_LINE = 0.72  # share of a colour's brightness, for the line round a cell


class SliceImage:
    """Pictures of the slices of cells.

    Parameters
    ----------
    cells : Cells
        At least one cell.
    longer_side : int
        Length of the picture's longer side, in pixels.
    """

    def __init__(self, cells: Cells, longer_side: int) -> None:
        self._cells = cells
        low, high = cells.lower[:, :2].min(axis=0), cells.upper[:, :2].max(axis=0)
        self.extent = (float(low[0]), float(high[0]), float(low[1]), float(high[1]))
        """Left, right, bottom and top in scene units, as matplotlib's imshow takes them."""
        self._low = low
        self._scale = longer_side / float((high - low).max())
        width, height = np.maximum(1, np.rint((high - low) * self._scale)).astype(int)
        self._shape = (int(height), int(width))
        bright = np.rint(255.0 * np.array([to_rgb(LABEL_COLOURS[name]) for name in LABELS]))
        table = np.full((256, 3), 255, dtype=np.uint8)
        table[: len(LABELS)] = bright
        table[len(LABELS) : 2 * len(LABELS)] = np.rint(_LINE * bright)
        self._table = table

    @staticmethod
    def colour(label: int) -> str:
        """Return the colour of a label, by its number."""
        return LABEL_COLOURS[LABELS[label]]

    def at(self, theta: float) -> Frame:
        """Return the slice at an angle, bottom row first; a pixel shows the cell at its centre."""
        cells = theta_slice(self._cells, theta)
        picture = np.full(self._shape, _EMPTY, dtype=np.uint8)
        first = self._pixels(cells.lower[:, :2])
        last = self._pixels(cells.upper[:, :2])
        seen = (last > first).all(axis=1)
        lined = (last - first).min(axis=1) >= OUTLINED_FROM
        for (i, j), (k, m), label, line in zip(
            first[seen].tolist(),
            last[seen].tolist(),
            cells.label[seen].tolist(),
            lined[seen].tolist(),
            strict=True,
        ):
            if line:
                picture[j:m, i:k] = label + len(LABELS)
                picture[j + 1 : m, i + 1 : k] = label
            else:
                picture[j:m, i:k] = label
        return self._table[picture]

    def _pixels(self, corners: NDArray[np.float64]) -> NDArray[np.int64]:
        """Return the first pixel whose centre is not before each corner."""
        where = np.ceil((corners - self._low) * self._scale - 0.5)
        inside = np.clip(where, 0.0, np.array(self._shape[::-1], dtype=np.float64))
        return np.asarray(inside, dtype=np.int64)
