"""Bodies to measure depths of: convex ones with many vertices, and pairs that interlock."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from oracles.placing import Array, Pose


@dataclass(frozen=True)
class Pair:
    """A movable body at a configuration, and a fixed one."""

    name: str
    moving: shapely.Geometry
    fixed: shapely.Geometry
    pose: Pose


def oval(random: np.random.Generator, vertices: int) -> Array:
    """Return a convex polygon with vertices at random on an ellipse, anticlockwise."""
    angles = np.sort(random.uniform(0, 2 * np.pi, vertices))
    angles[:3] = (0.0, 2.1, 4.2)  # never all on one side
    angles.sort()
    return np.column_stack([3.0 * np.cos(angles), 2.0 * np.sin(angles)])


def overlapping_pose(random: np.random.Generator) -> Pose:
    """Return a configuration at which two ovals overlap, deep or hardly."""
    x, y = random.uniform(-2.0, 2.0, 2)
    return float(x), float(y), float(random.uniform(-3.0, 3.0))


HAMMER = shapely.Polygon(
    [
        *((-1.5, 0.0), (1.5, 0.0), (1.5, 0.75), (0.25, 0.75)),
        *((0.25, 3.0), (-0.25, 3.0), (-0.25, 0.75), (-1.5, 0.75)),
    ]
)
NOTCH = shapely.Polygon(
    [
        *((-4.0, -3.0), (4.0, -3.0), (4.0, 1.0), (1.0, 1.0)),
        *((1.0, -1.5), (-1.0, -1.5), (-1.0, 1.0), (-4.0, 1.0)),
    ]
)
ELL = shapely.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)])


def interlocking() -> Iterator[Pair]:
    """Yield pairs after the paper's: a hammer in a notch, an L, and two that are convex.

    The paper gives no coordinates ([PDG] Figures 6 and 9); of convex bodies PD^g is PD^t.
    """
    for k, pose in enumerate(
        [(0.0, -0.5, 0.0), (0.3, -0.8, 0.4), (0.0, -1.0, 1.2), (1.2, 0.0, 2.8)]
    ):
        yield Pair(f"hammer, notch {k + 1}", HAMMER, NOTCH, pose)
    narrow = NOTCH.union(shapely.box(0.5, -1.5, 1.0, 1.0)).union(shapely.box(-1.0, -1.5, -0.5, 1.0))
    yield Pair("hammer, narrow notch", HAMMER, narrow, (0.1, -1.0, 3.0))
    yield Pair("two Ls", ELL, ELL, (0.4, 0.6, 0.7))
    yield Pair("L, notch", ELL, NOTCH, (-0.5, -1.2, 0.2))
    square = shapely.box(-1, -1, 1, 1)
    yield Pair("convex: squares", square, square, (0.5, 0.25, 0.5))
    random = np.random.default_rng(1)
    first, second = (shapely.Polygon(oval(random, 7)) for _ in range(2))
    yield Pair("convex: ovals", first, second, (0.5, 0.5, 1.0))
