"""OMPL's planners on the side that has a path: the only side on which a sampler can answer."""

from __future__ import annotations

import math
import resource
import statistics
import time
from collections.abc import Iterator, Sequence

from lib.timing import Spread
from parts.error_time.sweep import Point
from planar_planner.ompl.compare import SamplerRun, Settings, check_scene, run_samplers
from planar_planner.planning.path_judge import Judge
from worlds.critical import Family


def sweep_sampler(
    truth: Family, name: str, distances: Sequence[float], settings: Settings
) -> Iterator[Point]:
    """Run a sampler at falling distances until fewer than half of its runs find a sound path."""
    for distance in distances:
        if distance < truth.finest:
            return
        parameter = truth.parameter("path", distance)
        scene, problem = check_scene(truth.make(parameter))
        runs = list(timed(run_samplers(scene, Judge(problem), name, settings)))
        errors = [run.error for run, _ in runs if run.error]
        if len(errors) == len(runs):
            raise RuntimeError(f"{name}: {errors[0]}")
        sound = [(run, seconds) for run, seconds in runs if run.soundness == "sound"]
        unsound = sum(run.exact for run, _ in runs) - len(sound)
        yield Point(
            truth.name,
            name,
            "path",
            parameter,
            distance,
            len(sound) / len(runs),
            ranks([seconds for _, seconds in sound], len(runs)),
            ranks([run.seconds for run, _ in sound], len(runs)),
            statistics.median(run.checks for run, _ in runs),
            f"{unsound} paths not sound" if unsound else "",
        )
        if 2 * len(sound) < len(runs):
            return


def timed(runs: Iterator[SamplerRun]) -> Iterator[tuple[SamplerRun, float]]:
    """Add to each run the processor's time for it, estimated, in seconds.

    It is the run's time by the wall clock times the share of a core that its whole process had; but
    at least its state checks' time, since start-up, which waits for files, has a smaller share.
    """
    while True:
        wall, processor = time.perf_counter(), _children()
        run = next(runs, None)
        if run is None:
            return
        share = min(1.0, (_children() - processor) / (time.perf_counter() - wall))
        checking = 1e-9 * run.checks * run.check_ns if run.exact else 0.0
        yield run, min(run.seconds, max(share * run.seconds, checking))


def _children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def ranks(found: Sequence[float], runs: int) -> Spread:
    """Return median and quartiles of runs, of which those not found took infinitely long.

    They are values that occurred: interpolation fails at infinity.
    """
    ordered = sorted(found) + [math.inf] * (runs - len(found))
    last = runs - 1
    return Spread(
        ordered[runs // 2], ordered[round(0.25 * last)], ordered[round(0.75 * last)], runs
    )
