"""Every number this project set out to reach, measured: ``python bench/targets.py``.

Times are core time on one core (statistics: seconds total) unless a row says otherwise. Writes
``bench/results/targets.csv``. ``--quick`` leaves out the query of a million cells (a minute).
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass

from lib.bisection import bisect
from lib.provenance import print_provenance, use_one_core, write_csv
from lib.timing import Measured, Spread, measure
from parts.targets.processes import first_line, heavy_modules, import_time, large_query
from parts.targets.scenes import JAMMED_GATES
from planar_planner.scene.builtin import manifest
from scenarios import corner, field, gear

MS = 1e3
GIB = 2.0**30
BRACKET = 1e-8
OFFSET = 1e-6  # of the corner's length from the critical one
SMALL_SCENES = ("bug-trap", "piano", "slot", "corner", "comb", "snowflake")
TWINS = {"bug-trap": "bug-trap-closed", "corner": "corner-too-long"}  # others: name-jammed


@dataclass(frozen=True)
class Row:
    """One measured number. `target` is the largest allowed; None: for information."""

    what: str
    quantity: str
    value: float
    unit: str
    target: float | None
    spread: Spread | None = None
    note: str = ""

    @property
    def met(self) -> str:
        """``yes`` or ``NO``; nothing without a target."""
        if self.target is None:
            return ""
        return "yes" if self.value <= self.target else "NO"


def timed(what: str, measured: Measured, target: float | None, expected: str) -> Row:
    """Return the row of a query's core time; another verdict than expected is no measurement."""
    if measured.result.verdict != expected:
        raise RuntimeError(f"{what}: {measured.result.verdict}, expected {expected}")
    core = measured.core
    in_ms = Spread(MS * core.median, MS * core.lower, MS * core.upper, core.count)
    return Row(what, "core time", in_ms.median, "ms", target, in_ms, f"{measured.cells:,} cells")


def gears() -> Iterator[Row]:
    """Yield time and cells of the two gear scenes."""
    for name in ("gear", "gear-jammed"):
        measured = measure(name)
        yield timed(name, measured, 10, manifest()[name]["expected"])
        yield Row(name, "cells", measured.cells, "", 10_000)


def corners() -> Iterator[Row]:
    """Yield the corner off its critical length, both verdicts."""
    critical = corner.critical_length(corner.DEFAULT_WIDTH)
    for sign, expected in ((-1, "path"), (1, "no_path")):
        measured = measure(corner.corner(critical + sign * OFFSET))
        yield timed(f"corner {sign * OFFSET:+.0e} off critical", measured, 10, expected)


def gear_family() -> Iterator[Row]:
    """Yield the slowest decision of a bisection for the critical gap."""
    found = bisect(gear.gear, gear.JAMMED_GAP, gear.PATH_GAP, BRACKET)
    gap, measured = found.slowest
    row = timed("gear family, slowest decision", measured, 150, measured.result.verdict)
    bracket = f"[{found.blocked:.10f}, {found.passing:.10f}]"
    note = f"gap {gap:.10f} of {len(found.decisions)} decisions to {bracket}, {row.note}"
    yield Row(row.what, row.quantity, row.value, row.unit, row.target, row.spread, note)


def small_scenes() -> Iterator[Row]:
    """Yield the small scenes and their twins."""
    for name in SMALL_SCENES:
        for each in (name, TWINS.get(name, f"{name}-jammed")):
            yield timed(each, measure(each), 20, manifest()[each]["expected"])


def mazes() -> Iterator[Row]:
    """Yield time and search's share of the mazes."""
    for name, time_target, share_target in (("maze", 150, 30), ("maze-blocked", None, None)):
        measured = measure(name, budget=2.0)
        yield timed(name, measured, time_target, manifest()[name]["expected"])
        yield Row(name, "search's share", 100 * measured.shares["search"], "%", share_target)


def fields() -> Iterator[Row]:
    """Yield the field, and what 20,000 obstacles behind a wall add after loading."""
    yield timed("field", measure("field"), 150, "path")
    near = measure(field.field(annex=True), budget=2.0)
    far = measure(field.field(far=20_000), budget=2.0)
    yield timed("field with annex", near, None, "path")
    yield timed("field with annex, 20,000 far obstacles", far, None, "path")
    added = 100 * (far.core.median / near.core.median - 1)
    yield Row("20,000 far obstacles", "core time added", added, "%", 20)


def memory(gates: int) -> Iterator[Row]:
    """Yield memory a cell and the peak of a query of a million cells."""
    large = large_query(gates)
    stats = large["stats"]
    cells = stats["cells"]
    note = f"{cells:,} cells, {large['verdict']}, {stats['seconds']['total']:.1f} s"
    constraints = stats.get("constraint_bytes")
    if constraints is None:
        yield Row("memory", "with constraints", stats["memory_bytes"] / cells, "B/cell", None)
    else:
        own = (stats["memory_bytes"] - constraints) / cells
        yield Row("memory", "beyond constraints", own, "B/cell", 200, note=note)
        yield Row("memory", "constraints", constraints / cells, "B/cell", None)
    yield Row("memory", "peak, whole process", large["peak"] / GIB, "GiB", 1, note=note)
    yield Row("memory", "cells reached", cells, "", None)


def start_up() -> Iterator[Row]:
    """Yield import and time to the first line, and what is imported on the way."""
    timings = {
        "import planar_planner": import_time(),
        "list, first line": first_line("list"),
        "check gear, first line": first_line("check", "gear"),
    }
    for what, spread in timings.items():
        yield Row(what, "wall time", spread.median, "s", 0.3, spread)
    for arguments in (("list",), ("check", "gear")):
        heavy = heavy_modules(*arguments)
        yield Row(
            " ".join(arguments), "matplotlib, scipy imported", len(heavy), "", 0, note=str(heavy)
        )


def show(row: Row) -> None:
    """Print one row."""
    spread = f"{row.spread.lower:.3g} to {row.spread.upper:.3g}" if row.spread else ""
    target = "" if row.target is None else f"<= {row.target:g}"
    print(
        f"{row.what:<40} {row.quantity:<26} {row.value:>9,.4g} {row.unit:<6} {spread:<18}"
        f"{target:<9} {row.met:<4} {row.note}",
        flush=True,
    )


def main() -> int:
    """Measure all rows, print them, write them down; 1 if a target is missed."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="without the query of a million cells")
    arguments = parser.parse_args()
    facts = print_provenance()
    use_one_core()
    groups = [gears(), corners(), gear_family(), small_scenes(), mazes(), fields(), start_up()]
    if not arguments.quick:
        groups.append(memory(JAMMED_GATES))
    rows = []
    for group in groups:
        for row in group:
            show(row)
            rows.append(row)
    header = ("what", "quantity", "value", "unit", "quartiles", "repeated", "target", "met", "note")
    table = [
        (
            row.what,
            row.quantity,
            f"{row.value:.6g}",
            row.unit,
            f"{row.spread.lower:.6g} {row.spread.upper:.6g}" if row.spread else "",
            row.spread.count if row.spread else "",
            "" if row.target is None else row.target,
            row.met,
            row.note,
        )
        for row in rows
    ]
    print(f"\nwritten: {write_csv('targets.csv', facts, header, table).name}")
    return int(any(row.met == "NO" for row in rows))


if __name__ == "__main__":
    sys.exit(main())
