"""PD^g of any two bodies, bracketed to a tolerance by branch and bound over the angle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

from pdg import _core, _gate
from pdg.errors import PdgError
from pdg.pieces import convex_pieces
from pdg.upper_bounds import ConvexSeparators

Pose = tuple[float, float, float]
StopReason = Literal["tolerance", "time", "nodes", "rounding"]
_REASONS: tuple[StopReason, ...] = ("tolerance", "time", "nodes", "rounding")
_MOST_NODES = 2**63


@dataclass(frozen=True, slots=True)
class DepthBracket:
    """lo <= PD^g <= hi under DISP, and lo <= PD^g <= distance_hi under D_g.

    Attributes
    ----------
    lo, hi : float
        Bounds of PD^g under the displacement metric DISP (length); both 0 where the interiors do
        not meet. `lo` holds for the exact geometry of the doubles given.
    pose : tuple of float
        A free configuration (x, y, theta) with DISP(q, pose) <= hi: the exact test finds no
        interiors of pieces meeting, for A's vertices as placed in doubles.
    distance_hi : float
        Upper bound of PD^g under D_g; `lo` is its lower bound, as DISP <= D_g.
    distance_pose : tuple of float
        A free configuration whose D_g from q is at most that.
    nodes, slices : int
        Ranges of angles judged, and Minkowski slices made.
    stopped : {"tolerance", "time", "nodes", "rounding"}
        Why the search ended; "rounding": the doubles allow no narrower bracket.
    """

    lo: float
    hi: float
    pose: Pose
    distance_hi: float
    distance_pose: Pose
    nodes: int
    slices: int
    stopped: StopReason


def bracket(
    A: Any,
    B: Any,
    pose: Any = (0.0, 0.0, 0.0),
    rel_tol: float = 1e-3,
    *,
    time_limit: float | None = None,
    node_limit: int | None = None,
) -> DepthBracket:
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
        `generalized_depth_upper_bound`, so that `hi` is no more than that bound.
    pose : array_like of shape (3,)
        Configuration (x, y, theta) of A, theta in radians.
    rel_tol : float
        The search ends when hi - lo <= rel_tol * hi.
    time_limit : float, optional
        Seconds after which it ends; looked at between nodes.
    node_limit : int, optional
        Nodes after which it ends. Even 0 gives a bracket.

    Returns
    -------
    DepthBracket

    Raises
    ------
    PdgError
        For a broken polygon, a pose that is not three finite numbers, and limits that are negative
        or not numbers.
    """
    pieces_a = convex_pieces(A, name="A")
    prepared = isinstance(B, ConvexSeparators)
    pieces_b = B.pieces if prepared else convex_pieces(B, name="B")
    separators = B.core if prepared else None
    q = _gate.triple(pose, "pose")
    tolerance = _gate.length(rel_tol, "rel_tol")
    seconds = math.inf if time_limit is None else _gate.length(time_limit, "time_limit")
    nodes = _MOST_NODES if node_limit is None else _whole(node_limit, "node_limit")
    try:
        found = _core.bracket_depth(
            pieces_a.core, pieces_b.core, separators, q, tolerance, seconds, nodes
        )
    except ValueError as error:
        raise PdgError(str(error), "pose", value=q) from error
    lo, (hi, free), (distance_hi, distance_free), judged, slices, end = found
    return DepthBracket(lo, hi, free, distance_hi, distance_free, judged, slices, _REASONS[end])


def _whole(value: object, name: str) -> int:
    if not isinstance(value, int) or value < 0:
        raise PdgError("expected a whole number >= 0", name, value=value)
    return min(value, _MOST_NODES)
