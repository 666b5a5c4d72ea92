"""Upper bounds of the generalized penetration depth PD^g, with free configurations as proof.

Source: [PDG] Zhang, Kim, Varadhan, Manocha, *Generalized Penetration Depth Computation*, 2006,
sections 5 and 6.2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from pdg import _core, _gate
from pdg.aliases import Pose, RealArray, Rows
from pdg.bodies.body import Body
from pdg.bodies.piece_set import ConvexPieces
from pdg.bodies.pieces import convex_pieces
from pdg.depths.batch import Batch

UpperBoundMethod = Literal["hulls", "separators", "best"]
"""Which free configurations `generalized_depth_upper_bound` looks for."""

PlacementSource = Literal["free", "hulls", "separator"]
"""Where a free configuration comes from; see `FreePlacement`."""

_METHODS: tuple[UpperBoundMethod, ...] = ("hulls", "separators", "best")
# In the order of the core's PlacementSource.
_SOURCES: tuple[PlacementSource, ...] = ("free", "hulls", "separator")


class ConvexSeparators:
    """The convex separators of a fixed body, ready for repeated queries; immutable.

    Each is a convex container that holds nothing of the body's interior. Iterating gives its
    half-planes, an array of shape (k, 3) with rows (n_x, n_y, c): the points with n . p <= c. Made
    by `convex_separators`. Pickling keeps the body, whose separators are enumerated again.
    """

    __slots__ = ("_native", "_pieces")

    _native: _core.SeparatorSet
    _pieces: ConvexPieces

    def __init__(self) -> None:
        raise TypeError("ConvexSeparators are made by pdg.convex_separators")

    @property
    def pieces(self) -> ConvexPieces:
        """The convex pieces of the body."""
        return self._pieces

    def __len__(self) -> int:
        return len(self._native)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        return (self._native.sides(k) for k in range(len(self)))

    def __reduce__(self) -> tuple[Callable[..., ConvexSeparators], tuple[ConvexPieces]]:
        return convex_separators, (self._pieces,)

    def __repr__(self) -> str:
        return f"ConvexSeparators(separators={len(self)}, pieces={len(self.pieces)})"


@dataclass(frozen=True, slots=True)
class FreePlacement:
    """A configuration of A at which the bodies' interiors are disjoint, and where it comes from.

    Attributes
    ----------
    pose : tuple of float
        (x, y, theta). No convex piece of A overlaps one of B: exact for the vertices as placed in
        doubles.
    source : {"free", "hulls", "separator"}
        The pose given is free itself; the convex hulls were taken apart; A's hull
        was placed inside a convex container.
    separator : int or None
        That container's index in the `ConvexSeparators`.
    drawn_back : bool
        It lies on the way from the pose given to such a placement.
    """

    pose: Pose
    source: PlacementSource
    separator: int | None
    drawn_back: bool


@dataclass(frozen=True, slots=True, eq=False)
class FreePlacements(Batch[FreePlacement]):
    """Free configurations, one array a field; ``self[i]`` is the `FreePlacement` of row i.

    Attributes
    ----------
    pose : ndarray, shape (n, 3)
    source : ndarray of str, shape (n,)
    separator : ndarray of int, shape (n,)
        -1 where the source is not a separator.
    drawn_back : ndarray of bool, shape (n,)
    """

    pose: NDArray[np.float64]
    source: NDArray[np.str_]
    separator: NDArray[np.int32]
    drawn_back: NDArray[np.bool_]

    def _row(self, row: int) -> FreePlacement:
        pose, source, separator, drawn_back = self._values(row)
        return FreePlacement(pose, source, separator if separator >= 0 else None, drawn_back)


@dataclass(frozen=True, slots=True)
class DepthUpperBound:
    """Upper bounds of PD^g under both metrics.

    Attributes
    ----------
    upper : float
        Upper bound of PD^g under DISP (length): DISP from the pose given to ``placement.pose``.
    placement : FreePlacement
        Where `upper` is attained.
    distance_upper : float
        Upper bound of PD^g under D_g (length): the upper end of `generalized_distance_bracket` to
        ``distance_placement.pose``. It is never below `upper`, and equal to it for a translation.
    distance_placement : FreePlacement
        Where `distance_upper` is attained.
    angles : int
        Angles at which A's hull was placed in a container; 0 when every separator was culled.
    """

    upper: float
    placement: FreePlacement
    distance_upper: float
    distance_placement: FreePlacement
    angles: int


@dataclass(frozen=True, slots=True, eq=False)
class DepthUpperBounds(Batch[DepthUpperBound]):
    """Upper bounds of PD^g for n poses; ``self[i]`` is the `DepthUpperBound` of row i.

    Attributes
    ----------
    upper, distance_upper : ndarray, shape (n,)
    placement, distance_placement : FreePlacements
        Placements of n rows each.
    angles : ndarray of int, shape (n,)
    """

    upper: NDArray[np.float64]
    placement: FreePlacements
    distance_upper: NDArray[np.float64]
    distance_placement: FreePlacements
    angles: NDArray[np.int32]

    def _row(self, row: int) -> DepthUpperBound:
        return DepthUpperBound(*self._values(row))


def convex_separators(B: Body | ConvexSeparators) -> ConvexSeparators:
    """Enumerate convex containers of a fixed body's complement, its holes included.

    A separator in the sense of [PDG] section 6.2.3 is the boundary of such a container. Each piece
    of a convex cover of the complement is relaxed to an intersection of half-planes that still
    leaves out every convex piece of the body; containers inside others are dropped, and so are
    those beyond a line from the whole body, which the convex hulls account for ([PDG] sections
    6.2.2 and 6.2.4). Where
    polygons of one body cross each other, gaps that only several of them enclose are not searched.

    Parameters
    ----------
    B : body
        As in `convex_pieces`.

    Returns
    -------
    ConvexSeparators
        Take it in place of B in `generalized_depth_upper_bound` for many queries.

    Raises
    ------
    PdgError
        For a broken body.
    """
    if isinstance(B, ConvexSeparators):
        return B
    separators = object.__new__(ConvexSeparators)
    separators._pieces = convex_pieces(B, name="B")
    separators._native = _core.SeparatorSet(separators._pieces._native)
    return separators


@overload
def generalized_depth_upper_bound(
    A: Body,
    B: Body | ConvexSeparators,
    pose: Sequence[float] = ...,
    *,
    method: UpperBoundMethod = ...,
) -> DepthUpperBound: ...
@overload
def generalized_depth_upper_bound(
    A: Body, B: Body | ConvexSeparators, pose: Rows, *, method: UpperBoundMethod = ...
) -> DepthUpperBounds: ...
@overload
def generalized_depth_upper_bound(
    A: Body, B: Body | ConvexSeparators, pose: RealArray, *, method: UpperBoundMethod = ...
) -> DepthUpperBound | DepthUpperBounds: ...
def generalized_depth_upper_bound(
    A: Body,
    B: Body | ConvexSeparators,
    pose: Sequence[float] | Rows | RealArray = _gate.HERE,
    *,
    method: UpperBoundMethod = "separators",
) -> DepthUpperBound | DepthUpperBounds:
    """Return upper bounds of the generalized penetration depth PD^g, with free configurations.

    ``"hulls"`` is UB2 of [PDG] section 6.2.2: PD^t of the convex hulls, which is 0 only when they
    do not overlap. ``"separators"`` is UB1 of section 6.2.3: 0 if the pose is free; else the least
    of UB2 and of DISP to placements of A's hull inside a convex container of B's complement.
    Containers that already ask for more than the bound so far are culled. In place of the paper's
    two levels of linear programmes with small turns, the least DISP at each angle is found exactly
    (an LP-type problem of dimension two), and angles by branch and bound, for each container to
    one part in a thousand. UB1 is never above UB2. ``"best"`` goes on from there: it draws the free
    placements of both back towards the pose until the bodies themselves, not their hulls, are about
    to touch. It is never above UB1.

    Parameters
    ----------
    A : body
        As in `convex_pieces`.
    B : body or ConvexSeparators
        Pass `ConvexSeparators` to enumerate separators once for many queries.
    pose : array_like of shape (3,) or (n, 3)
        Configuration (x, y, theta) of A, theta in radians. Many rows are done in one call, without
        the interpreter's lock.
    method : {"separators", "hulls", "best"}

    Returns
    -------
    DepthUpperBound or DepthUpperBounds
        For one pose or many. Lengths in plain doubles. Configurations are confirmed free by the
        exact test of every pair of convex pieces; they lie beyond contact by some hundred roundings
        of the largest coordinate, so fits tighter than that are not found.

    Raises
    ------
    PdgError
        For a broken polygon, an unknown method, and a pose that is not three finite numbers
        (``index`` is its row in a batch).
    """
    pieces_a = convex_pieces(A, name="A")
    wanted = _gate.choice(method, _METHODS, "method")
    if wanted == "hulls":
        pieces_b = B.pieces if isinstance(B, ConvexSeparators) else convex_pieces(B, name="B")
        separators = None
    else:
        prepared = convex_separators(B)
        pieces_b, separators = prepared.pieces, prepared._native
    q = _gate.poses(pose, "pose")
    rows = np.atleast_2d(np.asarray(q))
    bad, numbers, codes = _core.depth_upper_bounds(
        pieces_a._native, pieces_b._native, separators, rows, wanted == "best"
    )
    _gate.check_placed(bad, rows, isinstance(q, tuple))
    bounds = DepthUpperBounds(
        numbers[:, 0],
        _placements(numbers[:, 1:4], codes[:, 0:3]),
        numbers[:, 4],
        _placements(numbers[:, 5:8], codes[:, 3:6]),
        codes[:, 6],
    )
    return bounds[0] if isinstance(q, tuple) else bounds


def _placements(poses: NDArray[np.float64], codes: NDArray[np.int32]) -> FreePlacements:
    """Return placements from the core's rows of source, separator and whether it is drawn back."""
    return FreePlacements(poses, np.array(_SOURCES)[codes[:, 0]], codes[:, 1], codes[:, 2] != 0)
