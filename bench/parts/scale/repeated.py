"""Many queries on one planner against a fresh planner for each."""

from __future__ import annotations

import random
import time
from dataclasses import dataclass
from itertools import pairwise

from lib.timing import Spread
from planar_planner import Planner
from planar_planner.planning.path_judge import Judge
from planar_planner.problem.make import Problem
from planar_planner.scene.model import Scene

SEED = 5


@dataclass(frozen=True)
class Repeated:
    """Processor seconds of each query, in order: on one planner, and on a fresh one each."""

    scene: str
    kept: list[float]
    fresh: list[float]
    cells: list[int]  # of the kept planner after each query

    @property
    def gain(self) -> Spread:
        """Fresh over kept, of the second half of the queries."""
        late = len(self.kept) // 2
        return Spread.of([f / k for f, k in zip(self.fresh[late:], self.kept[late:], strict=True)])


def repeated(scene: Scene, queries: int) -> Repeated:
    """Ask for ways between random free configurations of the scene."""
    rng = random.Random(SEED)
    kept = Planner(scene)
    ends = _free_configurations(kept.problem, rng, queries + 1)
    found = Repeated(scene.name, [], [], [])
    for start, goal in pairwise(ends):
        seconds, verdict, cells = _ask(kept, start, goal)
        found.kept.append(seconds)
        found.cells.append(cells)
        fresh = Planner(scene)
        seconds, again, _ = _ask(fresh, start, goal)
        found.fresh.append(seconds)
        if {verdict, again} == {"path", "no_path"}:
            raise RuntimeError(f"{scene.name}, {start} to {goal}: {verdict}, then {again}")
    return found


def _ask(
    planner: Planner, start: tuple[float, ...], goal: tuple[float, ...]
) -> tuple[float, str, int]:
    before = time.process_time()
    result = planner.solve(start, goal)
    return time.process_time() - before, result.verdict, int(result.stats["cells"])


def _free_configurations(
    problem: Problem, rng: random.Random, count: int
) -> list[tuple[float, float, float]]:
    """Draw them from the workspace's box."""
    check = Judge(problem).check
    low_x, high_x, low_y, high_y = _bounds(check.bounds)
    found: list[tuple[float, float, float]] = []
    while len(found) < count:
        q = rng.uniform(low_x, high_x), rng.uniform(low_y, high_y), rng.uniform(-3.1, 3.1)
        if check.is_free(*q):
            found.append(q)
    return found


def _bounds(bounds: list[float]) -> tuple[float, float, float, float]:
    xmin, ymin, xmax, ymax = bounds
    return xmin, xmax, ymin, ymax
