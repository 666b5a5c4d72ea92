"""Valid polygons, as everything behind the gate knows them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from planar_planner.frozen_arrays import FrozenArrays, freeze


@dataclass(frozen=True, eq=False)
class Polygons(FrozenArrays):
    """Valid polygons as flat, read-only, contiguous arrays; the form the core takes.

    Attributes
    ----------
    coords : NDArray of float64, shape (N, 2)
        Vertices; rings are closed without a repeated last vertex, of any orientation.
    ring_starts : NDArray of uint32, shape (R + 1,)
        Ring r is ``coords[ring_starts[r]:ring_starts[r + 1]]``.
    polygon_starts : NDArray of uint32, shape (P + 1,)
        Polygon p has the rings ``polygon_starts[p]:polygon_starts[p + 1]``: outer one, then holes.
    """

    coords: NDArray[np.float64]
    ring_starts: NDArray[np.uint32]
    polygon_starts: NDArray[np.uint32]

    def __post_init__(self) -> None:
        freeze(self)

    @property
    def arrays(self) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32]]:
        """The three arrays, as the core takes them."""
        return self.coords, self.ring_starts, self.polygon_starts

    def __len__(self) -> int:
        return len(self.polygon_starts) - 1
