"""Slow, independent answers about grasps: sampled forces, and a plain minimiser of h_A/h_Q."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from pdg.grasp import Contact, frictionless, point_contact, soft_finger

Support = Callable[[NDArray], tuple[float, NDArray]]


def random_contacts(random: np.random.Generator, count: int, space: int = 3) -> list[Contact]:
    """Contacts of every kind, anywhere."""
    contacts: list[Contact] = []
    for i in range(count):
        p, n = random.normal(size=(2, space))
        mu, mu_s = random.uniform(0.1, 1.0, 2)
        if i % 3 == 0 and space == 3:
            contacts.append(soft_finger(p, n, mu, mu_s, random.normal(size=3)))
        elif i % 3 == 1:
            contacts.append(frictionless(p, n))
        else:
            contacts.append(point_contact(p, n, mu))
    return contacts


def force_closed(random: np.random.Generator, count: int = 4, soft: bool = True) -> list[Contact]:
    """Contacts on a sphere about the origin in all directions: force closure as a rule."""
    directions = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    points = directions[np.arange(count) % 4] + 0.25 * random.normal(size=(count, 3))
    make = soft_finger if soft else lambda p, n, mu, _: point_contact(p, n, mu)
    return [make(p, -p, random.uniform(0.3, 0.8), random.uniform(0.2, 0.6)) for p in points]


def wrench(contact: Contact, force: NDArray) -> NDArray:
    """Force and torque about the origin, straight from mechanics."""
    f = force[0] * contact.normal + force[1 : len(contact.position)] @ contact.tangents
    if len(contact.position) == 2:
        return np.array([*f, contact.position[0] * f[1] - contact.position[1] * f[0]])
    return np.concatenate([f, np.cross(contact.position, f) + force[3] * contact.normal])


def forces_on_boundary(random: np.random.Generator, contact: Contact, count: int) -> NDArray:
    """Forces with f_1 = 1 on the boundary of the friction cone, tested against its definition."""
    k = 1 if len(contact.position) == 2 else 3
    x = random.normal(size=(count, k))
    if contact.kind == "point" and k == 3:
        x[:, 2] = 0
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    limits = np.array([contact.friction, contact.friction, contact.torsion])[:k]
    f = np.hstack([np.ones((count, 1)), x * limits])
    if contact.kind == "soft":
        share = (f[:, 1] ** 2 + f[:, 2] ** 2) / contact.friction**2
        np.testing.assert_allclose(share + f[:, 3] ** 2 / contact.torsion**2, 1)
    return f


def sampled_support(
    random: np.random.Generator, contacts: list[Contact], u: NDArray, norm: str, idle: bool
) -> float:
    """Greatest u · w over sampled forces: from below, by a little."""
    each = [
        max(float(u @ wrench(c, f)) for f in forces_on_boundary(random, c, 3000)) for c in contacts
    ]
    pushes = [max(0.0, h) if idle else h for h in each]
    return max(pushes) if norm == "l1" else sum(pushes)


def least_ratio(
    A: Support, Q: Support, dimension: int, starts: int = 30, seed: int = 0
) -> tuple[float, NDArray]:
    """Least h_A(u)/h_Q(u) found by descents from many directions: from above, close to d_Q(A)."""

    def ratio(u: NDArray) -> tuple[float, NDArray]:
        (a, s_a), (q, s_q) = A(u), Q(u)
        return a / q, s_a / q - a * s_q / q**2

    random = np.random.default_rng(seed)
    best, where = np.inf, np.zeros(dimension)
    for _ in range(starts):
        u = random.normal(size=dimension)
        for _ in range(3):  # BFGS gives up at kinks; a fresh start goes on
            u = minimize(ratio, u / np.linalg.norm(u), jac=True, method="BFGS").x
        value = ratio(u)[0]
        if value < best:
            best, where = value, u / np.linalg.norm(u)
    return best, where
