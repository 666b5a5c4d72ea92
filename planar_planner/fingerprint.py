"""The identity of a problem: a hash of its exact numbers."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable

from planar_planner.problem import Problem


def fingerprint(problem: Problem) -> str:
    """Return the SHA-256 of everything that the answer depends on, hexadecimal.

    Geometry, bounds, start and goal enter as the exact doubles (−0 as 0), each list on a line of
    its own. Names do not enter.
    """
    digest = hashlib.sha256(b"planar-planner/problem 1")

    def add(label: str, values: Iterable[float]) -> None:
        numbers = " ".join((float(value) + 0.0).hex() for value in values)
        digest.update(f"\n{label}: {numbers}".encode())

    for label, polygons in (
        ("robot", problem.robot),
        ("obstacles", problem.obstacles),
        ("workspace", problem.workspace),
    ):
        if polygons is not None:
            add(f"{label} points", polygons.coords.ravel().tolist())
            add(f"{label} rings", polygons.ring_starts.tolist())
            add(f"{label} polygons", polygons.polygon_starts.tolist())
    add("box", problem.workspace_box or ())
    add("reference bounds", problem.reference_bounds or ())
    add("rotation", [problem.rotation])
    add("start", problem.start)
    add("goal", problem.goal)
    return digest.hexdigest()
