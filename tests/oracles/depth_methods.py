"""PD^t of two convex polygons by other ways, in doubles: a Minkowski hull, sampled directions."""

from __future__ import annotations

import numpy as np
import shapely

from oracles.placing import Array, Pose, placed


def minkowski_depth(a: Array, b: Array, pose: Pose) -> float:
    """Return PD^t as the origin's distance from the boundary of the hull of all b - a (shapely).

    Negative if the origin lies outside: minus the distance of the bodies.
    """
    moved = placed(a, pose)
    sums = (b[:, None, :] - moved[None, :, :]).reshape(-1, 2)
    # The hull of a line through all points: as many points would be as many objects.
    difference, origin = shapely.linestrings(sums).convex_hull, shapely.Point(0, 0)
    distance = float(difference.exterior.distance(origin))
    return distance if difference.contains(origin) else -distance


def sampled_depth(a: Array, b: Array, pose: Pose, directions: int) -> float:
    """Return the least way out over evenly spread directions: an upper bound of PD^t."""
    angles = 2 * np.pi * np.arange(directions) / directions
    normals = np.stack([np.cos(angles), np.sin(angles)])
    return float(np.min((b @ normals).max(axis=0) - (placed(a, pose) @ normals).min(axis=0)))
