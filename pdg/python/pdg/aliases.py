"""Short names for the types of numbers in signatures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
"""A point or a vector (x, y), in the caller's unit of length."""

Pose = tuple[float, float, float]
"""A configuration (x, y, theta): turn by theta radians about the frame's origin, then translate."""

RealArray = NDArray[np.floating[Any] | np.integer[Any]]
"""An array of real numbers of any shape; the function says which shapes it takes."""

Rows = Sequence[Sequence[float] | RealArray]
"""Rows of numbers, one a vertex, a configuration or a cell."""
