"""Snowflake family: a six-armed robot of 24 vertices passes a gate narrower than itself."""

import math

from scenarios.model import Ring, Scene, box, polar, polygon, scene

# The snowflake is 2.0 from tip to tip; bisection with the planner puts the critical gate at 1.3998.
PATH_GATE = 1.6
JAMMED_GATE = 1.3

WALL = 0.2


def snowflake_ring() -> Ring:
    """Six arms of four vertices (valley, shoulder, tip, shoulder), star-shaped about the origin."""
    ring: Ring = []
    for k in range(6):
        arm = k * math.pi / 3.0
        ring += [
            polar(0.3, arm - math.pi / 6.0),
            polar(0.8, arm - 0.16),
            polar(1.0, arm),
            polar(0.8, arm + 0.16),
        ]
    return ring


def snowflake(gate: float = PATH_GATE, name: str = "snowflake") -> Scene:
    """Snowflake scene with a given width of the gate."""
    if not 0.0 < gate < 3.0:
        raise ValueError(f"snowflake: gate is {gate}, must be in (0, 3)")
    return scene(
        name,
        f"A snowflake 2.0 from tip to tip must pass a gate {gate} wide in a wall {WALL} thick.",
        workspace=(-4.0, -2.5, 4.0, 2.5),
        robot=polygon(snowflake_ring()),
        obstacles=[
            box(-0.5 * WALL, 0.5 * gate, 0.5 * WALL, 2.5),
            box(-0.5 * WALL, -2.5, 0.5 * WALL, -0.5 * gate),
        ],
        start=(-2.5, 1.0, 0.0),
        goal=(2.5, -1.0, 0.5),
    )
