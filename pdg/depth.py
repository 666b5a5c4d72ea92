"""Penetration depths of two bodies, A placed at a configuration and B fixed.

Source: [PDG] Zhang, Kim, Varadhan, Manocha, *Generalized Penetration Depth Computation*, 2006.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from pdg import _core, _gate
from pdg.pieces import convex_pieces, one_convex_piece

Point = tuple[float, float]
PairState = Literal["apart", "touching", "overlap"]
_STATES: tuple[PairState, PairState, PairState] = ("apart", "touching", "overlap")


@dataclass(frozen=True, slots=True)
class TranslationalDepth:
    """PD^t of two convex bodies with its witness, in B's frame and unit of length.

    Attributes
    ----------
    state : {"apart", "touching", "overlap"}
        Decided exactly for the vertices as placed in doubles.
    depth : float
        Overlap: PD^t; touching: 0; apart: minus the distance.
    direction : tuple of float
        Unit vector; moving A by ``depth * direction`` makes the two touch.
    on_a, on_b : tuple of float
        The point of A that then meets the point of B: ``on_b = on_a + depth * direction``.
    """

    state: PairState
    depth: float
    direction: Point
    on_a: Point
    on_b: Point


@dataclass(frozen=True, slots=True)
class DepthLowerBound:
    """A lower bound of PD^g with the pair of convex pieces that attains it.

    Attributes
    ----------
    depth : float
        The bound (length); 0 when no pair of pieces overlaps.
    pair : tuple of int or None
        Indices of the deepest pair in the bodies' convex pieces.
    witness : TranslationalDepth or None
        That pair's PD^t.
    """

    depth: float
    pair: tuple[int, int] | None
    witness: TranslationalDepth | None


def translational_depth(A: Any, B: Any, pose: Any = (0.0, 0.0, 0.0)) -> TranslationalDepth:
    """Return the translational penetration depth PD^t of two convex polygons.

    PD^t is the length of the shortest translation of A that leaves the interiors disjoint ([PDG]
    Eq. 1); in the plane it is minus the greatest separating-axis function over both polygons'
    edges. Disjoint polygons get minus their distance.

    Parameters
    ----------
    A, B : array_like of shape (n, 2), shapely geometry, GeoJSON-like mapping, WKT or ConvexPieces
        Convex polygons, each in its own frame.
    pose : array_like of shape (3,)
        Configuration (x, y, theta) of A: rotation by theta (radians) about its frame's origin,
        then translation.

    Returns
    -------
    TranslationalDepth
        In plain doubles; the error is some ten roundings of the largest coordinate.

    Raises
    ------
    PdgError
        For a polygon that is not convex or is broken, and a pose that is not three finite numbers.
    """
    pieces_a = one_convex_piece(A, "A")
    pieces_b = one_convex_piece(B, "B")
    q = _gate.triple(pose, "pose")
    return _depth(_core.translational_depth(pieces_a.core, pieces_b.core, q))


def generalized_depth_lower_bound(A: Any, B: Any, pose: Any = (0.0, 0.0, 0.0)) -> DepthLowerBound:
    """Return a lower bound of the generalized penetration depth PD^g of two bodies.

    The bound is the maximum of PD^t over pairs of convex pieces ([PDG] section 6.1). It holds
    under the arc-length metric D_g and under the displacement metric DISP. Pairs whose boxes miss
    each other are dropped by a bounding-volume hierarchy.

    Parameters
    ----------
    A, B : array_like of shape (n, 2), shapely geometry, GeoJSON-like mapping, WKT or ConvexPieces
        Any polygons. Pass `ConvexPieces` to decompose once for many queries.
    pose : array_like of shape (3,)
        Configuration (x, y, theta) of A, theta in radians.

    Returns
    -------
    DepthLowerBound
        In plain doubles. Depth 0 does not mean that the bodies are apart by any distance.

    Raises
    ------
    PdgError
        For a broken polygon, and a pose that is not three finite numbers.
    """
    pieces_a = convex_pieces(A, name="A")
    pieces_b = convex_pieces(B, name="B")
    q = _gate.triple(pose, "pose")
    depth, i, j, pair = _core.generalized_depth_lower_bound(pieces_a.core, pieces_b.core, q)
    if i < 0:
        return DepthLowerBound(0.0, None, None)
    return DepthLowerBound(depth, (i, j), _depth(pair))


def _depth(result: tuple[int, float, Point, Point, Point]) -> TranslationalDepth:
    state, depth, direction, on_a, on_b = result
    return TranslationalDepth(_STATES[state], depth, direction, on_a, on_b)
