"""Cells → a few bytes each, for a page: corners as 16-bit fractions of the space, and a label."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

from planar_planner.explain.cells import LABELS, Cells

MAX_SHOWN = 60_000
"""Cells in a page: 13 bytes each, so at most 1.1 MB of base64. The largest are kept; what is left
out is smaller than a screen shows unless one zooms in, and the page says that it is left out."""

_STEPS = 65535


def packed_cells(cells: Cells, *, rotation: bool) -> dict[str, Any] | None:
    """Return cells as the player takes them; None if there are none.

    Parameters
    ----------
    cells : Cells
        All of them.
    rotation : bool
        Whether the robot may turn; if not, a cell has no extent in theta.

    Returns
    -------
    dict
        count: how many there are; shown: how many follow; labels: how many of each label; box:
        lower and upper corner of the space; data: base64 of the lower x of all, as little-endian
        uint16 from 0 at the box's lower corner to 65535 at its upper one, likewise lower y, lower
        theta, upper x, y, theta, and a byte of label each.
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
