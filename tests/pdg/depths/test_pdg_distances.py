"""DISP and the bounds of D_g against moves of vertices, simulated motions and slow minimisation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

import pdg
from oracles.exact.depths import exact_displacement
from oracles.placing import placed
from worlds.bodies.random_bodies import blob, convex

Pose = tuple[float, float, float]
SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
STEPS = 400


def random_pair(random: np.random.Generator) -> tuple[Pose, Pose]:
    reach = 10.0 ** random.uniform(-3, 1)
    turn = random.choice([0.0, 1e-9, 1e-4, 0.1, 1.0, 2.0, math.pi]) * random.choice([-1, 1])
    q0 = (*random.uniform(-5, 5, 2), random.uniform(-7, 7))
    q1 = (*(np.array(q0[:2]) + random.uniform(-reach, reach, 2)), q0[2] + turn)
    return tuple(map(float, q0)), tuple(map(float, q1))


def short_turn(q0: Pose, q1: Pose) -> float:
    return math.remainder(q1[2] - q0[2], 2 * math.pi)


def longest(ring: NDArray, poses: NDArray) -> float:
    """Longest path of a vertex through the configurations: from below, by chords."""
    c, s = np.cos(poses[:, 2, None]), np.sin(poses[:, 2, None])
    x = c * ring[:, 0] - s * ring[:, 1] + poses[:, :1]
    y = s * ring[:, 0] + c * ring[:, 1] + poses[:, 1:2]
    return float(np.hypot(np.diff(x, axis=0), np.diff(y, axis=0)).sum(axis=0).max())


def about(centre: NDArray, q0: Pose, q1: Pose) -> NDArray:
    """The motion in which a point of the body's frame moves straight and the body turns evenly."""
    s = np.linspace(0, 1, STEPS + 1)[:, None]
    start, end = (placed(centre[None], q)[0] for q in (q0, q1))
    angles = q0[2] + s[:, 0] * short_turn(q0, q1)
    path = start + s * (end - start)
    arms = np.array([placed(centre[None], (0, 0, t))[0] for t in angles])
    return np.column_stack([path - arms, angles])


def vertex_bound(ring: NDArray, q0: Pose, q1: Pose, centre: NDArray) -> float:
    """The documented upper bound for one centre."""
    angle = abs(short_turn(q0, q1))
    excess = angle**2 - (2 * math.sin(angle / 2)) ** 2
    moves = ((placed(ring, q1) - placed(ring, q0)) ** 2).sum(axis=1)
    return math.sqrt((moves + excess * ((ring - centre) ** 2).sum(axis=1)).max())


def test_displacement_is_the_largest_move_of_a_vertex() -> None:
    random = np.random.default_rng(40)
    for _ in range(200):
        body = blob(random, 3)
        pieces = pdg.convex_pieces(body)
        q0, q1 = random_pair(random)
        moves = [np.hypot(*(placed(p, q1) - placed(p, q0)).T).max() for p in pieces]
        assert pdg.displacement(pieces, q0, q1) == pytest.approx(max(moves), abs=1e-12)


def test_lower_bound_is_the_displacement_or_the_turn_of_the_smallest_circle() -> None:
    random = np.random.default_rng(41)
    by_turn = 0
    for _ in range(200):
        ring = convex(random)
        q0, q1 = random_pair(random)
        got = pdg.generalized_distance_bracket(ring, q0, q1)
        # The smallest circle is that of some two or three vertices.
        turned = abs(short_turn(q0, q1)) * smallest_radius(ring)
        moved = float(exact_displacement(ring, q0, q1))
        by_turn += turned > moved
        assert got.lower <= max(moved, turned * (1 + 1e-15))
        assert got.lower == pytest.approx(max(moved, turned), abs=1e-12)
    assert by_turn > 20


def smallest_radius(ring: NDArray) -> float:
    def reach(centre: NDArray) -> float:
        return float(np.hypot(*(ring - centre).T).max())

    centres = [(a + b) / 2 for a in ring for b in ring]
    for i, a in enumerate(ring):
        for j, b in enumerate(ring[:i]):
            for c in ring[:j]:
                matrix = 2 * np.array([b - a, c - a])
                if abs(np.linalg.det(matrix)) > 1e-9:
                    centres.append(
                        a + np.linalg.solve(matrix, [(b - a) @ (b - a), (c - a) @ (c - a)])
                    )
    return min(reach(c) for c in centres)


def test_upper_bound_is_attained_by_the_motion_it_names() -> None:
    random = np.random.default_rng(42)
    slack = []
    for _ in range(200):
        ring = convex(random)
        q0, q1 = random_pair(random)
        got = pdg.generalized_distance_bracket(ring, q0, q1)
        poses = about(np.array(got.centre), q0, q1)
        assert np.abs(placed(ring, tuple(poses[-1])) - placed(ring, q1)).max() < 1e-12
        walked = longest(ring, poses)
        # Chords of STEPS steps are short of the arcs by (turn / STEPS)^2 / 24 of them.
        assert walked <= got.upper * (1 + 1e-14)
        slack.append(got.upper / walked - 1)
    assert max(slack) < 0.1
    assert np.median(slack) < 0.01


