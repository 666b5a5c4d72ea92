"""Are there false labels? The rounding harness at full size, and how tight the error bounds are.

``python tests/attacks/rounding.py`` builds ``tests/native/rounding`` in Release, evaluates
a million random and a hundred thousand adversarial inputs a family in ball arithmetic, and writes
``bench/results/rounding.csv``. It fails if a label is false or an error exceeds its bound. Needs
CMake, a C++20 compiler with ``__float128`` and GoogleTest.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.extend(str(Path(__file__).resolve().parents[k]) for k in (1, 2))  # tests and scenarios

from support import provenance

FAMILIES = (
    *("brackets", "queries", "scenes", "depths", "distances"),
    *("sets", "pairs", "placements", "segments", "bounds"),
)
WIDTHS = (22, 13, 11, 11, 13, 11, 26)


def built(folder: Path) -> Path:
    """Build the harness and return it."""
    configure = ["cmake", "-S", str(provenance.ROOT), "-B", str(folder)]
    options = {
        "CMAKE_BUILD_TYPE": "Release",
        "PLANNER_PYTHON": "OFF",
        "PLANNER_NATIVE_TESTS": "ON",
        "SKBUILD_PROJECT_VERSION_FULL": "0",
    }
    configure += [f"-D{key}={value}" for key, value in options.items()]
    for command in (configure, ["cmake", "--build", str(folder), "--target", "rounding", "-j2"]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise SystemExit(done.stdout + done.stderr)
    return folder / "tests" / "native" / "rounding" / "rounding"


def run(harness: Path, family: str, arguments: argparse.Namespace) -> list[list[str]]:
    """Return the harness's rows of one family; the first is the header."""
    command = [str(harness), "--family", family, "--seed", str(arguments.seed)]
    command += ["--random", str(arguments.random), "--adversarial", str(arguments.adversarial)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{family}: {done.stderr}")
    return [row(line) for line in done.stdout.splitlines()]


def row(line: str) -> list[str]:
    """Return the cells of a line; a family's name, the first, may hold commas."""
    return line.rsplit(",", len(WIDTHS) - 1)


def main() -> int:
    """Run all families and report."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--random", type=int, default=1_000_000, help="inputs a family")
    parser.add_argument("--adversarial", type=int, default=100_000, help="inputs a family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="families at a time")
    arguments = parser.parse_args()
    facts = provenance.print_provenance() | {"seed": str(arguments.seed)}
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(arguments.jobs) as pool:
        harness = built(Path(folder))
        tables = list(pool.map(lambda family: run(harness, family, arguments), FAMILIES))
    header, rows = tables[0][0], [cells for table in tables for cells in table[1:]]
    for line in (header, *rows):
        print(
            *(
                f"{cell:<{width}}" if i < 2 else f"{cell:>{width}}"
                for i, (cell, width) in enumerate(zip(line, WIDTHS, strict=True))
            )
        )
    print(f"\nwritten: {provenance.write_csv('rounding.csv', facts, header, rows)}")
    bad = [f"{r[0]} ({r[1]})" for r in rows if int(r[4]) > 0 or not float(r[6]) <= 1.0]
    if bad:
        print(f"false labels, or errors beyond their bounds: {', '.join(bad)}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
