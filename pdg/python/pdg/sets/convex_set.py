"""What a convex set is, compiled or a caller's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pdg import _core, _gate
from pdg.errors import PdgError
from pdg.sets._gate import dimension, vector
from pdg.tolerances import ACCURACY_SHARES, SUPPORT_ACCURACY


@runtime_checkable
class SupportSet(Protocol):
    """What a caller's own convex set must have.

    Attributes
    ----------
    dimension : int
        n >= 1.
    """

    @property
    def dimension(self) -> int:
        """The number of coordinates, n."""
        ...

    def support(self, u: NDArray[np.float64], /) -> tuple[float, ArrayLike]:
        """Return h(u) and a point s(u) of shape (n,) of the set with u·s(u) = h(u)."""
        ...


class ConvexSet:
    """A compiled convex set; immutable. Made by its subclasses and by `as_convex_set`.

    Pickling keeps what the set was made of, from which it is compiled again; a caller's own set
    must itself be one that pickles.
    """

    __slots__ = ("_arguments", "_native")

    _native: _core.ConvexSet
    _arguments: tuple[object, ...]

    def __init__(self) -> None:
        raise TypeError("a ConvexSet is made by its subclasses and by pdg.sets.as_convex_set")

    def _hold(self, native: _core.ConvexSet, *arguments: object) -> None:
        """Keep the compiled set and the arguments that make it anew, its arrays copied."""
        self._native = native
        self._arguments = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in arguments)

    def __reduce__(self) -> tuple[Callable[..., ConvexSet], tuple[object, ...]]:
        return type(self), self._arguments

    @property
    def dimension(self) -> int:
        """The number of coordinates, n."""
        return self._native.dimension

    def support(self, u: ArrayLike) -> tuple[float, NDArray[np.float64]]:
        """Return h(u) and s(u), of shape (n,), for a direction u of any length."""
        direction = vector(u, "u", self.dimension, 0.0)
        values, points = self._native.supports(direction[np.newaxis])
        return float(values[0]), points[0]

    def supports(self, directions: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return h, of shape (m,), and s, of shape (m, n), for m directions at once.

        Raises
        ------
        PdgError
            For directions that are not finite numbers of shape (m, n).
        """
        u = _gate.coordinates(directions, "directions", 2, 0.0)
        if u.shape[1] != self.dimension:
            raise PdgError(f"expected {self.dimension} coordinates", "directions", value=u.shape)
        return self._native.supports(u)

    def __repr__(self) -> str:
        return f"{type(self).__name__}(dimension={self.dimension})"


def as_convex_set(
    value: SupportSet, name: str = "value", accuracy: float = SUPPORT_ACCURACY
) -> ConvexSet:
    """Return the compiled set that `value` is, or one that asks `value` through its protocol.

    Parameters
    ----------
    value : ConvexSet or SupportSet
        A set of this module, or any object with `dimension` and `support`.
    name : str, optional
        What errors call the argument.
    accuracy : float, optional
        What a `SupportSet` promises: points and values are right to this times the set's extent
        along each coordinate. Bounds built on the set rely on it.

    Returns
    -------
    ConvexSet
        `value` itself if it is one.

    Raises
    ------
    PdgError
        If `value` is neither; later, during use, if its answers are no numbers of the right shape
        or break u·s(u) = h(u).
    """
    promised = _gate.length(accuracy, "accuracy")
    if isinstance(value, ConvexSet):
        return value
    if not isinstance(value, SupportSet):
        raise PdgError("expected a convex set: .dimension and .support(u)", name, value=value)
    n = dimension(value.dimension, f"{name}.dimension")
    asked = _Asked(value, name, promised)
    axes = np.eye(n)
    magnitude = [max(abs(asked(u)[0]), abs(asked(-u)[0])) for u in axes]
    asked.magnitude = np.array(magnitude)
    found = object.__new__(_CallersSet)
    native = _core.python_set(asked, magnitude, [promised * m for m in magnitude])
    found._hold(native, value, name, promised)
    return found


class _CallersSet(ConvexSet):
    """A set that asks a caller's object."""

    __slots__ = ()

    def __reduce__(self) -> tuple[Callable[..., ConvexSet], tuple[object, ...]]:
        return as_convex_set, self._arguments

    def __repr__(self) -> str:
        return f"ConvexSet({self._arguments[0]!r})"


class _Asked:
    """A caller's set, each of its answers checked."""

    def __init__(self, inner: SupportSet, name: str, accuracy: float) -> None:
        self.inner = inner
        self.name = f"{name}.support(u)"
        self.accuracy = accuracy
        self.magnitude: NDArray[np.float64] | None = None

    def __call__(self, u: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        answer = self.inner.support(u)
        if not isinstance(answer, tuple) or len(answer) != 2:
            raise PdgError("must return a value and a point", self.name, value=answer)
        value = float(_gate.coordinates([answer[0]], self.name, 1, 0.0)[0])
        point = vector(answer[1], self.name, len(u), 0.0)
        if self.magnitude is not None:
            slack = ACCURACY_SHARES * self.accuracy * float(np.abs(u) @ self.magnitude)
            if abs(float(u @ point) - value) > slack:
                problem = "u·s(u) differs from h(u) by more than the accuracy promised"
                raise PdgError(problem, self.name, value=(value, float(u @ point)))
        return value, point
