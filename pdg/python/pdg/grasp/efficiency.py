"""Force closure and grasp force efficiency of a wrench set, W or W^a.

Source: [GFE] Eqs. 8 and 16 and the end of section III.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg.distance import PenetrationDistance, penetration_distance
from pdg.errors import PdgError
from pdg.grasp import _gate
from pdg.grasp.wrenches import WrenchSet
from pdg.sets import AffineImage, Ball, ConvexSet, SupportSet, as_convex_set
from pdg.tolerances import (
    ABSOLUTE_TOLERANCE,
    CLOSURE_TOLERANCE,
    MAX_FACETS,
    MAX_ITERATIONS,
)

ClosureState = Literal["closed", "open", "undecided"]
"""Whether a grasp has force closure; see `ForceClosure`."""


@dataclass(frozen=True, slots=True, eq=False)
class ForceClosure:
    """Whether a grasp can balance every wrench of a wrench set's space.

    Attributes
    ----------
    state : {"closed", "open", "undecided"}
        "closed": the origin is proven to be an interior point of the convex hull of the W_i.
        "open": it is proven not to be in that hull, or the hull is flat to within rounding.
        "undecided": the origin is too close to the hull's boundary for doubles to tell, as when a
        contact's force is balanced exactly by none; or the timeout was reached.
    direction : ndarray of shape (D,)
        A unit wrench direction; where "open", one along which no contact can push.
    resistance : float
        Greatest product of `direction` and a wrench of the W_i: 0 or less where "open".
    """

    state: ClosureState
    direction: NDArray[np.float64]
    resistance: float


@dataclass(frozen=True, slots=True, eq=False)
class ForceEfficiency:
    """d_Q of a wrench set with its proof.

    Attributes
    ----------
    lower, upper : float
        Bracket of d_Q: the grasp applies every wrench of lower · Q, and not every one of a larger
        multiple than upper. Without force closure lower is 0; so are both where contacts that must
        not be idle cannot even make the zero wrench.
    direction : ndarray of shape (D,)
        Unit wrench direction u whose h(u)/h_Q(u) is `upper`: where the grasp is weakest.
    dimension : int
        Dimension of the space in which d_Q was taken, that of `WrenchSet.basis`.
    distance : PenetrationDistance
        All that the algorithm says, in coordinates of that basis.
    """

    lower: float
    upper: float
    direction: NDArray[np.float64]
    dimension: int
    distance: PenetrationDistance


def force_closure(wrenches: WrenchSet, timeout: float | None = None) -> ForceClosure:
    """Return whether contacts can balance every wrench, with the direction that shows it.

    A grasp has force closure in the space of its wrenches if the origin is an interior point of
    conv(W_1 ∪ … ∪ W_m). For W^a that means that joint torques alone can make every wrench of its
    minimal subspace ([GFE] end of section III).

    Parameters
    ----------
    wrenches : WrenchSet
        The set of either norm; the answer is the same.
    timeout : float, optional
        Seconds. By default there is no limit.

    Returns
    -------
    ForceClosure
        For the wrenches c_i, M_i as rounded to doubles.

    Raises
    ------
    PdgError
        For a timeout that is negative or no number.
    """
    wrenches = _gate.one_of_kind(wrenches, WrenchSet, "wrenches")
    primitive = WrenchSet(wrenches.centres, wrenches.axes, "l1", False, wrenches.basis)
    ball = Ball(primitive.dimension)
    found = penetration_distance(
        primitive, ball, 0.0, relative_tolerance=CLOSURE_TOLERANCE, timeout=timeout
    )
    resistance, _ = primitive.support(found.direction)
    u = wrenches.basis @ found.direction
    if found.state == "inside" and found.lower > 0:
        return ForceClosure("closed", u, resistance)
    if found.state in ("outside", "flat"):
        return ForceClosure("open", u, resistance)
    return ForceClosure("undecided", u, resistance)


def force_efficiency(
    wrenches: WrenchSet,
    Q: SupportSet | None = None,
    absolute_tolerance: float = ABSOLUTE_TOLERANCE,
    *,
    relative_tolerance: float = 0.0,
    timeout: float | None = None,
    max_iterations: int = MAX_ITERATIONS,
    max_facets: int = MAX_FACETS,
    history: bool = False,
) -> ForceEfficiency:
    """Return d_Q(W), the largest multiple of Q all of whose wrenches the grasp can apply.

    Parameters
    ----------
    wrenches : WrenchSet
        W (`grasp_wrench_set`) or W^a (`active_wrench_set`).
    Q : ConvexSet or SupportSet, optional
        Wrenches of interest, holding the origin, in wrench coordinates (force, torque/length): 6,
        or 3 in the plane. By default the unit ball. If W^a spans fewer dimensions, Q's orthogonal
        projection onto its space is taken.
    absolute_tolerance, relative_tolerance, timeout, max_iterations, max_facets, history : optional
        As for `pdg.penetration_distance`.

    Returns
    -------
    ForceEfficiency
        Proven bounds for the wrenches c_i, M_i as rounded to doubles.

    Raises
    ------
    PdgError
        For a Q of another dimension or without the origin, and as `penetration_distance`.
    """
    basis = _gate.one_of_kind(wrenches, WrenchSet, "wrenches").basis
    distance = penetration_distance(
        wrenches,
        _within(Q, basis),
        absolute_tolerance,
        relative_tolerance=relative_tolerance,
        timeout=timeout,
        max_iterations=max_iterations,
        max_facets=max_facets,
        history=history,
    )
    direction = basis @ distance.direction
    lower, upper = max(0.0, distance.lower), max(0.0, distance.upper)
    return ForceEfficiency(lower, upper, direction, basis.shape[1], distance)


def _within(Q: SupportSet | None, basis: NDArray[np.float64]) -> ConvexSet:
    """Return Q's projection onto the space of the basis, in its coordinates."""
    space, dimension = basis.shape
    if Q is None:
        return Ball(dimension)
    inner = as_convex_set(Q, "Q")
    if inner.dimension != space:
        problem = f"expected a set of {space} dimensions, those of wrenches"
        raise PdgError(problem, "Q", value=inner.dimension)
    return inner if dimension == space else AffineImage(basis.T, inner)
