"""Faults: limits and interrupts at random moments, want of memory, files that cannot be written.

A query that is cut short answers `undecided` (or rightly, if it was nearly done), and the planner
that was cut short answers the next queries like a fresh one: same verdicts, certificates that hold.
"""

from __future__ import annotations

import os
import random
import signal
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from attacks.stress_parts import fault_files, fault_processes
from attacks.stress_parts.certificates import certificate_failure
from attacks.stress_parts.common import Row, Settings, fail
from planar_planner import Options, Planner, load_scene
from planar_planner.planning.result import Result
from planar_planner.scene.model import Scene
from scenarios import maze

PART = "faults"
SHORT = (
    "maze",
    "maze-blocked",
    "gear-tight",
    "gear-jammed",
    "piano-jammed",
    "snowflake-jammed",
    "comb-jammed",
    "disc-jammed",
    "window-fixed",
    "bug-trap-closed",
)
LONG_MAZE = 32  # cells a side: some tenths of a second, so that a listener is called
COUNTED = ("cells", "memory", "time")  # what is cut short by these may be as short as can be
CUTS = (*COUNTED, "listener", "signal", "exception")
CUT = "undecided"
QUERIES_CUT = 3  # in a row, at most, before the planner is asked in earnest


class ListenerError(Exception):
    """What a listener of ours raises."""


@dataclass(frozen=True)
class Case:
    """A scene, and what fresh planners say of it, there and back."""

    scene: Scene
    there: Result
    back: Result
    seconds: float


def run(settings: Settings) -> list[Row]:
    """Cut queries short in every way, exhaust memory, interrupt processes, fill disks."""
    rows = [
        *_random_cuts(settings),
        _one_query_at_a_time(settings),
        *fault_processes.run(settings),
    ]
    return [*rows, *fault_files.run(settings)]


def _scenes(settings: Settings) -> tuple[list[Case], list[Case]]:
    """Return scenes that are answered at once, and scenes that take their time."""
    names = SHORT[:4] if settings.quick else SHORT
    short = [load_scene(name) for name in names[: settings.most]]
    long = [maze.maze(LONG_MAZE, settings.seed, blocked=blocked) for blocked in (False, True)]
    return [_asked(scene) for scene in short], [_asked(load_scene(dict(s))) for s in long]


def _asked(scene: Scene) -> Case:
    began = time.perf_counter()
    there = Planner(scene).solve()
    seconds = time.perf_counter() - began
    return Case(scene, there, Planner(scene).solve(scene.goal, scene.start), seconds)


def _random_cuts(settings: Settings) -> list[Row]:
    short, long = _scenes(settings)
    rows = []
    for kind in CUTS:
        row = Row(PART, f"queries cut short by {kind}")
        began = time.perf_counter()
        counts = Counter[bool]()
        for trial in range(settings.count(200 if kind in COUNTED else 30, 3)):
            rng = random.Random(f"{settings.seed} {kind} {trial}")
            case = rng.choice(short if kind in COUNTED else long)
            try:
                counts += _cut_and_ask_again(settings, row, rng, kind, case)
            except Exception as error:
                fail(settings, row, None, f"{case.scene.name}: {type(error).__name__}: {error}")
        row.seconds = time.perf_counter() - began
        row.note = f"{counts[True]} of {counts.total()} queries were cut short before their end"
        rows.append(row)
    return rows


def _cut_and_ask_again(
    settings: Settings, row: Row, rng: random.Random, kind: str, case: Case
) -> Counter[bool]:
    """Cut some queries short, then ask in earnest; count which were cut short before their end."""
    planner = Planner(case.scene)
    name = case.scene.name
    counts = Counter[bool]()
    for _ in range(rng.randint(1, QUERIES_CUT)):
        ends = (planner.problem.start, planner.problem.goal)
        result = CUTTERS[kind](planner, ends if rng.random() < 0.5 else ends[::-1], rng, case)
        row.tried += 1
        counts[result is None or result.verdict == "undecided"] += 1
        for wrong in [] if result is None else _inconsistencies(result, case.there.verdict, CUT):
            fail(settings, row, None, f"{name}, cut short by {kind}: {wrong}")
    for start, goal, expected in (
        (case.scene.start, case.scene.goal, case.there),
        (case.scene.goal, case.scene.start, case.back),
    ):
        result = planner.solve(start, goal, certificate=kind in COUNTED)
        row.tried += 1
        setattr(row, result.verdict, getattr(row, result.verdict) + 1)
        problems = list(_inconsistencies(result, expected.verdict))
        if kind in COUNTED:
            scene = case.scene.to_dict() | {"start": list(start), "goal": list(goal)}
            problems += filter(None, [certificate_failure(scene, result, 0.0)])
        for wrong in problems:
            fail(settings, row, None, f"{name}, asked after a cut by {kind}: {wrong}")
    return counts


