"""The C-obstacle query: whether A meets B in every configuration of a cell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from pdg import _core, _gate
from pdg.errors import PdgError
from pdg.pieces import convex_pieces

QueryMethod = Literal["per-normal", "displacement", "published"]
_METHODS = {"published": 0, "displacement": 1, "per-normal": 2}


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

    verdict: Literal["full", "undecided"]
    pair: tuple[int, int] | None
    margin: float

    @property
    def full(self) -> bool:
        """Whether the cell is proven to lie in C-obstacle space."""
        return self.verdict == "full"


def c_obstacle_query(
    A: Any, B: Any, cell: Any, method: QueryMethod = "per-normal"
) -> CObstacleVerdict:
    """Try to prove that A and B overlap in every configuration of a cell ([PDG] section 8.1).

    Parameters
    ----------
    A, B : array_like of shape (n, 2), shapely geometry, GeoJSON-like mapping, WKT or ConvexPieces
        Polygons, each in its own frame. Pass `ConvexPieces` to decompose once for many queries.
    cell : array_like of shape (6,)
        (x, y, theta, h_x, h_y, h_theta): centre and half-extents, angles in radians. The cell is
        closed; h_theta of pi or more means every orientation.
    method : {"per-normal", "displacement", "published"}
        "published": the lower bound of PD^g at the centre exceeds [PDG] Eq. 3's bound of the
        cell's motion. "displacement": for some pair, PD^t exceeds the displacement bound with the
        piece's own radius. "per-normal": for some pair, every separating-axis function is
        negative over the whole cell; it proves whatever the other two prove, and more.

    Returns
    -------
    CObstacleVerdict

    Raises
    ------
    PdgError
        For a broken polygon, an unknown method, numbers that are not finite and negative
        half-extents.
    """
    if method not in _METHODS:
        raise PdgError(f"expected one of {sorted(_METHODS)}", "method", value=method)
    centre, half = _gate.cell(cell, "cell")
    pieces_a = convex_pieces(A, name="A")
    pieces_b = convex_pieces(B, name="B")
    full, i, j, margin = _core.c_obstacle_query(
        pieces_a.core, pieces_b.core, centre, half, _METHODS[method]
    )
    return CObstacleVerdict("full" if full else "undecided", (i, j) if i >= 0 else None, margin)
