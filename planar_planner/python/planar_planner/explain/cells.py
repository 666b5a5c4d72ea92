"""The cells of a subdivision as arrays, to draw, count or search.

They are rounded to doubles, so no proof rests on them; what is proven is in a certificate
(docs/certificate.md).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from planar_planner.explain.about_point import path_of_point
from planar_planner.frozen_arrays import FrozenArrays, freeze

FREE, STAR, FULL, MIXED = range(4)
LABELS = ("FREE", "STAR", "FULL", "MIXED")
"""Names of the labels, by their numbers in `Cells.label`."""

# The colours are of Okabe and Ito's set, which any common colour blindness tells apart. They also
# differ in lightness: FULL is dark, STAR is middling, FREE is light, MIXED is lightest.
LABEL_COLOURS = {
    "FREE": "#56B4E9",  # sky blue
    "STAR": "#009E73",  # bluish green
    "FULL": "#4D4D4D",  # dark grey
    "MIXED": "#F5EE9E",  # yellow, paled: it fills most of a picture
}
"""By the names in `LABELS`."""


@dataclass(frozen=True, eq=False)
class Cells(FrozenArrays):
    """Boxes in (x, y, theta) that tile the configuration space, or some of them.

    Attributes
    ----------
    lower, upper : NDArray of float64, shape (N, 3)
        Opposite corners: x and y of the robot's point `point` in the scene's unit, theta in radians
        from 0 to 2π. If the robot may not turn, both thetas are the one that it has.
    level : NDArray of uint8, shape (N, 3)
        How often the cell's extent along x, y and theta was halved.
    label : NDArray of uint8, shape (N,)
        FREE: every configuration is free; STAR: the free ones are star-shaped about one of them;
        FULL: every configuration collides; MIXED: not decided. See `LABELS`.
    point : (x, y)
        In the robot's frame. It is the origin, the robot's reference point, unless that lies far
        from the body: the planner then works with a point of the body (`about_point`).
    """

    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    level: NDArray[np.uint8]
    label: NDArray[np.uint8]
    point: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        freeze(self)

    def __len__(self) -> int:
        return len(self.label)

    def __getitem__(self, which: Any) -> Cells:
        """Return the cells that a mask, a slice or an array of indices selects."""
        return Cells(
            self.lower[which], self.upper[which], self.level[which], self.label[which], self.point
        )


def make_cells(table: Mapping[str, Any]) -> Cells:
    """Build the cells from the core's table."""
    return Cells(table["lower"], table["upper"], table["level"], table["label"], table["point"])


def theta_slice(cells: Cells, theta: float) -> Cells:
    """Return the cells that contain an angle.

    Each contains its lower bound and not its upper one, so a slice of all cells tiles the plane
    just once.

    Parameters
    ----------
    cells : Cells
        Where to choose from.
    theta : float
        Radians; whole turns do not matter. A robot that may not turn has cells at its own angle
        only.

    Raises
    ------
    ValueError
        If theta is not finite.
    """
    if not math.isfinite(theta):
        raise ValueError(f"theta must be finite, not {theta!r}")
    flat = cells.lower[:, 2] == cells.upper[:, 2]
    turn = theta % math.tau  # rounds up to a whole turn just below zero
    turn = 0.0 if turn == math.tau else turn
    within = (cells.lower[:, 2] <= turn) & (turn < cells.upper[:, 2])
    same = np.remainder(theta - cells.lower[:, 2], math.tau) == 0.0
    return cells[np.where(flat, same, within)]


def cells_on_path(cells: Cells, path: ArrayLike) -> NDArray[np.bool_]:
    """Return which cells a path runs through: those whose closed box meets one of its segments.

    Parameters
    ----------
    cells : Cells
        The cells, N of them.
    path : (M, 3)
        Waypoints (x, y, theta) of the reference point, theta unwrapped. If the cells are of another
        point, its way is followed in steps of at most a hundredth of a radian.

    Returns
    -------
    NDArray of bool, shape (N,)
    """
    waypoints = path_of_point(np.asarray(path, dtype=np.float64).reshape(-1, 3), cells.point)
    met = np.zeros(len(cells), dtype=bool)
    for start, end in itertools.pairwise(waypoints):
        for turns in _turns_between(start[2], end[2]):
            shift = np.array([0.0, 0.0, math.tau * turns])
            met |= _meets(cells, start - shift, end - start)
    return met


def _turns_between(start: float, end: float) -> range:
    """Whole turns that bring some angle between the two into [0, 2π]."""
    low, high = min(start, end), max(start, end)
    return range(math.floor(low / math.tau) - 1, math.floor(high / math.tau) + 1)


def _meets(cells: Cells, start: NDArray[np.float64], motion: NDArray[np.float64]) -> Any:
    """Slab test: does start + s motion, 0 <= s <= 1, meet each box? Flat ones fit any theta."""
    first, last = np.zeros(len(cells)), np.ones(len(cells))
    possible = np.ones(len(cells), dtype=bool)
    for k in range(3):
        low, high = cells.lower[:, k], cells.upper[:, k]
        if motion[k] == 0.0:
            inside = (low <= start[k]) & (start[k] <= high)
            possible &= inside | (low == high) if k == 2 else inside
            continue
        s, t = (low - start[k]) / motion[k], (high - start[k]) / motion[k]
        first, last = np.maximum(first, np.minimum(s, t)), np.minimum(last, np.maximum(s, t))
    return possible & (first <= last)
