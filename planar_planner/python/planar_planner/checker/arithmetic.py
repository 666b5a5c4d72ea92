"""Arithmetic on integers: vectors, exactly; angles, cosines and sines with a known error.

A length is an integer in units of 2^-LENGTH_BITS. These units hold the doubles of scenes and the
corners of boxes exactly, so sums and products of lengths are exact.

An angle is radians + 2π turns, both exact fractions, because scenes write radians and boxes count
turns. Angles become integers in units of 2^-ANGLE_BITS, cosines and sines in units of
2^-ROTATION_BITS and off by at most one. Quarter turns are exact: a double that is nearest to a
multiple of π/2 means that multiple.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple, TypeVar

LENGTH_BITS = 320
"""Bits after the binary point of lengths: 219 for the doubles of scenes, 60 for the levels of
boxes, and some to spare."""
ONE = 1 << LENGTH_BITS
"""The length 1."""

Vector = tuple[int, int]
Ring = list[Vector]
Polygon = list[Ring]
"""Rings with the interior on the left: the outer one, then the holes."""
Rectangle = tuple[int, int, int, int]
"""xmin, ymin, xmax, ymax."""

MOST_DIGITS = 12
"""Of a decimal: two of 15 digits are never nearest to one double."""

ROTATION_BITS = 120
ANGLE_BITS = 220
TURNS_ERROR = Fraction(1, 1 << 180)
"""What `turns_of` is off by at most; π is off by 2^-220, an angle is at most 2^20."""

Rotation = tuple[int, int]
"""Cosine and sine."""


class Angle(NamedTuple):
    """The angle radians + 2π turns."""

    radians: Fraction
    turns: Fraction

    @property
    def quarters(self) -> int | None:
        """How many quarter turns it is; None if it is another angle."""
        quarters = 4 * self.turns
        return int(quarters) if self.radians == 0 and quarters.denominator == 1 else None

    def is_same_but_turns(self, other: Angle) -> bool:
        """Whether it is another angle but for whole turns."""
        return self.radians == other.radians and (self.turns - other.turns).denominator == 1


_Item = TypeVar("_Item")


def units(number: float) -> int:
    """Return a double in units of length; those of scenes are multiples of 2^-219."""
    above, below = number.as_integer_ratio()
    return above << (LENGTH_BITS + 1 - below.bit_length())


def decimal_units(number: float, places: int) -> int | None:
    """Return 10^places times the decimal of so many places that a double is nearest to, in units.

    None if there is none, or if it has more than MOST_DIGITS digits, so that there may be two.
    """
    decimal = round(Fraction(number) * Fraction(10) ** places)
    if abs(decimal) > 10**MOST_DIGITS or float(Fraction(decimal, 10**places)) != number:
        return None
    return decimal * ONE


def minus(a: Vector, b: Vector) -> Vector:
    """Return a − b."""
    return a[0] - b[0], a[1] - b[1]


def dot(a: Vector, b: Vector) -> int:
    """Return a · b."""
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Vector, b: Vector) -> int:
    """Return a × b, positive if b is to the left of a."""
    return a[0] * b[1] - a[1] * b[0]


def cyclic_pairs(ring: Sequence[_Item]) -> Iterator[tuple[_Item, _Item]]:
    """Return each item with its successor; the last item's is the first."""
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def bounding_box(points: Iterable[Vector]) -> Rectangle:
    """Return the least rectangle that holds the points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def interiors_apart(a: Rectangle, b: Rectangle) -> bool:
    """Whether the interiors of two rectangles have no point in common."""
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def _atan_inverse(n: int) -> int:
    """Return atan(1/n) in units of 2^-(ANGLE_BITS + 20), off by less than 2^10."""
    total, power, k = 0, (1 << (ANGLE_BITS + 20)) // n, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power, k = power // (n * n), k + 2
    return total


PI = (16 * _atan_inverse(5) - 4 * _atan_inverse(239)) >> 20
"""π in units of 2^-ANGLE_BITS, off by at most one; J. Machin's formula."""


def angle_units(radians: Fraction, turns: Fraction) -> int:
    """Return radians + 2π turns, both at most 2^22, in units of angle: off by less than 2^24."""
    return math.floor(radians * (1 << ANGLE_BITS)) + math.floor(2 * turns * PI)


@lru_cache(1 << 12)
def angle_of(theta: float) -> Angle:
    """Return what a double of a scene means: a quarter turn if no double is nearer to that."""
    quarters = round(theta / (math.pi / 2))
    if float(Fraction(quarters * PI, 2 << ANGLE_BITS)) == theta:
        return Angle(Fraction(), Fraction(quarters, 4))
    return Angle(Fraction(theta), Fraction())


def turns_of(angle: Angle) -> Fraction:
    """Return an angle in turns, off by at most `TURNS_ERROR`; exact without radians."""
    return Fraction(angle_units(angle.radians, Fraction()), 2 * PI) + angle.turns


def quarter_turned(p: Vector, quarters: int) -> Vector:
    """Return a vector turned by quarter turns, exactly."""
    x, y = p
    return ((x, y), (-y, x), (-x, -y), (y, -x))[quarters % 4]


@lru_cache(1 << 16)
def rotation(radians: Fraction, turns: Fraction) -> Rotation:
    """Return the cosine and sine of radians + 2π turns."""
    angle = angle_units(radians, turns)
    quarters = (4 * angle + PI) // (2 * PI)
    angle -= quarters * PI // 2  # now at most an eighth of a turn
    sums, term, k = [0, 0], 1 << ANGLE_BITS, 0
    while term not in (0, -1):  # Taylor's series alternates: the rest is less than the last term
        sums[k % 2] += term if k % 4 < 2 else -term
        term, k = (term * angle >> ANGLE_BITS) // (k + 1), k + 1
    c, s = ((part >> (ANGLE_BITS - ROTATION_BITS - 1)) + 1 >> 1 for part in sums)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]
