"""PD^t of bodies that are not convex against Minkowski sums united by shapely."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray
from shapely import affinity

import pdg
from oracles.placing import placed
from worlds.bodies.random_bodies import blob

Pose = tuple[float, float, float]
BLOCK = shapely.box(-4, -4, 4, 4)
CROSS = shapely.union_all([shapely.box(-3, -1, 3, 1), shapely.box(-1, -3, 1, 3)])
ELL = shapely.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)])


def triangles(body: shapely.Geometry) -> list[NDArray]:
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(body))
    return [shapely.get_coordinates(part)[:3] for part in parts]


def obstacle(a: shapely.Geometry, b: shapely.Geometry, pose: Pose) -> shapely.Geometry:
    """Translations of A at the pose that make it overlap B."""
    moving = [placed(t, pose) for t in triangles(a)]
    sums = [(y[:, None] - x[None]).reshape(-1, 2) for x in moving for y in triangles(b)]
    return shapely.union_all([shapely.multipoints(points).convex_hull for points in sums])


def signed_depth(a: shapely.Geometry, b: shapely.Geometry, pose: Pose) -> float:
    sums = obstacle(a, b, pose)
    origin = shapely.Point(0, 0)
    if sums.contains(origin):
        return float(sums.boundary.distance(origin))
    return -float(sums.distance(origin))


def at(a: shapely.Geometry, pose: Pose) -> shapely.Geometry:
    return shapely.transform(a, lambda points: placed(points, pose))


def check(a: shapely.Geometry, b: shapely.Geometry, pose: Pose) -> pdg.TranslationalDepth:
    got = pdg.translational_depth(a, b, pose)
    moved = at(a, pose)
    scale = max(np.abs(moved.bounds).max(), np.abs(b.bounds).max())
    assert got.depth == pytest.approx(signed_depth(a, b, pose), abs=1e-12 * scale)
    assert np.hypot(*got.direction) == pytest.approx(1, abs=1e-14)
    step = np.array(got.on_b) - np.array(got.on_a) - got.depth * np.array(got.direction)
    assert np.abs(step).max() < 1e-13 * scale
    for point, body in ((got.on_a, moved), (got.on_b, b)):
        assert body.boundary.distance(shapely.Point(point)) < 1e-12 * scale
    if got.state == "overlap":  # the way out leads out
        x, y = np.array(pose[:2]) + got.depth * np.array(got.direction)
        assert at(a, (x, y, pose[2])).intersection(b).area < 1e-11 * scale**2
    return got


def random_pose(random: np.random.Generator, reach: float) -> Pose:
    x, y, theta = random.uniform((-reach, -reach, -4), (reach, reach, 4))
    return float(x), float(y), float(theta)


def test_random_bodies() -> None:
    random = np.random.default_rng(21)
    states = []
    for _ in range(60):
        a, b = blob(random, int(random.integers(1, 4))), blob(random, int(random.integers(4, 9)))
        states.append(check(a, b, random_pose(random, 4)).state)
    assert min(states.count("overlap"), 4 * states.count("apart")) > 15


def test_random_ways_out_into_holes() -> None:
    random = np.random.default_rng(25)
    into_holes = 0
    for _ in range(20):
        small = affinity.scale(blob(random, 2), 0.1, 0.1)
        holed = BLOCK
        for x, y in random.uniform(-3, 3, (6, 2)):
            holed = holed.difference(shapely.Point(x, y).buffer(0.7, quad_segs=2))
        pose = random_pose(random, 3)
        got = check(small, holed, pose)
        into_holes += got.depth + 1e-9 < pdg.translational_depth(small, BLOCK, pose).depth
    assert into_holes > 5


def test_into_a_hole_and_into_a_notch() -> None:
    ring = BLOCK.difference(shapely.box(-1, -1, 1, 1))
    small = shapely.union_all([shapely.box(-0.5, -0.5, 0.5, 0), shapely.box(-0.2, 0, 0.2, 0.6)])
    got = check(small, ring, (1.0, 0.2, 0.0))
    assert got.depth == pytest.approx(0.5, abs=1e-15)
    assert got.direction == pytest.approx((-1, 0))
    notched = BLOCK.difference(shapely.box(-1, 0, 1, 9))
    got = check(small, notched, (0.0, -0.2, 0.0))
    assert got.depth == pytest.approx(0.7, abs=1e-15)
    assert got.direction == pytest.approx((0, 1))


def test_a_corner_between_two_edges() -> None:
    """The nearest free translation is where two sums' edges cross, not the foot on an edge."""
    got = check(shapely.box(-0.5, -0.5, 0.5, 0.5), ELL, (0.6, 0.7, 0.0))
    corner = np.hypot(1.5 - 0.6, 1.5 - 0.7)
    assert got.depth == pytest.approx(min(corner, 0.6 + 0.5), abs=1e-15)
    bar = shapely.box(-0.4, -0.4, 0.4, 0.4)
    room = BLOCK.difference(shapely.box(-0.5, -0.5, 0.5, 0.5))
    got = check(bar, room, (0.4, 0.3, 0.0))
    assert got.depth == pytest.approx(np.hypot(0.3, 0.2), abs=1e-15)


@pytest.mark.parametrize(
    ("pose", "state", "depth"),
    [
        ((0, 0, 0), "overlap", 2 * np.sqrt(5)),  # coincident
        ((2, 2, 0), "overlap", None),
        ((6, 0, 0), "touching", 0),
        ((4, 4, 0), "touching", 0),  # corners
        ((2, 4, 0), "touching", 0),
        ((4.5, 4.5, 0), "apart", -np.sqrt(0.5)),
    ],
)
def test_crosses_with_coincident_edges(pose: Pose, state: str, depth: float | None) -> None:
    got = check(CROSS, CROSS, pose)
    assert got.state == state
    if depth is not None:
        assert got.depth == pytest.approx(depth, abs=1e-14)


