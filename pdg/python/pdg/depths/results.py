"""What the depth functions return: one result, or an array a field for many poses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg.aliases import Point
from pdg.depths.batch import Batch

PairState = Literal["apart", "touching", "overlap"]
"""How two placed bodies meet: no common point, common points but disjoint interiors, or more."""

_STATES: tuple[PairState, PairState, PairState] = ("apart", "touching", "overlap")


@dataclass(frozen=True, slots=True)
class TranslationalDepth:
    """PD^t of two bodies with its witness, in B's frame and unit of length.

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
    lower : float
        The bound (length), of PD^g under DISP and under D_g; 0 when no pair of pieces overlaps.
    pair : tuple of int or None
        Indices of the deepest pair in the bodies' convex pieces.
    witness : TranslationalDepth or None
        That pair's PD^t.
    """

    lower: float
    pair: tuple[int, int] | None
    witness: TranslationalDepth | None


@dataclass(frozen=True, slots=True, eq=False)
class TranslationalDepths(Batch[TranslationalDepth]):
    """PD^t for n poses, one array a field; ``self[i]`` is the `TranslationalDepth` of row i.

    Attributes
    ----------
    state : ndarray of str, shape (n,)
    depth : ndarray, shape (n,)
    direction, on_a, on_b : ndarray, shape (n, 2)
    """

    state: NDArray[np.str_]
    depth: NDArray[np.float64]
    direction: NDArray[np.float64]
    on_a: NDArray[np.float64]
    on_b: NDArray[np.float64]

    def _row(self, row: int) -> TranslationalDepth:
        return TranslationalDepth(*self._values(row))


@dataclass(frozen=True, slots=True, eq=False)
class DepthLowerBounds(Batch[DepthLowerBound]):
    """Lower bounds of PD^g for n poses; ``self[i]`` is the `DepthLowerBound` of row i.

    Attributes
    ----------
    lower : ndarray, shape (n,)
        0 where no pair of pieces overlaps.
    pair : ndarray of int, shape (n, 2)
        (-1, -1) where no pair of pieces overlaps.
    witness : TranslationalDepths
        The deepest pair's; its rows mean nothing where there is no pair.
    """

    lower: NDArray[np.float64]
    pair: NDArray[np.int32]
    witness: TranslationalDepths

    def _row(self, row: int) -> DepthLowerBound:
        lower, pair, witness = self._values(row)
        return DepthLowerBound(lower, pair, witness) if pair[0] >= 0 else NO_PAIR


NO_PAIR = DepthLowerBound(0.0, None, None)


def one_depth(result: tuple[int, float, Point, Point, Point]) -> TranslationalDepth:
    """Return the core's answer for one pose."""
    state, depth, direction, on_a, on_b = result
    return TranslationalDepth(_STATES[state], depth, direction, on_a, on_b)


def many_depths(columns: tuple[NDArray[np.uint8], NDArray[np.float64]]) -> TranslationalDepths:
    """Return the core's answer for many poses: states, and rows of depth and three points."""
    states, rows = columns
    names = np.array(_STATES)[states]
    return TranslationalDepths(names, rows[:, 0], rows[:, 1:3], rows[:, 3:5], rows[:, 5:7])
