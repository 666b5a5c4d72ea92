"""Penetration depths of two bodies, A placed at a configuration and B fixed.

Source: [PDG] Zhang, Kim, Varadhan, Manocha, *Generalized Penetration Depth Computation*, 2006.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

import numpy as np

from pdg import _core, _gate
from pdg.aliases import RealArray, Rows
from pdg.bodies.body import Body
from pdg.bodies.pieces import convex_pieces
from pdg.depths.results import (
    NO_PAIR,
    DepthLowerBound,
    DepthLowerBounds,
    TranslationalDepth,
    TranslationalDepths,
    many_depths,
    one_depth,
)


@overload
def translational_depth(A: Body, B: Body, pose: Sequence[float] = ...) -> TranslationalDepth: ...
@overload
def translational_depth(A: Body, B: Body, pose: Rows) -> TranslationalDepths: ...
@overload
def translational_depth(
    A: Body, B: Body, pose: RealArray
) -> TranslationalDepth | TranslationalDepths: ...
def translational_depth(
    A: Body, B: Body, pose: Sequence[float] | Rows | RealArray = _gate.HERE
) -> TranslationalDepth | TranslationalDepths:
    """Return the translational penetration depth PD^t of two bodies.

    PD^t is the length of the shortest translation of A that leaves the interiors disjoint ([PDG]
    Eq. 1). Of convex bodies it is minus the greatest separating-axis function over both polygons'
    edges. Of others it is found outside the union of the Minkowski sums of their convex pieces, so
    A may also end in a hole or a notch of B. Disjoint bodies get minus their distance.

    Parameters
    ----------
    A, B : body
        As in `convex_pieces`: any polygons. Pass `ConvexPieces` to decompose once for many queries.
    pose : array_like of shape (3,) or (n, 3)
        Configuration (x, y, theta) of A: rotation by theta (radians) about its frame's origin,
        then translation. Many rows are done in one call, without the interpreter's lock.

    Returns
    -------
    TranslationalDepth or TranslationalDepths
        For one pose or many. In plain doubles; the error is some ten roundings of the largest
        coordinate, over the sine of the angle at which the edges meet that stop A. Of bodies that
        are not convex, gaps narrower than 16 roundings (2**-53) of both bodies' radii and the
        translation, added, may count as free or not.

    Raises
    ------
    PdgError
        For a broken polygon, and a pose that is not three finite numbers (``index`` is its row in
        a batch).
    """
    pieces_a = convex_pieces(A, name="A")
    pieces_b = convex_pieces(B, name="B")
    q = _gate.poses(pose, "pose")
    if isinstance(q, tuple):
        try:
            return one_depth(_core.translational_depth(pieces_a._native, pieces_b._native, q))
        except ValueError as error:
            raise _gate.out_of_range(q) from error
    bad, states, rows = _core.translational_depths(pieces_a._native, pieces_b._native, q)
    _gate.check_placed(bad, q, single=False)
    return many_depths((states, rows))


@overload
def generalized_depth_lower_bound(
    A: Body, B: Body, pose: Sequence[float] = ...
) -> DepthLowerBound: ...
@overload
def generalized_depth_lower_bound(A: Body, B: Body, pose: Rows) -> DepthLowerBounds: ...
@overload
def generalized_depth_lower_bound(
    A: Body, B: Body, pose: RealArray
) -> DepthLowerBound | DepthLowerBounds: ...
def generalized_depth_lower_bound(
    A: Body, B: Body, pose: Sequence[float] | Rows | RealArray = _gate.HERE
) -> DepthLowerBound | DepthLowerBounds:
    """Return a lower bound of the generalized penetration depth PD^g of two bodies.

    The bound is the maximum of PD^t over pairs of convex pieces ([PDG] section 6.1). It holds
    under the arc-length metric D_g and under the displacement metric DISP. Pairs whose boxes miss
    each other are dropped by a bounding-volume hierarchy.

    Parameters
    ----------
    A, B : body
        As in `convex_pieces`: any polygons. Pass `ConvexPieces` to decompose once for many queries.
    pose : array_like of shape (3,) or (n, 3)
        Configuration (x, y, theta) of A, theta in radians. Many rows are done in one call, without
        the interpreter's lock.

    Returns
    -------
    DepthLowerBound or DepthLowerBounds
        For one pose or many.
        In plain doubles. Depth 0 does not mean that the bodies are apart by any distance.

    Raises
    ------
    PdgError
        For a broken polygon, and a pose that is not three finite numbers (``index``
        is its row in a batch).
    """
    pieces_a = convex_pieces(A, name="A")
    pieces_b = convex_pieces(B, name="B")
    q = _gate.poses(pose, "pose")
    if isinstance(q, tuple):
        try:
            found = _core.generalized_depth_lower_bound(pieces_a._native, pieces_b._native, q)
        except ValueError as error:
            raise _gate.out_of_range(q) from error
        depth, i, j, pair = found
        return DepthLowerBound(depth, (i, j), one_depth(pair)) if i >= 0 else NO_PAIR
    bad, pairs, states, rows = _core.generalized_depth_lower_bounds(
        pieces_a._native, pieces_b._native, q
    )
    _gate.check_placed(bad, q, single=False)
    witness = many_depths((states, rows))
    return DepthLowerBounds(np.where(pairs[:, 0] >= 0, witness.depth, 0.0), pairs, witness)
