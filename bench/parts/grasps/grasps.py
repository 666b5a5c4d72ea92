"""Random force-closure grasps with point contacts, for the comparison with linearised cones."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from parts.grasps import linearised
from pdg.grasp import Contact, point_contact

FRICTION = 0.5
RADII = np.array([1.0, 0.8, 0.6])  # semi-axes of the ellipsoid that is grasped
LEAST = 0.02  # d_Q(W) of a grasp that is worth measuring, by cones with 16 edges within the true


def random_grasps(seed: int, count: int, contacts: int) -> Iterator[list[Contact]]:
    """Yield grasps of an ellipsoid at random points; those with d_Q(W) ≤ LEAST are passed over."""
    random = np.random.default_rng((seed, contacts))
    found = 0
    while found < count:
        directions = random.normal(size=(contacts, 3))
        points = RADII * directions / np.linalg.norm(directions, axis=1, keepdims=True)
        grasp = [point_contact(p, -p / RADII**2, FRICTION) for p in points]
        if linearised.efficiency(grasp, 16) > LEAST:
            found += 1
            yield grasp
