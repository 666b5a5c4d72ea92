"""Hands: Jacobians against moved tips, active forces against sampled torques, ranks and cases."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.grasps import force_closed
from pdg import PdgError
from pdg.grasp import (
    Contact,
    Finger,
    active_wrench_set,
    finger,
    finger_forces,
    frictionless,
    grasp_wrench_set,
    point_contact,
    prismatic,
    revolute,
    soft_finger,
)

CONTACT = soft_finger((0.3, -0.2, 0.5), (1, 2, -1), 0.4, 0.3)


def with_jacobian(jacobian: NDArray, contact: Contact = CONTACT, free=None) -> Finger:
    columns = jacobian.shape[1]
    reach = float(np.linalg.norm(jacobian))
    return Finger(contact, jacobian, (False,) * columns if free is None else free, (reach, reach))


def random_finger(random: np.random.Generator, contact: Contact, joints: int, **more) -> Finger:
    made = [revolute(*random.normal(size=(2, 3))) for _ in range(joints)]
    return finger(contact, made, **more)


def within_friction(f: NDArray, contact: Contact, slack: float = 1e-9) -> bool:
    share = np.hypot(f[1], f[2]) / contact.friction
    return bool(np.hypot(share, f[3] / contact.torsion) <= f[0] + slack)


def test_jacobian_is_the_tips_velocity():
    random = np.random.default_rng(1)
    frame = np.vstack([CONTACT.normal, CONTACT.tangents])
    step = 1e-6
    for _ in range(5):
        point, axis = random.normal(size=(2, 3))
        axis /= np.linalg.norm(axis)
        turn = Rotation.from_rotvec(step * axis)
        moved = point + turn.apply(CONTACT.position - point)
        velocity = frame @ (moved - CONTACT.position) / step
        spin = frame[0] @ turn.as_rotvec() / step
        column = finger(CONTACT, [revolute(point, axis)]).jacobian[:, 0]
        np.testing.assert_allclose(column, [*velocity, spin], atol=1e-5)
        slide = finger(CONTACT, [prismatic(axis)]).jacobian[:, 0]
        np.testing.assert_allclose(slide, [*(frame @ axis), 0], atol=1e-15)


def test_planar_jacobian_is_that_of_space():
    p, n, at = np.array([0.4, -1.2]), np.array([0.6, 0.8]), (0.5, 2.0)
    flat = finger(point_contact(p, n, 0.5), [revolute(at), prismatic((1, 2))])
    solid = finger(
        point_contact([*p, 0], [*n, 0], 0.5, tangent=[-n[1], n[0], 0]),
        [revolute([*at, 0], (0, 0, 1)), prismatic((1, 2, 0))],
    )
    np.testing.assert_allclose(solid.jacobian[:2], flat.jacobian, atol=1e-15)
    np.testing.assert_allclose(solid.jacobian[2:], 0, atol=1e-15)


def test_planar_hands_are_those_of_space_within_the_plane():
    """The same fingers in space, with joints that turn about z: forces in the plane, torque z."""
    random = np.random.default_rng(11)
    flat, solid = [], []
    for angle in (0.1, 2.3, 4.1):
        p = np.array([np.cos(angle), np.sin(angle)])
        n = -p
        joints = random.normal(size=(2, 2)) + 2 * p
        flat.append(finger(point_contact(p, n, 0.5), [revolute(at) for at in joints]))
        contact = point_contact([*p, 0], [*n, 0], 0.5, tangent=[-n[1], n[0], 0])
        solid.append(finger(contact, [revolute([*at, 0], (0, 0, 1)) for at in joints]))
    planar, spatial = active_wrench_set(flat), active_wrench_set(solid)
    np.testing.assert_array_equal(spatial.basis, np.eye(6)[:, [0, 1, 5]])
    u = random.normal(size=(30, 3))
    np.testing.assert_allclose(planar.supports(u)[0], spatial.supports(u)[0], atol=1e-12)
    whole = grasp_wrench_set([one.contact for one in flat])
    np.testing.assert_allclose(planar.supports(u)[0], whole.supports(u)[0], atol=1e-12)


def test_coupled_joints_share_a_column():
    random = np.random.default_rng(2)
    coupling = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]]
    state = random.bit_generator.state
    alone = random_finger(random, CONTACT, 4)
    random.bit_generator.state = state
    coupled = random_finger(random, CONTACT, 4, coupling=coupling)
    np.testing.assert_allclose(coupled.jacobian[:, :2], alone.jacobian[:, :2])
    np.testing.assert_allclose(coupled.jacobian[:, 2], alone.jacobian[:, 2:].sum(axis=1))


def test_four_independent_joints_make_every_force():
    random = np.random.default_rng(3)
    contacts = force_closed(random)
    fingers = [random_finger(random, c, 5) for c in contacts]
    forces = finger_forces(fingers[0])
    assert (forces.case, forces.rank) == ("ellipsoid", 4)
    assert forces.discriminant == pytest.approx(1)
    np.testing.assert_allclose(forces.offset, [1, 0, 0, 0], atol=1e-12)
    assert forces.passive.shape == (4, 0)
    whole, active = grasp_wrench_set(contacts), active_wrench_set(fingers)
    np.testing.assert_array_equal(active.basis, np.eye(6))
    u = random.normal(size=(50, 6))
    np.testing.assert_allclose(active.supports(u)[0], whole.supports(u)[0], rtol=1e-10)


@pytest.mark.parametrize("joints", [2, 3])
def test_active_forces_against_the_cone_itself(joints):
    """U^a is the part of range(J⁺ᵀ) at f_1 = 1 that friction allows: both ways, by sampling."""
    random = np.random.default_rng(joints)
    seen = 0
    for _ in range(30):
        J = random.normal(size=(4, joints))
        J[0, 0] += 3
        forces = finger_forces(with_jacobian(J))
        assert forces.rank == joints
        torques = random.normal(size=(400, joints))
        f = torques @ np.linalg.pinv(J)  # rows J⁺ᵀ τ
        f = f[f[:, 0] > 0.05]
        f /= f[:, :1]
        inside = np.array([within_friction(row, CONTACT, 0) for row in f])
        if forces.case == "none":
            assert not inside.any()
            continue
        seen += 1
        x, *_ = np.linalg.lstsq(forces.shape, (f - forces.offset).T, rcond=None)
        np.testing.assert_allclose(forces.offset + (forces.shape @ x).T, f, atol=1e-8)
        np.testing.assert_array_equal(np.linalg.norm(x, axis=0) <= 1, inside)
        # Its boundary is the friction cone's, and joint torques balance it.
        x = random.normal(size=(20, joints - 1))
        rim = forces.offset + (x / np.linalg.norm(x, axis=1)[:, None]) @ forces.shape.T
        for row in rim:
            share = np.hypot(row[1], row[2]) / CONTACT.friction
            assert np.hypot(share, row[3] / CONTACT.torsion) == pytest.approx(1)
            np.testing.assert_allclose(np.linalg.pinv(J.T) @ (J.T @ row), row, atol=1e-9)
    assert seen > 3


def test_one_joint_makes_one_force_or_none():
    steep = with_jacobian(np.array([[1.0], [0.5], [0.0], [0.0]]))
    good = with_jacobian(np.array([[-2.0], [0.4], [0.2], [0.1]]))
    sideways = with_jacobian(np.array([[0.0], [1.0], [0.0], [0.0]]))
    assert finger_forces(steep).case == "none"
    assert finger_forces(steep).discriminant == pytest.approx(1 - (0.5 / 0.4) ** 2)
    assert finger_forces(sideways).case == "none"
    forces = finger_forces(good)
    assert (forces.case, forces.rank, forces.shape.shape) == ("point", 1, (4, 0))
    np.testing.assert_allclose(forces.offset, [1, -0.2, -0.1, -0.05])


def test_the_three_signs_of_the_discriminant():
    """Active forces span f_1 = c, f_2 = m c and any f_4: Δ = 1 - (m/μ)²."""
    for slope, case in ((0.3, "ellipsoid"), (0.4, "point"), (0.5, "none")):
        J = np.array([[1.0, 0], [slope, 0], [0, 0], [0, 1]])
        forces = finger_forces(with_jacobian(J))
        assert forces.discriminant == pytest.approx(1 - (slope / 0.4) ** 2, abs=1e-12)
        assert forces.case == case
        if case != "none":
            np.testing.assert_allclose(forces.offset, [1, slope, 0, 0], atol=1e-12)
        if case == "ellipsoid":
            spin = CONTACT.torsion * np.sqrt(forces.discriminant)
            np.testing.assert_allclose(np.abs(forces.shape), [[0], [0], [0], [spin]], atol=1e-12)


def test_no_joint_that_moves_makes_no_force():
    joints = [revolute((0, 0, 0), (0, 0, 1))]
    still = finger(CONTACT, joints, modes=["locked"])
    assert finger_forces(still).case == "none"
    assert finger_forces(still).passive.shape == (4, 4)
    assert active_wrench_set([still]) is None
    through_tip = finger(CONTACT, [revolute(CONTACT.position, CONTACT.tangents[0])])
    assert finger_forces(through_tip).rank == 0


def test_passive_forces_need_no_torque_and_complete_the_active_ones():
    random = np.random.default_rng(5)
    for joints in range(5):
        one = random_finger(random, CONTACT, joints)
        forces = finger_forces(one)
        np.testing.assert_allclose(one.jacobian.T @ forces.passive, 0, atol=1e-12)
        both = np.hstack([forces.active, forces.passive])
        np.testing.assert_allclose(both.T @ both, np.eye(4), atol=1e-12)


def test_a_free_joint_bears_no_torque():
    random = np.random.default_rng(6)
    point, axis = random.normal(size=(2, 3))
    one = random_finger(random, CONTACT, 4, modes=["active", "free", "locked", "active"])
    assert one.jacobian.shape == (4, 3)
    forces = finger_forces(one)
    assert forces.rank == 2
    np.testing.assert_allclose(one.jacobian[:, 1] @ forces.active, 0, atol=1e-12)
    # What torques of the motors alone balance through J⁺ᵀ is the same space.
    f = np.linalg.pinv(one.jacobian.T)[:, [0, 2]]
    np.testing.assert_allclose(forces.active @ (forces.active.T @ f), f, atol=1e-12)
    assert revolute(point, axis).kind == "revolute"


def test_kinds_of_contact_narrow_the_active_forces():
    random = np.random.default_rng(7)
    J = random.normal(size=(4, 3))
    J[0] += 4
    p, n = CONTACT.position, CONTACT.normal
    for contact, held in ((frictionless(p, n), (1, 2, 3)), (point_contact(p, n, 0.9), (3,))):
        forces = finger_forces(with_jacobian(J, contact))
        if forces.case == "none":
            continue
        np.testing.assert_allclose(forces.offset[list(held)], 0, atol=1e-12)
        np.testing.assert_allclose(forces.shape[list(held)], 0, atol=1e-12)
    point = finger_forces(with_jacobian(J, point_contact(p, n, 0.9)))
    assert point.case == "ellipsoid"
    whole = finger_forces(with_jacobian(np.eye(4), frictionless(p, n)))
    assert whole.case == "point"
    np.testing.assert_allclose(whole.offset, [1, 0, 0, 0], atol=1e-15)


@pytest.mark.parametrize("norm", ["l1", "linf"])
def test_the_active_set_lies_in_the_whole_one(norm):
    random = np.random.default_rng(8)
    narrower = 0
    for joints in (2, 3, 4):
        contacts = force_closed(random)
        fingers = [random_finger(random, c, joints) for c in contacts]
        W, active = grasp_wrench_set(contacts, norm), active_wrench_set(fingers, norm)
        if active is None:
            continue
        np.testing.assert_allclose(
            active.basis.T @ active.basis, np.eye(active.dimension), atol=1e-13
        )
        u = random.normal(size=(200, 6))
        whole = W.supports(u)[0]
        part = active.supports(u @ active.basis)[0]
        assert np.all(part <= whole + 1e-9)
        narrower += int(np.any(part < 0.99 * whole))
    assert narrower >= 1


def test_the_minimal_subspace_is_that_of_the_active_wrenches():
    """A finger that moves in a plane only makes forces in that plane: three dimensions."""
    y = (0, 1, 0)
    contacts = [
        soft_finger((-1, 0, 0), (1, 0, 0), 0.2, 0.2),
        soft_finger((0.5, 0, 0), (-1, 0, 0), 0.2, 0.2),
    ]
    fingers = [
        finger(c, [revolute((2 * c.position[0], 0, 2), y), revolute((3 * c.position[0], 0, 1), y)])
        for c in contacts
    ]
    active = active_wrench_set(fingers)
    assert active.dimension == 3
    np.testing.assert_array_equal(active.basis, np.eye(6)[:, [0, 2, 4]])  # f_x, f_z, τ_y
    turned = Rotation.from_euler("xyz", (0.3, 0.5, 0.7)).as_matrix()
    oblique = active_wrench_set([_turned(f, turned) for f in fingers])
    assert oblique.dimension == 3
    wrench_turn = np.kron(np.eye(2), turned)
    u = np.random.default_rng(9).normal(size=(20, 6))
    np.testing.assert_allclose(
        oblique.supports(u @ oblique.basis)[0],
        active.supports((u @ wrench_turn) @ active.basis)[0],
        atol=1e-12,
    )


def _turned(one: Finger, turn: NDArray) -> Finger:
    c = one.contact
    contact = soft_finger(
        turn @ c.position, turn @ c.normal, c.friction, c.torsion, turn @ c.tangents[0]
    )
    return Finger(contact, one.jacobian, one.free, one.reach)


def test_a_length_makes_the_result_free_of_units():
    """Metres or millimetres: the same hand has the same active set if torques are scaled."""
    random = np.random.default_rng(10)
    contacts = force_closed(random)
    axes = random.normal(size=(4, 2, 2, 3))

    def hand(unit: float) -> list[Finger]:
        return [
            finger(
                soft_finger(unit * c.position, c.normal, c.friction, unit * c.torsion),
                [prismatic(c.normal), *(revolute(unit * p, a) for p, a in joints)],
                [[unit, 0, 0], [0, 1, 0], [0, 0, 1]],
            )
            for c, joints in zip(contacts, axes, strict=True)
        ]

    small, large = (active_wrench_set(hand(k), length=2.0 * k) for k in (1.0, 1000.0))
    u = random.normal(size=(30, 6))
    np.testing.assert_allclose(
        small.supports(u @ small.basis)[0], large.supports(u @ large.basis)[0], atol=1e-10
    )
    unscaled = active_wrench_set(hand(1000.0), length=1.0)  # moments count 1000 times as much
    assert not np.allclose(
        small.supports(u @ small.basis)[0], unscaled.supports(u @ unscaled.basis)[0], rtol=0.01
    )


@pytest.mark.parametrize(
    ("call", "name", "index", "value"),
    [
        (lambda: revolute((0, 0, 0), (0, 0, 0)), "axis", None, [0, 0, 0]),
        (lambda: revolute((0, 0), (0, 0, 1)), "axis", None, (0, 0, 1)),
        (lambda: prismatic((0, 1, 2, 3)), "axis", None, (4,)),
        (lambda: finger("x", []), "contact", None, "x"),
        (lambda: finger(CONTACT, [3]), "joints", 0, 3),
        (lambda: finger(CONTACT, [revolute((0, 0))]), "joints", 0, None),
        (lambda: finger(CONTACT, [prismatic((1, 0, 0))], [[1], [1]]), "coupling", None, (2, 1)),
        (lambda: finger(CONTACT, [prismatic((1, 0, 0))], [[np.inf]]), "coupling", 0, np.inf),
        (lambda: finger(CONTACT, [prismatic((1, 0, 0))], modes=["loose"]), "modes", 0, "loose"),
        (lambda: finger(CONTACT, [prismatic((1, 0, 0))], modes=[]), "modes", None, 0),
        (lambda: active_wrench_set([]), "fingers", None, 0),
        (lambda: active_wrench_set([CONTACT]), "fingers", 0, None),
        (lambda: finger_forces(with_jacobian(np.eye(4)), -1), "length", None, -1),
    ],
)
def test_bad_arguments(call, name, index, value):
    with pytest.raises(PdgError) as caught:
        call()
    assert (caught.value.name, caught.value.index) == (name, index)
    if value is not None:
        assert caught.value.value == value
