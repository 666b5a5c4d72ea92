"""Scenes of the targets beyond those that ship: families by bisection, a wall of many gates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from lib.timing import Measured, measure
from planar_planner import Options
from scenarios import snowflake
from scenarios.model import Scene, box, scene

GATE_PITCH = 4.0  # of the wall with many gates; the snowflake is 2 from tip to tip
GATE_WALL = 0.3  # half its thickness
JAMMED_GATES = 1300  # enough for a million cells


@dataclass(frozen=True)
class Bisection:
    """A parameter's bracket: no path at `blocked`, a path at `passing`; and each decision made."""

    blocked: float
    passing: float
    decisions: list[tuple[float, Measured]]

    @property
    def slowest(self) -> tuple[float, Measured]:
        """The decision with the largest median of core time."""
        return max(self.decisions, key=lambda decision: decision[1].core.median)


def bisect(
    make: Callable[[float], Scene],
    blocked: float,
    passing: float,
    width: float,
    *,
    repetitions: int = 5,
    options: Options | None = None,
) -> Bisection:
    """Halve a bracket until it is narrower than `width`; raise if a decision stays undecided."""
    decisions = []
    while abs(passing - blocked) > width:
        middle = 0.5 * (blocked + passing)
        measured = measure(make(middle), options, most=repetitions)
        decisions.append((middle, measured))
        if measured.result.verdict == "undecided":
            raise RuntimeError(f"undecided at {middle!r}: {measured.result.reason}")
        if measured.result.verdict == "path":
            passing = middle
        else:
            blocked = middle
    return Bisection(blocked, passing, decisions)


def jammed_gates(count: int = JAMMED_GATES) -> Scene:
    """Return a wall of gates, each too narrow: all must be refuted, so cells grow with them."""
    gate = snowflake.JAMMED_GATE
    half = 0.5 * (GATE_PITCH - gate)
    length = GATE_PITCH * count
    middle = 0.5 * length + 0.1
    return scene(
        "jammed-gates",
        f"A snowflake before a wall with {count} gates {gate} wide.",
        workspace=(0.0, -4.0, length, 4.0),
        robot=snowflake.snowflake()["robot"],
        obstacles=[
            box(GATE_PITCH * k - half, -GATE_WALL, GATE_PITCH * k + half, GATE_WALL)
            for k in range(count + 1)
        ],
        start=(middle, -2.0, 0.0),
        goal=(middle, 2.0, 0.0),
    )
