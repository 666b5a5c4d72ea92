"""Depths and distances against Minkowski sums, shapely and pymunk."""

from __future__ import annotations

import numpy as np
import pymunk
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import pdg
from oracles.depth_methods import minkowski_depth
from oracles.placing import placed
from worlds.bodies.random_bodies import blob, convex

Pose = tuple[float, float, float]


def random_pose(random: np.random.Generator, reach: float = 7.0) -> Pose:
    x, y = random.uniform(-reach, reach, 2)
    return float(x), float(y), float(random.uniform(-4, 4))


def check(a: NDArray, b: NDArray, pose: Pose) -> pdg.TranslationalDepth:
    moved = placed(a, pose)
    scale = max(np.abs(moved).max(), np.abs(b).max())
    got = pdg.translational_depth(a, b, pose)
    assert got.depth == pytest.approx(minkowski_depth(a, b, pose), abs=1e-14 * scale)
    assert np.hypot(*got.direction) == pytest.approx(1, abs=1e-14)
    step = np.array(got.on_b) - np.array(got.on_a) - got.depth * np.array(got.direction)
    assert np.abs(step).max() < 1e-14 * scale
    for point, ring in ((got.on_a, moved), (got.on_b, b)):
        edge = shapely.LinearRing(ring)
        assert edge.distance(shapely.Point(point)) < 1e-14 * scale
    return got


def test_random_pairs_match_the_minkowski_sum() -> None:
    random = np.random.default_rng(4)
    states = [check(convex(random), convex(random), random_pose(random)).state for _ in range(1500)]
    assert min(states.count("overlap"), states.count("apart")) > 300


SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
NEEDLE = np.array([(0.0, 0.0), (1e3, 0.0), (1e3, 1e-6)])


@pytest.mark.parametrize(
    ("pose", "state", "depth"),
    [
        ((0, 0, 0), "overlap", 2),  # coincident
        ((0.5, 0, 0), "overlap", 1.5),
        ((2, 0, 0), "touching", 0),  # along an edge
        ((2, 2, 0), "touching", 0),  # in a corner
        ((2, 2.5, 0), "apart", -0.5),
        ((5, 6, 0), "apart", -5),
        ((np.nextafter(2, 0), 0, 0), "overlap", 2 - np.nextafter(2, 0)),
    ],
)
def test_squares(pose: Pose, state: str, depth: float) -> None:
    got = check(SQUARE, SQUARE, pose)
    assert got.state == state
    assert got.depth == pytest.approx(depth, abs=1e-15)


def test_degenerate_pairs() -> None:
    random = np.random.default_rng(5)
    angles = 2 * np.pi * np.arange(200) / 200
    disc = 3 * np.column_stack([np.cos(angles), np.sin(angles)])
    for _ in range(50):
        check(disc, disc, (0, 0, float(random.uniform(-4, 4))))  # concentric
        check(NEEDLE, convex(random), random_pose(random))
        check(SQUARE * 1e-3, disc, random_pose(random, 3))  # wholly inside
        check(SQUARE, SQUARE, (float(random.integers(-2, 3)), float(random.integers(-2, 3)), 0.0))


@given(
    st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=8),
    st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=8),
)
@settings(max_examples=300, deadline=None)
def test_integer_pairs(points_a: list[tuple[int, int]], points_b: list[tuple[int, int]]) -> None:
    hulls = [shapely.MultiPoint(p).convex_hull for p in (points_a, points_b)]
    if any(h.geom_type != "Polygon" for h in hulls):
        return
    a, b = (shapely.get_coordinates(h.exterior)[:-1] for h in hulls)
    got = check(a, b, (0.0, 0.0, 0.0))
    # On small integers shapely's predicates are exact.
    touches = hulls[0].touches(hulls[1])
    expected = "touching" if touches else "overlap" if hulls[0].intersects(hulls[1]) else "apart"
    assert got.state == expected


def test_pymunk_agrees_where_it_can_be_trusted() -> None:
    random = np.random.default_rng(6)
    compared = 0
    for _ in range(300):
        a, b = convex(random), convex(random)
        pose = random_pose(random)
        depth = pdg.translational_depth(a, b, pose).depth
        if depth <= 0.01:
            continue
        shapes = [pymunk.Poly(pymunk.Body(1, 1), p.tolist()) for p in (placed(a, pose), b)]
        for shape in shapes:
            shape.cache_bb()
        points = shapes[0].shapes_collide(shapes[1]).points
        deepest = max(-p.distance for p in points)
        assert deepest == pytest.approx(depth, abs=1e-12)
        compared += 1
    assert compared > 100


def test_lower_bound_is_the_maximum_over_pairs() -> None:
    random = np.random.default_rng(7)
    overlapping = 0
    for _ in range(60):
        A, B = pdg.convex_pieces(blob(random, 3)), pdg.convex_pieces(blob(random, 6))
        pose = random_pose(random, 6)
        depths = [[minkowski_depth(a, b, pose) for b in B] for a in A]
        bound = pdg.generalized_depth_lower_bound(A, B, pose)
        assert bound.lower == pytest.approx(max(0.0, np.max(depths)), abs=1e-12)
        if bound.pair is None:
            assert bound.lower == 0
            assert bound.witness is None
            continue
        overlapping += 1
        assert depths[bound.pair[0]][bound.pair[1]] == pytest.approx(bound.lower, abs=1e-12)
        assert bound.witness is not None
        assert bound.witness.depth == bound.lower
    assert overlapping > 20


def test_lower_bound_is_below_every_escape() -> None:
    """Any free configuration bounds PD under DISP, and so the lower bound, from above."""
    random = np.random.default_rng(8)
    found = 0
    for _ in range(40):
        body, obstacle = blob(random, 2), blob(random, 3)
        A, B = pdg.convex_pieces(body), pdg.convex_pieces(obstacle)
        q0 = random_pose(random, 2)
        bound = pdg.generalized_depth_lower_bound(A, B, q0).lower
        for _ in range(40):
            q1 = tuple(np.array(q0) + random.normal(0, (2, 2, 1)))
            if pdg.generalized_depth_lower_bound(A, B, q1).pair is None:
                found += 1
                assert bound <= pdg.displacement(A, q0, q1) + 1e-12
    assert found > 100


def test_bad_arguments_are_refused() -> None:
    with pytest.raises(pdg.PdgError, match=r"pose\[1\]: must be finite") as caught:
        pdg.translational_depth(SQUARE, SQUARE, (0, float("nan"), 0))
    assert caught.value.index == 1
    with pytest.raises(pdg.PdgError, match="expected 3 numbers"):
        pdg.displacement(SQUARE, (0, 0), (0, 0, 0))
