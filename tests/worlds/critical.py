"""Families of scenes with one parameter, and on which side of its critical value there is a path.

The truth is that of the exact doubles in the scene. It is decided in rational arithmetic, from a
theorem stated at each family; touching is allowed, so that at the critical value there is a path.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from oracles.exact.corner import longest_round_corner
from oracles.exact.numbers import root
from oracles.exact.polygons import polygon, squared_width
from scenarios import bug_trap
from scenarios import model as draw
from worlds.maps import Similarity, similar
from worlds.scene import Scene, plain

Theorem = Callable[[float | Fraction], bool]
"""Whether there is a path at a parameter, in rational arithmetic."""


Side = Literal["path", "no_path"]
SIDES: tuple[Side, Side] = ("path", "no_path")


@dataclass(frozen=True)
class Family:
    """Scenes by a parameter, and where their answer changes.

    Attributes
    ----------
    name : str
        For tables and pictures.
    make : callable
        Scene of a parameter.
    no_path_at, path_at : Fraction
        The critical parameter from the side without a path and from the side with one: equal, to
        60 places, where there is a formula; else the ends of a bracket.
    passing : int
        1 if larger parameters have a path, -1 if smaller ones do.
    has_path : callable
        The theorem as a test of a parameter in rational arithmetic.
    grid : float
        Parameters are multiples of it, where the scene's coordinates would be rounded otherwise.
    finest : float
        The smallest relative distance at which scenes still differ by more than their rounding.
    """

    name: str
    make: Callable[[float], Scene]
    no_path_at: Fraction
    path_at: Fraction
    passing: int
    has_path: Theorem
    grid: float = 0.0
    finest: float = 1e-12

    @property
    def critical(self) -> float:
        """The critical value as a double, to choose parameters by."""
        return float(self.path_at)

    def near(self, relative: float) -> float:
        """Return the parameter at a signed relative distance from the critical value, nearly."""
        value = self.critical * (1.0 + relative)
        return self.grid * round(value / self.grid) if self.grid else value

    def parameter(self, side: Side, distance: float) -> float:
        """Return the parameter at a relative distance; raise if rounding puts it elsewhere."""
        known_end = self.path_at if side == "path" else self.no_path_at
        outward = self.passing if side == "path" else -self.passing
        exact = known_end * (1 + outward * Fraction(distance))
        value = self.grid * round(exact / Fraction(self.grid)) if self.grid else float(exact)
        off = (Fraction(value) / known_end - 1) * outward / Fraction(distance)
        if not Fraction(99, 100) < off < Fraction(101, 100):
            raise ValueError(f"{self.name}: {distance:g} is not kept by rounding")
        if self.has_path(value) != (side == "path"):
            raise ValueError(f"{self.name}: {value!r} is not on the side of {side}")
        return value


def with_theorem(
    name: str,
    make: Callable[[float], Scene],
    critical: Fraction,
    has_path: Theorem,
    *,
    passing: int = 1,
    grid: float = 0.0,
) -> Family:
    """Return a family whose critical value has a formula."""
    return Family(name, make, critical, critical, passing, has_path, grid)


def families() -> Iterator[Family]:
    """Yield all of them."""
    yield from (_corner(width) for width in (0.1, 0.5, 0.01))
    yield from (_uneven_corner(*sizes) for sizes in ((1.0, 2.0, 0.125), (1.5, 1.0, 0.5)))
    yield with_theorem(
        "bug trap's neck",
        lambda neck: plain(bug_trap.bug_trap(neck)),
        Fraction(bug_trap.ROBOT_WIDTH),
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

    return with_theorem(
        f"corner, {width} wide",
        lambda length: _round_corner(1.0, 1.0, width, length),
        2 * (root(Fraction(2)) - Fraction(width)),
        has_path,
        passing=-1,
    )


def _uneven_corner(a: float, b: float, width: float) -> Family:
    """Turn a rectangle round a corner between corridors of two widths."""
    critical = longest_round_corner(Fraction(a), Fraction(b), Fraction(width))
    return with_theorem(
        f"corner of {a} and {b}, {width} wide",
        lambda length: _round_corner(a, b, width, length),
        critical,
        lambda length: Fraction(length) <= critical,
        passing=-1,
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
    return with_theorem(
        f"{kind} {thick} thick, {name}{'' if turns else ', no turning'}",
        make,
        root(squared),
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
    return with_theorem(
        f"room{' of obstacles' if walls else ''}, {width:g} x {height:g}",
        make,
        root(squared),
        lambda side: Fraction(side) ** 2 >= squared,
    )
