"""Measurements that need a process of their own: start-up times, imports, peak memory."""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # bench: also run as a script

from lib.timing import Spread

STARTS = 15


def first_line(*arguments: str) -> Spread:
    """Seconds from starting ``python -m planar_planner`` to the first line of its output."""
    seconds = []
    for _ in range(STARTS):
        began = time.perf_counter()
        with subprocess.Popen(
            [sys.executable, "-P", "-m", "planar_planner", *arguments],
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            assert process.stdout is not None
            process.stdout.readline()
            seconds.append(time.perf_counter() - began)
            process.stdout.read()
    return Spread.of(seconds)


def import_time() -> Spread:
    """Seconds of a process that imports the package with its public names, less an empty one."""
    names = "from planar_planner import Options, Planner, load_scene, solve"
    empty = Spread.of([_run_code("pass") for _ in range(STARTS)])
    return Spread.of([_run_code(names) - empty.median for _ in range(STARTS)])


def heavy_modules(*arguments: str) -> list[str]:
    """Which of matplotlib and scipy a command imports."""
    code = (
        "import sys; from planar_planner.cli.main import main; "
        f"main({list(arguments)!r}); "
        "print([m for m in ('matplotlib', 'scipy') if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], capture_output=True, text=True, check=True
    )
    found: list[str] = json.loads(done.stderr.strip().splitlines()[-1].replace("'", '"'))
    return found


def _run_code(code: str) -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-P", "-c", code], check=True)
    return time.perf_counter() - began


def large_query(gates: int) -> dict[str, Any]:
    """Solve the wall of jammed gates in a process of its own; statistics, peak memory (bytes)."""
    done = subprocess.run(
        [sys.executable, __file__, str(gates)], capture_output=True, text=True, check=True
    )
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def main() -> None:
    """Be that process."""
    from parts.targets.scenes import jammed_gates
    from planar_planner import Options, solve

    result = solve(jammed_gates(int(sys.argv[1])), Options(timeout=600))
    peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # kilobytes on Linux
    print(json.dumps({"verdict": result.verdict, "peak": peak, "stats": dict(result.stats)}))


if __name__ == "__main__":
    main()
