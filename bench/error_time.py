"""Run time against error: ``python bench/error_time.py``.

Families of scenes with a critical parameter that is known exactly. The *error* of a planner within
a time is the half-width of the band of parameters, relative to the critical one, that it does not
decide rightly in that time; of a sampler, which cannot say no, the smallest gap that it passes.
Measured for our planner, for ours without each of its parts, and for OMPL's planners if OMPL is
installed. Writes ``bench/results/error_time*.csv`` and pictures; exit status 1 if ours misses an
error of 1e-9 within 50 ms on a family that has a formula, 2 if a verdict is wrong.

Times are the processor's, medians with quartiles; those by the wall clock are in the table too.
``--quick`` takes under a minute and writes files of its own.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import sys
from collections.abc import Iterator, Sequence

from lib.provenance import print_provenance, write_csv
from lib.tables import show
from parts.error_time import bracketing, pictures, tables, truths
from parts.error_time.sampling import sweep_sampler
from parts.error_time.sweep import OURS, PARTS, Effort, Point, WrongVerdictError, sweep
from planar_planner.ompl.compare import Settings
from planar_planner.ompl.samplers import DEFAULT_SAMPLERS
from worlds.critical import Family

DISTANCES = [10.0 ** (-0.5 * k) for k in range(2, 25)]
DECADES = DISTANCES[::2]
SPARSE = [1e-1, 1e-3, 1e-6, 1e-9]
QUICK_FAMILIES = ("corner", "rectangle, slot", "triangle, corridor")
QUICK_PARTS = (OURS, "no joint test", "as published")


def main() -> int:
    """Measure, print, write, draw."""
    arguments = parsed()
    facts = print_provenance()
    facts["load"] = f"{os.getloadavg()[0]:.1f} processes wanted to run when it began"
    samplers = list_of_samplers(arguments)
    if samplers:
        from importlib.metadata import version

        facts["versions"] += f", ompl {version('ompl')}"
        facts["seeds"] = f"1 to {arguments.runs} of each sampler, limit {arguments.limit:g} s"
    chosen = list(families(arguments, facts))
    points: list[Point] = []
    try:
        for point in measurements(chosen, samplers, arguments):
            points.append(point)
            report(point)
    except WrongVerdictError as error:
        print(f"WRONG VERDICT: {error}")
        return 2
    laws = list(tables.rows_of_laws(points))
    errors = list(tables.rows_of_errors(points))
    show("Ours: cells and time near the critical parameter", tables.LAWS_HEADER, laws)
    show("Error at a time", tables.ERRORS_HEADER, errors)
    if arguments.family:
        print("\nnot all families: nothing is written")
    else:
        write("_quick" if arguments.quick else "", points, laws, errors, facts)
    known = {truth.name for truth in chosen if truth.name not in truths.NOT_HELD_TO_THE_GOAL}
    return int(any(row[0] in known and row[-1] == "MISSED" for row in laws))


def write(
    suffix: str,
    points: Sequence[Point],
    laws: Sequence[Sequence[str]],
    errors: Sequence[Sequence[str]],
    facts: dict[str, str],
) -> None:
    """Write tables and pictures."""
    rows = list(tables.rows_of_points(points))
    planners = tables.names(points, "planner")
    parts = [planner for planner in planners if planner in PARTS and planner != OURS]
    samplers = [planner for planner in planners if planner not in PARTS]
    files = [
        write_csv(f"error_time{suffix}.csv", facts, tables.POINTS_HEADER, rows),
        write_csv(f"error_time_laws{suffix}.csv", facts, tables.LAWS_HEADER, laws),
        write_csv(f"error_time_errors{suffix}.csv", facts, tables.ERRORS_HEADER, errors),
        pictures.error_picture(points, samplers, f"error_time{suffix}.png"),
        pictures.cells_picture(points, f"error_time_cells{suffix}.png"),
        pictures.error_picture(points, parts, f"error_time_parts{suffix}.png"),
    ]
    print("\nwritten:", ", ".join(file.name for file in files))


def parsed() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="three families, few distances")
    parser.add_argument("--family", action="append", help="only this one (repeatable); print only")
    parser.add_argument("--no-parts", action="store_true", help="do not leave parts out")
    parser.add_argument(
        "--samplers",
        help="OMPL's planners, comma-separated; 'none'; default: "
        f"{','.join(DEFAULT_SAMPLERS)} if OMPL is installed",
    )
    parser.add_argument("--runs", type=int, help="of each sampler at each distance (5)")
    parser.add_argument("--limit", type=float, help="seconds for each run of a sampler (5)")
    arguments = parser.parse_args()
    arguments.runs = arguments.runs or (2 if arguments.quick else 5)
    arguments.limit = arguments.limit or (1.0 if arguments.quick else 5.0)
    return arguments


def list_of_samplers(arguments: argparse.Namespace) -> list[str]:
    """Return the samplers to run; none if OMPL is not installed and none was asked for."""
    if arguments.samplers == "none":
        return []
    if arguments.samplers:
        return list(Settings(tuple(arguments.samplers.split(","))).planners)
    if importlib.util.find_spec("ompl") is None:
        print("OMPL is not installed: ours only\n")
        return []
    return list(DEFAULT_SAMPLERS[:1] if arguments.quick else DEFAULT_SAMPLERS)


def families(arguments: argparse.Namespace, facts: dict[str, str]) -> Iterator[Family]:
    """Yield those asked for; the gears are bracketed first."""
    wanted = arguments.family or (QUICK_FAMILIES if arguments.quick else None)
    for truth in (*truths.with_formula(), *truths.harder()):
        if wanted is None or truth.name in wanted:
            yield truth
    if wanted is None or bracketing.NAME in wanted:
        gears = bracketing.gears()
        facts["gears"] = f"critical gap in [{float(gears.no_path_at)!r}, {float(gears.path_at)!r}]"
        print(f"gears: {facts['gears']}, both certificates checked\n")
        yield gears


def measurements(
    chosen: Sequence[Family], samplers: Sequence[str], arguments: argparse.Namespace
) -> Iterator[Point]:
    """Yield ours, ours without parts, samplers, family by family."""
    ours = Effort(limit=5.0)
    variant = Effort(limit=1.0 if arguments.quick else 2.0, budget=0.1, most=5)
    settings = Settings(tuple(samplers) or DEFAULT_SAMPLERS, arguments.runs, arguments.limit)
    parts = QUICK_PARTS if arguments.quick else tuple(PARTS)
    for truth in chosen:
        for name in parts:
            if name == OURS:
                yield from sweep(truth, name, SPARSE if arguments.quick else DISTANCES, ours)
            elif not arguments.no_parts:
                yield from sweep(truth, name, SPARSE if arguments.quick else DECADES, variant)
        for sampler in samplers:
            distances = DECADES[:2] if arguments.quick else DISTANCES
            yield from sweep_sampler(truth, sampler, distances, settings)


def report(point: Point) -> None:
    """Print one point."""
    print(
        f"{point.family:20} {point.planner:20} {point.side:8} {point.distance:8.1e} "
        f"{100 * point.decided:4.0f} % {1e3 * point.seconds.median:10.4g} ms "
        f"{point.count:9,.0f} {point.note}",
        flush=True,
    )


if __name__ == "__main__":
    sys.exit(main())
