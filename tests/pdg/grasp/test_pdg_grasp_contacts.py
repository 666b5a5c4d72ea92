"""Contacts and grasp wrench sets: frames, maps and support functions against sampled forces."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest

from oracles.grasps import (
    force_closed,
    forces_on_boundary,
    random_contacts,
    sampled_support,
    wrench,
)
from pdg import PdgError, grasp
from pdg.grasp import (
    contact_map,
    frictionless,
    grasp_wrench_set,
    point_contact,
    soft_finger,
)

NORMS = ["l1", "linf"]


@pytest.mark.parametrize("normal", [(0, 0, 1), (0, -3, 0), (1, 1, 1), (1e-12, 2, 1), (-1, 0, 1e-9)])
@pytest.mark.parametrize("tangent", [None, (0.3, 0.2, 0.9), (1, 1.0000001, 1)])
def test_frames_are_right_handed(normal, tangent):
    contact = soft_finger((1, 2, 3), normal, 0.5, 0.1, tangent)
    frame = np.vstack([contact.normal, contact.tangents])
    np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(np.cross(frame[1], frame[2]), frame[0], atol=1e-15)
    np.testing.assert_allclose(contact.normal, np.array(normal) / np.linalg.norm(normal))
    if tangent is not None:  # o lies in the plane of the normal and what was asked for
        assert abs(np.linalg.det([contact.normal, contact.tangents[0], tangent])) < 1e-15
        assert contact.tangents[0] @ np.array(tangent) > 0


@pytest.mark.parametrize("space", [2, 3])
def test_contact_map_is_mechanics(space):
    random = np.random.default_rng(1)
    for contact in random_contacts(random, 6, space):
        f = random.normal(size=2 if space == 2 else 4)
        np.testing.assert_allclose(contact_map(contact) @ f, wrench(contact, f), atol=1e-14)
        scaled = contact_map(contact, 4.0) @ f
        torques = np.arange(len(scaled)) >= space
        np.testing.assert_allclose(
            scaled, wrench(contact, f) / np.where(torques, 4.0, 1.0), atol=1e-14
        )


def test_the_plane_is_a_part_of_space():
    p, n = np.array([0.4, -1.2]), np.array([0.6, 0.8])
    flat = contact_map(point_contact(p, n, 0.5))
    solid = contact_map(point_contact([*p, 0], [*n, 0], 0.5, tangent=[-n[1], n[0], 0]))
    np.testing.assert_allclose(flat, solid[np.ix_([0, 1, 5], [0, 1])], atol=1e-15)


@pytest.mark.parametrize("idle", [True, False])
@pytest.mark.parametrize("norm", NORMS)
@pytest.mark.parametrize("space", [2, 3])
def test_supports_against_sampled_forces(space, norm, idle):
    random = np.random.default_rng(2)
    contacts = random_contacts(random, 4, space)
    W = grasp_wrench_set(contacts, norm, idle=idle)
    u = random.normal(size=(12, W.dimension))
    values, points = W.supports(u)
    np.testing.assert_allclose(np.sum(u * points, axis=1), values, rtol=1e-13, atol=1e-13)
    for row, value in zip(u, values, strict=True):
        sampled = sampled_support(random, contacts, row, norm, idle)
        scale = np.linalg.norm(row) * len(contacts)
        assert sampled - 1e-12 * scale <= value <= sampled + 0.02 * scale


def test_support_points_of_one_contact_are_forces_within_friction():
    random = np.random.default_rng(3)
    for contact in random_contacts(random, 6):
        W = grasp_wrench_set([contact], idle=False)
        for point in W.supports(random.normal(size=(20, 6)))[1]:
            f, *_ = np.linalg.lstsq(contact_map(contact), point, rcond=None)
            np.testing.assert_allclose(contact_map(contact) @ f, point, atol=1e-14)
            assert f[0] == pytest.approx(1)
            tangential, spin = np.hypot(f[1], f[2]), abs(f[3])
            if contact.kind == "soft":
                share = (tangential / contact.friction) ** 2 + (spin / contact.torsion) ** 2
                assert share == pytest.approx(1)
            else:
                assert tangential == pytest.approx(contact.friction, abs=1e-14)
                assert spin < 1e-14


@pytest.mark.parametrize("norm", NORMS)
@pytest.mark.parametrize("idle", [True, False])
def test_compiled_support_against_its_formula(norm, idle):
    random = np.random.default_rng(4)
    W = grasp_wrench_set(force_closed(random), norm, 0.5, idle)
    for u in random.normal(size=(50, 6)):
        each = [c @ u + np.linalg.norm(M.T @ u) for c, M in zip(W.centres, W.axes, strict=True)]
        pushes = np.maximum(each, 0) if idle else each
        expected = max(pushes) if norm == "l1" else sum(pushes)
        assert W.support(u)[0] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("norm", NORMS)
@pytest.mark.parametrize("idle", [True, False])
@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_values_keep_the_promised_rounding(norm, idle, size):
    """Against extended precision, of the set that the doubles c_i, M_i describe."""
    random = np.random.default_rng(8)
    contacts = [
        soft_finger(size * random.normal(size=3), random.normal(size=3), 0.5, size * 0.1)
        for _ in range(5)
    ]
    W = grasp_wrench_set(contacts, norm, idle=idle)
    wide = np.longdouble
    c, M = W.centres.astype(wide), W.axes.astype(wide)
    largest = 0.0
    for u in random.normal(size=(300, 6)) * 10.0 ** random.uniform(-6, 6, (300, 6)):
        v = np.einsum("mkj,k->mj", M, u.astype(wide))
        each = c @ u.astype(wide) + np.sqrt((v * v).sum(axis=1))
        pushes = np.maximum(each, 0) if idle else each
        exact = pushes.max() if norm == "l1" else pushes.sum()
        promised = float(np.abs(u) @ np.array(W._native.error()))
        value, point = W.support(u)
        off = max(
            abs(float(value - exact)), abs(float(point.astype(wide) @ u.astype(wide) - exact))
        )
        largest = max(largest, off / promised)
    assert 1e-4 < largest <= 1


def test_a_direction_without_friction_has_a_support_point():
    # u along the normal: every tangential force is as good as any other.
    W = grasp_wrench_set([soft_finger((0, 0, 0), (1, 0, 0), 0.5, 0.5)], idle=False)
    value, point = W.support([2.0, 0, 0, 0, 0, 0])
    assert value == 2
    np.testing.assert_array_equal(point, [1, 0, 0, 0, 0, 0])


def test_zero_friction_is_frictionless():
    random = np.random.default_rng(5)
    u = random.normal(size=(10, 6))
    p, n = random.normal(size=(2, 3))
    plain = grasp_wrench_set([frictionless(p, n)]).supports(u)[0]
    for other in (point_contact(p, n, 0), soft_finger(p, n, 0, 0)):
        np.testing.assert_allclose(grasp_wrench_set([other]).supports(u)[0], plain, atol=1e-15)


def test_length_divides_torques():
    random = np.random.default_rng(6)
    contacts = force_closed(random)
    u = random.normal(size=(10, 6))
    stretched = u * [1, 1, 1, 0.1, 0.1, 0.1]
    np.testing.assert_allclose(
        grasp_wrench_set(contacts, length=10).supports(u)[0],
        grasp_wrench_set(contacts).supports(stretched)[0],
    )


def test_sampled_forces_lie_in_the_cone():
    random = np.random.default_rng(7)
    for contact in random_contacts(random, 3):
        forces_on_boundary(random, contact, 100)


def _soft(**changed):
    arguments = {"position": (0, 0, 1), "normal": (0, 0, -1), "friction": 0.5, "torsion": 0.1}
    return soft_finger(**{**arguments, **changed})


@pytest.mark.parametrize(
    ("call", "name", "index", "value"),
    [
        (lambda: _soft(position=(0, 1)), "normal", None, (3,)),
        (lambda: _soft(position=(0, 1), normal=(0, 1)), "position", None, (2,)),
        (lambda: _soft(position=(0, float("nan"), 1)), "position", 1, None),
        (lambda: _soft(position="abc"), "position", None, "abc"),
        (lambda: _soft(normal=(0, 0, 0)), "normal", None, [0, 0, 0]),
        (lambda: _soft(friction=-0.5), "friction", None, -0.5),
        (lambda: _soft(torsion=float("inf")), "torsion", None, float("inf")),
        (lambda: _soft(tangent=(0, 0, 2)), "tangent", None, [0, 0, 1]),
        (lambda: point_contact((0, 1), (1, 0), 0.5, (0, 1)), "tangent", None, (0, 1)),
        (lambda: grasp_wrench_set([]), "contacts", None, 0),
        (lambda: grasp_wrench_set([_soft(), "x"]), "contacts", 1, "x"),
        (
            lambda: grasp_wrench_set([_soft(), frictionless((0, 1), (1, 0))]),
            "contacts",
            1,
            [0, 1],
        ),
        (lambda: grasp_wrench_set([_soft()], "l2"), "norm", None, "l2"),
        (lambda: grasp_wrench_set([_soft()], length=0), "length", None, 0),
    ],
)
def test_bad_arguments(call, name, index, value):
    with pytest.raises(PdgError) as caught:
        call()
    assert (caught.value.name, caught.value.index) == (name, index)
    if value is not None:
        assert caught.value.value == value


def test_arguments_of_other_types_give_the_library_s_error() -> None:
    contact = point_contact((1, 0, 0), (-1, 0, 0), 0.5)
    odd: Any = 3
    for call, name in (
        (lambda: grasp.grasp_wrench_set(odd), "contacts"),
        (lambda: grasp.grasp_wrench_set([contact], cast(Any, np.zeros(0))), "norm"),
        (lambda: grasp.grasp_wrench_set([contact], idle=odd), "idle"),
        (lambda: grasp.active_wrench_set(odd), "fingers"),
        (lambda: grasp.finger(contact, odd), "joints"),
        (lambda: grasp.finger_forces(odd), "finger"),
        (lambda: grasp.force_closure(odd), "wrenches"),
        (lambda: grasp.force_efficiency(odd), "wrenches"),
        (lambda: grasp.contact_map(contact, 0), "length"),
    ):
        with pytest.raises(PdgError) as caught:
            call()
        assert caught.value.name == name
        assert caught.value.value is not None
