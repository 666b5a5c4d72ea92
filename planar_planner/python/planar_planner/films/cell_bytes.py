"""Cells packed for a page: corners as 16-bit fractions of the space, and a label."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

from planar_planner.explain.cells import LABELS, Cells

MAX_SHOWN = 60_000
"""Most cells in a page: 13 bytes each, so at most 1.1 MB of base64. The largest cells are kept. The
others are smaller than a screen shows without zoom, and the page says that they are left out."""

_STEPS = 65535


def packed_cells(cells: Cells, *, rotation: bool) -> dict[str, Any] | None:
    """Return cells in the player's form; None if there are none.

    Parameters
    ----------
    cells : Cells
        All cells of the subdivision.
    rotation : bool
        Whether the robot may turn; if not, a cell has no extent in theta.

    Returns
    -------
    dict
        count: number of cells; shown: number of cells in data; labels: number of cells of each
        label; box: lower and upper corner of the space; data: base64 of the lower x of all cells,
        as little-endian uint16 from 0 at the box's lower corner to 65535 at its upper one, then in
        the same form lower y, lower theta, upper x, y, theta, and one byte of label for each cell.
    """
    if not len(cells):
        return None
    low, high = cells.lower.min(axis=0), cells.upper.max(axis=0)
    extent = np.where(high > low, high - low, 1.0)
    lower = np.rint((cells.lower - low) / extent * _STEPS)
    upper = np.rint((cells.upper - low) / extent * _STEPS)
    axes = slice(0, 3 if rotation else 2)
    visible = (upper > lower)[:, axes].all(axis=1)
    size = np.where(visible, cells.level.sum(axis=1), np.iinfo(np.int64).max)
    largest = np.argsort(size, kind="stable")[: min(MAX_SHOWN, int(visible.sum()))]
    largest.sort()
    corners = np.concatenate([lower[largest].T, upper[largest].T]).astype("<u2")
    counts = np.bincount(cells.label, minlength=len(LABELS)).tolist()
    return {
        "count": len(cells),
        "shown": len(largest),
        "labels": dict(zip(LABELS, counts, strict=True)),
        "box": [low.tolist(), high.tolist()],
        "data": base64.b64encode(
            corners.tobytes() + cells.label[largest].astype(np.uint8).tobytes()
        ).decode("ascii"),
    }
