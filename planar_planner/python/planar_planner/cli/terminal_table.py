"""A table for a terminal, cut at its width, by rich; imported only if there is a terminal."""

from __future__ import annotations

import sys
from collections.abc import Container, Sequence

from rich.box import SIMPLE_HEAD
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

from planar_planner.cli.terminal import VERDICT_STYLES, has_colours


def styled_table(
    headings: Sequence[str],
    rows: Sequence[Sequence[str]],
    numeric: Container[int],
    coloured: int,
    verdicts: Sequence[str],
) -> str:
    """Return a table for standard output; only its last column is cut at the terminal's width.

    Parameters
    ----------
    headings, rows
        Texts of the cells.
    numeric
        Columns that are aligned to the right.
    coloured
        The column whose cells have the colours of verdicts.
    verdicts
        The verdict of each row.
    """
    colours = has_colours(sys.stdout)
    table = Table(
        box=SIMPLE_HEAD,
        show_edge=False,
        pad_edge=False,
        expand=True,
        header_style="bold" if colours else "",
    )
    for column, texts in enumerate(zip(headings, *rows, strict=True)):
        last = column == len(headings) - 1
        table.add_column(
            headings[column],
            justify="right" if column in numeric else "left",
            no_wrap=True,
            overflow="ellipsis",
            width=None if last else max(map(cell_len, texts)),
            ratio=1 if last else None,
        )
    for row, verdict in zip(rows, verdicts, strict=True):
        cells = [Text(cell) for cell in row]
        if colours:
            cells[coloured].stylize(VERDICT_STYLES[verdict])
        table.add_row(*cells)
    console = Console(file=sys.stdout, force_terminal=True, no_color=not colours)
    with console.capture() as captured:
        console.print(table)
    return "\n".join(line.rstrip() for line in captured.get().splitlines()).strip("\n")
