"""Families of scenes with a critical parameter that is known: to 60 places, or by a bracket.

Scenes and theorems are those of ``stress_parts/families.py`` where it has them. Parameters are
chosen at a relative distance from the critical value and must lie on the side that they are meant
for *after* rounding to a double; that is checked in rational arithmetic.
"""

from __future__ import annotations

import decimal
import itertools
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from stress_parts import families as known
from stress_parts.exact import Polygon, longest_round_corner, polygon, squared_width

from scenarios import model as draw

Scene = dict[str, Any]
Side = Literal["path", "no_path"]
SIDES: tuple[Side, Side] = ("path", "no_path")

PLACES = 60


@dataclass(frozen=True)
class Truth:
    """Scenes by a parameter, and where their answer changes.

    Attributes
    ----------
    name : str
        For tables and pictures.
    make : callable
        Scene of a parameter.
    no_path_at, path_at : Fraction
        The critical parameter from the side without a path and from the side with one: equal, to
        `PLACES` places, where there is a formula; else the ends of a bracket.
    passing : int
        1 if larger parameters have a path, -1 if smaller ones do.
    has_path : callable or None
        The theorem as a test of a parameter in rational arithmetic; None without one.
    grid : float
        Parameters are multiples of it, where the scene's coordinates would be rounded otherwise.
    finest : float
        The smallest relative distance at which scenes still differ by more than their rounding.
    expected : bool
        Whether ours is held to its goal here.
    """

    name: str
    make: Callable[[float], Scene]
    no_path_at: Fraction
    path_at: Fraction
    passing: int
    has_path: known.Theorem | None
    grid: float = 0.0
    finest: float = 1e-12
    expected: bool = True

    def parameter(self, side: Side, distance: float) -> float:
        """Return the parameter at a relative distance; raise if rounding puts it elsewhere."""
        known_end = self.path_at if side == "path" else self.no_path_at
        outward = self.passing if side == "path" else -self.passing
        exact = known_end * (1 + outward * Fraction(distance))
        value = self.grid * round(exact / Fraction(self.grid)) if self.grid else float(exact)
        off = (Fraction(value) / known_end - 1) * outward / Fraction(distance)
        if not Fraction(99, 100) < off < Fraction(101, 100):
            raise ValueError(f"{self.name}: {distance:g} is not kept by rounding")
        if self.has_path is not None and self.has_path(value) != (side == "path"):
            raise ValueError(f"{self.name}: {value!r} is not on the side of {side}")
        return value


def exact_root(square: Fraction) -> Fraction:
    """Return a square root to `PLACES` places."""
    with decimal.localcontext() as context:
        context.prec = PLACES + 10
        return Fraction((decimal.Decimal(square.numerator) / square.denominator).sqrt())


def _of(family: known.Family, critical: Fraction, name: str, **fields: Any) -> Truth:
    """Return a family of the stress test with its critical value in full."""
    make = fields.pop("make", family.make)
    passing = fields.pop("passing", 1)
    return Truth(name, make, critical, critical, passing, family.has_path, family.grid, **fields)


def with_formula() -> Iterator[Truth]:
    """Yield the families whose critical value has a formula."""
    by_name = {family.name: family for family in known.families()}

    for a, b, width in ((1.0, 1.0, 0.1), (1.0, 2.0, 0.125)):
        even = f"corner, {width} wide"
        family = by_name[even if a == b else f"corner of {a} and {b}, {width} wide"]
        critical = longest_round_corner(Fraction(a), Fraction(b), Fraction(width))
        name = "corner" if a == b else f"corner {a:g} : {b:g}"
        yield _of(family, critical, name, passing=-1)

    yield _of(by_name["room, 3 x 4"], Fraction(5), "square room", make=_off_centre_room(by_name))

    rectangle = known.ROBOTS["rectangle"]
    yield _of(by_name["gate 0.5 thick, rectangle"], _width(rectangle), "rectangle, slot")
    for sides in (5, 8, 32):
        ring = draw.regular_ring(sides, 0.5)
        family = known.gate(f"{sides}-gon", ring, 0.5)
        yield _of(family, _width(ring), f"{sides}-gon, slot")

    yield _turning_triangle()


def harder() -> Iterator[Truth]:
    """Yield two families, with formulas too, that are known to be hard for our cells."""
    by_name = {family.name: family for family in known.families()}
    yield _of(by_name["bug trap's neck"], Fraction(1, 2), "bug trap's neck", expected=False)
    # The scene is mapped by z -> (3 + 4i) z: a gate slanted against both axes.
    slanted = by_name["slanted gate 0.5 thick, rectangle"]
    width = _width(known.ROBOTS["rectangle"])
    yield _of(slanted, width, "slanted slot", finest=1e-10)


def _width(ring: list[draw.Point]) -> Fraction:
    """Return the least width of a convex polygon as its doubles are (Strang's theorem)."""
    return exact_root(squared_width(polygon(ring)))


def _off_centre_room(by_name: dict[str, known.Family]) -> Callable[[float], Scene]:
    """Start and end the quarter turn off the room's centre: not the straight motion that passes.

    The theorem does not depend on where they are.
    """
    family = by_name["room, 3 x 4"]

    def make(side: float) -> Scene:
        return {
            **family.make(side),
            "start": [0.375, 0.125, 0.0],
            "goal": [-0.125, -0.375, 0.5 * math.pi],
        }

    return make


def _diameter_squared(ring: Polygon) -> Fraction:
    pairs = itertools.combinations(ring, 2)
    return max((bx - ax) ** 2 + (by - ay) ** 2 for (ax, ay), (bx, by) in pairs)


def _turning_triangle() -> Truth:
    """Turn a triangle by half a turn in a corridor: as wide as the longest side.

    In half a turn, either way round, every direction of the body comes to lie across the corridor;
    its extent in a direction is largest along its diameter, the longest side. Half a turn to the
    double of π leaves out directions within 10^-15 of the corridor's own; the longest side is not
    among them.
    """
    ring = known.ROBOTS["triangle"]
    squared = _diameter_squared(polygon(ring))

    def make(width: float) -> Scene:
        half = 0.5 * width
        return known.plain(
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

    critical = exact_root(squared)
    return Truth(
        "triangle, corridor",
        make,
        critical,
        critical,
        1,
        lambda width: Fraction(width) ** 2 >= squared,
    )
