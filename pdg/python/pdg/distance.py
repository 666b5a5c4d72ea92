"""The generalized penetration distance of a convex set, in any dimension.

Source: [GFE] Zheng, Yamane, *Evaluation of Grasp Force Efficiency Considering Hand Configuration
and Using Novel Generalized Penetration Distance Algorithm*, ICRA 2013.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg._set_frame import Frame, frame_of
from pdg.errors import PdgError
from pdg.sets import SupportSet, as_convex_set
from pdg.stop_reason import StopReason
from pdg.tolerances import (
    ABSOLUTE_TOLERANCE,
    MAX_FACETS,
    MAX_ITERATIONS,
    MAX_SET_COORDINATE,
)

OriginState = Literal["inside", "boundary", "outside", "flat"]
"""Where the origin is with respect to a convex set; see `PenetrationDistance`."""

_STATES: tuple[OriginState, ...] = ("inside", "boundary", "outside", "flat")
# In the order of the core's StopReason.
_ENDS = (
    StopReason.CONVERGED,
    StopReason.MAX_ITERATIONS,
    StopReason.MAX_FACETS,
    StopReason.TIMEOUT,
    StopReason.ROUNDING,
)


@dataclass(frozen=True, slots=True, eq=False)
class PenetrationDistance:
    """A bracket of d_Q(A).

    Attributes
    ----------
    state : {"inside", "boundary", "outside", "flat"}
        Where the origin is. "inside": A's interior (relative to its own subspace where
        ``dimension`` is less than the space's). "boundary": so near A's boundary that rounding
        decides on which side; lower is 0. "outside": proved, h_A(direction) < 0, so that no
        multiple of Q is in A, and both bounds are -inf. "flat": A lies in a hyperplane that Q
        leaves, so that d_Q(A) = 0.
    lower, upper : float
        ``lower <= d_Q(A) <= upper``, rounding included.
    direction : ndarray of shape (n,)
        A unit vector u with h_A(u) / h_Q(u) <= upper.
    point : ndarray of shape (n,)
        s_A(u), a point of A farthest along u.
    iterations : int
        Support points added to the first simplex.
    facets : int
        Facets of the last polytope.
    stop_reason : StopReason
        CONVERGED, TIMEOUT, MAX_ITERATIONS, MAX_FACETS or ROUNDING.
    dimension : int
        The dimension of the space that the computation took place in: less than n if A is flat.
    history : tuple of (lower, upper, facets)
        One bracket an iteration, in plain doubles; empty unless asked for.
    """

    state: OriginState
    lower: float
    upper: float
    direction: NDArray[np.float64]
    point: NDArray[np.float64]
    iterations: int
    facets: int
    stop_reason: StopReason
    dimension: int
    history: tuple[tuple[float, float, int], ...] = ()


def penetration_distance(
    A: SupportSet,
    Q: SupportSet,
    absolute_tolerance: float = ABSOLUTE_TOLERANCE,
    *,
    relative_tolerance: float = 0.0,
    timeout: float | None = None,
    max_iterations: int = MAX_ITERATIONS,
    max_facets: int = MAX_FACETS,
    history: bool = False,
) -> PenetrationDistance:
    """Return a bracket of d_Q(A), the largest l >= 0 with l Q inside A.

    d_Q(A) = min over unit u of h_A(u) / h_Q(u) ([GFE] Eq. 16 and Proposition 1). A polytope in A
    is grown by the support point beyond the facet that bounds l Q most ([GFE] Algorithm 1). With
    Q the unit ball this is the distance from the origin to A's boundary; with A = {b - a} besides,
    the translational penetration depth of two convex bodies; with Q a segment from the origin it
    is ray shooting.

    Parameters
    ----------
    A, Q : ConvexSet or SupportSet
        Compact convex sets of one dimension n; see `pdg.sets`. Q holds the origin and may be of
        lower dimension or have the origin on its boundary. Calls into Python are slow.
    absolute_tolerance : float, optional
        The search ends when ``upper - lower <= absolute_tolerance``, as in the paper (its ε).
    relative_tolerance : float, optional
        It also ends when ``upper - lower <= relative_tolerance * upper``.
    timeout : float, optional
        Seconds. By default there is no limit.
    max_iterations, max_facets : int, optional
        Limits of work and, at some 200 bytes a facet, memory.
    history : bool, optional
        Whether to keep each iteration's bracket.

    Returns
    -------
    PenetrationDistance
        The bounds hold for the exact sets that the input doubles describe. If A is flat and spans
        the same subspace as Q, they hold for the sets' projections onto it, which differ from the
        sets by rounding; A counts as flat along u where its width is within 8 times the rounding
        error of its support function.

    Raises
    ------
    PdgError
        For arguments that are no convex sets of one dimension, a Q without the origin, and limits
        that are not numbers >= 0.
    """
    a = as_convex_set(A, "A")._native
    q = as_convex_set(Q, "Q")._native
    _check_sets(a, q)
    tolerances = (
        _gate.length(absolute_tolerance, "absolute_tolerance"),
        _gate.length(relative_tolerance, "relative_tolerance"),
    )
    limits = (_gate.count(max_iterations, "max_iterations"), _gate.count(max_facets, "max_facets"))
    seconds = math.inf if timeout is None else _gate.seconds(timeout, "timeout")
    steps_wanted = _gate.flag(history, "history")
    frame = frame_of(a)
    found = _beside_subspace(a, q, frame)
    if found is not None:
        return found
    state, end, lower, upper, direction, _, iterations, facets, steps = _core.penetration_distance(
        frame.image(a), frame.image(q), *tolerances, *limits, seconds, steps_wanted
    )
    u = _unit(np.array(direction) @ frame.matrix)
    return PenetrationDistance(
        _STATES[state],
        lower,
        upper,
        u,
        a.supports(u[np.newaxis])[1][0],
        iterations,
        facets,
        _ENDS[end],
        len(frame.matrix),
        tuple(steps),
    )


def _beside_subspace(
    a: _core.ConvexSet, q: _core.ConvexSet, frame: Frame
) -> PenetrationDistance | None:
    """Return the answer if A is flat and the origin, or Q, is not in its subspace."""
    both = np.concatenate([frame.flat, -frame.flat])
    if len(both) == 0:
        return None
    h_a, points = a.supports(both)
    h_q, _ = q.supports(both)
    rounding_a = np.abs(both) @ np.array(a.error())
    rounding_q = np.abs(both) @ np.array(q.error())
    worst = int(np.argmin(h_a + rounding_a))
    if h_a[worst] < -rounding_a[worst]:
        answer = (-math.inf, -math.inf)
        return PenetrationDistance(
            "outside",
            *answer,
            both[worst],
            points[worst],
            0,
            0,
            StopReason.CONVERGED,
            len(frame.matrix),
        )
    beyond = h_q - rounding_a - 2 * rounding_q
    steepest = int(np.argmax(beyond))
    if beyond[steepest] > 0:
        upper = max(0.0, _core.upper_bound_along(a, q, both[steepest].tolist()))
        return PenetrationDistance(
            "flat",
            0.0,
            upper,
            both[steepest],
            points[steepest],
            0,
            0,
            StopReason.CONVERGED,
            len(frame.matrix),
        )
    if len(frame.matrix) == 0:  # both sets are the origin
        return PenetrationDistance(
            "flat", 0.0, math.inf, both[0], points[0], 0, 0, StopReason.ROUNDING, 0
        )
    return None


def _check_sets(a: _core.ConvexSet, q: _core.ConvexSet) -> None:
    if a.dimension != q.dimension:
        raise PdgError(f"expected dimension {a.dimension}, that of A", "Q", value=q.dimension)
    for core, name in ((a, "A"), (q, "Q")):
        largest = max(core.magnitude())
        if not largest <= MAX_SET_COORDINATE:
            problem = f"must extend to {MAX_SET_COORDINATE:.3g} at most"
            raise PdgError(problem, name, value=largest)
    if not any(q.magnitude()):
        raise PdgError("is the origin alone: any multiple of it is in A", "Q")
    axes = np.concatenate([np.eye(q.dimension), -np.eye(q.dimension)])
    values = q.supports(axes)[0]
    if (values < -np.tile(q.error(), 2)).any():
        raise PdgError("must hold the origin", "Q", value=float(values.min()))


def _unit(u: NDArray[np.float64]) -> NDArray[np.float64]:
    unit: NDArray[np.float64] = u / np.linalg.norm(u)
    return unit
