"""Hostile input: no crash, no hang, no unbounded memory; a clear refusal instead.

Whole files through the command line, each in a process with little memory and a time limit;
thousands of small changes to scenes and certificates through the readers; polygons of almost
touching edges through the judge of shapes and the decomposition, against rational arithmetic.
`tests/attacks/fuzz_readers.py` does the second, guided by coverage, for as long as one likes.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from attacks.stress_parts import hostile_files, hostile_mutations, hostile_polygons
from attacks.stress_parts.common import Row, Settings, fail

PART = "hostile"
SECONDS = 60.0  # for one file, with the start of the program
ADDRESS_SPACE = 4 * 2**30  # bytes a process may ask for
RESIDENT = 2 * 2**30  # bytes it may use
SOLVE_TIMEOUT = "10"

# Tells its largest resident size; the system's own account would begin with the parent's.
_COMMAND = f"""
import re, sys
try:
    import resource
    resource.setrlimit(resource.RLIMIT_AS, ({ADDRESS_SPACE}, {ADDRESS_SPACE}))
except ImportError:
    pass
from planar_planner.cli.main import main
status = main()
try:
    peak = re.search(r"VmHWM:\\s*(\\d+)", open("/proc/self/status").read())[1]
except OSError:
    peak = "0"
sys.stderr.write("\\n" + peak)
sys.exit(status)
"""


def run(settings: Settings) -> list[Row]:
    """Run all of it; the quick run does without the files that take long to write or read."""
    rows = [
        _files(settings, "scene files", ["check", "--timeout", SOLVE_TIMEOUT]),
        _files(settings, "certificate files", ["verify", "corner"]),
        hostile_mutations.scenes(settings),
        hostile_mutations.certificates(settings),
    ]
    return [*rows, *hostile_polygons.run(settings)]


def _files(settings: Settings, name: str, arguments: list[str]) -> Row:
    row = Row(PART, name)
    began = time.perf_counter()
    slowest, largest = (0.0, ""), (0, "")
    made = hostile_files.scenes if name.startswith("scene") else hostile_files.certificates
    with tempfile.TemporaryDirectory() as folder:
        for k, (case, data) in enumerate(made(quick=settings.quick)):
            if k >= settings.most:
                break
            file = Path(folder) / "hostile.json"
            file.write_bytes(data)
            seconds, kibibytes = _one(settings, row, case, [*arguments, str(file)])
            slowest, largest = max(slowest, (seconds, case)), max(largest, (kibibytes, case))
    row.seconds = time.perf_counter() - began
    row.note = (
        f"slowest {slowest[0]:.1f} s ({slowest[1]}), "
        f"largest {largest[0] / 1024:.0f} MiB ({largest[1]}) resident"
    )
    return row


def _one(settings: Settings, row: Row, case: str, arguments: list[str]) -> tuple[float, int]:
    """Give a file to the command; return seconds and the largest resident size in KiB."""
    began = time.perf_counter()
    row.tried += 1
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}  # each thread reserves address space
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-c", _COMMAND, *arguments],
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
            env=environment,
        )
    except subprocess.TimeoutExpired:
        fail(settings, row, None, f"{case}: no answer after {SECONDS:g} s")
        return SECONDS, 0
    seconds = time.perf_counter() - began
    err, _, peak = done.stderr.rpartition("\n")
    kibibytes = int(peak) if re.fullmatch(r"\d+", peak) else 0
    verdicts = {0: "path", 1: "no_path", 2: "refused", 3: "undecided"}
    if arguments[0] == "verify":
        verdicts = {0: "path", 1: "refused", 2: "refused"}
    if done.returncode not in verdicts or "internal error" in err or "Traceback" in err:
        what = f"{case}: exit status {done.returncode}, {done.stderr[-300:]!r}"
        fail(settings, row, None, what)
    elif done.returncode == 2 and (err.strip().count("\n") or not 0 < len(err) < 1000):
        fail(settings, row, None, f"{case}: refused with {json.dumps(err[:300])}")
    else:
        verdict = verdicts[done.returncode]
        setattr(row, verdict, getattr(row, verdict) + 1)
    if kibibytes * 1024 > RESIDENT:
        fail(settings, row, None, f"{case}: {kibibytes // 1024} MiB resident")
    return seconds, kibibytes
