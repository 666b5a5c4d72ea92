"""The convex pieces of a body, as the core holds them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from pdg import _core


class ConvexPieces:
    """The convex pieces of a body, ready for repeated queries; immutable. Made by `convex_pieces`.

    Iterating gives each piece's vertices, an (n, 2) array, counter-clockwise and strictly convex.
    Every function that takes a body takes one of these too, and then decomposes nothing.
    """

    __slots__ = ("_native",)

    _native: _core.PieceSet

    def __init__(self) -> None:
        raise TypeError("ConvexPieces are made by pdg.convex_pieces")

    def __len__(self) -> int:
        return len(self._native)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        coords, starts = self._native.arrays()
        return (coords[starts[i] : starts[i + 1]] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"ConvexPieces(pieces={len(self)}, radius={self.radius:.6g})"

    @property
    def radius(self) -> float:
        """Largest distance of the body from its frame origin, rounded up (length)."""
        return self._native.radius

    @property
    def radii(self) -> tuple[float, ...]:
        """Largest distance of each piece from the frame origin, rounded up (length)."""
        return tuple(self._native.radii())


def hold(native: _core.PieceSet) -> ConvexPieces:
    """Return the pieces that the core holds."""
    pieces = object.__new__(ConvexPieces)
    pieces._native = native
    return pieces
