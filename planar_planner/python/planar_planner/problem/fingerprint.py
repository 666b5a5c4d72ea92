"""The identity of a problem: a hash of its exact numbers."""

from __future__ import annotations

import hashlib

import numpy as np
from numpy.typing import ArrayLike

from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem


def fingerprint(problem: Problem) -> str:
    """Return the SHA-256 of everything that the answer depends on, hexadecimal.

    Geometry, bounds, start and goal enter as the exact doubles (little-endian, −0 as 0), each list
    with its name and length. Names of scenes do not enter.
    """
    digest = hashlib.sha256(b"planar-planner/problem 1")

    def add(label: str, values: ArrayLike) -> None:
        numbers = np.asarray(values, dtype="<f8").ravel() + 0.0  # which turns −0 into 0
        digest.update(f"\n{label} {len(numbers)}\n".encode() + numbers.tobytes())

    for label, polygons in (
        ("robot", problem.robot),
        ("obstacles", problem.obstacles),
        ("workspace", problem.workspace),
    ):
        if polygons is not None:
            add(f"{label} points", polygons.coords)
            add(f"{label} rings", polygons.ring_starts)
            add(f"{label} polygons", polygons.polygon_starts)
    add("box", problem.workspace_box or ())
    add("reference bounds", problem.reference_bounds or ())
    add("rotation", [problem.rotation])
    add("start", problem.start)
    goal = problem.goal
    if isinstance(goal, GoalSet):
        add("goal points", goal.polygons.coords)
        add("goal rings", goal.polygons.ring_starts)
        add("goal polygons", goal.polygons.polygon_starts)
        add("goal angles", goal.angles or ())
    else:
        add("goal", goal)
    return digest.hexdigest()
