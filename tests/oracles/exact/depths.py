"""PD^t, distances and displacements of convex polygons, exactly of the doubles given.

`exact_depth` takes vertices where they are and computes in integers; `placed_depth` and
`exact_displacement` take bodies at configurations, with sines and cosines to 50 places.
"""

from __future__ import annotations

import decimal
import math
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple, TypeVar

from oracles.exact.numbers import PLACES, number
from oracles.exact.polygons import polygon, turned
from oracles.placing import Array, Pose

Number = TypeVar("Number", int, Decimal)
IntegerPoint = tuple[int, int]
DecimalPoint = tuple[Decimal, Decimal]


class ExactDepth(NamedTuple):
    """State, and PD^t (positive) or minus the distance, rounded once or twice."""

    state: str
    depth: float


def exact_depth(a: Array, b: Array) -> ExactDepth:
    """Return what `pdg.translational_depth` approximates, for the hulls of two sets of vertices."""
    bits = max(_fraction_bits(a), _fraction_bits(b))
    first, second = _hull(_integers(a, bits)), _hull(_integers(b, bits))
    ways = [*_ways_out(first, second), *_ways_out(second, first)]
    least = min(deepest**2 / length if deepest > 0 else 0.0 for deepest, length in ways)
    if least > 0:
        return ExactDepth("overlap", math.ldexp(math.sqrt(least), -bits))
    gap = min(*_squares(first, second), *_squares(second, first))
    return ExactDepth("apart" if gap > 0 else "touching", -math.ldexp(math.sqrt(gap), -bits))


def placed_depth(a: Array, b: Array, pose: Pose) -> Decimal:
    """Return PD^t of two convex polygons that overlap, the first at a configuration.

    It is the origin's least distance from an edge of B minus A, and every edge of that is parallel
    to one of B or of A: the least way out over the outward normals of either's edges. If they do
    not overlap, the result is negative.
    """
    with decimal.localcontext() as context:
        context.prec = PLACES + 10
        moved, fixed = _placed_exactly(a, pose), _placed_exactly(b, (0.0, 0.0, 0.0))
        ways = [*_ways_out(moved, fixed), *_ways_out(fixed, moved)]
        return min(deepest / length.sqrt() for deepest, length in ways)


def exact_displacement(ring: Array, q0: Pose, q1: Pose) -> Decimal:
    """Return the largest distance that a vertex moves."""
    with decimal.localcontext() as context:
        context.prec = PLACES + 10
        ends = zip(_placed_exactly(ring, q0), _placed_exactly(ring, q1), strict=True)
        return max((bx - ax) ** 2 + (by - ay) ** 2 for (ax, ay), (bx, by) in ends).sqrt()


def _placed_exactly(ring: Array, pose: Pose) -> list[DecimalPoint]:
    x, y = Fraction(pose[0]), Fraction(pose[1])
    points = turned(polygon(ring.tolist()), pose[2])
    return [(number(px + x), number(py + y)) for px, py in points]


def _area(u: tuple[Number, Number], v: tuple[Number, Number], w: tuple[Number, Number]) -> Number:
    """Return twice the signed area of a triangle."""
    return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])


def _edges(
    ring: Sequence[tuple[Number, Number]],
) -> list[tuple[tuple[Number, Number], tuple[Number, Number]]]:
    return [(ring[k - 1], ring[k]) for k in (*range(1, len(ring)), 0)]


def _ways_out(
    ring: Sequence[tuple[Number, Number]], other: Sequence[tuple[Number, Number]]
) -> list[tuple[Number, Number]]:
    """Return, per edge, how far behind it the deepest vertex lies times its length, and length².

    The distance is the first over the square root of the second. A point has no edges.
    """
    return [
        (max(_area(u, v, w) for w in other), (v[0] - u[0]) ** 2 + (v[1] - u[1]) ** 2)
        for u, v in (_edges(ring) if len(ring) > 1 else [])
    ]


def _fraction_bits(points: Array) -> int:
    return max(v.as_integer_ratio()[1].bit_length() - 1 for v in points.ravel().tolist())


def _integers(points: Array, bits: int) -> list[IntegerPoint]:
    def scaled(value: float) -> int:
        numerator, denominator = value.as_integer_ratio()
        return (numerator << bits) // denominator

    return [(scaled(x), scaled(y)) for x, y in points.tolist()]


def _hull(points: list[IntegerPoint]) -> list[IntegerPoint]:
    ordered = sorted(set(points))
    if len(ordered) == 1:
        return ordered
    chain: list[IntegerPoint] = []
    for half in (ordered, ordered[::-1]):
        base = len(chain)
        for p in half:
            while len(chain) >= base + 2 and _area(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return chain


def _squares(ring: list[IntegerPoint], other: list[IntegerPoint]) -> list[float]:
    """Return the squared distances of one's vertices from the other's edges."""
    found = []
    for u, v in _edges(ring):
        dx, dy = v[0] - u[0], v[1] - u[1]
        length = dx * dx + dy * dy
        for x, y in other:
            along = dx * (x - u[0]) + dy * (y - u[1])
            if along <= 0:
                found.append(float((x - u[0]) ** 2 + (y - u[1]) ** 2))
            elif along >= length:
                found.append(float((x - v[0]) ** 2 + (y - v[1]) ** 2))
            else:
                found.append(_area(u, v, (x, y)) ** 2 / length)
    return found
