"""A row of the table, and timing of calls that take microseconds."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import NamedTuple

from lib.timing import Spread

UNIT = 2.0**-53  # roundoff
ALLOWED = 64.0  # roundings of the largest coordinate by which a depth may be off
REPETITIONS = 5


class Row(NamedTuple):
    """What one method gave on one kind of body.

    Attributes
    ----------
    quantity : str
        ``PD^t``, ``PD^g`` or ``DISP, D_g``.
    case, method : str
        Names of the case of bodies and of the method of computation.
    error : float
        Relative to the true value; the median over the bodies.
    largest : float
        The same, the largest.
    microseconds, lower, upper : float
        For one body: median and quartiles.
    right : bool
        Whether what the library promises of this held for every body.
    note : str
        Anything else.
    """

    quantity: str
    case: str
    method: str
    error: float
    largest: float
    microseconds: float
    lower: float
    upper: float
    right: bool = True
    note: str = ""


def timed(call: Callable[[], object], repetitions: int = REPETITIONS) -> float:
    """Return the least of the processor's seconds of some repetitions."""
    least = float("inf")
    for _ in range(repetitions):
        began = time.process_time()
        call()
        least = min(least, time.process_time() - began)
    return least


def in_microseconds(seconds: Iterable[float]) -> tuple[float, float, float]:
    """Return median and quartiles."""
    spread = Spread.of([1e6 * s for s in seconds])
    return spread.median, spread.lower, spread.upper


def failures(rows: Iterable[Row]) -> list[Row]:
    """Return the rows on which the library broke a promise."""
    return [row for row in rows if not row.right]


def show(row: Row) -> None:
    """Print a row."""
    print(
        f"{row.quantity:10} {row.case:22} {row.method:26} {row.error:9.1e} {row.largest:9.1e} "
        f"{row.microseconds:12.4g} us {'' if row.right else 'WRONG'} {row.note}",
        flush=True,
    )
