"""PD^t of convex bodies: ours, an outside library's, and by trying directions."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from decimal import Decimal

import numpy as np

import pdg
from oracles.depth_methods import minkowski_depth, sampled_depth
from oracles.exact.depths import placed_depth
from oracles.placing import Array, Pose, placed
from parts.depth_accuracy.bodies import oval, overlapping_pose
from parts.depth_accuracy.common import ALLOWED, UNIT, Row, in_microseconds, timed

VERTICES = (4, 8, 16, 32, 64)
DIRECTIONS = tuple(2**k for k in range(3, 15))
SAMPLED_VERTICES = 16
OURS = "pdg.translational_depth"
SAMPLED = "directions: "

Method = Callable[[Array, Array, Pose], Callable[[], float]]


def rows(seed: int, bodies: int) -> Iterator[Row]:
    """Yield ours and shapely's for bodies of growing size, and sampling for one size."""
    random = np.random.default_rng(seed)
    for vertices in VERTICES:
        pairs = list(overlapping(random, vertices, bodies))
        yield measured(vertices, OURS, pairs, _ours)
        yield measured(vertices, "shapely: Minkowski hull", pairs, _minkowski)
        if vertices == SAMPLED_VERTICES:
            for count in DIRECTIONS:
                yield measured(vertices, f"{SAMPLED}{count}", pairs, _sampled(count))


def overlapping(
    random: np.random.Generator, vertices: int, count: int
) -> Iterator[tuple[Array, Array, Pose, Decimal]]:
    """Yield pairs of convex bodies that overlap, with their depth."""
    while count:
        a, b, pose = oval(random, vertices), oval(random, vertices), overlapping_pose(random)
        depth = placed_depth(a, b, pose)
        if depth > 0:
            count -= 1
            yield a, b, pose, depth


def measured(
    vertices: int, name: str, pairs: list[tuple[Array, Array, Pose, Decimal]], method: Method
) -> Row:
    """Return the errors and times of a method."""
    errors, seconds, units = [], [], []
    for a, b, pose, depth in pairs:
        call = method(a, b, pose)
        off = abs(Decimal(call()) - depth)
        errors.append(float(off / depth))
        scale = max(np.abs(placed(a, pose)).max(), np.abs(b).max())
        units.append(float(off) / (UNIT * scale))
        seconds.append(timed(call))
    right = name != OURS or max(units) <= ALLOWED
    return Row(
        "PD^t",
        f"{vertices} vertices each",
        name,
        statistics.median(errors),
        max(errors),
        *in_microseconds(seconds),
        right,
        "" if name.startswith(SAMPLED) else f"off by up to {max(units):.1f} roundings",
    )


def _ours(a: Array, b: Array, pose: Pose) -> Callable[[], float]:
    first, second = pdg.convex_pieces(a), pdg.convex_pieces(b)
    return lambda: pdg.translational_depth(first, second, pose).depth


def _minkowski(a: Array, b: Array, pose: Pose) -> Callable[[], float]:
    return lambda: minkowski_depth(a, b, pose)


def _sampled(directions: int) -> Method:
    def method(a: Array, b: Array, pose: Pose) -> Callable[[], float]:
        return lambda: sampled_depth(a, b, pose, directions)

    return method
