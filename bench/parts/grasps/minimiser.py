"""A plain descent on h_A(u)/|u|, independent of the compiled sets and of the algorithm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from pdg.grasp import Contact


def least_found(contacts: Sequence[Contact], start: NDArray[np.float64], others: int = 6) -> float:
    """Return the least value found from `start` and some random directions: an upper bound.

    h is written out from the definition: the greatest work of a unit normal force and of the
    friction that may go with it (point contacts, L1 norm).
    """
    n = np.array([c.normal for c in contacts])
    p = np.array([c.position for c in contacts])
    mu = np.array([c.friction for c in contacts])

    def value(u: NDArray[np.float64]) -> float:
        velocity = u[:3] + np.cross(u[3:], p)
        along = np.sum(velocity * n, axis=1)
        sideways = np.linalg.norm(velocity - along[:, None] * n, axis=1)
        return float(max(0.0, (along + mu * sideways).max()) / np.linalg.norm(u))

    random = np.random.default_rng(0)
    best = value(start)
    for first in (start, *random.normal(size=(others, 6))):
        found = minimize(
            value,
            first,
            method="Nelder-Mead",
            options={"maxfev": 4000, "xatol": 1e-9, "fatol": 1e-13},
        )
        best = min(best, float(found.fun))
    return best
