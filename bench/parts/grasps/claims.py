"""What [GFE] claims of its situations, checked on ours."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

SAME_CONTACTS = (("b1", "b2", "c", "d"), ("e1", "e2", "f", "g"))
WEAKER = (("b2", ("b1", "c", "d")), ("e2", ("e1", "f", "g", "h")))
EPS = 1e-4  # as published
ROUNDING = 1e-14  # of the formulas


class TableRow(NamedTuple):
    """One d_Q of one situation, beside the published one where there is one.

    Attributes
    ----------
    situation, set : str
        Row and half of the table; ``W`` or ``W^a``.
    dimension, published_dimension : int
        Dimensions of the space that the set spans.
    lower, upper : float
        Our bracket of d_Q.
    formula : float or None
        d_Q in closed form.
    milliseconds : float
        Processor time, the least of some repetitions.
    """

    situation: str
    set: str
    dimension: int
    published_dimension: int
    lower: float
    upper: float
    formula: float | None
    published: float | None
    iterations: int
    published_iterations: int | None
    milliseconds: float
    published_milliseconds: float | None


def failures(rows: Sequence[TableRow]) -> list[str]:
    """Return what does not hold.

    d_Q(W^a) ≤ d_Q(W) follows from W^a ⊆ W where both span six dimensions. In a subspace it need
    not hold, and row (a4) of the paper's own table has 0.1513 > 0.1119; it is not asked there.
    """
    table = {(row.situation, row.set): row for row in rows}
    failed = []
    for row in rows:
        place = f"({row.situation}) {row.set}"
        if row.dimension != row.published_dimension:
            failed.append(f"{place} spans {row.dimension} dimensions")
        if row.formula is not None:
            failed += list(against_formula(row, place, row.formula))
        if row.set == "W^a" and row.dimension == 6:
            whole = table[row.situation, "W"]
            if row.lower > whole.upper:
                failed.append(f"{place} exceeds W's")
    for group in SAME_CONTACTS:
        first = table[group[0], "W"]
        failed += [
            f"({name}) W differs from ({group[0]})"
            for name in group
            if (table[name, "W"].lower, table[name, "W"].upper) != (first.lower, first.upper)
        ]
    for best, others in WEAKER:
        failed += [
            f"({name}) W^a is not weaker than ({best})"
            for name in others
            if table[name, "W^a"].dimension == 6
            and table[name, "W^a"].upper >= table[best, "W^a"].lower
        ]
    return failed


def against_formula(row: TableRow, place: str, formula: float) -> Iterator[str]:
    """Yield how the bracket and the published value contradict the closed form."""
    if not row.lower * (1 - ROUNDING) <= formula <= row.upper * (1 + ROUNDING):
        yield f"{place}: {formula} is not in [{row.lower}, {row.upper}]"
    # The published value is a lower bound that is right to ε, then rounded to four decimals.
    if row.published is not None and not -0.5 * EPS <= formula - row.published <= 1.5 * EPS:
        yield f"{place}: the fit gives {formula}, not {row.published}"
