"""Brackets of PD^g against dense searches over the angle with shapely, and against known facts."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

import pdg
from oracles.placing import placed
from worlds.bodies.random_bodies import blob, convex

Pose = tuple[float, float, float]
HAMMER = shapely.Polygon(
    [
        *((-1.5, 0.0), (1.5, 0.0), (1.5, 0.75), (0.25, 0.75)),
        *((0.25, 3.0), (-0.25, 3.0), (-0.25, 0.75), (-1.5, 0.75)),
    ]
)
NOTCHED = shapely.Polygon(
    [
        *((-6.0, -6.0), (6.0, -6.0), (6.0, 2.5), (1.6, 2.5)),
        *((1.6, -3.0), (-1.6, -3.0), (-1.6, 2.5), (-6.0, 2.5)),
    ]
)
# The hammer lies slanted in the notch and pokes into both walls: turning helps, but in the last.
HAMMERS = [(-0.13, 0.9, 2.47), (0.4, -2.0, 0.9), (-0.35, 0.96, -1.94), (0.0, -2.9, 0.3)]
SPACING = 4e-3


def at(body: shapely.Geometry, pose: Pose) -> shapely.Geometry:
    return shapely.transform(body, lambda points: placed(points, pose))


def triangles(body: shapely.Geometry) -> list[NDArray]:
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(body))
    return [shapely.get_coordinates(part)[:3] for part in parts]


def sampled_least(a: shapely.Geometry, b: shapely.Geometry, q: Pose, theta: float) -> float:
    """Least DISP over points along the slice's boundary: at most SPACING too large."""
    moving = [placed(t, (*q[:2], theta)) for t in triangles(a)]
    sums = [(y[:, None] - x[None]).reshape(-1, 2) for x in moving for y in triangles(b)]
    obstacle = shapely.union_all([shapely.multipoints(points).convex_hull for points in sums])
    hull = shapely.get_coordinates(a.convex_hull)[:-1]
    moves = placed(hull, (*q[:2], theta)) - placed(hull, q)
    # f is least at the centre of the circle round -moves.
    circle = shapely.minimum_bounding_circle(shapely.multipoints(-moves))
    shifts = [shapely.get_coordinates(circle.centroid) if np.ptp(moves) > 1e-9 else -moves[:1]]
    if shapely.contains_properly(obstacle, shapely.Point(shifts[0][0])):
        shifts = [
            shapely.get_coordinates(line.segmentize(SPACING))
            for line in shapely.get_parts(obstacle.boundary)
        ]
    distances = [np.hypot(*np.moveaxis(s[:, None] + moves[None], 2, 0)).max(1) for s in shifts]
    return float(np.concatenate(distances).min())


def check(
    a: shapely.Geometry, b: shapely.Geometry, pose: Pose, rel_tol: float = 1e-3
) -> pdg.DepthBracket:
    """What holds for every bracket."""
    got = pdg.generalized_depth_bracket(a, b, pose, rel_tol)
    assert got.stop_reason == "converged"
    assert got.upper - got.lower <= rel_tol * got.upper
    depth = pdg.translational_depth(a, b, pose)
    if depth.state != "overlap":
        assert (got.lower, got.upper, got.distance_upper, got.pose) == (0.0, 0.0, 0.0, pose)
        return got
    scale = sum(np.abs(g.bounds).max() for g in (a, b)) + abs(pose[0]) + abs(pose[1])
    bound = pdg.generalized_depth_lower_bound(a, b, pose).lower
    assert 0 <= bound - 1e-13 * scale <= got.lower <= got.upper <= depth.depth + 1e-11 * scale
    assert pdg.displacement(a, pose, got.pose) <= got.upper
    assert pdg.displacement(a, pose, got.pose) == pytest.approx(got.upper, abs=1e-12 * scale)
    assert pdg.generalized_distance_bracket(a, pose, got.distance_pose).upper <= got.distance_upper
    assert got.upper - 1e-12 * scale <= got.distance_upper <= depth.depth + 1e-11 * scale
    half = abs(math.remainder(got.pose[2] - pose[2], 2 * math.pi)) / 2
    factor = half / math.sin(half) if half > 0 else 1.0  # depth.md section 3
    assert got.distance_upper <= got.upper * factor * (1 + 1e-12)
    for free in (got.pose, got.distance_pose):
        assert pdg.translational_depth(a, b, free).state != "overlap"
        assert at(a, free).intersection(b).area < 1e-12 * scale**2
    return got


