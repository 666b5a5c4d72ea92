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
    """A way from start to goal through the wall whose deepest overlap is least, and where that is.

    The depth of a configuration is the greatest over all pairs of a convex piece of the robot and
    one of the obstacles (or a side of the workspace): the length of the shortest translation that
    parts the two. Outside the reference bounds it is the distance from them. Depths count where
    collision is proven, that is in FULL cells and blocked faces.

    It is an estimate from samples, for people: nothing of it is proven.

    Attributes
    ----------
    way : NDArray, shape (N, 3)
        Configurations (x, y, theta) from the start's cell to the goal's, theta unwrapped. Outside
        the overlap they are middles of the cells' faces, not a path.
    depths : NDArray, shape (N,)
        How deep each overlaps, in the scene's unit; 0 where nothing is proven to collide.
    index : int
        Of the bottleneck: the deepest overlap of the way by the middles of faces, made as shallow
        as can be by going another way there. (Elsewhere the way is left as it is.)
    """

    way: NDArray[np.float64]
    depths: NDArray[np.float64]
    index: int

    @property
    def at(self) -> NDArray[np.float64]:
        """The bottleneck, (x, y, theta)."""
        return np.asarray(self.way[self.index])

    @property
    def depth(self) -> float:
        """How deep it overlaps: what would have to give way there, in the scene's unit."""
        return float(self.depths[self.index])

    @property
    def crossing(self) -> NDArray[np.float64]:
        """The stretch of the way about the bottleneck that overlaps, and one more at either end."""
        first = last = self.index
        while first > 0 and self.depths[first] > 0.0:
            first -= 1
        while last + 1 < len(self.depths) and self.depths[last] > 0.0:
            last += 1
        return np.asarray(self.way[first : last + 1])


def make_bottleneck(found: Mapping[str, Any]) -> Bottleneck | None:
    """Build it from the core's table; None if that is empty."""
    if not len(found["way"]):
        return None
    bottleneck = Bottleneck(found["way"], found["depth"], int(found["deepest"]))
    freeze(bottleneck)
    return bottleneck
