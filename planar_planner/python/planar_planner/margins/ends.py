"""The ends of a query: how far the robot can grow until start or goal is not free."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_planner._core import Core
from planar_planner.errors import SceneError
from planar_planner.margins.scaling import Scalings
from planar_planner.margins.surroundings import Surroundings, placed, shape_of
from planar_planner.planning.engine import make_core
from planar_planner.planning.placement import explanation
from planar_planner.problem.make import Problem
from planar_planner.problem.make import ends as both_ends
from planar_planner.problem.plane import with_robot
from planar_planner.scene.input_limits import MAX_COORDINATE


@dataclass(frozen=True)
class Ends:
    """Rounded clearances of the robot at its own size, and the margin at which an end is not free.

    Attributes
    ----------
    start, goal : float
        Distances from what is nearest; 0 at an end that is in contact or collides. Infinite for a
        goal that is a region: a larger robot may use another place in it.
    limit : float
        Beyond this margin one of them is proven not to be free. Infinite if there is nothing to
        touch.
    binding : str
        The end that is not free: "start" or "goal"; "none" if there is nothing to touch.
    """

    start: float
    goal: float
    limit: float
    binding: str


def ends_of(problem: Problem, core: Core, around: Surroundings) -> Ends:
    """Measure both ends, and how far the robot can grow there.

    Raises
    ------
    SceneError
        If an end is outside the reference bounds, which no size of the robot makes legal.
    """
    found, room = {}, {}
    shape = shape_of(problem.robot)
    for name, q in both_ends(problem).items():
        placement = core.placement(q)
        if placement["what"] == "reference_bounds":
            raise SceneError(explanation(placement, problem), name, str(list(q)), problem.source)
        clearance = around.clearance(placed(shape, q))
        found[name] = clearance if placement["state"] == "free" else 0.0
        # A placement in contact is one within rounding, so the measured distance counts.
        room[name] = 0.0 if placement["state"] in ("colliding", "outside") else clearance
    binding = min(room, key=lambda name: room[name])
    if not math.isfinite(room[binding]):
        return Ends(math.inf, math.inf, math.inf, "none")
    slack = max(around.rounding(problem.robot, q) for q in both_ends(problem).values())
    return Ends(found["start"], found.get("goal", math.inf), room[binding] + slack, binding)


def scale_limit(problem: Problem, family: Scalings, ends: Ends, width: float) -> tuple[float, str]:
    """Return a factor at which an end is proven not to be free, and which end.

    The factor is doubled until an end is not free, then bisected to `width`, by placements only.
    """
    if not math.isfinite(ends.limit):
        return math.inf, "none"
    low, high = family.neutral, 2.0 * family.neutral
    blocked = _blocked_end(problem, family, high, high)
    while blocked is None:
        low, high = high, 2.0 * high
        if high * family.reach > MAX_COORDINATE:
            return math.inf, "none"
        blocked = _blocked_end(problem, family, high, high)
    while high - low > width:
        end = _blocked_end(problem, family, low, high)
        middle = 0.5 * (low + high)
        low, high, blocked = (middle, high, blocked) if end is None else (low, middle, end)
    return family.between(high, high).outer, blocked


def _blocked_end(problem: Problem, family: Scalings, low: float, high: float) -> str | None:
    """Return the end, if any, that is proven not to be free for the body in the middle."""
    body = family.between(low, high)
    if body.polygons is None:
        return None
    core = make_core(with_robot(problem, body.polygons))
    both = both_ends(problem).items()
    return next((name for name, q in both if core.placement(q)["state"] == "colliding"), None)
