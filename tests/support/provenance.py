"""What reproduces a measurement: commit, machine, compiler, versions; and tables that state it."""

from __future__ import annotations

import csv
import importlib.util
import os
import platform
import re
import subprocess
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "bench" / "results"
SOURCES = ("pdg", "planar_planner", "CMakeLists.txt")


def provenance() -> dict[str, str]:
    """Return what to state with a measurement."""
    return {
        "measured": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "commit": _commit(),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {platform.system()}",
        "compiler": _compiler(),
        "python": platform.python_version(),
        "versions": f"planar-planner {version('planar-planner')}, numpy {version('numpy')}",
    }


def print_provenance() -> dict[str, str]:
    """Print it, one fact a line, and return it."""
    facts = provenance()
    for key, value in facts.items():
        print(f"{key + ':':10} {value}")
    print()
    return facts


def write_csv(
    name: str, facts: dict[str, str], header: Sequence[str], rows: Iterable[Sequence[object]]
) -> Path:
    """Write a table into ``bench/results/``, below comment lines that state the provenance."""
    RESULTS.mkdir(exist_ok=True)
    file = RESULTS / name
    with file.open("w", encoding="utf-8", newline="") as stream:
        stream.writelines(f"# {key}: {value}\n" for key, value in facts.items())
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    return file


def _git(*arguments: str) -> str:
    done = subprocess.run(
        ["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=False
    )
    return done.stdout.strip() if done.returncode == 0 else ""


def _commit() -> str:
    """Return the checkout's commit, and whether what is installed is seen to be something else."""
    commit = _git("rev-parse", "--short=12", "HEAD")
    if not commit:
        return "unknown"
    notes = []
    if _git("status", "--porcelain", "--", *SOURCES):
        notes.append("with changes")
    if _installed_differs():
        notes.append("not what is installed")
    return f"{commit} ({'; '.join(notes)})" if notes else commit


def _installed_differs() -> bool:
    """Whether an installed Python file is another, or the core older than its last commit."""
    from planar_planner import _core

    committed = _git(
        "log", "-1", "--format=%ct", "--", *(f"{package}/native" for package in SOURCES[:2])
    )
    if committed and Path(str(_core.__file__)).stat().st_mtime < float(committed):
        return True
    for package in SOURCES[:2]:
        spec = importlib.util.find_spec(package)
        if spec is None or spec.origin is None:
            raise SystemExit("install the package first: pip install .")
        for file in Path(spec.origin).parent.rglob("*.py"):
            beside = file.relative_to(Path(spec.origin).parent)
            source = ROOT / package / "python" / package / beside
            if not source.is_file() or source.read_bytes() != file.read_bytes():
                return True
    return False


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.is_file():
        found = re.search(r"^model name\s*:\s*(.+)$", cpuinfo.read_text(), re.MULTILINE)
        if found:
            return found[1]
    return platform.processor() or platform.machine()


def _compiler() -> str:
    """Return what compilers write into the module they make."""
    from planar_planner import _core

    found = re.search(
        rb"GCC: \([^)]*\) [\d.]+|clang version [\w.+~-]+", Path(str(_core.__file__)).read_bytes()
    )
    return found[0].decode() if found else "unknown"
