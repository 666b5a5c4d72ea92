"""PD^g of any two bodies, bracketed to a tolerance by branch and bound over the angle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg.aliases import Pose, RealArray, Rows
from pdg.bodies.body import Body
from pdg.bodies.pieces import convex_pieces
from pdg.depths.batch import Batch
from pdg.depths.upper_bounds import ConvexSeparators
from pdg.stop_reason import StopReason
from pdg.tolerances import MOST_COUNTED

# In the order of the core's BracketEnd.
_ENDS = (StopReason.CONVERGED, StopReason.TIMEOUT, StopReason.MAX_NODES, StopReason.ROUNDING)


@dataclass(frozen=True, slots=True)
class DepthBracket:
    """lower <= PD^g <= upper under DISP, and lower <= PD^g <= distance_upper under D_g.

    Attributes
    ----------
    lower, upper : float
        Bounds of PD^g under the displacement metric DISP (length); both 0 where the interiors do
        not meet. `lower` holds for the exact geometry of the doubles given.
    pose : tuple of float
        A free configuration (x, y, theta) with DISP(q, pose) <= upper: the exact test finds no
        interiors of pieces meeting, for A's vertices as placed in doubles.
    distance_upper : float
        Upper bound of PD^g under D_g; `lower` is its lower bound, as DISP <= D_g.
    distance_pose : tuple of float
        A free configuration whose D_g from q is at most `distance_upper`.
    nodes, slices : int
        Ranges of angles judged, and Minkowski slices made.
    stop_reason : StopReason
        CONVERGED, TIMEOUT, MAX_NODES or ROUNDING.
    """

    lower: float
    upper: float
    pose: Pose
    distance_upper: float
    distance_pose: Pose
    nodes: int
    slices: int
    stop_reason: StopReason


@dataclass(frozen=True, slots=True, eq=False)
class DepthBrackets(Batch[DepthBracket]):
    """Brackets of PD^g for n poses, one array a field; ``self[i]`` is the `DepthBracket` of row i.

    Attributes
    ----------
    lower, upper, distance_upper : ndarray, shape (n,)
    pose, distance_pose : ndarray, shape (n, 3)
    nodes, slices : ndarray of int, shape (n,)
    stop_reason : ndarray of str, shape (n,)
        Values of `StopReason`.
    """

    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    pose: NDArray[np.float64]
    distance_upper: NDArray[np.float64]
    distance_pose: NDArray[np.float64]
    nodes: NDArray[np.uint64]
    slices: NDArray[np.uint64]
    stop_reason: NDArray[np.str_]

    def _row(self, row: int) -> DepthBracket:
        *values, stop_reason = self._values(row)
        return DepthBracket(*[*values, StopReason(stop_reason)])


@overload
def generalized_depth_bracket(
    A: Body,
    B: Body | ConvexSeparators,
    pose: Sequence[float] = ...,
    relative_tolerance: float = ...,
    *,
    timeout: float | None = ...,
    max_nodes: int | None = ...,
) -> DepthBracket: ...
@overload
def generalized_depth_bracket(
    A: Body,
    B: Body | ConvexSeparators,
    pose: Rows,
    relative_tolerance: float = ...,
    *,
    timeout: float | None = ...,
    max_nodes: int | None = ...,
) -> DepthBrackets: ...
@overload
def generalized_depth_bracket(
    A: Body,
    B: Body | ConvexSeparators,
    pose: RealArray,
    relative_tolerance: float = ...,
    *,
    timeout: float | None = ...,
    max_nodes: int | None = ...,
) -> DepthBracket | DepthBrackets: ...
def generalized_depth_bracket(
    A: Body,
    B: Body | ConvexSeparators,
    pose: Sequence[float] | Rows | RealArray = _gate.HERE,
    relative_tolerance: float = 1e-3,
    *,
    timeout: float | None = None,
    max_nodes: int | None = None,
) -> DepthBracket | DepthBrackets:
    """Bracket the generalized penetration depth PD^g of two bodies.

    PD^g is the least distance of a free configuration of A from the given one ([PDG] Eq. 5);
    DISP, the greatest distance between a point of A at both, is the metric bracketed, and its
    optimum bounds PD^g under D_g too. At one angle the least DISP is found exactly, outside the
    Minkowski sums of the bodies' convex pieces. Over a range of angles the same is done outside
    what stays covered throughout, less the motion of A by turning. The range with the least lower
    bound is halved until the bracket is narrow enough.

    Parameters
    ----------
    A, B : body
        As in `convex_pieces`: any polygons. Pass `ConvexPieces` to decompose once for many queries.
        B may be `ConvexSeparators`: the search then begins with the free poses of
        `generalized_depth_upper_bound`, so that `upper` is no more than that bound.
    pose : array_like of shape (3,) or (n, 3)
        Configuration (x, y, theta) of A, theta in radians. Many rows are done in one call, without
        the interpreter's lock.
    relative_tolerance : float
        The search ends when upper - lower <= relative_tolerance * upper.
    timeout : float, optional
        Seconds for each pose; the clock is read between nodes. By default there is no limit.
    max_nodes : int, optional
        Ranges of angles judged for each pose. Even 0 gives a bracket. By default there is no limit.

    Returns
    -------
    DepthBracket or DepthBrackets
        For one pose or many.

    Raises
    ------
    PdgError
        For a broken polygon, a pose that is not three finite numbers (``index`` is its row in a
        batch), and limits that are negative or not numbers.
    """
    pieces_a = convex_pieces(A, name="A")
    if isinstance(B, ConvexSeparators):
        pieces_b, separators = B.pieces, B._native
    else:
        pieces_b, separators = convex_pieces(B, name="B"), None
    q = _gate.poses(pose, "pose")
    tolerance = _gate.length(relative_tolerance, "relative_tolerance")
    seconds = math.inf if timeout is None else _gate.seconds(timeout, "timeout")
    nodes = MOST_COUNTED if max_nodes is None else _gate.count(max_nodes, "max_nodes")
    rows = np.atleast_2d(np.asarray(q))
    bad, numbers, counts, ends = _core.bracket_depths(
        pieces_a._native, pieces_b._native, separators, rows, tolerance, seconds, nodes
    )
    _gate.check_placed(bad, rows, isinstance(q, tuple))
    brackets = DepthBrackets(
        numbers[:, 0],
        numbers[:, 1],
        numbers[:, 2:5],
        numbers[:, 5],
        numbers[:, 6:9],
        counts[:, 0],
        counts[:, 1],
        np.array(_ENDS)[ends],
    )
    return brackets[0] if isinstance(q, tuple) else brackets
