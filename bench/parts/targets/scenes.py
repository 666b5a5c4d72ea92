"""A scene of the targets beyond those that ship: a wall of many gates."""

from __future__ import annotations

from scenarios import snowflake
from scenarios.model import Scene, box, scene

GATE_PITCH = 4.0  # of the wall with many gates; the snowflake is 2 from tip to tip
GATE_WALL = 0.3  # half its thickness
JAMMED_GATES = 1300  # enough for a million cells


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
