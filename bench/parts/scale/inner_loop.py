"""What one evaluation of a separating-axis function costs, over the cells of our own searches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from lib.native import instructions, run
from lib.timing import Spread

NS = 1e9
QUERY = "per_normal"  # labelling as the planner does it, without star and joint tests


@dataclass(frozen=True)
class InnerLoop:
    """The cost of labelling all cells of a search; `instructions` are those of one evaluation."""

    scene: str
    cells: int
    evaluations: float  # of one cell
    ns: Spread  # of one evaluation, its share of the cell's other work included
    instructions: float | None


def inner_loop(program: Path, scene: str, repeats: int, count: bool) -> InnerLoop:
    """Replay the cells of a search."""
    found = run(program, scene, "--search", "--misses", "0", "--repeats", str(repeats))
    cells = int(found["total"]["cells"])
    cost = found["costs"][QUERY]
    evaluations = int(cost["evaluations"])
    total = (
        instructions(program, scene, "bench_replay", "--search", "--only", QUERY) if count else None
    )
    return InnerLoop(
        scene,
        cells,
        evaluations / cells,
        Spread.of([NS * seconds / evaluations for seconds in cost["seconds"]]),
        None if total is None else total / evaluations,
    )


def print_inner_loops(found: Sequence[InnerLoop]) -> None:
    """Print a line for each scene."""
    for each in found:
        counted = "" if each.instructions is None else f"{each.instructions:7.0f} instructions"
        print(
            f"{each.scene:<18} {each.cells:>7,} cells, {each.evaluations:5.1f} evaluations a cell, "
            f"{each.ns.median:6.1f} ns ({each.ns.lower:.1f} to {each.ns.upper:.1f}) {counted}",
            flush=True,
        )
