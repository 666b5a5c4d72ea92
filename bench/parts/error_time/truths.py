"""The families of the measurement, with names for its tables; the truths are the tests' own.

Scenes and theorems are those of ``tests/worlds/critical.py`` where it has them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from oracles.exact.numbers import root
from oracles.exact.polygons import polygon, squared_diameter
from scenarios import model as draw
from worlds import critical
from worlds.critical import Family
from worlds.scene import Scene, plain

NOT_HELD_TO_THE_GOAL = frozenset({"bug trap's neck"})  # known to be hard for our cells


def with_formula() -> Iterator[Family]:
    """Yield the families whose critical value has a formula."""
    by_name = {family.name: family for family in critical.families()}
    yield replace(by_name["corner, 0.1 wide"], name="corner")
    yield replace(by_name["corner of 1.0 and 2.0, 0.125 wide"], name="corner 1 : 2")
    room = by_name["room, 3 x 4"]
    yield replace(room, name="square room", make=_off_centre(room.make))
    yield replace(by_name["gate 0.5 thick, rectangle"], name="rectangle, slot")
    for sides in (5, 8, 32):
        family = critical.gate(f"{sides}-gon", draw.regular_ring(sides, 0.5), 0.5)
        yield replace(family, name=f"{sides}-gon, slot")
    yield _turning_triangle()


def harder() -> Iterator[Family]:
    """Yield two families, with formulas too, that are known to be hard for our cells."""
    by_name = {family.name: family for family in critical.families()}
    yield by_name["bug trap's neck"]
    # The scene is mapped by z -> (3 + 4i) z: a gate slanted against both axes.
    slanted = by_name["slanted gate 0.5 thick, rectangle"]
    yield replace(slanted, name="slanted slot", finest=1e-10)


def _off_centre(make: Callable[[float], Scene]) -> Callable[[float], Scene]:
    """Start and end the quarter turn off the room's centre: not the straight motion that passes.

    The theorem does not depend on where they are.
    """

    def moved(side: float) -> Scene:
        return {
            **make(side),
            "start": [0.375, 0.125, 0.0],
            "goal": [-0.125, -0.375, 0.5 * math.pi],
        }

    return moved


def _turning_triangle() -> Family:
    """Turn a triangle by half a turn in a corridor: as wide as the longest side.

    In half a turn, either way round, every direction of the body comes to lie across the corridor;
    its extent in a direction is largest along its diameter, the longest side. Half a turn to the
    double of π leaves out directions within 10^-15 of the corridor's own; the longest side is not
    among them.
    """
    ring = critical.ROBOTS["triangle"]
    squared = squared_diameter(polygon(ring))

    def make(width: float) -> Scene:
        half = 0.5 * width
        return plain(
            draw.scene(
                "corridor",
                f"A triangle makes half a turn in a corridor {width} wide.",
                workspace=(-4.0, -half, 4.0, half),
                robot=draw.polygon(ring),
                obstacles=[],
                start=(-2.5, -0.125, 0.0),
                goal=(2.5, 0.125, math.pi),
            )
        )

    return critical.with_theorem(
        "triangle, corridor", make, root(squared), lambda width: Fraction(width) ** 2 >= squared
    )