@pytest.mark.parametrize("pose", HAMMERS)
def test_hammer_in_a_notch_against_a_dense_search(pose: Pose) -> None:
    got = check(HAMMER, NOTCHED, pose, 1e-4)
    turns = np.append(
        np.linspace(-0.9, 0.9, 13), got.pose[2] - pose[2] + np.linspace(-0.02, 0.02, 5)
    )
    sampled = [sampled_least(HAMMER, NOTCHED, pose, pose[2] + turn) for turn in turns]
    assert got.lower <= min(sampled) + 1e-9
    # At the optimum's own angle, in the middle of the five, the search is off by its spacing only.
    assert got.upper - 1e-9 <= sampled[-3] <= got.upper + SPACING


def test_hammers_for_which_turning_matters() -> None:
    for pose in HAMMERS[:3]:
        depth = pdg.translational_depth(HAMMER, NOTCHED, pose).depth
        assert check(HAMMER, NOTCHED, pose).upper < 0.5 * depth


def test_random_bodies_against_a_dense_search() -> None:
    random = np.random.default_rng(31)
    overlapping = 0
    for _ in range(8):
        a, b = blob(random, 2), blob(random, 5)
        x, y, theta = random.uniform((-2, -2, -4), (2, 2, 4))
        pose = (float(x), float(y), float(theta))
        got = check(a, b, pose, 1e-2)
        if got.upper == 0:
            continue
        overlapping += 1
        sampled = [sampled_least(a, b, pose, pose[2] + turn) for turn in np.linspace(-0.5, 0.5, 9)]
        assert got.lower <= min(sampled) + 1e-9
    assert overlapping > 4


def test_of_convex_bodies_it_holds_the_translational_depth() -> None:
    """PD^g = PD^t for convex bodies ([PDG] Theorem 1)."""
    random = np.random.default_rng(32)
    deep = 0
    for _ in range(60):
        a, b = (shapely.Polygon(convex(random)) for _ in range(2))
        x, y, theta = random.uniform((-3, -3, -4), (3, 3, 4))
        got = check(a, b, (float(x), float(y), float(theta)), 1e-4)
        depth = pdg.translational_depth(a, b, (x, y, theta)).depth
        deep += depth > 0
        assert got.lower <= max(depth, 0) + 1e-12
        assert got.upper == pytest.approx(max(depth, 0), abs=1e-11)
    assert deep > 30


def test_turning_is_nearer_than_translating() -> None:
    """A bar pokes with its slanted ends into both walls of a corridor: a turn sets it free."""
    bar = shapely.box(-2, -0.4, 2, 0.4)
    walls = shapely.union_all([shapely.box(-9, 0.4, 9, 9), shapely.box(-9, -9, 9, -0.4)])
    got = pdg.generalized_depth_bracket(bar, walls, (0.0, 0.0, 0.1), 1e-4)
    back = 2 * math.sin(0.05) * math.hypot(2, 0.4)  # the slot fits exactly: theta = 0 only
    assert got.lower == pytest.approx(back, abs=1e-12)  # either answer to an exact fit, but no more
    assert got.lower <= back * (1 + 1e-15)
    assert got.stop_reason in ("converged", "rounding")
    wide = shapely.union_all([shapely.box(-9, 0.5, 9, 9), shapely.box(-9, -9, 9, -0.5)])
    got = check(bar, wide, (0.0, 0.0, 0.1), 1e-4)
    corner = math.atan2(0.4, 2)
    free = math.asin(0.5 / math.hypot(2, 0.4)) - corner  # the steepest slant that fits
    turn = 2 * math.sin((0.1 - free) / 2) * math.hypot(2, 0.4)
    assert got.lower <= turn * (1 + 1e-12)
    assert got.upper == pytest.approx(turn, rel=1e-4)
    assert pdg.translational_depth(bar, wide, (0.0, 0.0, 0.1)).depth > 4


