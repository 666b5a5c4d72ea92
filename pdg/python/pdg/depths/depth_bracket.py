"""PD^g of any two bodies, bracketed to a tolerance by branch and bound over the angle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from pdg import _core, _gate
from pdg.bodies.pieces import convex_pieces
from pdg.depths.batch import Batch
from pdg.depths.upper_bounds import ConvexSeparators
from pdg.errors import PdgError
from pdg.tolerances import MOST_COUNTED

if TYPE_CHECKING:
    from numpy.typing import NDArray

Pose = tuple[float, float, float]
StopReason = Literal["tolerance", "time", "nodes", "rounding"]
_REASONS: tuple[StopReason, ...] = ("tolerance", "time", "nodes", "rounding")
_HERE = (0.0, 0.0, 0.0)


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


@dataclass(frozen=True, slots=True, eq=False)
class DepthBrackets(Batch[DepthBracket]):
    """Brackets of PD^g for n poses, one array a field; ``self[i]`` is the `DepthBracket` of row i.

    Attributes
    ----------
    lo, hi, distance_hi : ndarray, shape (n,)
    pose, distance_pose : ndarray, shape (n, 3)
    nodes, slices : ndarray of int, shape (n,)
    stopped : ndarray of str, shape (n,)
    """

    lo: NDArray[np.float64]
    hi: NDArray[np.float64]
    pose: NDArray[np.float64]
    distance_hi: NDArray[np.float64]
    distance_pose: NDArray[np.float64]
    nodes: NDArray[np.uint64]
    slices: NDArray[np.uint64]
    stopped: NDArray[np.str_]

    def _row(self, row: int) -> DepthBracket:
        return DepthBracket(*self._values(row))


@overload
def bracket(
    A: Any,
    B: Any,
    pose: Sequence[float] = ...,
    rel_tol: float = ...,
    *,
    time_limit: float | None = ...,
    node_limit: int | None = ...,
) -> DepthBracket: ...
@overload
def bracket(
    A: Any,
    B: Any,
    pose: Any,
    rel_tol: float = ...,
    *,
    time_limit: float | None = ...,
    node_limit: int | None = ...,
) -> Any: ...
def bracket(
    A: Any,
    B: Any,
    pose: Any = _HERE,
    rel_tol: float = 1e-3,
    *,
    time_limit: float | None = None,
    node_limit: int | None = None,
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
        `generalized_depth_upper_bound`, so that `hi` is no more than that bound.
    pose : array_like of shape (3,) or (n, 3)
        Configuration (x, y, theta) of A, theta in radians. Many rows are done in one call, without
        the interpreter's lock.
    rel_tol : float
        The search ends when hi - lo <= rel_tol * hi.
    time_limit : float, optional
        Seconds, for each pose, after which it ends; looked at between nodes.
    node_limit : int, optional
        Nodes, for each pose, after which it ends. Even 0 gives a bracket.

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
    prepared = isinstance(B, ConvexSeparators)
    pieces_b = B.pieces if prepared else convex_pieces(B, name="B")
    separators = B.core if prepared else None
    q = _gate.poses(pose, "pose")
    tolerance = _gate.length(rel_tol, "rel_tol")
    seconds = math.inf if time_limit is None else _gate.seconds(time_limit, "time_limit")
    nodes = MOST_COUNTED if node_limit is None else _gate.count(node_limit, "node_limit")
    rows = np.atleast_2d(np.asarray(q))
    bad, numbers, counts, ends = _core.bracket_depths(
        pieces_a.core, pieces_b.core, separators, rows, tolerance, seconds, nodes
    )
    if bad >= 0:
        problem = "places the body outside the range of exact arithmetic"
        raise PdgError(problem, "pose", None if isinstance(q, tuple) else bad, rows[bad].tolist())
    brackets = DepthBrackets(
        numbers[:, 0],
        numbers[:, 1],
        numbers[:, 2:5],
        numbers[:, 5],
        numbers[:, 6:9],
        counts[:, 0],
        counts[:, 1],
        np.array(_REASONS)[ends],
    )
    return brackets[0] if isinstance(q, tuple) else brackets
