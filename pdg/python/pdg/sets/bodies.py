"""Convex sets that a few numbers describe."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pdg import _core, _gate
from pdg.sets._gate import centred, middle_of, repeated, vector
from pdg.sets.convex_set import ConvexSet


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
            middle = middle_of(centre, len(radii))
            self._hold(_core.axis_ellipsoid(radii, middle), radii, middle)
        else:
            matrix = _gate.coordinates(numbers, "axes", 2)
            middle = middle_of(centre, len(matrix))
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
        radii = repeated(dimension, radius, "radius")
        middle = middle_of(centre, len(radii))
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
        arrays = centred(half_extents, "half_extents", centre)
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
        arrays = centred(radii, "radii", centre)
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
        q = vector(end, "end", len(p))
        self._hold(_core.point_set(np.stack([p, q])), p, q)
