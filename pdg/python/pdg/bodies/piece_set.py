"""The convex pieces of a body, as the core holds them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from pdg import _core


@dataclass(frozen=True, slots=True)
class ConvexPieces:
    """The convex pieces of a body, ready for repeated queries.

    Iterating gives each piece's vertices, an (n, 2) array, counter-clockwise and strictly convex.
    Every function that takes a body takes one of these too, and then decomposes nothing.
    """

    core: _core.PieceSet = field(repr=False)

    def __len__(self) -> int:
        return len(self.core)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        coords, starts = self.core.arrays()
        return (coords[starts[i] : starts[i + 1]] for i in range(len(self)))

    @property
    def radius(self) -> float:
        """Largest distance of the body from its frame origin, rounded up (length)."""
        return self.core.radius

    @property
    def radii(self) -> tuple[float, ...]:
        """The same for each piece."""
        return tuple(self.core.radii())
