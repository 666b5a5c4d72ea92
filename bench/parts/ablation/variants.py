"""The planner without some of its parts, and how long it takes then."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from lib.timing import Spread, repetitions
from planar_planner import Options
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import Problem

FEWEST, MOST = 3, 15


@dataclass(frozen=True)
class Variant:
    """Parts left out by name (native/ablation.hpp), and the query that culls cells."""

    name: str
    without: tuple[str, ...] = ()
    query: str = "per-normal"


# The published method: level by level, star-shaped cells, no more than the query. What is
# tried before any subdivision is off throughout, so that all have the same to do.
AT_FIRST = ("cheap", "probe")
PUBLISHED = ("guided", "joint", *AT_FIRST)
TABLE_2 = (
    Variant("original: no query", PUBLISHED, "none"),
    Variant("accelerated: Eq. 3", PUBLISHED, "published"),
    Variant("DISP, radius per piece", PUBLISHED, "displacement"),
    Variant("per normal", PUBLISHED),
    Variant("per normal and joint", ("guided", *AT_FIRST)),
    Variant("this planner", AT_FIRST),
)

# Where the first try finds a path no other part has anything to do: all variants go without it, and
# are held against the planner without it.
CELLS = Variant("no first try", ("probe",))
ABLATIONS = (
    Variant("this planner"),
    CELLS,
    Variant("no joint obstruction", ("joint", "probe")),
    Variant("no joint, DISP query", ("joint", "probe"), "displacement"),
    Variant("no joint, Eq. 3 query", ("joint", "probe"), "published"),
    Variant("no joint, no query", ("joint", "probe"), "none"),
    Variant("no ridge", ("ridge", "probe")),
    Variant("no star test", ("star", "probe")),
    Variant("level by level", ("guided", "probe")),
    Variant("search from scratch", ("incremental", "probe")),
    Variant("cover, not partition", ("partition", "probe")),
    Variant("no hierarchy", ("hierarchy", "probe")),
    Variant("no cheap moves", AT_FIRST),
)


@dataclass(frozen=True)
class Outcome:
    """A query answered by a variant; processor seconds of making a core and asking it."""

    variant: Variant
    verdict: str
    reason: str
    seconds: Spread
    stats: Mapping[str, Any]

    @property
    def decided(self) -> bool:
        """Whether there was an answer within the limits."""
        return self.verdict != "undecided"

    @property
    def work(self) -> int:
        """Return the labelled cells: what a part saves or costs, without clocks."""
        return int(self.stats["labelled_cells"])


def outcome(problem: Problem, variant: Variant, limits: Options, budget: float) -> Outcome:
    """Ask fresh cores for about `budget` seconds; slow queries are asked once."""
    runs: list[tuple[float, dict[str, Any]]] = []
    for _ in repetitions(budget, FEWEST, MOST, patience=FEWEST * budget):
        before = time.process_time()
        answer = ask(make_core(problem, variant.without, variant.query), problem, limits)
        runs.append((time.process_time() - before, answer))
    middle = sorted(runs, key=lambda run: run[0])[len(runs) // 2][1]
    seconds = Spread.of([run[0] for run in runs])
    return Outcome(variant, middle["verdict"], middle["reason"], seconds, middle["stats"])
