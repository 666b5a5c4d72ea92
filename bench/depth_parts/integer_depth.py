"""PD^t and distance of convex polygons, exactly of the doubles given, in integers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Point = tuple[int, int]


class ExactDepth(NamedTuple):
    """State, and PD^t (positive) or minus the distance, rounded once or twice."""

    state: str
    depth: float


def placed_vertices(ring: Array, pose: Array) -> Array:
    """Return the vertices at a configuration, with the roundings of the library."""
    c, s = math.cos(pose[2]), math.sin(pose[2])
    x, y = ring.T
    return np.column_stack([c * x - s * y + pose[0], s * x + c * y + pose[1]])


def exact_depth(a: Array, b: Array) -> ExactDepth:
    """Return what `pdg.translational_depth` approximates, for the hulls of two sets of vertices."""
    bits = max(_fraction_bits(a), _fraction_bits(b))
    first, second = _hull(_integers(a, bits)), _hull(_integers(b, bits))
    ways_out = [*_ways_out(first, second), *_ways_out(second, first)]
    least = min(ways_out)
    if least > 0:
        return ExactDepth("overlap", math.ldexp(math.sqrt(least), -bits))
    gap = min(*_squares(first, second), *_squares(second, first))
    return ExactDepth("apart" if gap > 0 else "touching", -math.ldexp(math.sqrt(gap), -bits))


def _fraction_bits(points: Array) -> int:
    return max(v.as_integer_ratio()[1].bit_length() - 1 for v in points.ravel().tolist())


def _integers(points: Array, bits: int) -> list[Point]:
    def scaled(value: float) -> int:
        numerator, denominator = value.as_integer_ratio()
        return (numerator << bits) // denominator

    return [(scaled(x), scaled(y)) for x, y in points.tolist()]


def _area(u: Point, v: Point, w: Point) -> int:
    return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])


def _hull(points: list[Point]) -> list[Point]:
    ordered = sorted(set(points))
    if len(ordered) == 1:
        return ordered
    chain: list[Point] = []
    for half in (ordered, ordered[::-1]):
        base = len(chain)
        for p in half:
            while len(chain) >= base + 2 and _area(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return chain


def _edges(ring: list[Point]) -> list[tuple[Point, Point]]:
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def _ways_out(ring: list[Point], other: list[Point]) -> list[float]:
    """Return, per edge, the square of the deepest vertex's distance behind it, or 0."""
    ways = []
    for u, v in _edges(ring) if len(ring) > 1 else []:
        deepest = max(_area(u, v, w) for w in other)
        length = (v[0] - u[0]) ** 2 + (v[1] - u[1]) ** 2
        ways.append(deepest**2 / length if deepest > 0 else 0.0)
    return ways


def _squares(ring: list[Point], other: list[Point]) -> list[float]:
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
