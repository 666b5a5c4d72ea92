"""Repeated queries on a fresh planner each time: medians with spread, counts, verdicts."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from planar_planner import Options, Planner, Scene, load_scene
from planar_planner.planning.result import Result

BUDGET = 0.4  # seconds of repetitions for each figure
FEWEST, MOST = 5, 60


@dataclass(frozen=True)
class Spread:
    """Median with quartiles, and how many values they are of."""

    median: float
    lower: float
    upper: float
    count: int

    @classmethod
    def of(cls, values: Sequence[float]) -> Spread:
        """Return the spread of at least one value."""
        if len(values) == 1:
            return cls(values[0], values[0], values[0], 1)
        lower, median, upper = statistics.quantiles(values, n=4, method="inclusive")
        return cls(median, lower, upper, len(values))


@dataclass(frozen=True)
class Measured:
    """A query that was repeated.

    Attributes
    ----------
    result : Result
        The result of the last repetition; verdict and counts are the same in all.
    core : Spread
        Seconds in the core: preprocessing and search, without reading and checking the file.
    whole : Spread
        Seconds of everything after reading the file: checks in Python, start and goal, the core.
    shares : mapping
        Part of the core's time of each of its clocks, from the repetition with the median time.
    """

    result: Result
    core: Spread
    whole: Spread
    shares: Mapping[str, float]

    @property
    def cells(self) -> int:
        """Leaves of the subdivision."""
        return int(self.result.stats.cells)


def repetitions(budget: float, fewest: int, most: int, patience: float = math.inf) -> Iterator[int]:
    """Count repetitions for about `budget` seconds, `fewest` to `most` of them.

    Beyond `patience` seconds there is none but the first, even if that makes fewer than `fewest`.
    """
    began = time.perf_counter()
    for done in range(most):
        elapsed = time.perf_counter() - began
        if done > 0 and elapsed >= (budget if done >= fewest else patience):
            return
        yield done


def measure(
    scene: str | Mapping[str, Any] | Scene,
    options: Options | None = None,
    budget: float = BUDGET,
    most: int = MOST,
) -> Measured:
    """Repeat a query for about `budget` seconds; raise if its answer is not always the same."""
    loaded = load_scene(scene)
    runs: list[tuple[float, float, Result]] = []
    for _ in repetitions(budget, FEWEST, most):
        before = time.perf_counter()
        result = Planner(loaded).solve(options=options)
        whole = time.perf_counter() - before
        runs.append((float(result.stats.seconds.total), whole, result))
    answers = {(run[2].verdict, run[2].stats.cells) for run in runs}
    if len(answers) != 1:
        raise RuntimeError(f"{loaded.name}: not the same answer each time: {answers}")
    middle = sorted(runs, key=lambda run: run[0])[len(runs) // 2][2]
    return Measured(
        runs[-1][2],
        Spread.of([run[0] for run in runs]),
        Spread.of([run[1] for run in runs]),
        _shares(middle.stats.seconds.to_dict()),
    )


def _shares(seconds: Mapping[str, float]) -> dict[str, float]:
    total = seconds["total"]
    return {name: value / total for name, value in seconds.items() if name != "total"}
