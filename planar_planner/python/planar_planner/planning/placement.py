"""Start and goal: is the robot free there? Asked of the core before anything else is computed."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

from planar_planner._core import Core
from planar_planner.errors import SceneError
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem, ends, obstacle_title

SMALL_OVERLAP = 1e-3
"""Share of the robot's radius up to which an overlap is probably meant as a contact."""


Placements = dict[str, dict[str, Any]]
"""What `Core.placement` says of the start, and of the goal if it is a configuration."""


def find_placements(core: Core, problem: Problem) -> Placements:
    """Return where the ends of a query are, by name; lengths in the core's unit."""
    return {field: core.placement(q) for field, q in ends(problem).items()}


def is_contact(found: Placements) -> bool:
    """Whether rounded arithmetic leaves it open that an end touches, overlaps or is free."""
    return any(each["state"] == "contact" or each["exact"] for each in found.values())


def check_placements(
    found: Placements, problem: Problem, contact_tolerance: float, unit: float = 1.0
) -> None:
    """Reject a start or goal where the robot collides or is outside its bounds.

    A region may lie in collision, wholly or in part: that is for the planner to find out. Touching
    is legal. A depth up to `contact_tolerance` (length) counts as touching. `found` counts lengths
    in `unit` of the scene's.

    Raises
    ------
    SceneError
        With the obstacle and how deep the robot is in it, or how far it is outside.
    """
    for field, q in ends(problem).items():
        each = {**found[field], "depth": found[field]["depth"] * unit}
        if each["state"] in ("colliding", "outside") and each["depth"] > contact_tolerance:
            hint = _hint(each["depth"], problem) if contact_tolerance == 0 else ""
            raise SceneError(explanation(each, problem) + hint, field, str(list(q)), problem.source)


def _hint(depth: float, problem: Problem) -> str:
    """Name the tolerance that takes an overlap which is small beside the robot for a contact."""
    radius = float(np.hypot(*problem.robot.coords.T).max())
    if depth > SMALL_OVERLAP * radius:
        return ""
    tolerance = f"--contact-tolerance {1.1 * depth:.2g} takes it for a contact"
    if depth <= _rounding(problem):
        return f", which may be the rounding of decimals to doubles; {tolerance}"
    return f"; {tolerance}"


def _rounding(problem: Problem) -> float:
    """Return by how much a contact of decimals may overlap when each is rounded to a double."""
    lengths = [problem.robot.coords, problem.obstacles.coords, np.array(problem.start[:2])]
    if not isinstance(problem.goal, GoalSet):
        lengths.append(np.array(problem.goal[:2]))
    if problem.workspace_box:
        lengths.append(np.array(problem.workspace_box))
    largest = max(float(np.abs(each).max()) for each in lengths if each.size)
    return 4 * sys.float_info.epsilon * largest


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
