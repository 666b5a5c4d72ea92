"""Vectors of integers, and cosines and sines as integers with a known error.

Lengths are integers in units of 2^-UNIT, which hold the doubles of scenes and the corners of boxes
exactly; cosines and sines are integers in units of 2^-BITS, off by at most one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from planar_planner.checker.form import UNIT

BITS, WORK = 120, 220  # bits after the binary point of cosines and of angles


ONE, HALF_TURN = 1 << UNIT, Fraction(1, 2)


Vector = tuple[int, int]


Rotation = tuple[int, int]  # cos, sin


Region = tuple[int, int, int, int]  # xmin, ymin, xmax, ymax


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1]


def _dot(a: Vector, b: Vector) -> int:
    return a[0] * b[0] + a[1] * b[1]


def _cross(a: Vector, b: Vector) -> int:
    return a[0] * b[1] - a[1] * b[0]


def _sides(ring: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def _region(points: Iterable[Vector]) -> Region:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _apart(a: Region, b: Region) -> bool:  # in their interiors
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def _atan_inverse(n: int) -> int:  # atan(1/n) in 2^-(WORK + 20), off by less than 2^10
    total, power, k = 0, (1 << (WORK + 20)) // n, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power, k = power // (n * n), k + 2
    return total


PI = (16 * _atan_inverse(5) - 4 * _atan_inverse(239)) >> 20  # in 2^-WORK, off by at most one


def fixed(radians: Fraction, turns: Fraction) -> int:
    """Return radians + 2π turns, both at most 2^22, in 2^-WORK: off by less than 2^24."""
    return math.floor(radians * (1 << WORK)) + math.floor(2 * turns * PI)


@lru_cache(1 << 16)
def rotation(radians: Fraction, turns: Fraction) -> Rotation:
    """Return cos and sin of radians + 2π turns."""
    angle = fixed(radians, turns)
    quarters = (4 * angle + PI) // (2 * PI)
    angle -= quarters * PI // 2  # now at most an eighth of a turn
    sums, term, k = [0, 0], 1 << WORK, 0
    while term not in (0, -1):  # Taylor's series alternates: the rest is less than the last term
        sums[k % 2] += term if k % 4 < 2 else -term
        term, k = (term * angle >> WORK) // (k + 1), k + 1
    c, s = ((part >> (WORK - BITS - 1)) + 1 >> 1 for part in sums)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


class Extent(NamedTuple):
    """A box, face or point: the corners of its translations; its angles, radians + 2π turns."""

    corners: list[Vector]
    first: Fraction  # turns
    last: Fraction
    radians: Fraction = Fraction()

    def ends(self) -> list[Rotation]:
        """Return the rotations at both ends, of a single angle only one."""
        return [rotation(self.radians, turns) for turns in sorted({self.first, self.last})]

    def halves(self) -> list[Extent]:
        """Return the halves of the angles."""
        middle = (self.first + self.last) / 2
        return [self._replace(last=middle), self._replace(first=middle)]
