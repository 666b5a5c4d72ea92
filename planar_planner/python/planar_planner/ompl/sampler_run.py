"""One run of one of OMPL's planners, in a process of its own: ``python -m`` this module.

A request comes as JSON on standard input, the run goes out as JSON on standard output. A process a
run, because OMPL seeds its generators once, never releases the interpreter's lock while it solves,
and prints a report of leaked objects at exit.
"""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

import numpy as np

from planar_planner.load import load_scene
from planar_planner.ompl.samplers import import_ompl
from planar_planner.problem.make import Problem, make_problem

WARM_UP = 0.05
"""Seconds at most of a first, untimed run: its process is new, whereas ours is timed in a process
that has answered the query before. Loading code and touching memory are in neither's time."""
OVERHEAD_STATES = 2000
"""States on which the cost of a validity check is measured after the run."""
OVERHEAD_PASSES = 5
"""The least of so many passes over them counts: what else the machine does only adds."""


def run(request: Mapping[str, Any]) -> dict[str, Any]:
    """Run a planner on a scene until its first exact solution or the limit.

    Parameters
    ----------
    request : mapping
        ``scene`` (content of a scene file), ``planner``, ``seed``, ``timeout`` (seconds),
        ``resolution``.

    Returns
    -------
    dict
        ``exact`` (bool), ``prepare_seconds`` (from the scene's polygons in memory until the planner
        is made), ``seconds`` (of the planner's setup and solve), ``checks`` (state validity
        checks), ``path`` (waypoints; empty without an exact solution), ``check_ns`` (one check as
        OMPL calls it, through Python) and ``native_check_ns`` (the check itself), ``ompl``
        (version).
    """
    util = import_ompl("util")
    util.setLogLevel(util.LogLevel.LOG_NONE)
    problem = make_problem(load_scene(request["scene"]))
    limit = float(request["timeout"])
    util.RNG.setSeed(request["seed"])
    _attempt(problem, request, min(WARM_UP, limit))
    util.RNG.setSeed(request["seed"])
    setup, answer = _attempt(problem, request, limit)
    return answer | _cost_of_check(setup) | {"ompl": version("ompl")}


def _attempt(
    problem: Problem, request: Mapping[str, Any], limit: float
) -> tuple[Any, dict[str, Any]]:
    """Prepare and solve once; return the OMPL problem too."""
    from planar_planner.ompl.setup import base, make_sampler, set_up_problem, waypoints_of

    began = time.perf_counter()
    setup = set_up_problem(problem, resolution=request["resolution"])
    definition = setup.problem_definition()
    # Without a cost that satisfies them, planners that optimize run to the limit.
    objective = base.PathLengthOptimizationObjective(setup.information)
    objective.setCostThreshold(base.Cost(1e300))
    definition.setOptimizationObjective(objective)
    planner = make_sampler(request["planner"], setup.information)
    done = base.plannerOrTerminationCondition(
        base.timedPlannerTerminationCondition(limit),
        base.exactSolnPlannerTerminationCondition(definition),
    )
    checks = setup.judge.check.checks
    prepared = time.perf_counter()
    planner.setProblemDefinition(definition)
    planner.setup()
    planner.solve(done)
    ended = time.perf_counter()
    checks = setup.judge.check.checks - checks
    exact = bool(definition.hasExactSolution())  # of the status, also an approximate one is true
    path = []
    if exact:
        solution = definition.getSolutionPath()
        path = waypoints_of(solution, problem.start[2], turning=problem.rotation).tolist()
    return setup, {
        "exact": exact,
        "prepare_seconds": prepared - began,
        "seconds": ended - prepared,
        "checks": checks,
        "path": path,
    }


def _cost_of_check(setup: Any) -> dict[str, float]:
    """Time the check on random states, as OMPL calls it and on its own; nanoseconds."""
    generator = np.random.default_rng(0)
    low, high = np.array(setup.judge.check.bounds).reshape(2, 2)
    points = np.column_stack(
        [
            generator.uniform(low, high, (OVERHEAD_STATES, 2)),
            generator.uniform(-np.pi, np.pi, OVERHEAD_STATES)
            if setup.problem.rotation
            else np.full(OVERHEAD_STATES, setup.problem.start[2]),
        ]
    )
    states = [setup.state(tuple(q)) for q in points.tolist()]
    is_valid = setup.information.isValid
    native = through_python = math.inf
    for _ in range(OVERHEAD_PASSES):
        began = time.perf_counter()
        setup.judge.check.are_free(points)
        between = time.perf_counter()
        for state in states:
            is_valid(state)
        native = min(native, between - began)
        through_python = min(through_python, time.perf_counter() - between)
    return {
        "check_ns": 1e9 * through_python / OVERHEAD_STATES,
        "native_check_ns": 1e9 * native / OVERHEAD_STATES,
    }


def main() -> None:
    """Be that process."""
    answer = run(json.load(sys.stdin))
    json.dump(answer, sys.stdout, allow_nan=False)
    sys.stdout.flush()


if __name__ == "__main__":
    main()
