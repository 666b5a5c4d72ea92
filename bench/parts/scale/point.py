"""One point of a family in a process of its own.

So that a point cannot outlive its time limit, and peak memory is its own. Prints JSON.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # bench: also run as a script

BUDGET = 0.6  # seconds of repetitions
MOST = 15
KIB = 1024  # of ru_maxrss on Linux


def measure(family: str, value: float, timeout: float) -> dict[str, Any]:
    """Measure the point in a new process; without an answer the verdict is timeout or failed."""
    command = [sys.executable, __file__, family, repr(value), repr(timeout)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=2.0 * timeout + 10.0
        )
    except subprocess.TimeoutExpired:
        return {"verdict": "timeout", "reason": f"over {2.0 * timeout + 10.0:g} s with loading"}
    if done.returncode != 0:
        return {"verdict": "failed", "reason": done.stderr.strip().splitlines()[-1]}
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def here(family: str, value: float, timeout: float) -> dict[str, Any]:
    """Measure the point in this process; seconds are of the processor."""
    from parts.scale.families import families
    from planar_planner import Options, load_scene
    from planar_planner.planning.engine import ask, make_core
    from planar_planner.problem.make import make_problem

    make = next(each.make for each in families() if each.name == family)
    scene = make(value)
    before = time.process_time()
    problem = make_problem(load_scene(scene))
    loading = time.process_time() - before
    limits = Options(timeout=timeout)
    seconds: list[float] = []
    while not seconds or (sum(seconds) < BUDGET and len(seconds) < MOST):
        before = time.process_time()
        answer = ask(make_core(problem), problem, limits)
        seconds.append(time.process_time() - before)
    stats = answer["stats"]
    return {
        "verdict": answer["verdict"],
        "reason": answer["reason"],
        "seconds": seconds,
        "loading": loading,
        "peak_bytes": KIB * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss,
        **{
            key: stats[key]
            for key in ("cells", "labelled_cells", "separation_evaluations", "memory_bytes")
        },
    }


if __name__ == "__main__":
    from lib import provenance

    provenance.use_one_core()
    print(json.dumps(here(sys.argv[1], float(sys.argv[2]), float(sys.argv[3]))))
