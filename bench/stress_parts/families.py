"""Families of scenes with one parameter, and on which side of its critical value there is a path.

The truth is that of the exact doubles in the scene. It is decided in rational arithmetic, from a
theorem stated at each family; touching is allowed, so that at the critical value there is a path.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import cast

from scenarios import bug_trap
from scenarios import model as draw
from stress_parts.common import Scene
from stress_parts.exact import longest_round_corner, polygon, squared_width
from stress_parts.maps import Similarity, similar

Theorem = Callable[[float | Fraction], bool]
"""Whether there is a path at a parameter, in rational arithmetic."""


@dataclass(frozen=True)
class Family:
    """Scenes by a parameter.

    Attributes
    ----------
    name : str
        For the table.
    critical : float
        Near the critical value, to choose parameters by.
    make : callable
        Scene of a parameter.
    has_path : callable
        The truth of a parameter.
    grid : float
        Parameters are multiples of it, where the scene's coordinates would be rounded otherwise.
    """

    name: str
    critical: float
    make: Callable[[float], Scene]
    has_path: Theorem
    grid: float = 0.0

    def parameter(self, relative: float) -> float:
        """Return the parameter at a relative distance from the critical value."""
        value = self.critical * (1.0 + relative)
        return self.grid * round(value / self.grid) if self.grid else value


def plain(scene: draw.Scene) -> Scene:
    """Return a generated scene as a dictionary of lists."""
    return cast(Scene, scene)


def families() -> Iterator[Family]:
    """Yield all of them."""
    yield from (_corner(width) for width in (0.1, 0.5, 0.01))
    yield from (_uneven_corner(*sizes) for sizes in ((1.0, 2.0, 0.125), (1.5, 1.0, 0.5)))
    yield Family(
        "bug trap's neck",
        bug_trap.ROBOT_WIDTH,
        lambda neck: plain(bug_trap.bug_trap(neck)),
        lambda neck: neck >= bug_trap.ROBOT_WIDTH,
    )
    for name, ring in ROBOTS.items():
        yield gate(name, ring, 0.5)
    yield gate("rectangle", ROBOTS["rectangle"], 0.5, turns=False)
    yield gate("rectangle", ROBOTS["rectangle"], 3.0)
    yield gate("rectangle", ROBOTS["rectangle"], 0.5, by=Similarity(3 + 4j))
    yield gate("triangle", ROBOTS["triangle"], 0.25, by=Similarity(5 + 2j))
    for walls in (False, True):
        yield _room(1.0, 1.0, walls=walls)
        yield _room(3.0, 4.0, walls=walls)


def _corner(width: float) -> Family:
    """Turn a rectangle round a corner between corridors of width 1: (l/2 + w)² ≤ 2.

    At angle φ it passes if l ≤ (sin φ + cos φ − w)/(sin φ cos φ) = 2(s − w)/(s² − 1) with
    s = sin φ + cos φ, which falls with s for w < 1 and is least at s = √2.
    """

    def has_path(length: float | Fraction) -> bool:
        return bool((Fraction(length) / 2 + Fraction(width)) ** 2 <= 2)

    return Family(
        f"corner, {width} wide",
        2.0 * (math.sqrt(2.0) - width),
        lambda length: _round_corner(1.0, 1.0, width, length),
        has_path,
    )


def _uneven_corner(a: float, b: float, width: float) -> Family:
    """Turn a rectangle round a corner between corridors of two widths."""
    critical = longest_round_corner(Fraction(a), Fraction(b), Fraction(width))
    return Family(
        f"corner of {a} and {b}, {width} wide",
        float(critical),
        lambda length: _round_corner(a, b, width, length),
        lambda length: Fraction(length) <= critical,
    )


def _round_corner(a: float, b: float, width: float, length: float) -> Scene:
    """Return the scene of a rectangle before a corner; coordinates are halves of the arguments."""
    far = 8.0
    return plain(
        draw.scene(
            "corner",
            f"A rectangle {length} x {width} between corridors of {a} and {b}.",
            workspace=(0.0, 0.0, far, far),
            robot=draw.box(-0.5 * length, -0.5 * width, 0.5 * length, 0.5 * width),
            obstacles=[draw.box(a, b, far, far)],
            start=(0.5 * a, 5.0, -0.5 * math.pi),
            goal=(5.0, 0.5 * b, 0.0),
        )
    )


ROBOTS: dict[str, list[draw.Point]] = {
    "rectangle": draw.box_ring(-0.75, -0.25, 0.75, 0.25),
    "triangle": [(-0.625, -0.5), (0.875, -0.25), (0.0, 0.75)],
    "pentagon": [(-0.75, 0.0), (-0.5, -0.625), (0.5, -0.5), (0.75, 0.125), (0.0, 0.5)],
    "32-gon, a disc nearly": draw.regular_ring(32, 0.5),
}


def gate(
    name: str,
    ring: list[draw.Point],
    thick: float,
    *,
    turns: bool = True,
    by: Similarity | None = None,
) -> Family:
    """Pass a convex robot through a gate: its least width must not exceed the gate's.

    That is Strang, *The Width of a Chair*, American Mathematical Monthly 89, 1982: a convex body
    gets through a door just when it can be translated through. It may not turn: the rectangle's
    height, which at θ = 0 is its least width, and all of its upright chords.
    """
    squared = squared_width(polygon(ring))

    def make(width: float) -> Scene:
        y, x = 0.5 * width, 0.5 * thick
        theta = 1.0 if turns else 0.0
        made = plain(
            draw.scene(
                "gate",
                f"{name} through a gate {width} wide.",
                workspace=(-4.0, -4.0, 4.0, 4.0),
                robot=draw.polygon(ring),
                obstacles=[draw.box(-x, y, x, 4.0), draw.box(-x, -4.0, x, -y)],
                start=(-2.75, 0.5, theta),
                goal=(2.75, -0.5, 0.5 * theta),
                rotation=turns,
            )
        )
        image = similar(made, by) if by else made
        assert image is not None
        return image

    kind = "slanted gate" if by else "gate"
    return Family(
        f"{kind} {thick} thick, {name}{'' if turns else ', no turning'}",
        math.sqrt(squared),
        make,
        lambda width: Fraction(width) ** 2 >= squared,
        grid=2.0**-44 if by else 0.0,
    )


def _room(width: float, height: float, *, walls: bool) -> Family:
    """Turn a rectangle in a square room by a right angle: its diagonal must not exceed the side.

    At angle φ its extent is w cos φ + h sin φ in one direction and w sin φ + h cos φ in the other;
    from 0 to π/2, either way round, the larger of them takes its maximum, the diagonal.
    """

    def make(side: float) -> Scene:
        half = 0.5 * side
        room = (-half, -half, half, half)
        far = 16.0
        frame = draw.polygon(draw.box_ring(-far, -far, far, far), draw.box_ring(*room))
        return plain(
            draw.scene(
                "room",
                f"A rectangle {width} x {height} turns in a room {side} wide.",
                workspace=(-far, -far, far, far) if walls else room,
                robot=draw.box(-0.5 * width, -0.5 * height, 0.5 * width, 0.5 * height),
                obstacles=[frame] if walls else [],
                start=(0.0, 0.0, 0.0),
                goal=(0.0, 0.0, 0.5 * math.pi),
            )
        )

    squared = Fraction(width) ** 2 + Fraction(height) ** 2
    return Family(
        f"room{' of obstacles' if walls else ''}, {width:g} x {height:g}",
        math.sqrt(squared),
        make,
        lambda side: Fraction(side) ** 2 >= squared,
    )