def test_limits_still_give_brackets() -> None:
    pose = HAMMERS[1]
    truth = pdg.generalized_depth_bracket(HAMMER, NOTCHED, pose, 1e-6)
    widths = []
    for nodes in (0, 1, 2, 10, 40):
        got = pdg.generalized_depth_bracket(HAMMER, NOTCHED, pose, 1e-9, max_nodes=nodes)
        assert got.stop_reason == "max_nodes"
        assert got.nodes <= nodes
        assert got.lower <= truth.upper
        assert got.upper >= truth.lower
        assert pdg.translational_depth(HAMMER, NOTCHED, got.pose).state != "overlap"
        widths.append(got.upper - got.lower)
    assert widths == sorted(widths, reverse=True)
    got = pdg.generalized_depth_bracket(HAMMER, NOTCHED, pose, 1e-9, timeout=0.0)
    assert got.stop_reason == "timeout"
    assert got.nodes == 0
    got = pdg.generalized_depth_bracket(HAMMER, NOTCHED, pose, 0.0)
    assert got.stop_reason == "rounding"
    assert got.upper - got.lower < 1e-10
    assert got.lower <= truth.upper
    assert got.upper >= truth.lower


def test_scale_and_place() -> None:
    pose = HAMMERS[0]
    plain = pdg.generalized_depth_bracket(HAMMER, NOTCHED, pose, 1e-4)
    for power in (-300, -40, 40, 300):
        scaled = [
            shapely.transform(g, lambda p, k=power: np.ldexp(p, k)) for g in (HAMMER, NOTCHED)
        ]
        x, y = np.ldexp(pose[:2], power)
        got = pdg.generalized_depth_bracket(*scaled, (float(x), float(y), pose[2]), 1e-4)
        assert np.ldexp(got.lower, -power) == pytest.approx(plain.lower, rel=1e-4)
        assert np.ldexp(got.upper, -power) == pytest.approx(plain.upper, rel=1e-4)
    # Neither the frame's origin on the body nor the place in the plane matters.
    shifted = shapely.transform(HAMMER, lambda p: p - (7.0, 3.0))
    x, y = placed(np.array([(7.0, 3.0)]), (0.0, 0.0, pose[2]))[0] + np.array(pose[:2])
    got = pdg.generalized_depth_bracket(shifted, NOTCHED, (float(x), float(y), pose[2]), 1e-4)
    assert got.lower <= plain.upper
    assert got.upper >= plain.lower
    away = shapely.transform(NOTCHED, lambda p: p + 1e4)
    got = pdg.generalized_depth_bracket(HAMMER, away, (pose[0] + 1e4, pose[1] + 1e4, pose[2]), 1e-4)
    assert got.lower <= plain.upper * (1 + 1e-9)
    assert got.upper >= plain.lower * (1 - 1e-9)


def test_apart_touching_and_hardly_overlapping() -> None:
    box = shapely.box(-1, -1, 1, 1)
    assert check(box, box, (3.0, 0.0, 0.0)).upper == 0
    assert check(box, box, (2.0, 0.0, 0.0)).upper == 0
    got = pdg.generalized_depth_bracket(HAMMER, box, (2.5 - 1e-14, 0.0, 0.0))
    assert 0 <= got.lower <= 1e-14 <= got.upper < 1e-12


def test_bad_arguments_are_refused() -> None:
    box = shapely.box(-1, -1, 1, 1)
    with pytest.raises(pdg.PdgError, match="relative_tolerance: must not be negative"):
        pdg.generalized_depth_bracket(box, box, relative_tolerance=-1)
    with pytest.raises(pdg.PdgError, match="timeout"):
        pdg.generalized_depth_bracket(box, box, timeout=math.nan)
    with pytest.raises(pdg.PdgError, match="max_nodes: expected a whole number"):
        pdg.generalized_depth_bracket(box, box, max_nodes=1.5)
    with pytest.raises(pdg.PdgError, match=r"pose\[2\]"):
        pdg.generalized_depth_bracket(box, box, (0, 0, math.inf))
