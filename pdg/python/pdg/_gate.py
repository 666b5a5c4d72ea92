"""Numbers and rings a caller may pass → checked doubles. Nothing behind this checks again."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from pdg import _core
from pdg.errors import BodyError, PdgError, PlacementError
from pdg.tolerances import (
    MAX_SET_COORDINATE,
    MIN_SET_COORDINATE,
    MOST_COUNTED,
    MOST_DIMENSIONS,
)

Kind = TypeVar("Kind", bound=str)
Item = TypeVar("Item")
Triple = tuple[float, float, float]

LEAST_VERTICES = 3
"""A ring has at least so many."""

HERE: Triple = (0.0, 0.0, 0.0)
"""The configuration of a body that stays as it is."""


def ring(value: object, name: str) -> NDArray[np.float64]:
    """Return the ring as an (n, 2) array without a repeated last or consecutive vertex."""
    try:
        points = numbers(value, name)
    except PdgError as error:
        raise BodyError(error.problem, name, value=value) from error
    if points.ndim != 2 or points.shape[1] != 2:
        raise BodyError("a ring is an array of shape (n, 2)", name, value=points.shape)
    sane = in_range(points)
    if not sane.all():
        row = int(np.flatnonzero(~sane.all(axis=1))[0])
        problem = (
            "coordinates must be finite, and 0 or between "
            f"{_core.MIN_COORDINATE:.3g} and {_core.MAX_COORDINATE:.3g} in magnitude"
        )
        raise BodyError(problem, name, row, points[row].tolist())
    if len(points):
        points = points[np.any(points != np.roll(points, 1, axis=0), axis=1)]
    if len(np.unique(points, axis=0)) < LEAST_VERTICES:
        raise BodyError("a ring needs at least three distinct points", name, value=len(points))
    return np.ascontiguousarray(points)


def in_range(points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which coordinates the core's exact predicates take; NaN is none of them."""
    magnitude = np.abs(points)
    sane: NDArray[np.bool_] = (magnitude == 0) | (
        (magnitude >= _core.MIN_COORDINATE) & (magnitude <= _core.MAX_COORDINATE)
    )
    return sane


def poses(value: object, name: str) -> Triple | NDArray[np.float64]:
    """Return one configuration (x, y, theta) as a tuple, or many as an (n, 3) array."""
    array = _empty_as_rows(numbers(value, name), 3)
    if array.ndim != 2:
        x, y, theta = _vector(array, name, 3, "(x, y, theta), or rows of them")
        return x, y, theta
    return _rows(array, name, 3, "(x, y, theta)")


def out_of_range(pose: object, row: int | None = None) -> PlacementError:
    """Return the error for a configuration, in a row of a batch, that the core refused."""
    problem = "places the body outside the range of exact arithmetic"
    return PlacementError(problem, "pose", row, pose)


def check_placed(bad: int, rows: NDArray[np.float64], single: bool) -> None:
    """Raise for the row at which the core stopped, unless it is -1."""
    if bad >= 0:
        raise out_of_range(rows[bad].tolist(), None if single else bad)


def pose_pairs(q0: object, q1: object) -> tuple[NDArray[np.float64], NDArray[np.float64], bool]:
    """Return two (n, 3) arrays, and whether both arguments were single configurations.

    One configuration stands against many.
    """
    start, end = poses(q0, "q0"), poses(q1, "q1")
    first, second = np.atleast_2d(np.asarray(start)), np.atleast_2d(np.asarray(end))
    if isinstance(start, tuple):
        first = np.ascontiguousarray(np.broadcast_to(first, second.shape))
    elif isinstance(end, tuple):
        second = np.ascontiguousarray(np.broadcast_to(second, first.shape))
    if len(first) != len(second):
        raise PdgError(f"expected {len(first)} rows, as many as q0 has", "q1", value=len(second))
    return first, second, isinstance(start, tuple) and isinstance(end, tuple)


def half_extents(value: object, name: str) -> Triple:
    """Return three finite numbers >= 0 (h_x, h_y, h_theta)."""
    h_x, h_y, h_theta = _vector(numbers(value, name), name, 3, "(h_x, h_y, h_theta)")
    for i, extent in enumerate((h_x, h_y, h_theta)):
        _check_not_negative(extent, name, i)
    return h_x, h_y, h_theta


def cells(value: object, name: str) -> tuple[Triple, Triple] | NDArray[np.float64]:
    """Return centre and half-extents of one (x, y, theta, h_x, h_y, h_theta), or rows of them."""
    array = _empty_as_rows(numbers(value, name), 6)
    meaning = "(x, y, theta, h_x, h_y, h_theta)"
    if array.ndim != 2:
        x, y, theta, *half = _vector(array, name, 6, f"{meaning}, or rows of them")
        for i, extent in enumerate(half, 3):
            _check_not_negative(extent, name, i)
        h_x, h_y, h_theta = half
        return (x, y, theta), (h_x, h_y, h_theta)
    rows = _rows(array, name, 6, meaning)
    negative = (rows[:, 3:] < 0).any(axis=1)
    if negative.any():
        row = int(np.flatnonzero(negative)[0])
        raise PdgError("a half-extent must not be negative", name, row, rows[row].tolist())
    return rows


def length(value: object, name: str) -> float:
    """Return one finite number >= 0."""
    number = numbers(value, name)
    if number.shape != ():
        raise PdgError("expected one number", name, value=number.shape)
    _check_magnitude(number.reshape(1), name)
    if number < 0:
        raise PdgError("must not be negative", name, value=float(number))
    return float(number)


