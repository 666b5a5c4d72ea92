"""Start and goal: is the robot free there? Asked of the core before anything else is computed."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_planner._core import Core
from planar_planner.errors import SceneError
from planar_planner.problem.make import Problem, ends, obstacle_title

SMALL_OVERLAP = 1e-3
"""Share of the robot's radius up to which an overlap is probably meant as a contact."""


def check_placements(core: Core, problem: Problem, contact_tolerance: float) -> None:
    """Reject a start or goal where the robot collides or is outside its bounds.

    A region may lie in collision, wholly or in part: that is for the planner to find out. Touching
    is legal. A depth up to `contact_tolerance` (length) counts as touching.

    Raises
    ------
    SceneError
        With the obstacle and how deep the robot is in it, or how far it is outside.
    """
    for field, q in ends(problem).items():
        found = core.placement(q)
        if found["state"] in ("colliding", "outside") and found["depth"] > contact_tolerance:
            hint = _hint(found["depth"], problem) if contact_tolerance == 0 else ""
            raise SceneError(
                explanation(found, problem) + hint, field, str(list(q)), problem.source
            )


def _hint(depth: float, problem: Problem) -> str:
    """Name the tolerance that takes an overlap which is small beside the robot for a contact."""
    radius = float(np.hypot(*problem.robot.coords.T).max())
    if depth > SMALL_OVERLAP * radius:
        return ""
    return f"; --contact-tolerance {1.1 * depth:.2g} takes it for a contact"


def explanation(found: dict[str, Any], problem: Problem) -> str:
    """Return in words how a placement, of `Core.placement`, is not free."""
    depth = f"{found['depth']:.6g}"
    if found["what"] == "obstacle":
        polygon = found["polygon"]
        obstacle, path = obstacle_title(problem, polygon), problem.obstacle_paths[polygon]
        whole = f"obstacles[{problem.obstacle_indices[polygon]}].coordinates"
        part = "" if path == whole else f" (at {path})"
        return f"robot collides with {obstacle}{part}, penetration depth {depth}"
    if found["what"] == "reference_bounds":
        chosen = ", which were chosen for a file that states none" * problem.bounds_are_chosen
        return f"reference point is outside reference_bounds by {depth}{chosen}"
    return f"robot is outside the workspace by {depth}"
