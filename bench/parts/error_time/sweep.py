"""Our planner, whole and without each of its parts, towards the critical parameter."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from lib.timing import Spread, repetitions
from planar_planner import Options, load_scene
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import Problem, make_problem
from worlds.critical import SIDES, Family, Side

# The finest that doubles allow: at the default resolution the band begins at some 1e-10.
RESOLUTION = 1e-15
OURS = "ours"
PARTS: dict[str, tuple[tuple[str, ...], str]] = {
    OURS: ((), "per-normal"),
    "no star test": (("star",), "per-normal"),
    "no joint test": (("joint",), "per-normal"),
    "level by level": (("guided",), "per-normal"),
    "search from scratch": (("incremental",), "per-normal"),
    "no hierarchy": (("hierarchy",), "per-normal"),
    "cover": (("partition",), "per-normal"),
    "no ridge": (("ridge",), "per-normal"),
    "no cheap moves": (("cheap",), "per-normal"),
    "query: displacement": ((), "displacement"),
    "query: published": ((), "published"),
    "query: none": ((), "none"),
    # [NOPATH] with [STAR]: star-shaped cells and the scalar query, refined level by level.
    "as published": (("joint", "guided", "cheap", "incremental", "ridge"), "published"),
}
"""What is left out, and the C-obstacle query (planar_planner/native/ablation.hpp), by name."""

NEVER = Spread(math.inf, math.inf, math.inf, 1)
FAILURES = 2  # undecided distances in a row after which a side is given up


class WrongVerdictError(RuntimeError):
    """The planner contradicted a theorem."""


@dataclass(frozen=True)
class Effort:
    """How much time may be spent on a query: its limit, and repetitions until `budget` seconds."""

    limit: float
    budget: float = 0.3
    fewest: int = 3
    most: int = 15


@dataclass(frozen=True)
class Point:
    """What a planner did at one distance from critical.

    Attributes
    ----------
    distance : float
        Relative to the critical parameter.
    decided : float
        The share of runs that answered rightly (for a sampler: with a sound path); 0 or 1 for ours.
    seconds : Spread
        The processor's time to the answer: what an idle core would take. Infinite for runs without
        an answer.
    wall : Spread
        The same by the wall clock, with whatever else the machine was doing.
    count : float
        Cells of ours, state checks of a sampler (median).
    note : str
        Why there was no answer.
    """

    family: str
    planner: str
    side: Side
    parameter: float
    distance: float
    decided: float
    seconds: Spread
    wall: Spread
    count: float
    note: str = ""


def sweep(truth: Family, name: str, distances: Sequence[float], effort: Effort) -> Iterator[Point]:
    """Measure one variant of ours at falling distances, on both sides, until it gives up."""
    for side in SIDES:
        failures = 0
        for distance in distances:
            if distance < truth.finest or failures == FAILURES:
                break
            point = measure(truth, name, side, distance, effort)
            failures = 0 if point.decided else failures + 1
            yield point


def measure(truth: Family, name: str, side: Side, distance: float, effort: Effort) -> Point:
    """Repeat a query on a fresh core each time; raise if the answer is wrong or varies."""
    parameter = truth.parameter(side, distance)
    problem = make_problem(load_scene(truth.make(parameter)))
    runs: list[Run] = []
    for _ in repetitions(effort.budget, effort.fewest, effort.most):
        runs.append(answered(problem, name, effort.limit))
        if runs[-1].verdict == "undecided":  # at a limit; a repetition says nothing new
            break
        if runs[-1].verdict != side:
            raise WrongVerdictError(f"{truth.name} at {parameter!r}, {name}: not {side}")
    last = runs[-1]
    decided = last.verdict != "undecided"
    if decided and len({run.cells for run in runs}) != 1:
        raise WrongVerdictError(f"{truth.name} at {parameter!r}, {name}: not the same each time")
    return Point(
        truth.name,
        name,
        side,
        parameter,
        distance,
        float(decided),
        Spread.of([run.cpu for run in runs]) if decided else NEVER,
        Spread.of([run.seconds for run in runs]) if decided else NEVER,
        last.cells,
        "" if decided else f"{last.reason}, {last.seconds:.3g} s",
    )


class Run(NamedTuple):
    """One query: seconds in the core by the wall clock, and of the processor."""

    verdict: str
    cells: int
    seconds: float
    cpu: float
    reason: str


def answered(problem: Problem, name: str, limit: float) -> Run:
    """Answer a query once with a variant, on a fresh core."""
    without, query = PARTS[name]
    options = Options(resolution=RESOLUTION, timeout=limit)
    began = time.thread_time()
    answer = ask(make_core(problem, without, query), problem, options)
    cpu = time.thread_time() - began
    stats = answer["stats"]
    seconds = float(stats["seconds"]["total"])
    return Run(answer["verdict"], int(stats["cells"]), seconds, cpu, str(answer["reason"]))
