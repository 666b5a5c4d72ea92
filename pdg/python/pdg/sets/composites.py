"""Convex sets that are made of others."""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from pdg import _core, _gate
from pdg.errors import PdgError
from pdg.sets._gate import middle_of
from pdg.sets.convex_set import ConvexSet, SupportSet, as_convex_set


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
        shift = middle_of(offset, len(m), "offset")
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
