"""From times at distances to error at a time, and the laws that both follow."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from parts.error_time.sweep import Point
from worlds.critical import SIDES

DECIDED = 0.5  # share of runs that must be right


@dataclass(frozen=True)
class Step:
    """From `seconds` on, the band of parameters that are not decided has half-width `error`."""

    seconds: float
    error: float


@dataclass(frozen=True)
class Law:
    """A straight line through n points: slope, and the share of the variance that it explains."""

    slope: float
    r_squared: float
    count: int


def reached(points: Sequence[Point]) -> list[Step]:
    """Return the steps of one side: a distance counts if all larger ones are decided in time too.

    `points` are those of one planner, family and side.
    """
    steps: list[Step] = []
    slowest = 0.0
    for point in sorted(points, key=lambda p: -p.distance):
        if point.decided < DECIDED or math.isinf(point.seconds.median):
            break
        slowest = max(slowest, point.seconds.median)
        steps.append(Step(slowest, point.distance))
    return steps


def error_at(steps: Sequence[Step], seconds: float) -> float:
    """Return the error of one side within a time; infinite before its first step."""
    return min((step.error for step in steps if step.seconds <= seconds), default=math.inf)


def error_curve(points: Sequence[Point]) -> list[Step]:
    """Return a planner's error on a family, against time.

    For a planner that decides both sides it is half of the band's width. A sampler has only the
    side with a path, and its error is the smallest distance at which it found one.
    """
    sides = {side: [p for p in points if p.side == side] for side in SIDES}
    by_side = [reached(each) for each in sides.values() if each]
    times = sorted({step.seconds for steps in by_side for step in steps})
    curve: list[Step] = []
    for seconds in times:
        error = sum(error_at(steps, seconds) for steps in by_side) / len(by_side)
        if math.isfinite(error) and (not curve or error < curve[-1].error):
            curve.append(Step(seconds, error))
    return curve


def line(x: Sequence[float], y: Sequence[float]) -> Law | None:
    """Fit y = a + slope x by least squares; None for fewer than three points."""
    if len(x) < 3:
        return None
    slope, offset = np.polyfit(x, y, 1)
    rest = np.asarray(y) - (slope * np.asarray(x) + offset)
    spread = np.asarray(y) - np.mean(y)
    total = float(spread @ spread)
    return Law(float(slope), 1.0 if total == 0 else 1.0 - float(rest @ rest) / total, len(x))


def decided(points: Sequence[Point], largest: float) -> list[Point]:
    """Return the points that were decided, at distances up to `largest`."""
    return [p for p in points if p.decided >= DECIDED and p.distance <= largest]


def logarithmic_law(points: Sequence[Point], largest: float) -> Law | None:
    """Fit count = a + slope · log10(1/distance): what a factor of ten costs."""
    chosen = decided(points, largest)
    return line([-math.log10(p.distance) for p in chosen], [p.count for p in chosen])


def power_law(points: Sequence[Point], largest: float, quantity: str) -> Law | None:
    """Fit quantity ~ distance^-slope, of ``count`` or ``seconds``."""
    chosen = decided(points, largest)
    values = [p.count if quantity == "count" else p.seconds.median for p in chosen]
    if any(value <= 0 for value in values):
        return None
    return line([-math.log10(p.distance) for p in chosen], [math.log10(v) for v in values])
