"""Vectors, rings and rectangles in the plane, of integers.

A length is an integer in units of 2^-LENGTH_BITS. These units hold the doubles of scenes and the
corners of boxes exactly, so sums and products here are exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TypeVar

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

_Item = TypeVar("_Item")


def units(number: float) -> int:
    """Return a double in units of length; those of scenes are multiples of 2^-219."""
    above, below = number.as_integer_ratio()
    return above << (LENGTH_BITS + 1 - below.bit_length())


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
