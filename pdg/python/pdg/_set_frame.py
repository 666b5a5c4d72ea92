"""A linear map under which a convex set is about as wide in every direction.

d_Q(A) = d_MQ(MA) for linear M, so the map costs nothing but its own rounding; scaling by powers of
two has none. It also finds the least subspace that holds A.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pdg import _core
from pdg.tolerances import FLATNESS_UNITS, MOST_ROUNDS, ROUND_ENOUGH, ROUND_ENOUGH_ALONG_AXES


@dataclass(frozen=True, slots=True)
class Frame:
    """Coordinates y = matrix x.

    Attributes
    ----------
    matrix : ndarray of shape (k, n)
        k <= n rows; fewer than n if the set is flat.
    factors : ndarray of shape (n,) or None
        The matrix's diagonal, powers of two, if it is a diagonal one.
    flat : ndarray of shape (n - k, n)
        Unit vectors along which the set has no extent, to within rounding.
    """

    matrix: NDArray[np.float64]
    factors: NDArray[np.float64] | None
    flat: NDArray[np.float64]

    def image(self, core: _core.ConvexSet) -> _core.ConvexSet:
        """Return the set in these coordinates."""
        if self.factors is None:
            return _core.affine_image(self.matrix, np.zeros(len(self.matrix)), core)
        return core if (self.factors == 1).all() else _core.stretched(self.factors, core)


def frame_of(core: _core.ConvexSet) -> Frame:
    """Return coordinates in which the set is about as wide in every direction.

    Widths are taken along the principal axes of support points in 4n directions (from a generator
    with a fixed seed), by a singular value decomposition, until they are within a factor of
    `ROUND_ENOUGH`. The set is flat along those where the width is at most `FLATNESS_UNITS` times
    the rounding error that the set admits to.
    """
    n = core.dimension
    factors = _axis_factors(core)
    matrix = np.diag(factors)
    image = core if (factors == 1).all() else _core.stretched(factors, core)
    flat: list[NDArray[np.float64]] = []
    diagonal = True
    for _ in range(MOST_ROUNDS):
        axes, widths, rounding = _principal_axes(image)
        thin = widths <= FLATNESS_UNITS * rounding
        if thin.any():
            flat.extend(axes[thin] @ matrix)
        elif widths.max() <= ROUND_ENOUGH * widths.min():
            break
        if thin.all():
            matrix = np.zeros((0, n))
            break
        matrix = (axes[~thin] / widths[~thin, np.newaxis]) @ matrix
        diagonal = False
        image = _core.affine_image(matrix, np.zeros(len(matrix)), core)
    return Frame(matrix, factors if diagonal else None, _unit_rows(np.array(flat).reshape(-1, n)))


def _axis_factors(core: _core.ConvexSet) -> NDArray[np.float64]:
    """Return powers of two that make the set about as wide along each coordinate axis."""
    axes = np.eye(core.dimension)
    widths = core.supports(axes)[0] + core.supports(-axes)[0]
    rounding = np.array(core.error())
    thick = widths > FLATNESS_UNITS * rounding
    if not thick.any():
        return np.ones(core.dimension)
    if thick.all() and widths.max() <= ROUND_ENOUGH_ALONG_AXES * widths.min():
        return np.ones(core.dimension)
    widths = np.where(thick, widths, widths[thick].max())
    factors: NDArray[np.float64] = np.exp2(-np.round(np.log2(widths)))
    return factors


def _principal_axes(
    core: _core.ConvexSet,
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return orthonormal axes, one a row, the set's widths along them and the widths' rounding."""
    n = core.dimension
    directions = np.random.default_rng(0).normal(size=(4 * n, n))
    chords = core.supports(directions)[1] - core.supports(-directions)[1]
    axes = np.ascontiguousarray(np.linalg.svd(chords)[2])
    widths = core.supports(axes)[0] + core.supports(-axes)[0]
    return axes, widths, np.abs(axes) @ np.array(core.error())


def _unit_rows(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    unit: NDArray[np.float64] = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    return unit
