"""Parking-competition cases: start, goal and obstacles as one line of numbers."""

from __future__ import annotations

import math

Ring = list[tuple[float, float]]
LOT = [(-12.0, 6.0), (-1.6, 6.0), (-1.6, 12.0), (-12.0, 12.0)]
NEXT = [(1.6, 6.0), (12.0, 6.0), (12.0, 12.0), (1.6, 12.0)]


def case(start: tuple[float, ...], goal: tuple[float, ...], *rings: Ring) -> str:
    numbers: list[float] = [*start, *goal, len(rings), *map(len, rings)]
    numbers += [value for ring in rings for point in ring for value in point]
    return ",".join(map(repr, numbers)) + "\n"


def box(xmin: float, ymin: float, xmax: float, ymax: float) -> Ring:
    return [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]


BAY = case((-6.0, 2.0, 0.0), (0.0, 7.5, math.pi / 2), LOT, NEXT)