def _inconsistencies(result: Result, *allowed: str) -> Iterator[str]:
    """Yield what is wrong with an answer in itself."""
    if result.verdict not in allowed:
        yield f"{result.verdict} ({result.reason}) where it should be {' or '.join(allowed)}"
    if not result.reason:
        yield "no reason"
    if (len(result.path) >= 2) != (result.verdict == "path"):
        yield f"{result.verdict} with {len(result.path)} waypoints"
    stats = result.stats
    if not stats and result.verdict == "undecided":
        return  # out of memory: nothing is left to count
    labels = sum(stats["cells_by_label"].values())
    if not stats["cells"] == labels == sum(stats["cells_by_level"]):
        yield f"{stats['cells']} cells, {labels} by label, {sum(stats['cells_by_level'])} by level"
    negative = [k for k, v in stats.items() if isinstance(v, (int, float)) and v < 0]
    if negative:
        yield f"negative: {negative}"


# --- Ways to cut a query short: planner, ends, random numbers, the case → the answer, if any -----


def _by_cells(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result:
    most = rng.randint(1, max(2, case.there.stats["cells"]))
    start, goal = ends
    return planner.solve(start, goal, Options(max_cells=most))


def _by_memory(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result:
    most = rng.randint(1, max(2, case.there.stats["memory_bytes"]))
    start, goal = ends
    return planner.solve(start, goal, Options(max_memory=most))


def _by_time(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result:
    start, goal = ends
    return planner.solve(start, goal, Options(timeout=case.seconds * rng.uniform(0.001, 1.0)))


def _by_listener(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result:
    calls = iter(range(rng.randint(0, 2), -1, -1))
    start, goal = ends
    return planner.solve(start, goal, listener=lambda _: next(calls) > 0)


def _by_exception(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result | None:
    def listener(_: Any) -> bool:
        raise ListenerError

    start, goal = ends
    try:
        return planner.solve(start, goal, listener=listener)
    except ListenerError:
        return None


def _by_signal(planner: Planner, ends: Any, rng: random.Random, case: Case) -> Result | None:
    """Ctrl-C from a second thread; it may strike Python code outside the core as well."""
    start, goal = ends
    delay = rng.uniform(0.0, 1.2 * case.seconds)
    timer = threading.Timer(delay, os.kill, (os.getpid(), signal.SIGINT))
    previous = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        result: Result | None = planner.solve(start, goal)
        timer.join()
        time.sleep(0.001)  # a late signal strikes here
    except KeyboardInterrupt:
        result = None
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, previous)
    return result


CUTTERS: dict[str, Callable[[Planner, Any, random.Random, Case], Result | None]] = {
    "cells": _by_cells,
    "memory": _by_memory,
    "time": _by_time,
    "listener": _by_listener,
    "signal": _by_signal,
    "exception": _by_exception,
}


def _one_query_at_a_time(settings: Settings) -> Row:
    """Let a listener ask its own planner: it is told off, and the query goes on."""
    row = Row(PART, "a planner asked by its own listener")
    planner = Planner(fault_processes.ENDLESS)
    refusals = []

    def listener(_: Any) -> bool:
        try:
            planner.solve()
        except RuntimeError as error:
            refusals.append(str(error))
        return False

    result = planner.solve(options=Options(resolution=1e-300), listener=listener)
    row.tried = 1
    row.undecided = int(result.verdict == "undecided")
    if len(refusals) != 1 or result.reason != "interrupted":
        fail(settings, row, None, f"{refusals}, {result.verdict} ({result.reason})")
    return row
