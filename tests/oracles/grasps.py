"""Slow, independent answers about grasps: sampled forces, and a plain minimiser of h_A/h_Q."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from pdg.grasp import Contact, frictionless, point_contact, soft_finger
from pdg.sets import ConvexSet

Array = NDArray[np.float64]


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
    contacts = []
    for p in points:
        mu, mu_s = random.uniform(0.3, 0.8), random.uniform(0.2, 0.6)
        contacts.append(soft_finger(p, -p, mu, mu_s) if soft else point_contact(p, -p, mu))
    return contacts


def wrench(contact: Contact, forces: Array) -> Array:
    """Force and torque about the origin, straight from mechanics, of each row of forces."""
    f = forces[..., :1] * contact.normal + forces[..., 1 : len(contact.position)] @ contact.tangents
    p = contact.position
    if len(p) == 2:
        torque = p[0] * f[..., 1:] - p[1] * f[..., :1]
    else:
        torque = np.cross(p, f) + forces[..., 3:] * contact.normal
    return np.concatenate([f, torque], axis=-1)


def forces_on_boundary(random: np.random.Generator, contact: Contact, count: int) -> Array:
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
    random: np.random.Generator, contacts: list[Contact], u: Array, norm: str, idle: bool
) -> float:
    """Greatest u · w over sampled forces: from below, by a little."""
    each = [float((wrench(c, forces_on_boundary(random, c, 20000)) @ u).max()) for c in contacts]
    pushes = [max(0.0, h) if idle else h for h in each]
    return max(pushes) if norm == "l1" else sum(pushes)


def least_ratio(
    A: ConvexSet, Q: ConvexSet, sampled: int = 20000, descents: int = 4, seed: int = 0
) -> tuple[float, Array]:
    """Least h_A(u)/h_Q(u) found, and u: an upper bound of d_Q(A).

    The best of many directions, and descents by `polished` from the best of them.
    """
    u = np.random.default_rng(seed).normal(size=(sampled, A.dimension))
    values, points = A.supports(u)
    order = np.argsort(values / Q.supports(u)[0])[:descents]
    seen = list(points[:: sampled // 300])
    return min((polished(A, Q, u[k], seen) for k in order), key=lambda end: end[0])


def polished(A: ConvexSet, Q: ConvexSet, u: Array, points: list[Array]) -> tuple[float, Array]:
    """Go down from u: min h_A(v) over s_Q(u) · v = 1, a convex problem, then again from v.

    As h_Q(v) ≥ s_Q(u) · v, the ratio never grows. Each problem by cutting planes (linear
    programmes over the support points of A seen so far, which are added to `points`).
    """
    value = A.support(u)[0] / Q.support(u)[0]
    points += [A.support(e)[1] for e in (*np.eye(len(u)), *-np.eye(len(u)), u)]
    for _ in range(20):
        before, s = value, Q.support(u)[1]
        for _ in range(60):
            solved = linprog(
                [0.0] * len(u) + [1.0],
                A_ub=np.column_stack([np.array(points), -np.ones(len(points))]),
                b_ub=np.zeros(len(points)),
                A_eq=[[*s, 0.0]],
                b_eq=[1.0],
                bounds=[(-1e3, 1e3)] * len(u) + [(None, None)],
            )
            v = solved.x[:-1]
            h_a, point = A.support(v)
            here = h_a / Q.support(v)[0]
            if here < value:
                value, u = here, v
            points.append(point)
            if h_a - solved.x[-1] < 1e-6:
                break
        if value > before - 1e-6:
            break
    return float(value), u / np.linalg.norm(u)
