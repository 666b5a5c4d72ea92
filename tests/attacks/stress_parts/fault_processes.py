"""Faults that strike a whole process: Ctrl-C at any moment, an address space that is too small."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from attacks.stress_parts.common import Row, Settings, fail

PART = "faults"
PATIENCE = 60.0  # seconds: no process here takes a tenth of it


def _wall(low: float, high: float) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": [[[4, low], [6, low], [6, high], [4, high]]]}


# A door exactly as wide as the robot: undecided at every resolution, so it takes what it is given.
ENDLESS: dict[str, Any] = {
    "format": "planar-planner/scene",
    "version": 1,
    "name": "endless",
    "workspace": {"box": [0, 0, 10, 10]},
    "robot": {
        "type": "Polygon",
        "coordinates": [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]],
    },
    "obstacles": [_wall(-1, 4.5), _wall(5.5, 11)],
    "start": [2, 5, 0.3],
    "goal": [8, 5, 0.3],
}
UNLIMITED = "resolution=1e-300, max_cells=10**10, max_memory=2**40"

# Says when it is ready to be interrupted: before that the interpreter itself is starting.
_COMMAND = (
    "import sys\n"
    "from planar_planner.cli.main import main\n"
    "print('ready', file=sys.stderr, flush=True)\n"
    "sys.exit(main())\n"
)

# Three queries: within a small address space, then without that limit, on one planner; and what a
# fresh one says. The libraries are loaded before the limit, so that it strikes the search.
_STARVED = f"""
import json, resource, sys
import numpy, shapely
from planar_planner import Options, Planner
scene = json.loads(sys.argv[1])
def asked(planner, **limits):
    result = planner.solve(options=Options(**limits), certificate=True)
    return result.verdict, result.reason, result.stats.cells
planner = Planner(scene)
asked(planner, max_cells=50)
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
soft = used + int(sys.argv[2])
resource.setrlimit(resource.RLIMIT_AS, (soft, resource.RLIM_INFINITY))
starved = asked(planner, {UNLIMITED}, timeout=40)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
again, fresh = asked(planner, max_cells=5000), asked(Planner(scene), max_cells=5000)
print(json.dumps([starved, again, fresh]))
"""

_STARVED_COMMAND = """
import resource, sys
import numpy, shapely
import planar_planner.cli.commands.solve, planar_planner.planning.planner
from planar_planner.cli.main import main
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + int(sys.argv.pop(1)), resource.RLIM_INFINITY))
sys.exit(main())
"""


def run(settings: Settings) -> list[Row]:
    """Interrupt and starve processes, where the system knows how to."""
    if os.name != "posix":
        return []
    rows = [_interrupted(settings)]
    if Path("/proc/self/statm").exists():
        rows += [_starved_planner(settings), _starved_command(settings)]
    return rows


def _interrupted(settings: Settings) -> Row:
    """Ctrl-C at a random moment: the verdict if it was there already, undecided if not."""
    row = Row(PART, "Ctrl-C to the command")
    began = time.perf_counter()
    slowest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "result.json"
        for trial in range(settings.count(100, 5)):
            rng = random.Random(f"{settings.seed} ctrl-c {trial}")
            results.write_text("{}")
            delay = rng.uniform(0.0, 0.8)
            status, seconds, err = _interrupt(
                ["solve", rng.choice(["maze", "gear-tight", "-"]), "--json", str(results)],
                folder,
                delay,
            )
            slowest = max(slowest, seconds)
            row.tried += 1
            if status == -signal.SIGINT and err == "" and "verdict" in results.read_text():
                status = 0  # all was done; the interpreter, about to end, no longer catches it
            row.undecided += status == 3
            row.path += status == 0
            lines = err.count("\n")
            if status not in (0, 3) or lines > 1 or (lines and "interrupted" not in err):
                what = f"after {delay:.3f} s: exit status {status}, {err[-300:]!r}"
                fail(settings, row, None, what)
            files = sorted(f.name for f in Path(folder).iterdir())
            if files != ["result.json", "scene.json"]:
                fail(settings, row, None, f"after {delay:.3f} s: files {files}")
    row.seconds = time.perf_counter() - began
    row.note = f"ended at most {slowest:.2f} s after the signal"
    return row


def _interrupt(arguments: list[str], folder: str, delay: float) -> tuple[int, float, str]:
    """Start the command, interrupt it, and return its status, how long it lived on, and stderr."""
    scene = Path(folder) / "scene.json"
    scene.write_text(json.dumps(ENDLESS))
    arguments = [str(scene) if a == "-" else a for a in arguments]
    # A job in the background of a script has Ctrl-C ignored, and its children would inherit that.
    inherited = signal.signal(signal.SIGINT, signal.default_int_handler)
    process = subprocess.Popen(
        [sys.executable, "-P", "-c", _COMMAND, *arguments, "--resolution", "1e-300"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    signal.signal(signal.SIGINT, inherited)
    assert process.stderr is not None
    process.stderr.readline()
    time.sleep(delay)
    struck = time.perf_counter()
    process.send_signal(signal.SIGINT)
    try:
        _, err = process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        err = process.communicate()[1] + "hangs"
    return process.returncode, time.perf_counter() - struck, err


def _starved_planner(settings: Settings) -> Row:
    """Let the address space run out during the search: undecided, and the planner lives on."""
    row = Row(PART, "no more memory during the search")
    began = time.perf_counter()
    for trial in range(settings.count(12, 2)):
        rng = random.Random(f"{settings.seed} memory {trial}")
        room = int(2.0 ** rng.uniform(18.0, 27.5))
        command = [sys.executable, "-P", "-c", _STARVED, json.dumps(ENDLESS), str(room)]
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=2 * PATIENCE, check=False
        )
        row.tried += 1
        what = f"{room} bytes: exit status {done.returncode}, {done.stdout}{done.stderr[-300:]}"
        if done.returncode != 0:
            fail(settings, row, None, what)
            continue
        starved, again, fresh = json.loads(done.stdout)
        row.undecided += starved[0] == "undecided"
        if starved[:2] != ["undecided", "out of memory"] or again != fresh:
            fail(settings, row, None, what)
    row.seconds = time.perf_counter() - began
    return row


def _starved_command(settings: Settings) -> Row:
    """Leave the command too little room, or none: one line, no traceback."""
    row = Row(PART, "no more memory for the command")
    began = time.perf_counter()
    for trial in range(settings.count(40, 4)):
        rng = random.Random(f"{settings.seed} command {trial}")
        room = rng.choice([0, int(2.0 ** rng.uniform(16.0, 28.0))])
        scene = rng.choice(["gear", "gear-jammed", "field", "maze"])
        command = [sys.executable, "-P", "-c", _STARVED_COMMAND, str(room), "check", scene]
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=PATIENCE, check=False
        )
        row.tried += 1
        row.undecided += done.returncode == 3
        row.path += done.returncode == 0
        row.no_path += done.returncode == 1
        lines = done.stderr.count("\n")
        clean = done.returncode in (0, 1) and lines == 0
        if not clean and not (done.returncode in (2, 3) and done.stdout.count("\n") + lines == 1):
            what = f"{scene}, {room} bytes: exit status {done.returncode}, {done.stderr[-300:]!r}"
            fail(settings, row, None, what)
    row.seconds = time.perf_counter() - began
    return row
