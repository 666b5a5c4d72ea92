"""The usual practice: friction cones with k edges, convex hull by Qhull, nearest facet."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from pdg.grasp import Contact, contact_map

EDGES = (4, 8, 16, 24, 64)


def edge_wrenches(contacts: Sequence[Contact], edges: int) -> NDArray[np.float64]:
    """Return the wrenches of forces on the cones' edges with f_1 = 1, for point contacts."""
    angles = 2 * np.pi * np.arange(edges) / edges
    wrenches = []
    for contact in contacts:
        f = np.ones((edges, 4))
        f[:, 1] = contact.friction * np.cos(angles)
        f[:, 2] = contact.friction * np.sin(angles)
        f[:, 3] = 0
        wrenches.append(f @ contact_map(contact).T)
    return np.concatenate(wrenches)


def efficiency(contacts: Sequence[Contact], edges: int) -> float:
    """Return the distance from the origin to the hull's surface (L1 norm, Q the unit ball)."""
    hull = ConvexHull(edge_wrenches(contacts, edges))
    return max(0.0, float(-hull.equations[:, -1].max()))