def cells_of(random: np.random.Generator, size: int) -> set[tuple[int, int]]:
    chosen = random.random((size, size)) < 0.7
    chosen[size // 2, size // 2] = True
    return {(int(x), int(y)) for x, y in np.argwhere(chosen)}


def test_seams_between_pieces_are_not_free_and_exact_fits_are() -> None:
    """Bodies of unit squares: every sum's edges coincide with others', and partitions' abut.

    The free translations are a closed union of unit squares, edges and points of the lattice, so
    the nearest to a lattice point is a lattice point, at which the cells do not meet.
    """
    random = np.random.default_rng(22)
    overlaps = 0
    for _ in range(80):
        a, b = cells_of(random, 3), cells_of(random, 7)
        x, y = (int(v) for v in random.integers(-1, 6, 2))
        shifts = [
            (i, j)
            for i in range(-12, 13)
            for j in range(-12, 13)
            if not any((cx + x + i, cy + y + j) in b for cx, cy in a)
        ]
        expected = min(np.hypot(i, j) for i, j in shifts)
        squares = ([shapely.box(i, j, i + 1, j + 1) for i, j in cells] for cells in (a, b))
        bodies = [shapely.union_all(boxes) for boxes in squares]
        for cover in (True, False):
            pieces = [pdg.convex_pieces(body, cover=cover) for body in bodies]
            got = pdg.translational_depth(*pieces, (x, y, 0))
            assert max(got.depth, 0) == pytest.approx(expected, abs=1e-13)
            assert (got.state == "overlap") == (expected > 0)
        overlaps += expected > 0
    assert overlaps > 40


def test_many_vertices() -> None:
    angles = 2 * np.pi * np.arange(40) / 40
    star = shapely.Polygon(
        np.column_stack([np.cos(angles), np.sin(angles)]) * np.resize([3.0, 2.0], 40)[:, None]
    )
    random = np.random.default_rng(23)
    assert check(star, star, (0, 0, 0)).state == "overlap"  # concentric, every way out alike
    for _ in range(3):
        check(star, star, random_pose(random, 2))


def test_scale_and_distance_from_the_origin() -> None:
    random = np.random.default_rng(24)
    for _ in range(20):
        a, b = blob(random, 3), blob(random, 6)
        pose = random_pose(random, 2)
        depth = pdg.translational_depth(a, b, pose).depth
        for power in (-400, -30, 40, 400):
            scaled = [shapely.transform(g, lambda p, k=power: np.ldexp(p, k)) for g in (a, b)]
            x, y = np.ldexp(pose[:2], power)
            got = pdg.translational_depth(*scaled, (x, y, pose[2]))
            assert np.ldexp(got.depth, -power) == pytest.approx(depth, rel=1e-12, abs=1e-15)
        moved = shapely.transform(b, lambda p: p + 1e6)
        got = pdg.translational_depth(a, moved, (pose[0] + 1e6, pose[1] + 1e6, pose[2]))
        assert got.depth == pytest.approx(depth, abs=1e-8)


def test_hardly_overlapping() -> None:
    """Exact state, and a depth of that size, down to the last bit."""
    for gap in (1e-3, 1e-9, 1e-15):
        got = pdg.translational_depth(ELL, ELL, (3.0 - gap, 0.0, 0.0))
        assert got.state == "overlap"
        assert got.depth == pytest.approx(3.0 - (3.0 - gap), abs=1e-15)


def test_many_poses() -> None:
    random = np.random.default_rng(26)
    poses = [random_pose(random, 5) for _ in range(30)]
    assert list(pdg.translational_depth(CROSS, ELL, np.array(poses))) == [
        pdg.translational_depth(CROSS, ELL, pose) for pose in poses
    ]


def test_parallel_edges_in_general_directions() -> None:
    """Edges of A and B that are parallel but for rounding do not cut each other off."""
    random = np.random.default_rng(7)
    square, stairs = shapely.box(0, 0, 1, 1), shapely.box(0, 0, 3, 1).union(shapely.box(0, 1, 1, 3))
    overlapping = 0
    for _ in range(60):
        turn, shear, height = random.uniform((0, -1, 0.2), (7, 1, 1.5))
        c, s = np.cos(turn), np.sin(turn)
        basis = np.array([[c, -s], [s, c]]) @ [[1, shear], [0, height]]
        a, b = (shapely.transform(g, lambda p, m=basis: p @ m.T) for g in (square, stairs))
        for step in ((0, 0), (0, 1), (0.5, 0.5), (0, 2), (1, 0)):
            x, y = basis @ step
            got = check(a, b, (float(x), float(y), 0.0))
            overlapping += got.state == "overlap"
    assert overlapping > 200


def test_a_piece_that_placing_shrinks_to_a_point_counts() -> None:
    """The other part is out at once; the small one is deep inside."""
    tiny = shapely.Polygon([(0, 0), (1e-9, 0), (0, 1e-9)])
    a = shapely.MultiPolygon([tiny, shapely.box(-30, -1, -20, 1)])
    b = shapely.box(-16, -16, 16, 16)
    got = pdg.translational_depth(a, shapely.affinity.translate(b, 2.0**30, 0), (2.0**30, 1, 0))
    assert (got.state, got.depth, got.direction) == ("overlap", 15.0, (0.0, 1.0))
