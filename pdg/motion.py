"""How far a body moves: bounds over a cell of configurations, and between two configurations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from pdg import _core, _gate
from pdg.pieces import convex_pieces

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class MotionBounds:
    """Upper bounds of the motion from a cell's centre to any point of it (length, rounded up).

    Attributes
    ----------
    sum : float
        h_x + h_y + r h_theta ([PDG] Eq. 3). Bounds D_g.
    arc : float
        sqrt(h_x^2 + h_y^2) + r h_theta. Bounds D_g.
    displacement : float
        sqrt(h_x^2 + h_y^2) + 2 r sin(min(h_theta, pi) / 2). Bounds DISP, but not D_g.
    """

    sum: float
    arc: float
    displacement: float


def motion_bounds(half_extents: Any, radius: float) -> MotionBounds:
    """Return the three motion bounds of a cell.

    Parameters
    ----------
    half_extents : array_like of shape (3,)
        (h_x, h_y, h_theta) >= 0, lengths and radians.
    radius : float
        Largest distance of the moving points from the reference point: `ConvexPieces.radius` for
        a body, an entry of `ConvexPieces.radii` for one piece.

    Returns
    -------
    MotionBounds

    Raises
    ------
    PdgError
        For numbers that are negative or not finite.
    """
    half = _gate.half_extents(half_extents, "half_extents")
    return MotionBounds(*_core.motion_bounds(half, _gate.length(radius, "radius")))


@overload
def displacement(body: Any, q0: Sequence[float], q1: Sequence[float]) -> float: ...
@overload
def displacement(body: Any, q0: Any, q1: Any) -> Any: ...
def displacement(body: Any, q0: Any, q1: Any) -> float | NDArray[np.float64]:
    """Return DISP(q0, q1), the largest distance between a body point at q0 and at q1.

    The displacement is a convex function of the body point, so a vertex attains it.

    Parameters
    ----------
    body : body
        As in `convex_pieces`: polygons in their own frame.
    q0, q1 : array_like of shape (3,) or (n, 3)
        Configurations (x, y, theta), theta in radians; one may stand against many. Many rows are
        done in one call, without the interpreter's lock.

    Returns
    -------
    float or ndarray of shape (n,)
        Length, in plain doubles.

    Raises
    ------
    PdgError
        For a broken body, and configurations that are not three finite numbers
        (``index`` is the row in a batch), or as many.
    """
    pieces = convex_pieces(body)
    start, end, single = _gate.pose_pairs(q0, q1)
    lengths = _core.displacements(pieces.core, start, end)
    return float(lengths[0]) if single else lengths


def generalized_distance_bounds(body: Any, q0: Any, q1: Any) -> tuple[float, float]:
    """Return a lower and an upper bound of the generalized distance D_g(q0, q1).

    D_g is the least, over all motions from q0 to q1, of the longest path of a body point ([PDG]
    Eq. 2). Below it lies DISP; above it lie turning about the pole of the relative motion, which
    is within a factor (|dtheta| / 2) / sin(|dtheta| / 2) of DISP, and moving any vertex or the
    reference point straight while turning. Angles count modulo full turns.

    Parameters
    ----------
    body : body
        As in `convex_pieces`: polygons in their own frame.
    q0, q1 : array_like of shape (3,)
        Configurations (x, y, theta), theta in radians.

    Returns
    -------
    tuple of float
        (lower, upper), lengths in plain doubles.

    Raises
    ------
    PdgError
        For a broken body, and configurations that are not three finite numbers.
    """
    pieces = convex_pieces(body)
    return _core.generalized_distance_bounds(
        pieces.core, _gate.triple(q0, "q0"), _gate.triple(q1, "q1")
    )
