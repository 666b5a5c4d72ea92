"""Arguments of `pdg.grasp` → checked arrays of doubles. Nothing behind this checks again."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from pdg import _gate
from pdg.errors import PdgError
from pdg.tolerances import MAX_GRASP_MAGNITUDE, MIN_GRASP_MAGNITUDE

Kind = TypeVar("Kind")


def vector(value: object, name: str, sizes: tuple[int, ...]) -> NDArray[np.float64]:
    """Return a vector of sane numbers with one of the given numbers of components."""
    numbers = array(value, name)
    if numbers.ndim != 1 or len(numbers) not in sizes:
        wanted = " or ".join(str(size) for size in sizes)
        raise PdgError(f"expected {wanted} numbers", name, value=numbers.shape)
    return numbers


def unit(value: object, name: str, size: int) -> NDArray[np.float64]:
    """Return the unit vector along `value`."""
    direction = vector(value, name, (size,))
    norm = float(np.linalg.norm(direction))
    if norm == 0:
        raise PdgError("a direction must not be zero", name, value=direction.tolist())
    return frozen(direction / norm)


def coefficient(value: object, name: str) -> float:
    """Return one sane number >= 0."""
    numbers = array(value, name)
    if numbers.shape != ():
        raise PdgError("expected one number", name, value=numbers.shape)
    number = float(numbers)
    if number < 0:
        raise PdgError("must not be negative", name, value=number)
    return number


def positive(value: object, name: str) -> float:
    """Return one sane number > 0."""
    number = coefficient(value, name)
    if number == 0:
        raise PdgError("must be positive", name, value=number)
    return number


def array(value: object, name: str) -> NDArray[np.float64]:
    """Return a read-only array of any shape, whose numbers are 0 or of sane magnitude."""
    numbers = np.array(_gate.numbers(value, name))
    magnitude = np.abs(numbers)
    # Negated, so that NaN fails too.
    sane = (magnitude >= MIN_GRASP_MAGNITUDE) & (magnitude <= MAX_GRASP_MAGNITUDE)
    bad = ~((magnitude == 0) | sane)
    if bad.any():
        first = tuple(np.argwhere(bad)[0])
        problem = (
            f"must be finite, and 0 or between {MIN_GRASP_MAGNITUDE:.3g} and "
            f"{MAX_GRASP_MAGNITUDE:.3g} in magnitude"
        )
        raise PdgError(problem, name, int(first[0]) if first else None, float(numbers[first]))
    return frozen(numbers)


def one_of_kind(value: object, kind: type[Kind], name: str, index: int | None = None) -> Kind:
    """Return the value, an instance of `kind`."""
    if not isinstance(value, kind):
        raise PdgError(f"expected a {kind.__name__}", name, index, value)
    return value


def all_of_kind(values: Iterable[object], kind: type[Kind], name: str) -> list[Kind]:
    """Return the items of an iterable, instances of `kind`."""
    return [one_of_kind(item, kind, name, i) for i, item in enumerate(_gate.items(values, name))]


def frozen(numbers: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the array, made read-only."""
    numbers.flags.writeable = False
    return numbers
