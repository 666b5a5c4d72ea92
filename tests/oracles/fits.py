"""How a quantity grows: exponents and growth per decade, robust, with their spread.

Slopes are medians of the slopes between all pairs of points (Theil and Sen), with the quartiles of
these: one bad clock reading moves them little, and a curve that bends shows as a wide spread.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations


@dataclass(frozen=True)
class Fit:
    """Median slope with quartiles, and how many points it is of."""

    slope: float
    lower: float
    upper: float
    points: int

    def __str__(self) -> str:
        return f"{self.slope:.2f} [{self.lower:.2f}, {self.upper:.2f}]"


def exponent(xs: Sequence[float], ys: Sequence[float]) -> Fit | None:
    """Return p of ``y ~ x**p``; None for fewer than three points with positive values."""
    return _slopes(xs, ys, math.log10, math.log10)


def per_decade(xs: Sequence[float], ys: Sequence[float]) -> Fit | None:
    """Return by how much y grows while x grows tenfold; None as for `exponent`."""
    return _slopes(xs, ys, math.log10, lambda y: y)


def _slopes(
    xs: Sequence[float],
    ys: Sequence[float],
    of_x: Callable[[float], float],
    of_y: Callable[[float], float],
) -> Fit | None:
    if len(xs) != len(ys):
        raise ValueError(f"{len(xs)} x and {len(ys)} y")
    points = [(of_x(x), of_y(y)) for x, y in zip(xs, ys, strict=True) if x > 0 and y > 0]
    slopes = [(y1 - y0) / (x1 - x0) for (x0, y0), (x1, y1) in combinations(points, 2) if x0 != x1]
    if len({x for x, _ in points}) < 3:
        return None
    lower, middle, upper = statistics.quantiles(slopes, n=4, method="inclusive")
    return Fit(middle, lower, upper, len(points))