def seconds(value: object, name: str) -> float:
    """Return one number >= 0, or infinity."""
    return math.inf if isinstance(value, float) and value == math.inf else length(value, name)


def count(value: object, name: str) -> int:
    """Return a whole number >= 0, at most `MOST_COUNTED`, which nothing reaches."""
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer) or value < 0:
        raise PdgError("expected a whole number >= 0", name, value=value)
    return min(int(value), MOST_COUNTED)


def flag(value: object, name: str) -> bool:
    """Return True or False."""
    if not isinstance(value, bool | np.bool_):
        raise PdgError("expected True or False", name, value=value)
    return bool(value)


def starts(value: object, name: str, end: int) -> NDArray[np.uint32]:
    """Return starts that ascend from 0 to `end`, each part not empty."""
    problem = "expected integers of shape (n,), not empty"
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise PdgError(problem, name, value=value) from error
    if array.ndim != 1 or array.dtype.kind not in "iu" or len(array) == 0:
        raise PdgError(problem, name, value=value)
    for place, expected in ((0, 0), (-1, end)):
        if array[place] != expected:
            raise PdgError(f"must begin with 0 and end with {end}", name, value=array.tolist())
    flat = np.flatnonzero(array[1:] <= array[:-1])
    if len(flat):
        raise PdgError("must ascend", name, int(flat[0]) + 1, int(array[flat[0] + 1]))
    return np.ascontiguousarray(array, dtype=np.uint32)


def choice(value: object, choices: Sequence[Kind], name: str, index: int | None = None) -> Kind:
    """Return the one of a few strings that `value` is."""
    for known in choices:
        if isinstance(value, str) and value == known:
            return known
    *others, last = (f'"{known}"' for known in choices)
    raise PdgError(f"expected {', '.join(others)} or {last}", name, index, value)


def items(values: Iterable[Item], name: str) -> list[Item]:
    """Return the items of an iterable."""
    try:
        return list(values)
    except TypeError as error:
        raise PdgError("expected a sequence", name, value=values) from error


def coordinates(
    value: object, name: str, axes: int, smallest: float = MIN_SET_COORDINATE
) -> NDArray[np.float64]:
    """Return a contiguous array, not empty, with `axes` axes, of a convex set's array.

    Those are 0 or between `smallest` and `MAX_SET_COORDINATE` in magnitude.
    """
    array = numbers(value, name)
    if array.ndim != axes or array.size == 0:
        kind = {1: "a vector (n,)", 2: "a matrix (m, n)"}[axes]
        raise PdgError(f"expected {kind}, not empty", name, value=array.shape)
    if array.shape[-1] > MOST_DIMENSIONS:
        problem = f"must have {MOST_DIMENSIONS} components at most"
        raise PdgError(problem, name, value=array.shape)
    magnitude = np.abs(array)
    sane = (magnitude == 0) | ((magnitude >= smallest) & (magnitude <= MAX_SET_COORDINATE))
    if not sane.all():
        row = int(np.argwhere(~sane)[0][0])
        problem = (
            "must be finite, and 0 or between "
            f"{smallest:.3g} and {MAX_SET_COORDINATE:.3g} in magnitude"
        )
        raise PdgError(problem, name, row, array[row].tolist())
    return np.ascontiguousarray(array)


def numbers(value: object, name: str) -> NDArray[np.float64]:
    """Return an array of doubles; integers and narrower floats are widened, nothing else is."""
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise PdgError("expected real numbers", name, value=value) from error
    if array.dtype.kind not in "iuf" or array.dtype.itemsize > 8:
        raise PdgError("expected real numbers", name, value=value)
    return array.astype(np.float64, copy=False)


def _empty_as_rows(array: NDArray[np.float64], size: int) -> NDArray[np.float64]:
    """Take an empty sequence for a batch without rows."""
    return array.reshape(0, size) if array.shape == (0,) else array


def _vector(array: NDArray[np.float64], name: str, size: int, meaning: str) -> list[float]:
    if array.shape != (size,):
        raise PdgError(f"expected {size} numbers {meaning}", name, value=array.shape)
    _check_magnitude(array, name)
    return [float(v) for v in array]


def _rows(array: NDArray[np.float64], name: str, size: int, meaning: str) -> NDArray[np.float64]:
    if array.shape[1] != size:
        raise PdgError(f"expected rows of {size} numbers {meaning}", name, value=array.shape)
    # Negated, so that NaN fails too.
    bad = ~(np.abs(array) <= _core.MAX_COORDINATE).all(axis=1)
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        raise PdgError(_MAGNITUDE, name, row, array[row].tolist())
    return np.ascontiguousarray(array)


def _check_not_negative(extent: float, name: str, index: int) -> None:
    if extent < 0:
        raise PdgError("a half-extent must not be negative", name, index, extent)


_MAGNITUDE = f"must be finite and at most {_core.MAX_COORDINATE:.3g} in magnitude"


def _check_magnitude(array: NDArray[np.float64], name: str) -> None:
    bad = ~(np.abs(array) <= _core.MAX_COORDINATE)  # negated, so that NaN fails too
    if bad.any():
        i = int(np.flatnonzero(bad)[0])
        raise PdgError(_MAGNITUDE, name, i, float(array[i]))
