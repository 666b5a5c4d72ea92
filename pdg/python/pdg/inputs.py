"""Types of the numbers that a caller may give, which `_gate` checks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

RealArray = NDArray[np.floating[Any] | np.integer[Any]]
"""An array of real numbers of any shape; the function says which shapes it takes."""

Rows = Sequence[Sequence[float] | RealArray]
"""Rows of numbers, one a vertex, a configuration or a cell."""
