"""d_Q of grasps against closed forms, linear programmes and a plain minimiser; force closure."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from oracles.grasps import force_closed, least_ratio, polished
from pdg import PdgError
from pdg.grasp import (
    active_wrench_set,
    contact_map,
    finger,
    force_closure,
    force_efficiency,
    frictionless,
    grasp_wrench_set,
    point_contact,
    revolute,
    soft_finger,
)
from pdg.sets import Ball, Box, CrossPolytope, Ellipsoid, Segment

# The fit to Table I of [GFE]: two opposed contacts on the x axis, mu = mu_s = 0.2.
L1, L2, MU = 0.75 * 3**0.5, 0.75, 0.2
ALPHA, GAMMA = L1 / (MU * (L1 + L2)), 1 / (MU * (L1 + L2))


def _unit_segment(n: int) -> Segment:
    return Segment(-np.eye(n)[0], np.eye(n)[0])


# Q in n dimensions, d_Q in space, d_Q in the plane
TABLE = {
    "a1": (Ball, *(2 * [1 / math.sqrt(1 + ALPHA**2 + GAMMA**2)])),
    "a2": (
        lambda n: Ellipsoid([2.0] + [1.0] * (n - 1)),
        *(2 * [1 / math.sqrt(4 + ALPHA**2 + GAMMA**2)]),
    ),
    "a3": (lambda n: CrossPolytope(np.ones(n)), *(2 * [1 / max(1, ALPHA, GAMMA)])),
    "a4": (
        lambda n: Box(np.ones(n)),
        1 / (1 + math.sqrt(2) * (ALPHA + GAMMA)),
        1 / (1 + ALPHA + GAMMA),
    ),
    "a5": (_unit_segment, 1.0, 1.0),
}


def _opposed(space: int):
    if space == 2:
        return [point_contact((-L1, 0), (1, 0), MU), point_contact((L2, 0), (-1, 0), MU)]
    return [
        soft_finger((-L1, 0, 0), (1, 0, 0), MU, MU, (0, 0, 1)),
        soft_finger((L2, 0, 0), (-1, 0, 0), MU, MU, (0, 0, 1)),
    ]


def _bending_fingers(contacts):
    """Fingers that bend about y, in the xz plane: forces along x and z only."""
    bases = [(-2.0, 0, 1.5), (1.5, 0, 1.5)]
    return [
        finger(c, [revolute(b, (0, 1, 0)), revolute((1.2 * b[0], 0, 0.5), (0, 1, 0))])
        for c, b in zip(contacts, bases, strict=True)
    ]


@pytest.mark.parametrize("row", TABLE)
def test_closed_forms_of_table_1(row):
    q, in_space, in_plane = TABLE[row]
    whole = force_efficiency(grasp_wrench_set(_opposed(3)), q(6), 1e-4)
    assert whole.lower <= in_space * (1 + 1e-14)
    assert in_space <= whole.upper * (1 + 1e-14)
    assert whole.upper - whole.lower <= 1e-4
    flat = force_efficiency(grasp_wrench_set(_opposed(2)), q(3), 1e-9)
    assert flat.lower == pytest.approx(in_plane, abs=2e-9)
    assert flat.upper == pytest.approx(in_plane, abs=2e-9)
    active = active_wrench_set(_bending_fingers(_opposed(3)))
    assert active.dimension == 3
    bent = force_efficiency(active, q(6), 1e-9)
    assert bent.lower == pytest.approx(in_plane, abs=2e-9)
    assert bent.upper == pytest.approx(in_plane, abs=2e-9)


def test_the_literal_sum_of_equation_5_has_no_extent_between_opposed_contacts():
    """Without idle contacts both push with exactly 1, and row (a5) would be 0, not 1."""
    literal = grasp_wrench_set(_opposed(2), idle=False)
    found = force_efficiency(literal, _unit_segment(3))
    assert found.upper <= 1e-12


@pytest.mark.parametrize("norm", ["l1", "linf"])
@pytest.mark.parametrize("soft", [True, False])
def test_brackets_against_a_plain_minimiser(norm, soft):
    random = np.random.default_rng(21)
    W, Q = (
        grasp_wrench_set(force_closed(random, 4, soft), norm),
        Ellipsoid(random.uniform(0.5, 2, 6)),
    )
    found = force_efficiency(W, Q, 1e-6)
    u = found.direction
    assert found.upper == pytest.approx(W.support(u)[0] / Q.support(u)[0], rel=1e-9)
    # Nothing goes below the lower bound, neither from elsewhere nor from where it is attained.
    least, _ = least_ratio(W, Q)
    assert 0 < found.lower <= least * (1 + 1e-12)
    assert least <= 1.01 * found.upper  # or the comparison would say little
    lower_still, _ = polished(W, Q, u, [])
    assert found.lower <= lower_still * (1 + 1e-12)


def _farthest(wrenches: NDArray, direction: NDArray, norm: str) -> float:
    """Return t of the farthest t * direction in the set, by linear programming."""
    count = len(wrenches)
    bounds = [(0, None)] + [(0, 1 if norm == "linf" else None)] * count
    limits = {} if norm == "linf" else {"A_ub": [[0.0] + [1.0] * count], "b_ub": [1.0]}
    equal = np.column_stack([-direction, wrenches.T])
    solved = linprog(
        [-1.0] + [0.0] * count, A_eq=equal, b_eq=np.zeros(len(direction)), bounds=bounds, **limits
    )
    assert solved.status == 0
    return float(solved.x[0])


@pytest.mark.parametrize("norm", ["l1", "linf"])
@pytest.mark.parametrize("space", [2, 3])
def test_frictionless_grasps_and_polytopes_by_linear_programmes(space, norm):
    random = np.random.default_rng(22)
    count, n = (7, 3) if space == 2 else (14, 6)
    points, normals = random.normal(size=(2, count, space))
    contacts = [frictionless(p, 0.7 * d - p) for p, d in zip(points, normals, strict=True)]
    wrenches = np.array([contact_map(c)[:, 0] for c in contacts])
    W = grasp_wrench_set(contacts, norm)
    for Q, corners in (
        (CrossPolytope(np.ones(n)), np.concatenate([np.eye(n), -np.eye(n)])),
        (Box(np.ones(n)), np.array(list(itertools.product((-1, 1), repeat=n)))),
    ):
        expected = min(_farthest(wrenches, corner, norm) for corner in corners)
        found = force_efficiency(W, Q, 1e-9)
        assert expected > 0.01
        assert found.lower == pytest.approx(expected, abs=1e-8)
        assert found.upper == pytest.approx(expected, abs=1e-8)


def test_planar_friction_by_linear_programmes():
    """In the plane a cone has two edges, so that the hull of the edges is exact."""
    random = np.random.default_rng(23)
    points = [(1, 0.1), (-0.6, 0.9), (-0.5, -0.8)]
    contacts = [point_contact(p, (-p[0], -p[1]), random.uniform(0.3, 0.6)) for p in points]
    edges = [contact_map(c) @ [1, side * c.friction] for c in contacts for side in (-1, 1)]
    corners = np.concatenate([np.eye(3), -np.eye(3)])
    expected = min(_farthest(np.array(edges), corner, "l1") for corner in corners)
    found = force_efficiency(grasp_wrench_set(contacts, "l1"), CrossPolytope(np.ones(3)), 1e-9)
    assert found.lower == pytest.approx(expected, abs=1e-8)


def test_turning_the_frame_changes_nothing():
    random = np.random.default_rng(24)
    contacts = force_closed(random)
    turn = Rotation.random(random_state=5).as_matrix()
    turned = [
        soft_finger(turn @ c.position, turn @ c.normal, c.friction, c.torsion) for c in contacts
    ]
    first, second = (force_efficiency(grasp_wrench_set(g), None, 1e-5) for g in (contacts, turned))
    assert max(first.lower, second.lower) <= min(first.upper, second.upper)
    mirrored = [soft_finger(-c.position, -c.normal, c.friction, c.torsion) for c in contacts]
    third = force_efficiency(grasp_wrench_set(mirrored), None, 1e-5)
    assert max(first.lower, third.lower) <= min(first.upper, third.upper)


def test_more_force_and_more_contacts_never_make_it_weaker():
    random = np.random.default_rng(25)
    contacts = force_closed(random, 5)
    sum_of_forces, each_force, fewer = (
        force_efficiency(grasp_wrench_set(g, norm), None, 1e-4)
        for g, norm in ((contacts, "l1"), (contacts, "linf"), (contacts[:4], "linf"))
    )
    assert sum_of_forces.lower <= each_force.upper
    assert fewer.lower <= each_force.upper
    assert each_force.lower > sum_of_forces.upper  # strictly, for these


def test_an_ellipsoid_in_the_minimal_subspace_is_projected():
    active = active_wrench_set(_bending_fingers(_opposed(3)))  # f_x, f_z, torque about y
    radii = np.array([1.0, 50.0, 2.0, 50.0, 3.0, 50.0])
    found = force_efficiency(active, Ellipsoid(radii), 1e-9)
    expected = force_efficiency(active, Ellipsoid(np.diag([1, 50, 2, 50, 3, 50.0])), 1e-9)
    assert found.dimension == 3
    assert found.lower == pytest.approx(expected.lower, abs=1e-9)
    np.testing.assert_allclose(found.direction[[1, 3, 5]], 0, atol=1e-12)
    assert np.linalg.norm(found.direction) == pytest.approx(1)
    # Axis-parallel: the projection is the part within the subspace.
    reduced = least_ratio(active, Ellipsoid([1.0, 2.0, 3.0]))[0]
    assert found.lower == pytest.approx(reduced, abs=1e-3)


def test_the_active_grasp_is_no_stronger_than_the_whole_one():
    random = np.random.default_rng(26)
    contacts = force_closed(random)
    fingers = [
        finger(c, [revolute(*random.normal(size=(2, 3))) for _ in range(4)]) for c in contacts
    ]
    fewer = [
        finger(
            c,
            [
                revolute(c.position - 2 * c.tangents[0], c.tangents[1]),
                revolute(c.position - 3 * c.tangents[1], c.tangents[0]),
                revolute(c.position - c.normal, c.tangents[0]),
            ],
        )
        for c in contacts
    ]
    whole = force_efficiency(grasp_wrench_set(contacts), None, 1e-4)
    same = force_efficiency(active_wrench_set(fingers), None, 1e-4)
    less = force_efficiency(active_wrench_set(fewer), None, 1e-4)
    assert (same.dimension, less.dimension) == (6, 6)
    assert max(same.lower, whole.lower) <= min(same.upper, whole.upper)
    assert less.lower <= whole.upper


@pytest.mark.parametrize("norm", ["l1", "linf"])
def test_force_closure(norm):
    random = np.random.default_rng(27)
    contacts = force_closed(random)
    W = grasp_wrench_set(contacts, norm)
    assert force_closure(W).state == "closed"
    assert force_efficiency(W).lower > 0
    # All contacts on one side push one way.
    above = [soft_finger((x, y, 1), (0, 0, -1), 0.3, 0.3) for x, y in ((0, 0), (1, 0), (0, 1))]
    one_sided = force_closure(grasp_wrench_set(above, norm))
    assert one_sided.state == "open"
    assert one_sided.resistance < 0
    each = grasp_wrench_set(above, "l1", idle=False)
    assert each.support(one_sided.direction)[0] == pytest.approx(one_sided.resistance)
    assert force_efficiency(grasp_wrench_set(above, norm)).lower == 0
    assert force_efficiency(grasp_wrench_set(above, norm)).upper <= 1e-4


def test_balance_without_a_margin_is_undecided():
    """Frictionless contacts in the plane whose lines meet in one point cannot resist a torque."""
    angles = np.radians([90, 210, 330])
    meeting = [frictionless((np.cos(a), np.sin(a)), (-np.cos(a), -np.sin(a))) for a in angles]
    assert force_closure(grasp_wrench_set(meeting)).state != "closed"
    # A fourth, off that point: its torque is balanced by none.
    fourth = frictionless((0.5, -0.9), (0, 1))
    found = force_closure(grasp_wrench_set([*meeting, fourth]))
    assert found.state != "closed"
    assert abs(found.resistance) < 1e-12 or found.resistance < 0


def test_two_point_contacts_do_not_resist_turning_about_their_line():
    pair = [point_contact((-1, 0, 0), (1, 0, 0), 0.5), point_contact((1, 0, 0), (-1, 0, 0), 0.5)]
    closure = force_closure(grasp_wrench_set(pair))
    assert closure.state == "open"
    np.testing.assert_allclose(np.abs(closure.direction), [0, 0, 0, 1, 0, 0], atol=1e-12)
    assert force_efficiency(grasp_wrench_set(pair)).upper < 1e-12
    soft = [soft_finger(c.position, c.normal, 0.5, 0.1) for c in pair]
    assert force_closure(grasp_wrench_set(soft)).state == "closed"


def test_limits_are_passed_on():
    W = grasp_wrench_set(_opposed(3))
    early = force_efficiency(W, None, 1e-6, max_iterations=20, history=True)
    assert early.distance.stop_reason == "max_iterations"
    assert len(early.distance.history) >= 20
    assert early.lower <= TABLE["a1"][1] <= early.upper


@pytest.mark.parametrize(
    ("call", "name", "value"),
    [
        (lambda W: force_efficiency(W, Ball(3)), "Q", 3),
        (lambda W: force_efficiency(W, "ball"), "Q", "ball"),
        (lambda W: force_efficiency(W, Ball(6, centre=[2, 0, 0, 0, 0, 0])), "Q", None),
        (lambda W: force_efficiency(W, None, -1.0), "absolute_tolerance", -1.0),
        (lambda W: force_closure(W, -1.0), "timeout", -1.0),
    ],
)
def test_bad_arguments(call, name, value):
    with pytest.raises(PdgError) as caught:
        call(grasp_wrench_set(_opposed(3)))
    assert caught.value.name == name
    if value is not None:
        assert caught.value.value == value
