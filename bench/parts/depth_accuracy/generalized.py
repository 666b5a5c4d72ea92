"""The lower bound of PD^g by pieces, against a bracket of PD^g under the displacement metric."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pdg
from oracles.depth_bracket import Bracket, refine
from parts.depth_accuracy.bodies import Pair, interlocking
from parts.depth_accuracy.common import Row, in_microseconds, timed

LOWER_BOUND = "lower bound by pieces"
ORACLE = "bracket: "
# The oracle works in plain doubles, and minimises along edges to the root of their precision.
ORACLE_ERROR = 1e-7


def rows(gap: float, limit: float) -> Iterator[Row]:
    """Yield for each pair our bound, and the bracket each time that its gap has halved."""
    for pair in interlocking():
        history = brackets(pair, gap, limit)
        last = history[-1]
        yield lower_bound(pair, last)
        shown = 2.0
        for bracket in history:
            if bracket.gap <= 0.5 * shown or bracket is last:
                shown = bracket.gap
                micros = 1e6 * bracket.seconds
                note = f"[{bracket.lower:.6f}, {bracket.upper:.6f}]"
                name = f"{ORACLE}{bracket.gap:.1%}"
                yield Row("PD^g", pair.name, name, shown, shown, micros, micros, micros, note=note)


def brackets(pair: Pair, gap: float, limit: float) -> list[Bracket]:
    """Return the brackets found until one is as narrow as asked for, or time is up."""
    found: list[Bracket] = []
    for bracket in refine(pair.moving, pair.fixed, pair.pose):
        found.append(bracket)
        if bracket.gap <= gap or bracket.seconds > limit:
            break
    return found


def lower_bound(pair: Pair, truth: Bracket) -> Row:
    """Return how far our bound is below PD^g; of convex bodies it is PD^g ([PDG] Theorem 1)."""
    first, second = pdg.convex_pieces(pair.moving), pdg.convex_pieces(pair.fixed)
    depth = pdg.generalized_depth_lower_bound(first, second, pair.pose).lower
    error = abs(truth.upper - depth) / truth.upper  # or less: PD^g is not above the upper end
    right = depth <= truth.upper * (1 + ORACLE_ERROR)
    if len(first) == len(second) == 1:
        right = right and depth >= truth.lower * (1 - ORACLE_ERROR)
    times = in_microseconds(
        timed(lambda: pdg.generalized_depth_lower_bound(first, second, pair.pose)) for _ in range(5)
    )
    share = f"{depth:.6f}, {depth / truth.upper:.0%} of the oracle's upper end"
    return Row("PD^g", pair.name, LOWER_BOUND, error, math.nan, *times, right, share)
