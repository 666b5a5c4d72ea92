"""Where a proof of absence is nearest to failing: the thinnest place of the wall of FULL cells."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.frozen_arrays import FrozenArrays, freeze


@dataclass(frozen=True, eq=False)
class Bottleneck(FrozenArrays):
    """A way from start to goal through the wall, and the place where the wall was found thinnest.

    The way is chosen by the depth of overlap of sampled configurations in FULL cells and blocked
    faces. It is a heuristic for people and proves nothing. It gives a place and no length, because
    the least overlap of all ways can be several times smaller than that of this way. The length
    that must give way is bounded from both sides by `planar_planner.margin`.

    Attributes
    ----------
    way : NDArray, shape (N, 3)
        Configurations (x, y, theta) from the start's cell to the goal's, theta unwrapped. Outside
        the overlap they are middles of the cells' faces, not a path.
    collides : NDArray of bool, shape (N,)
        Whether each of them is found to overlap, in a cell or face that is proven to collide.
    index : int
        Index of the bottleneck in `way`.
    """

    way: NDArray[np.float64]
    collides: NDArray[np.bool_]
    index: int

    @property
    def at(self) -> NDArray[np.float64]:
        """The bottleneck, (x, y, theta)."""
        return np.asarray(self.way[self.index])

    @property
    def crossing(self) -> NDArray[np.float64]:
        """The stretch of the way about the bottleneck that overlaps, and one more at either end."""
        first = last = self.index
        while first > 0 and self.collides[first]:
            first -= 1
        while last + 1 < len(self.collides) and self.collides[last]:
            last += 1
        return np.asarray(self.way[first : last + 1])


def make_bottleneck(found: Mapping[str, Any]) -> Bottleneck | None:
    """Build it from the core's table; None if that is empty."""
    if not len(found["way"]):
        return None
    bottleneck = Bottleneck(found["way"], found["depth"] > 0.0, int(found["deepest"]))
    freeze(bottleneck)
    return bottleneck
