"""Numbers that describe a convex set → checked arrays of doubles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pdg import _gate
from pdg.errors import PdgError
from pdg.tolerances import MIN_SET_COORDINATE, MOST_DIMENSIONS


def dimension(value: object, name: str) -> int:
    """Return a whole number of coordinates that a convex set may have."""
    if not isinstance(value, int | np.integer) or not 1 <= value <= MOST_DIMENSIONS:
        problem = f"expected an integer between 1 and {MOST_DIMENSIONS}"
        raise PdgError(problem, name, value=value)
    return int(value)


def repeated(count: int, radius: float, name: str) -> NDArray[np.float64]:
    """Return one number >= 0 for each of so many coordinates, the argument `dimension`."""
    return np.repeat(not_negative([radius], name), dimension(count, "dimension"))


def not_negative(value: ArrayLike, name: str) -> NDArray[np.float64]:
    """Return a vector of numbers >= 0."""
    numbers = _gate.coordinates(value, name, 1)
    if (numbers < 0).any():
        i = int(np.flatnonzero(numbers < 0)[0])
        raise PdgError("must not be negative", name, i, float(numbers[i]))
    return numbers


def centred(
    extents: ArrayLike, name: str, centre: ArrayLike | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return extents along the coordinates and a centre that fits them."""
    numbers = not_negative(extents, name)
    return numbers, middle_of(centre, len(numbers))


def vector(
    value: ArrayLike, name: str, size: int, smallest: float = MIN_SET_COORDINATE
) -> NDArray[np.float64]:
    """Return a vector of so many numbers, 0 or at least `smallest` in magnitude."""
    numbers = _gate.coordinates(value, name, 1, smallest)
    if len(numbers) != size:
        raise PdgError(f"expected {size} numbers", name, value=numbers.shape)
    return numbers


def middle_of(value: ArrayLike | None, size: int, name: str = "centre") -> NDArray[np.float64]:
    """Return a vector of so many numbers, zeros by default."""
    return np.zeros(size) if value is None else vector(value, name, size)
