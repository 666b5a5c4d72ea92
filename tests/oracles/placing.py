"""Bodies at configurations, in doubles."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pose = tuple[float, float, float]


def placed(ring: Array, pose: Sequence[float] | Array) -> Array:
    """Return the vertices at a configuration (x, y, theta), with the roundings of the library."""
    c, s = math.cos(pose[2]), math.sin(pose[2])
    x, y = ring.T
    return np.column_stack([c * x - s * y + pose[0], s * x + c * y + pose[1]])
