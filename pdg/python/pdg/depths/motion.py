"""How far a body moves: bounds over a cell of configurations, and between two configurations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg.aliases import Point, RealArray, Rows
from pdg.bodies.body import Body
from pdg.bodies.pieces import convex_pieces
from pdg.depths.batch import Batch


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


@dataclass(frozen=True, slots=True)
class DistanceBracket:
    """Bounds of D_g, and the motion that attains the upper one. Unpacks as lower, upper.

    Attributes
    ----------
    lower, upper : float
        Lengths; lower <= D_g <= upper.
    centre : tuple of float
        A point of the body's frame. When it moves straight while the body turns evenly, the short
        way round, no body point's path is longer than `upper`.
    """

    lower: float
    upper: float
    centre: Point

    def __iter__(self) -> Iterator[float]:
        return iter((self.lower, self.upper))


@dataclass(frozen=True, slots=True, eq=False)
class DistanceBrackets(Batch[DistanceBracket]):
    """Bounds of D_g for n pairs of configurations; ``self[i]`` is the `DistanceBracket` of row i.

    Attributes
    ----------
    lower, upper : ndarray, shape (n,)
    centre : ndarray, shape (n, 2)
    """

    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    centre: NDArray[np.float64]

    def _row(self, row: int) -> DistanceBracket:
        return DistanceBracket(*self._values(row))


def motion_bounds(half_extents: Sequence[float] | RealArray, radius: float) -> MotionBounds:
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
        Lengths, rounded up.

    Raises
    ------
    PdgError
        For numbers that are negative or not finite.
    """
    half = _gate.half_extents(half_extents, "half_extents")
    return MotionBounds(*_core.motion_bounds(half, _gate.length(radius, "radius")))


@overload
def displacement(body: Body, q0: Sequence[float], q1: Sequence[float]) -> float: ...
@overload
def displacement(
    body: Body, q0: Rows, q1: Sequence[float] | Rows | RealArray
) -> NDArray[np.float64]: ...
@overload
def displacement(body: Body, q0: Sequence[float] | RealArray, q1: Rows) -> NDArray[np.float64]: ...
@overload
def displacement(
    body: Body, q0: Sequence[float] | RealArray, q1: Sequence[float] | RealArray
) -> float | NDArray[np.float64]: ...
def displacement(
    body: Body, q0: Sequence[float] | Rows | RealArray, q1: Sequence[float] | Rows | RealArray
) -> float | NDArray[np.float64]:
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
    lengths = _core.displacements(pieces._native, start, end)
    return float(lengths[0]) if single else lengths


@overload
def generalized_distance_bracket(
    body: Body, q0: Sequence[float], q1: Sequence[float]
) -> DistanceBracket: ...
@overload
def generalized_distance_bracket(
    body: Body, q0: Rows, q1: Sequence[float] | Rows | RealArray
) -> DistanceBrackets: ...
@overload
def generalized_distance_bracket(
    body: Body, q0: Sequence[float] | RealArray, q1: Rows
) -> DistanceBrackets: ...
@overload
def generalized_distance_bracket(
    body: Body, q0: Sequence[float] | RealArray, q1: Sequence[float] | RealArray
) -> DistanceBracket | DistanceBrackets: ...
def generalized_distance_bracket(
    body: Body, q0: Sequence[float] | Rows | RealArray, q1: Sequence[float] | Rows | RealArray
) -> DistanceBracket | DistanceBrackets:
    """Return a lower and an upper bound of the generalized distance D_g(q0, q1).

    D_g is the least, over all motions from q0 to q1, of the longest path of a body point ([PDG]
    Eq. 2). With ``w = |dtheta|`` modulo full turns, ``k = 2 sin(w / 2)``, and rho the radius of the
    smallest circle round the body, ``D_g >= max(DISP, w rho)``, and for every point c of the body's
    frame D_g^2 is at most the maximum over vertices v of ``|dv|^2 + (w^2 - k^2) |v - c|^2``; the
    best c is taken. The upper bound is at most ``|dc| + w max |v - c|`` for every c ([PDG] Eq. 4),
    at most the arc about the pole of the relative motion, and at most ``sqrt(2 - (k / w)^2)`` times
    the lower bound: a factor of 1.012 at 30 degrees, 1.091 at 90 and 1.263 at 180. Proofs:
    docs/pdg.md.

    Parameters
    ----------
    body : body
        As in `convex_pieces`: polygons in their own frame.
    q0, q1 : array_like of shape (3,) or (n, 3)
        Configurations (x, y, theta), theta in radians; one may stand against many. Many rows are
        done in one call, without the interpreter's lock.

    Returns
    -------
    DistanceBracket or DistanceBrackets
        Lengths, rounded outward: they hold for the exact doubles given.

    Raises
    ------
    PdgError
        For a broken body, and configurations that are not three finite numbers
        (``index`` is the row in a batch), or as many.
    """
    pieces = convex_pieces(body)
    start, end, single = _gate.pose_pairs(q0, q1)
    rows = _core.generalized_distance_bounds(pieces._native, start, end)
    brackets = DistanceBrackets(rows[:, 0], rows[:, 1], rows[:, 2:])
    return brackets[0] if single else brackets
