"""The C-obstacle query: whether A meets B in every configuration of a cell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg.aliases import RealArray, Rows
from pdg.bodies.body import Body
from pdg.bodies.pieces import convex_pieces
from pdg.depths.batch import Batch

QueryMethod = Literal["per-normal", "displacement", "published"]
"""Which sufficient test `c_obstacle_query` makes."""

CellVerdict = Literal["full", "undecided"]
"""What `c_obstacle_query` says of a cell: proven to lie in the C-obstacle, or nothing."""

# In the order of the core's QueryMethod.
_METHODS: tuple[QueryMethod, ...] = ("published", "displacement", "per-normal")


@dataclass(frozen=True, slots=True)
class CObstacleVerdict:
    """Answer of the C-obstacle query.

    Attributes
    ----------
    verdict : {"full", "undecided"}
        "full" is proven, for the exact doubles given, rounding included. "undecided" claims
        nothing: the cell may be full, mixed or free.
    pair : tuple of int or None
        The pair of convex pieces that proves it, or that came closest; None when no pair's boxes
        meet at the centre.
    margin : float
        Length, positive exactly when full. For the scalar methods PD^t at the centre less the
        motion bound, for "per-normal" a lower bound of PD^t over the whole cell.
    """

    verdict: CellVerdict
    pair: tuple[int, int] | None
    margin: float

    @property
    def full(self) -> bool:
        """Whether the cell is proven to lie in the C-obstacle."""
        return self.verdict == "full"


@dataclass(frozen=True, slots=True, eq=False)
class CObstacleVerdicts(Batch[CObstacleVerdict]):
    """Answers for n cells, one array a field; ``self[i]`` is the `CObstacleVerdict` of row i.

    Attributes
    ----------
    verdict : ndarray of str, shape (n,)
    pair : ndarray of int, shape (n, 2)
        (-1, -1) where no pair's boxes meet at the centre.
    margin : ndarray, shape (n,)
    """

    verdict: NDArray[np.str_]
    pair: NDArray[np.int32]
    margin: NDArray[np.float64]

    @property
    def full(self) -> NDArray[np.bool_]:
        """Whether each cell is proven to lie in the C-obstacle."""
        full: NDArray[np.bool_] = self.verdict == "full"
        return full

    def _row(self, row: int) -> CObstacleVerdict:
        verdict, pair, margin = self._values(row)
        return CObstacleVerdict(verdict, pair if pair[0] >= 0 else None, margin)


@overload
def c_obstacle_query(
    A: Body, B: Body, cell: Sequence[float], method: QueryMethod = ...
) -> CObstacleVerdict: ...
@overload
def c_obstacle_query(
    A: Body, B: Body, cell: Rows, method: QueryMethod = ...
) -> CObstacleVerdicts: ...
@overload
def c_obstacle_query(
    A: Body, B: Body, cell: RealArray, method: QueryMethod = ...
) -> CObstacleVerdict | CObstacleVerdicts: ...
def c_obstacle_query(
    A: Body, B: Body, cell: Sequence[float] | Rows | RealArray, method: QueryMethod = "per-normal"
) -> CObstacleVerdict | CObstacleVerdicts:
    """Try to prove that A and B overlap in every configuration of a cell ([PDG] section 8.1).

    Parameters
    ----------
    A, B : body
        As in `convex_pieces`: polygons, each in its own frame. Pass `ConvexPieces` to decompose
        once for many queries.
    cell : array_like of shape (6,) or (n, 6)
        (x, y, theta, h_x, h_y, h_theta): centre and half-extents, angles in radians. The cell is
        closed; h_theta of pi or more means every orientation. Many rows are done in one call,
        without the interpreter's lock.
    method : {"per-normal", "displacement", "published"}
        "published": the lower bound of PD^g at the centre exceeds [PDG] Eq. 3's bound of the
        cell's motion. "displacement": for some pair, PD^t exceeds the displacement bound with the
        piece's own radius. "per-normal": for some pair, every separating-axis function is
        negative over the whole cell; it proves whatever the other two prove, and more.

    Returns
    -------
    CObstacleVerdict or CObstacleVerdicts
        For one cell or many.

    Raises
    ------
    PdgError
        For a broken polygon, an unknown method, numbers that are not finite and negative
        half-extents (``index`` is the row in a batch).
    """
    code = _METHODS.index(_gate.choice(method, _METHODS, "method"))
    judged = _gate.cells(cell, "cell")
    pieces_a = convex_pieces(A, name="A")
    pieces_b = convex_pieces(B, name="B")
    if isinstance(judged, tuple):
        return _verdict(*_core.c_obstacle_query(pieces_a._native, pieces_b._native, *judged, code))
    full, pairs, margins = _core.c_obstacle_queries(
        pieces_a._native, pieces_b._native, judged, code
    )
    return CObstacleVerdicts(np.where(full, "full", "undecided"), pairs, margins)


def _verdict(full: bool, i: int, j: int, margin: float) -> CObstacleVerdict:
    return CObstacleVerdict("full" if full else "undecided", (i, j) if i >= 0 else None, margin)
