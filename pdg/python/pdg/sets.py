"""Compact convex sets of R^n by support function and support mapping.

A set is known by h(u) = max of u·x over the set and by s(u), a point that attains it ([GFE] Eq.
17). Ready-made sets are compiled; any object with `dimension` and `support` serves as well, but
each question then costs a call into Python.

Source: [GFE] Zheng, Yamane, *Evaluation of Grasp Force Efficiency Considering Hand Configuration
and Using Novel Generalized Penetration Distance Algorithm*, ICRA 2013.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pdg import _core, _gate
from pdg.errors import PdgError
from pdg.tolerances import (
    ACCURACY_SHARES,
    MIN_SET_COORDINATE,
    MOST_DIMENSIONS,
    SUPPORT_ACCURACY,
)

__all__ = [
    "AffineImage",
    "Ball",
    "Box",
    "ConvexSet",
    "CrossPolytope",
    "Ellipsoid",
    "MinkowskiSum",
    "PointSet",
    "Scaled",
    "Segment",
    "SupportSet",
    "UnionHull",
    "as_convex_set",
]


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
        direction = _vector(u, "u", self.dimension, 0.0)
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


class Ellipsoid(ConvexSet):
    """``{centre + axes x : |x| <= 1}``, with ``h(u) = centre·u + |axesᵀ u|``.

    Parameters
    ----------
    axes : array_like of shape (n,) or (n, k)
        Semi-axes along the coordinates, or any matrix. With k < n, or with semi-axes of length 0,
        the ellipsoid is flat: the base of a second-order cone.
    centre : array_like of shape (n,), optional
        The origin by default.

    Raises
    ------
    PdgError
        For numbers that are not finite or do not fit together.
    """

    __slots__ = ()

    def __init__(self, axes: ArrayLike, centre: ArrayLike | None = None) -> None:
        numbers = _gate.numbers(axes, "axes")
        if numbers.ndim == 1:
            radii = _gate.coordinates(numbers, "axes", 1)
            middle = _centre(centre, len(radii))
            self._hold(_core.axis_ellipsoid(radii, middle), radii, middle)
        else:
            matrix = _gate.coordinates(numbers, "axes", 2)
            middle = _centre(centre, len(matrix))
            self._hold(_core.ellipsoid(matrix, middle), matrix, middle)


class Ball(Ellipsoid):
    """``{x : |x - centre| <= radius}``, with ``h(u) = centre·u + radius |u|``.

    Parameters
    ----------
    dimension : int
        n.
    radius : float, optional
        At least 0; 1 by default.
    centre : array_like of shape (n,), optional
        The origin by default.
    """

    __slots__ = ()

    def __init__(
        self, dimension: int, radius: float = 1.0, centre: ArrayLike | None = None
    ) -> None:
        radii = _repeated(dimension, radius, "radius")
        middle = _centre(centre, len(radii))
        self._hold(_core.axis_ellipsoid(radii, middle), len(radii), float(radii[0]), middle)


class Box(ConvexSet):
    """``{centre + x : |x_i| <= half_extents_i}``; ``h(u) = centre·u + Σ half_extents_i |u_i|``.

    Parameters
    ----------
    half_extents : array_like of shape (n,)
        At least 0; a box may be flat.
    centre : array_like of shape (n,), optional
        The origin by default.
    """

    __slots__ = ()

    def __init__(self, half_extents: ArrayLike, centre: ArrayLike | None = None) -> None:
        arrays = _centred(half_extents, "half_extents", centre)
        self._hold(_core.box(*arrays), *arrays)


class CrossPolytope(ConvexSet):
    """The convex hull of ``centre ± radii_i e_i``; ``h(u) = centre·u + max radii_i |u_i|``.

    Parameters
    ----------
    radii : array_like of shape (n,)
        At least 0.
    centre : array_like of shape (n,), optional
        The origin by default.
    """

    __slots__ = ()

    def __init__(self, radii: ArrayLike, centre: ArrayLike | None = None) -> None:
        arrays = _centred(radii, "radii", centre)
        self._hold(_core.cross_polytope(*arrays), *arrays)


class PointSet(ConvexSet):
    """The convex hull of points, with h(u) = max of p·u.

    Parameters
    ----------
    points : array_like of shape (m, n)
        m points, in any order; those inside their hull do no harm.
    """

    __slots__ = ()

    def __init__(self, points: ArrayLike) -> None:
        rows = _gate.coordinates(points, "points", 2)
        self._hold(_core.point_set(rows), rows)


class Segment(PointSet):
    """The segment between two points.

    Parameters
    ----------
    start, end : array_like of shape (n,)
        The points; they may be the same.
    """

    __slots__ = ()

    def __init__(self, start: ArrayLike, end: ArrayLike) -> None:
        p = _gate.coordinates(start, "start", 1)
        q = _vector(end, "end", len(p))
        self._hold(_core.point_set(np.stack([p, q])), p, q)


class MinkowskiSum(ConvexSet):
    """{x_1 + ... + x_m : x_i in A_i}, with h = Σ h_i.

    Parameters
    ----------
    sets : iterable of ConvexSet or SupportSet
        At least one, all of one dimension.
    """

    __slots__ = ()

    def __init__(self, sets: Iterable[SupportSet]) -> None:
        parts = _compiled(sets)
        self._hold(_core.minkowski_sum([part._native for part in parts]), parts)


class UnionHull(ConvexSet):
    """The convex hull of a union, with h = max h_i.

    Parameters
    ----------
    sets : iterable of ConvexSet or SupportSet
        At least one, all of one dimension.
    """

    __slots__ = ()

    def __init__(self, sets: Iterable[SupportSet]) -> None:
        parts = _compiled(sets)
        self._hold(_core.union_hull([part._native for part in parts]), parts)


class AffineImage(ConvexSet):
    """{matrix x + offset : x in A}, with h(u) = h_A(matrixᵀ u) + offset·u.

    Parameters
    ----------
    matrix : array_like of shape (m, n)
        The linear part.
    inner : ConvexSet or SupportSet
        A, of dimension n.
    offset : array_like of shape (m,), optional
        0 by default.
    """

    __slots__ = ()

    def __init__(
        self, matrix: ArrayLike, inner: SupportSet, offset: ArrayLike | None = None
    ) -> None:
        m = _gate.coordinates(matrix, "matrix", 2)
        part = as_convex_set(inner, "inner")
        if m.shape[1] != part.dimension:
            problem = f"expected {part.dimension} columns, the set's dimension"
            raise PdgError(problem, "matrix", value=m.shape)
        shift = _centre(offset, len(m), "offset")
        self._hold(_core.affine_image(m, shift, part._native), m, part, shift)


class Scaled(ConvexSet):
    """{factor x : x in A}; a factor of -1 reflects A in the origin.

    Parameters
    ----------
    factor : float
        Finite, of either sign.
    inner : ConvexSet or SupportSet
        A.
    """

    __slots__ = ()

    def __init__(self, factor: float, inner: SupportSet) -> None:
        (number,) = _gate.coordinates([factor], "factor", 1)
        part = as_convex_set(inner, "inner")
        self._hold(_core.scaled(float(number), part._native), float(number), part)


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
    dimension = _dimension(value.dimension, f"{name}.dimension")
    asked = _Asked(value, name, promised)
    axes = np.eye(dimension)
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
        point = _vector(answer[1], self.name, len(u), 0.0)
        if self.magnitude is not None:
            slack = ACCURACY_SHARES * self.accuracy * float(np.abs(u) @ self.magnitude)
            if abs(float(u @ point) - value) > slack:
                problem = "u·s(u) differs from h(u) by more than the accuracy promised"
                raise PdgError(problem, self.name, value=(value, float(u @ point)))
        return value, point


def _compiled(sets: Iterable[SupportSet]) -> list[ConvexSet]:
    """Return compiled sets of one dimension, at least one."""
    compiled = [
        as_convex_set(inner, f"sets[{i}]") for i, inner in enumerate(_gate.items(sets, "sets"))
    ]
    if not compiled:
        raise PdgError("at least one set is needed", "sets")
    for i, part in enumerate(compiled):
        if part.dimension != compiled[0].dimension:
            problem = f"expected dimension {compiled[0].dimension}, the first set's"
            raise PdgError(problem, "sets", i, part.dimension)
    return compiled


def _dimension(value: object, name: str) -> int:
    if not isinstance(value, int | np.integer) or not 1 <= value <= MOST_DIMENSIONS:
        problem = f"expected an integer between 1 and {MOST_DIMENSIONS}"
        raise PdgError(problem, name, value=value)
    return int(value)


def _repeated(dimension: int, radius: float, name: str) -> NDArray[np.float64]:
    return np.repeat(_not_negative([radius], name), _dimension(dimension, "dimension"))


def _not_negative(value: ArrayLike, name: str) -> NDArray[np.float64]:
    numbers = _gate.coordinates(value, name, 1)
    if (numbers < 0).any():
        i = int(np.flatnonzero(numbers < 0)[0])
        raise PdgError("must not be negative", name, i, float(numbers[i]))
    return numbers


def _centred(
    extents: ArrayLike, name: str, centre: ArrayLike | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return extents along the coordinates and a centre that fits them."""
    numbers = _not_negative(extents, name)
    return numbers, _centre(centre, len(numbers))


def _vector(
    value: ArrayLike, name: str, size: int, smallest: float = MIN_SET_COORDINATE
) -> NDArray[np.float64]:
    numbers = _gate.coordinates(value, name, 1, smallest)
    if len(numbers) != size:
        raise PdgError(f"expected {size} numbers", name, value=numbers.shape)
    return numbers


def _centre(value: ArrayLike | None, size: int, name: str = "centre") -> NDArray[np.float64]:
    return np.zeros(size) if value is None else _vector(value, name, size)
