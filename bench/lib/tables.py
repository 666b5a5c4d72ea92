"""Tables of benchmarks: on the terminal, and the figures in their cells."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lib.timing import Spread

MS = 1e3


def figures(spread: Spread, unit: float = MS, form: str = ".4g") -> tuple[str, str, str]:
    """Return median and quartiles in a unit, milliseconds as a rule."""
    return (
        f"{unit * spread.median:{form}}",
        f"{unit * spread.lower:{form}}",
        f"{unit * spread.upper:{form}}",
    )


def show(title: str, header: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Print a table with columns as wide as needed."""
    table = [tuple(header), *(tuple(row) for row in rows)]
    widths = [max(len(row[k]) for row in table) for k in range(len(header))]
    print(f"\n{title}")
    for row in table:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)))
