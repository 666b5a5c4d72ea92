"""The convex pieces of a body, as the core holds them."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from pdg import _core

# Coordinates, where each ring starts, the ring with which each polygon starts, and `cover`.
Source = tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32], bool]


class ConvexPieces:
    """The convex pieces of a body, ready for repeated queries; immutable. Made by `convex_pieces`.

    Iterating gives each piece's vertices, an (n, 2) array, counter-clockwise and strictly convex.
    Every function that takes a body takes one of these too, and then decomposes nothing. Pickling
    keeps the polygons, which are decomposed again, to the same pieces.
    """

    __slots__ = ("_native", "_source")

    _native: _core.PieceSet
    _source: Source

    def __init__(self) -> None:
        raise TypeError("ConvexPieces are made by pdg.convex_pieces")

    def __len__(self) -> int:
        return len(self._native)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        coords, starts = self._native.arrays()
        return (coords[starts[i] : starts[i + 1]] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"ConvexPieces(pieces={len(self)}, radius={self.radius:.6g})"

    def __reduce__(self) -> tuple[Callable[..., ConvexPieces], Source]:
        return decompose, self._source

    @property
    def radius(self) -> float:
        """Largest distance of the body from its frame origin, rounded up (length)."""
        return self._native.radius

    @property
    def radii(self) -> tuple[float, ...]:
        """Largest distance of each piece from the frame origin, rounded up (length)."""
        return tuple(self._native.radii())


def decompose(
    coords: NDArray[np.float64],
    ring_starts: NDArray[np.uint32],
    polygon_starts: NDArray[np.uint32],
    cover: bool,
) -> ConvexPieces:
    """Return the pieces of polygons that the gate has checked.

    Raises
    ------
    ValueError
        If the core cannot decompose them: edges cross.
    """
    pieces = object.__new__(ConvexPieces)
    pieces._source = (coords, ring_starts, polygon_starts, cover)
    pieces._native = _core.PieceSet(*pieces._source)
    return pieces
