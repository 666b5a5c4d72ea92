"""What is printed and written: laws of growth, errors at a time, all points."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from lib.tables import MS, figures
from parts.error_time.curves import (
    Law,
    decided,
    error_at,
    error_curve,
    logarithmic_law,
    power_law,
    reached,
)
from parts.error_time.sweep import OURS, Point
from worlds.critical import SIDES

LARGEST = 0.1  # distances from here on are fitted ...
SMALLEST = 1e-9  # ... down to here; nearer to the rounding floor of doubles another law begins
TIMES = (0.001, 0.01, 0.05, 0.5, 5.0)
GOAL_ERROR, GOAL_SECONDS = 1e-9, 0.05

POINTS_HEADER = (
    *("family", "planner", "side", "parameter", "distance", "decided", "count", "ms", "lower"),
    *("upper", "wall_ms", "runs", "note"),
)


def of(points: Iterable[Point], **wanted: str) -> list[Point]:
    """Return the points with the given fields."""
    return [p for p in points if all(getattr(p, key) == value for key, value in wanted.items())]


def names(points: Iterable[Point], key: str) -> list[str]:
    """Return the values of a field in order of appearance."""
    return list(dict.fromkeys(getattr(p, key) for p in points))


def rows_of_points(points: Iterable[Point]) -> Iterator[tuple[object, ...]]:
    """Yield the rows of the table of all points."""
    for p in points:
        yield (
            *(p.family, p.planner, p.side, repr(p.parameter), f"{p.distance:.3e}"),
            *(f"{p.decided:g}", f"{p.count:g}", *figures(p.seconds)),
            *(f"{MS * p.wall.median:.4g}", p.seconds.count, p.note),
        )


LAWS_HEADER = (
    *("family", "side", "decided_to", "cells_1e-3", "cells_1e-6", "cells_1e-9", "ms_1e-9"),
    *("wall_ms_1e-9", "cells_per_decade", "r2", "power", "power_r2", "goal"),
)


def rows_of_laws(points: Sequence[Point]) -> Iterator[tuple[str, ...]]:
    """Yield for each family and side of ours: cells, time, and the two laws fitted."""
    ours = of(points, planner=OURS)
    for family in names(ours, "family"):
        for side in SIDES:
            chosen = of(ours, family=family, side=side)
            fitted = [p for p in chosen if p.distance > 0.99 * SMALLEST]
            straight = logarithmic_law(fitted, LARGEST)
            power = power_law(fitted, LARGEST, "count")
            steps = reached(chosen)
            near = {p.distance: p for p in decided(chosen, 1.0)}
            at_goal = near.get(GOAL_ERROR)
            yield (
                *(family, side, f"{steps[-1].error:.0e}" if steps else "-"),
                *(f"{near[d].count:.0f}" if d in near else "-" for d in (1e-3, 1e-6, GOAL_ERROR)),
                f"{MS * at_goal.seconds.median:.2f}" if at_goal else "-",
                f"{MS * at_goal.wall.median:.2f}" if at_goal else "-",
                *_shown(straight, ".0f"),
                *_shown(power, ".3f"),
                "met" if at_goal and at_goal.seconds.median <= GOAL_SECONDS else "MISSED",
            )


def _shown(law: Law | None, form: str) -> tuple[str, str]:
    return ("-", "-") if law is None else (f"{law.slope:{form}}", f"{law.r_squared:.3f}")


ERRORS_HEADER = ("family", "planner", *(f"error_{t:g}s" for t in TIMES), "least", "power", "r2")


def rows_of_errors(points: Sequence[Point]) -> Iterator[tuple[str, ...]]:
    """Yield for each family and planner the error at some times, the least one, and a power law.

    The power p is that of work ~ error^-p on the side with a path, the one that all can answer: of
    cells for ours, of state checks for a sampler, because counts do not depend on clocks.
    """
    for family in names(points, "family"):
        in_family = of(points, family=family)
        for planner in names(in_family, "planner"):
            chosen = of(in_family, planner=planner)
            curve = error_curve(chosen)
            shown = (error_at(curve, t) for t in TIMES)
            yield (
                *(family, planner),
                *(f"{e:.0e}" if math.isfinite(e) else "-" for e in shown),
                f"{curve[-1].error:.0e}" if curve else "-",
                *_shown(power_law(of(chosen, side="path"), LARGEST, "count"), ".2f"),
            )
