"""The active contact forces of one finger, [GFE] Eqs. 9–15, in the contact's frame.

U^a = {f_0 + P x : |x| ≤ 1} (the published P times √Δ) is what the friction cone at f_1 = 1 leaves
of the active force space range(A).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg.tolerances import RANK_TOLERANCE

ForceCase = Literal["none", "point", "ellipsoid"]
"""What friction leaves of the forces that a finger's motors make; see `ActiveForces`."""


@dataclass(frozen=True, slots=True, eq=False)
class ActiveForces:
    """What the motors of a finger can do at its contact, k = 4 force components, or 2 in the plane.

    Attributes
    ----------
    case : {"none", "point", "ellipsoid"}
        Δ < 0 or no active force that pushes: U^a is empty; Δ = 0: one force; Δ > 0: an ellipsoid.
    rank : int
        r: dimension of the active force space.
    discriminant : float
        Δ ≤ 1 of [GFE] Eq. 14: 1 less the least squared share of the friction cone that an active
        force with f_1 = 1 uses. -inf if none has f_1 = 1.
    offset : ndarray of shape (k,)
        f_0; NaN in case "none".
    shape : ndarray of shape (k, j)
        P √Δ; no columns unless the case is "ellipsoid".
    active : ndarray of shape (k, r)
        Columns that span the active force space, which joint torques make.
    passive : ndarray of shape (k, p)
        Columns that span the forces with Jᵀ f = 0: structure alone bears them, at no torque.
    """

    case: ForceCase
    rank: int
    discriminant: float
    offset: NDArray[np.float64]
    shape: NDArray[np.float64]
    active: NDArray[np.float64]
    passive: NDArray[np.float64]


def active_forces(
    jacobian: NDArray[np.float64], free: Sequence[bool], limits: NDArray[np.float64], reach: float
) -> ActiveForces:
    """Return U^a of a finger.

    Parameters
    ----------
    jacobian : ndarray of shape (k, q)
        J, a column for each motion that is not locked.
    free : sequence of q bool
        Motions without a motor: an active force must have no torque there.
    limits : ndarray of shape (k - 1,)
        Semi-axes of the friction ellipsoid at f_1 = 1; where one is 0 the component must be 0.
    reach : float
        Singular values of J below `RANK_TOLERANCE` times this count as zero.
    """
    J = jacobian
    A = column_space(J, reach)
    passive = null_space(J.T, reach)
    loose = column_space(J[:, np.array(free, dtype=bool)], reach)
    A = A @ null_space(loose.T @ A, scale=1.0)
    rank = A.shape[1]
    held = limits == 0
    B = A @ null_space(A[1:][held], scale=1.0)  # active forces whose components friction allows
    case, discriminant, f_0, P = _within_friction(B, limits, ~held)
    return ActiveForces(case, rank, discriminant, f_0, P, A, passive)


def _within_friction(
    A: NDArray[np.float64], limits: NDArray[np.float64], carries: NDArray[np.bool_]
) -> tuple[ForceCase, float, NDArray[np.float64], NDArray[np.float64]]:
    """[GFE] Eqs. 11–15 for orthonormal A: case, Δ, f_0 and P √Δ."""
    k, r = A.shape
    nothing = np.full(k, np.nan), np.zeros((k, 0))
    first = A[0]
    if r == 0 or np.linalg.norm(first) <= RANK_TOLERANCE:
        return "none", -np.inf, *nothing
    c_0 = first / (first @ first)  # A_1⁺
    N = null_space(first[None, :], scale=1.0)
    S = A[1:][carries] / limits[carries][:, None]  # D^{1/2} A_2
    # Q = (S N)ᵀ(S N) = UᵀU by a QR factorisation of S N, which halves the digits lost; the shift
    # -Q⁻¹ b is then the least-squares solution of S N λ = -S c_0, and 1 - Δ its squared residual.
    V, U = np.linalg.qr(S @ N)
    shift = -np.linalg.solve(U, V.T @ (S @ c_0))
    f_0 = A @ (c_0 + N @ shift)
    residual = S @ (c_0 + N @ shift)
    discriminant = 1.0 - float(residual @ residual)
    if discriminant < -RANK_TOLERANCE:
        return "none", discriminant, *nothing
    if discriminant <= RANK_TOLERANCE or r == 1:
        return "point", discriminant, f_0, np.zeros((k, 0))
    return "ellipsoid", discriminant, f_0, np.sqrt(discriminant) * np.linalg.solve(U.T, (A @ N).T).T


def column_space(matrix: NDArray[np.float64], scale: float) -> NDArray[np.float64]:
    """Return orthonormal columns that span the columns of `matrix`, as `null_space` counts them."""
    left, values, _ = np.linalg.svd(matrix, full_matrices=False)
    return np.asarray(left[:, : _rank(values, scale)])


def null_space(matrix: NDArray[np.float64], scale: float) -> NDArray[np.float64]:
    """Return orthonormal columns that span {x : matrix x = 0}.

    Singular values below `RANK_TOLERANCE` times `scale` count as zero: 1 for products of
    orthonormal matrices, which may vanish altogether but for rounding.
    """
    _, values, right = np.linalg.svd(matrix, full_matrices=True)
    return np.asarray(right[_rank(values, scale) :].T)


def _rank(values: NDArray[np.float64], scale: float) -> int:
    return int(np.count_nonzero(values > RANK_TOLERANCE * scale))
