"""Try to break the verdicts: ``python tests/attacks/stress.py``.

Takes ``--quick``, ``--seed N``, ``--only PART ...``. Runs the parts in ``stress_parts/``, prints a
table and every failure, and writes ``bench/results/stress.csv`` when all parts were run in full.
Exit status 1 if anything failed: a wrong verdict, a contradiction between answers, a rejected
certificate, a crash, a hang.
"""

from __future__ import annotations

import argparse
import faulthandler
import importlib
import sys
import time
from collections.abc import Sequence
from pathlib import Path

sys.path.extend(str(Path(__file__).resolve().parents[k]) for k in (1, 2))  # tests and scenarios

from attacks.stress_parts import PARTS
from attacks.stress_parts.common import Row, Settings
from support.provenance import print_provenance, write_csv

SHOWN = 10  # failures printed of each row
VERDICTS = ("path", "no_path", "undecided", "refused")
HEADER = ("part", "case", "tried", *VERDICTS, "failures", "s", "check_s")


def cells(row: Row) -> tuple[object, ...]:
    """Return a row's columns, as in `HEADER`; the note follows."""
    counts = (row.tried, *(getattr(row, verdict) for verdict in VERDICTS), len(row.failures))
    return (row.part, row.case, *counts, f"{row.seconds:.1f}", f"{row.checking:.1f}")


def print_row(columns: Sequence[object], note: str) -> None:
    """Print one line of the table."""
    part, case, *numbers = columns
    print(f"{part:<10} {case:<50}" + "".join(f"{n:>10}" for n in numbers) + f"  {note}", flush=True)


def run_part(name: str, settings: Settings) -> list[Row]:
    """Run one part and print its rows."""
    began = time.perf_counter()
    rows: list[Row] = []
    for row in importlib.import_module(f"attacks.stress_parts.{name}").run(settings):
        rows.append(row)
        print_row(cells(row), row.note)
    print(f"{name}: {time.perf_counter() - began:.0f} s\n", flush=True)
    return rows


def print_failures(rows: Sequence[Row]) -> int:
    """Print the first failures of each row; return how many there are in all."""
    for row in rows:
        for line in row.failures[:SHOWN]:
            print(f"FAILED {line}")
        if len(row.failures) > SHOWN:
            print(f"FAILED {row.part}, {row.case}: {len(row.failures) - SHOWN} more")
    return sum(len(row.failures) for row in rows)


def parsed(arguments: Sequence[str] | None) -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="a sample, for every change")
    parser.add_argument("--seed", type=int, default=0, help="of everything random (default 0)")
    parser.add_argument("--only", nargs="+", choices=PARTS, help="these parts only")
    parser.add_argument("--processes", type=int, default=1, help="at a time (default 1)")
    parser.add_argument(
        "--failures",
        type=Path,
        default=Path("stress-failures"),
        help="folder for the scenes that failed (default ./stress-failures)",
    )
    return parser.parse_args(arguments)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run, tabulate, and say whether anything failed."""
    given = parsed(arguments)
    facts = print_provenance()
    settings = Settings(
        quick=given.quick,
        seed=given.seed,
        processes=given.processes,
        failures=given.failures,
    )
    facts["seed"] = str(given.seed)
    print(f"seed:      {given.seed}{' (quick)' if given.quick else ''}\n")
    print_row(HEADER, "note")
    rows = [row for name in given.only or PARTS for row in run_part(name, settings)]
    failures = print_failures(rows)
    print(f"{sum(row.tried for row in rows):,} cases, {failures} failures")
    if not given.quick and not given.only:
        table = ((*cells(row), row.note) for row in rows)
        print(f"written: {write_csv('stress.csv', facts, (*HEADER, 'note'), table).name}")
    return 1 if failures else 0


if __name__ == "__main__":
    faulthandler.enable()  # a crash of the core names the part that was running
    sys.exit(main())