def test_no_motion_undercuts_the_lower_bound() -> None:
    """Detours, overshoots, uneven turning, pauses, the long way round: none is shorter."""
    random = np.random.default_rng(43)
    closest = math.inf
    for _ in range(400):
        ring = convex(random)
        q0, q1 = random_pair(random)
        lower = pdg.generalized_distance_bracket(ring, q0, q1).lower
        s = np.linspace(0, 1, STEPS + 1)
        long_way = random.choice([0.0, 0.0, 2 * math.pi])
        end = np.array([*q1[:2], q0[2] + short_turn(q0, q1) + long_way])
        if random.random() < 0.5:
            pose = about(random.normal(size=2), q0, q1)
        else:
            pace = s[:, None] ** random.uniform(0.5, 2, 3)
            pose = np.array(q0) + pace * (end - q0)
        wobble = 10.0 ** random.uniform(-6, 0)
        pose = pose + np.sin(math.pi * s)[:, None] * random.normal(size=3) * wobble
        walked = longest(ring, pose)
        # Chords are short of the path by a share that grows with the angle of a step.
        walked *= 1 + (np.abs(np.diff(pose[:, 2])).max()) ** 2
        assert lower <= walked + 1e-12
        if lower > 0:
            closest = min(closest, walked / lower)
    assert closest < 1.01


def test_upper_bound_is_below_every_known_one() -> None:
    random = np.random.default_rng(44)
    better = 0
    for _ in range(300):
        ring = convex(random)
        q0, q1 = random_pair(random)
        got = pdg.generalized_distance_bracket(ring, q0, q1)
        angle = abs(short_turn(q0, q1))
        chord = 2 * math.sin(angle / 2)
        # [PDG] Eq. 4 with any point of the frame in the place of the reference point.
        for centre in [np.zeros(2), *ring, *random.normal(size=(5, 2)) * 4]:
            step = np.hypot(*(placed(centre[None], q1) - placed(centre[None], q0))[0])
            eq4 = step + angle * np.hypot(*(ring - centre).T).max()
            bound = vertex_bound(ring, q0, q1, centre)
            assert got.upper <= bound + 1e-12
            assert bound <= eq4 + 1e-12
        moved = pdg.displacement(ring, q0, q1)
        pole_arc = moved * (angle / chord) if angle else moved
        assert got.upper <= pole_arc + 1e-12
        better += got.upper < pole_arc * (1 - 1e-6)
        # The factor that is proven of the two bounds together.
        share = chord / angle if angle else 1.0
        assert got.upper <= got.lower * math.sqrt(2 - share**2) + 1e-12
        assert got.lower <= got.upper
    assert better > 50


def test_the_centre_is_the_best_one() -> None:
    """No small step of the centre makes the bound, a convex function of it, smaller."""
    random = np.random.default_rng(45)
    for _ in range(200):
        ring = convex(random)
        q0, q1 = random_pair(random)
        got = pdg.generalized_distance_bracket(ring, q0, q1)
        centre = np.array(got.centre)
        assert got.upper == pytest.approx(vertex_bound(ring, q0, q1, centre), abs=1e-12)
        for step in random.normal(size=(20, 2)) * 10.0 ** random.uniform(-6, 0):
            assert got.upper <= vertex_bound(ring, q0, q1, centre + step) + 1e-12


def test_cases_done_by_hand() -> None:
    shifted = pdg.generalized_distance_bracket(SQUARE, (0, 0, 1), (3, 4, 1))
    assert (shifted.lower, shifted.upper) == pytest.approx((5, 5), rel=1e-14)
    assert shifted.lower <= 5 <= shifted.upper
    # About the centre of the smallest circle both bounds are the arc.
    for angle in (1e-3, 0.5, 2.0, math.pi):
        got = pdg.generalized_distance_bracket(SQUARE, (0, 0, 0), (0, 0, angle))
        arc = angle * math.sqrt(2)
        assert (got.lower, got.upper) == pytest.approx((arc, arc), rel=1e-13)
        assert got.lower <= arc <= got.upper
    assert pdg.generalized_distance_bracket(SQUARE, (1, 2, 3), (1, 2, 3)).lower == 0
    full_turn = pdg.generalized_distance_bracket(SQUARE, (0, 0, 0), (0, 0, 2 * math.pi))
    assert full_turn.upper < 1e-13


def test_batches_are_the_single_ones() -> None:
    random = np.random.default_rng(46)
    body = blob(random, 3)
    pairs = [random_pair(random) for _ in range(50)]
    starts, ends = (np.array(q) for q in zip(*pairs, strict=True))
    many = pdg.generalized_distance_bracket(body, starts, ends)
    assert list(many) == [pdg.generalized_distance_bracket(body, *pair) for pair in pairs]
    assert len(pdg.generalized_distance_bracket(body, [], (0, 0, 0))) == 0
