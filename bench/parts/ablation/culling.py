"""Cell culling ratios and costs of the C-obstacle queries, from the native program `culling`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lib.native import instructions, run
from lib.timing import Spread

NS = 1e9
QUERIES = {  # the native program's names, and ours
    "published": "PD^t > Eq. 3",
    "displacement": "PD^t > DISP, radius per piece",
    "per_normal_alone": "per normal, from scratch",
    "per_normal": "per normal",
    "per_normal_single": "and joint, one axis a pair",
    "per_normal_joint": "and joint, case by case",
}
DRIVER = "published"  # whose walk is the published population
COUNTED_CELLS = 70_000  # at most, of a run under valgrind, which is fifty times slower


@dataclass(frozen=True)
class Cost:
    """The cost of one query on one cell; `instructions` is None where nothing counts them."""

    ns: Spread
    evaluations: float
    instructions: float | None


@dataclass(frozen=True)
class Culling:
    """What the queries identify of one scene's cells.

    Attributes
    ----------
    scene, walk : str
        The cells: ``search`` are those that our planner meets, inner ones included; ``octree
        QUERY`` are split level by level unless that query identifies them.
    cells, obstacle, undecided : int
        All of them; those proven to lie in the C-obstacle by refining them; those not decided so.
    culled : mapping
        How many of `obstacle` each query identifies.
    costs : mapping
        The cost of each query on all cells of the walk.
    misses : mapping
        Why ``per_normal`` misses, of a sample: the covering pair was not opened yet, its ranges are
        too wide, several pairs are needed, or unclear.
    levels : list
        Cells, obstacle and culled by level.
    """

    scene: str
    walk: str
    cells: int
    obstacle: int
    undecided: int
    culled: Mapping[str, int]
    costs: Mapping[str, Cost]
    misses: Mapping[str, int]
    levels: list[dict[str, Any]]

    def ratio(self, query: str) -> float | None:
        """Return the cell culling ratio; None where no cell lies in C-obstacle."""
        return self.culled[query] / self.obstacle if self.obstacle else None


def culling(
    program: Path,
    scene: str,
    *,
    cells: int,
    repeats: int,
    driver: str | None = DRIVER,
    count: bool = False,
) -> Culling:
    """Run the program; `driver` None takes the cells of our own search."""
    walk = ["--search"] if driver is None else ["--driver", driver, "--cells", str(cells)]
    found = run(program, scene, *walk, "--repeats", str(repeats))
    total = found["total"]
    costs = {}
    for query, cost in found["costs"].items():
        each = [NS * seconds / total["cells"] for seconds in cost["seconds"]]
        counted = _instructions(program, scene, query) if count else None
        costs[query] = Cost(Spread.of(each), cost["evaluations"] / total["cells"], counted)
    name = "search" if driver is None else f"octree {driver}"
    return Culling(
        scene,
        name,
        total["cells"],
        total["obstacle"],
        total["undecided"],
        total["culled"],
        costs,
        found["misses"],
        found["levels"],
    )


def _instructions(program: Path, scene: str, query: str) -> float | None:
    """Return instructions of one query on one cell, over a smaller walk of its own."""
    walk = ["--only", query, "--driver", DRIVER, "--cells", str(COUNTED_CELLS)]
    total = instructions(program, scene, "bench_replay", *walk)
    return None if total is None else total / int(run(program, scene, *walk)["cells"])
