"""How far the library's PD^t is from each oracle, over families of convex pairs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import pymunk
import scipy.spatial
import shapely

import pdg
from oracles.exact.depths import exact_depth
from oracles.placing import Array, placed
from worlds.bodies.convex_pairs import FAMILIES

ALLOWED = 1e-12


class Deviation(NamedTuple):
    """The largest of one family; the exact one relative to the depth, the others to the extent."""

    family: str
    pairs: int
    overlap: int
    touching: int
    exact: float
    states: int
    shapely: float
    scipy: float
    pymunk: float


# Twice the depth on coincident bodies, and about one centre from 64 sides on (depth.md section 5);
# of very small and very thin bodies it keeps no contact, and far away it rounds coordinates.
DISTRUSTED_BY_PYMUNK = (
    "coincident",
    "concentric",
    "parallel edges",
    "slivers",
    "very different sizes",
    "far from the origin",
)
PYMUNK_SEES = 1e-6  # it reports no contact of bodies that barely overlap
# Qhull merges facets that are within its rounding of each other, and gives up on flat input.
DISTRUSTED_BY_SCIPY = ("slivers",)


def measure(family: str, seed: int, pairs: int, *, every: int = 1) -> Deviation:
    """Compare at least `pairs` poses of one family; `every` n-th with the outside oracles."""
    random = np.random.default_rng([seed, *family.encode()])
    worst = {"exact": 0.0, "shapely": 0.0, "scipy": 0.0, "pymunk": 0.0}
    count = {"overlap": 0, "touching": 0, "apart": 0}
    states = done = 0
    while done < pairs:
        a, b, poses = FAMILIES[family](random)
        found = pdg.translational_depth(a, b, list(poses))
        for row, (pose, got) in enumerate(zip(poses, found, strict=True)):
            moved = placed(a, pose)
            truth = exact_depth(moved, b)
            done += 1
            count[truth.state] += 1
            states += truth.state != got.state
            off = abs(got.depth - truth.depth)
            worst["exact"] = max(worst["exact"], off / abs(truth.depth) if off else 0.0)
            if row % every:
                continue
            extent = float(np.ptp(np.vstack([moved, b]), axis=0).max())
            for name, value in outside(family, moved, b, got.depth):
                worst[name] = max(worst[name], abs(value - got.depth) / extent)
    return Deviation(
        family,
        done,
        count["overlap"],
        count["touching"],
        worst["exact"],
        states,
        worst["shapely"],
        worst["scipy"],
        worst["pymunk"],
    )


def outside(family: str, a: Array, b: Array, depth: float) -> Iterator[tuple[str, float]]:
    """Yield what other libraries say of PD^t, where they may be trusted."""
    sums = (b[:, None, :] - a[None, :, :]).reshape(-1, 2)
    difference = shapely.multipoints(sums).convex_hull
    origin = shapely.Point(0, 0)
    distance = float(shapely.boundary(difference).distance(origin))
    yield "shapely", math.copysign(distance, depth)
    if depth <= 0:
        return
    if family not in DISTRUSTED_BY_SCIPY:
        equations = scipy.spatial.ConvexHull(sums).equations
        yield "scipy", float(-equations[:, 2].max())
    if family not in DISTRUSTED_BY_PYMUNK and depth > PYMUNK_SEES:
        shapes = [pymunk.Poly(pymunk.Body(1, 1), ring.tolist()) for ring in (a, b)]
        for shape in shapes:
            shape.cache_bb()
        points = shapes[0].shapes_collide(shapes[1]).points
        yield "pymunk", max(-p.distance for p in points)


def failures(row: Deviation) -> list[str]:
    """Return what of a row breaks the promise."""
    wrong = [f"{row.states} states"] if row.states else []
    oracles = ("exact", "shapely", "scipy", "pymunk")
    return wrong + [name for name in oracles if not getattr(row, name) <= ALLOWED]
