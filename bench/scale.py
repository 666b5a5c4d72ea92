"""How cells, time and memory grow, with exponents: ``python bench/scale.py [--quick]``.

Against the number of obstacles, the robot's pieces, the size of a maze, the critical clearance,
irrelevant obstacles and repeated queries; and what the inner loop costs. Each point is a process of
its own with a time limit. Times are of the processor. Writes ``scale.csv``, ``scale_fits.csv``,
``scale_repeated.csv``, ``scale_inner_loop.csv`` and ``scale.png`` into ``bench/results/``.
``--quick``: small values, under a minute, nothing is written. ``--only NAME ...``: families whose
names begin so; nothing is written.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from lib.native import build
from lib.provenance import print_provenance, use_one_core, write_csv
from lib.tables import MS, figures
from lib.timing import Spread
from oracles import fits
from parts.scale import point
from parts.scale.families import Family, families
from parts.scale.inner_loop import InnerLoop, inner_loop, print_inner_loops
from parts.scale.picture import draw
from parts.scale.repeated import Repeated, repeated
from planar_planner import load_scene

LIMIT = 120.0  # seconds of a query, by the wall clock
QUICK_LIMIT = 2.0
REPEATED = ("maze", "field", "gear")
INNER = ("gear", "gear-jammed", "maze", "field", "corner-too-long", "snowflake-jammed")
MIB = 2.0**20

Point = dict[str, Any]
Points = list[tuple[float, Point]]
QUANTITIES: dict[str, Callable[[Point], float]] = {
    "labelled": lambda p: float(p["labelled_cells"]),
    "evaluations": lambda p: float(p["separation_evaluations"]),
    "time": lambda p: Spread.of(p["seconds"]).median,
    "memory": lambda p: float(p["memory_bytes"]),
}


def run_family(family: Family, quick: bool) -> Points:
    """Measure a family's values until two in a row are not decided; print a line for each."""
    found: Points = []
    values = family.values[: family.quick] if quick else family.values
    for value in values:
        each = point.measure(family.name, value, QUICK_LIMIT if quick else LIMIT)
        if each["verdict"] in ("path", "no_path") and each["verdict"] != family.expected:
            raise RuntimeError(f"{family.name} at {value:g}: {each['verdict']}")
        found.append((value, each))
        print_point(family, value, each)
        if len(found) > 1 and all(p["verdict"] != family.expected for _, p in found[-2:]):
            break
    return found


def print_point(family: Family, value: float, each: Point) -> None:
    """Print one line of the table."""
    start = f"{family.name:<18} {value:>13,g} {family.parameter:<22} {each['verdict']:<10}"
    if "seconds" not in each:
        print(start, each["reason"], flush=True)
        return
    time = Spread.of(each["seconds"])
    print(
        f"{start} {each['cells']:>9,} cells {each['labelled_cells']:>10,} labelled "
        f"{1e3 * time.median:>10,.2f} ms ({1e3 * time.lower:,.2f} to {1e3 * time.upper:,.2f}, "
        f"{time.count}) {each['memory_bytes'] / MIB:>8,.2f} MiB, "
        f"loading {1e3 * each['loading']:,.0f} ms",
        flush=True,
    )


def fitted(family: Family, points: Points) -> list[tuple[str, str, str, fits.Fit]]:
    """Return family, quantity, kind and fit; of decided points only."""
    decided = [(x, p) for x, p in points if p["verdict"] == family.expected]
    xs = [x for x, _ in decided]
    found = []
    for name, quantity in QUANTITIES.items():
        ys = [quantity(p) for _, p in decided]
        kinds = {"exponent": fits.exponent(xs, ys)}
        if family.logarithmic:
            kinds["per decade"] = fits.per_decade(xs, ys)
        found += [(family.name, name, kind, fit) for kind, fit in kinds.items() if fit]
    return found


def print_fits(rows: Sequence[tuple[str, str, str, fits.Fit]]) -> None:
    """Print a line for each fit."""
    print("\nGrowth: median slope of all pairs of points [quartiles]")
    for family, quantity, kind, fit in rows:
        scale = 1e3 if (quantity, kind) == ("time", "per decade") else 1.0
        unit = {"exponent": "", "per decade": " ms" if quantity == "time" else ""}[kind]
        shown = fits.Fit(scale * fit.slope, scale * fit.lower, scale * fit.upper, fit.points)
        print(f"{family:<18} {quantity:<12} {kind:<11} {shown}{unit} ({fit.points} points)")


def print_repeated(found: Repeated) -> None:
    """Print one line."""
    first, gain = found.kept[0], found.gain
    late = Spread.of(found.kept[len(found.kept) // 2 :])
    print(
        f"{found.scene:<18} {len(found.kept)} queries: first {1e3 * first:.2f} ms, later ones "
        f"{1e3 * late.median:.2f} ms ({1e3 * late.lower:.2f} to {1e3 * late.upper:.2f}); fresh "
        f"planners take {gain.median:.1f}x ({gain.lower:.1f} to {gain.upper:.1f}); "
        f"{found.cells[0]:,} to {found.cells[-1]:,} cells",
        flush=True,
    )


def write(
    facts: dict[str, str],
    all_points: Mapping[str, Points],
    rows: Sequence[tuple[str, str, str, fits.Fit]],
    repeats: Sequence[Repeated],
    inner: Sequence[InnerLoop],
) -> None:
    """Write tables and picture."""
    keys = ("cells", "labelled_cells", "separation_evaluations", "memory_bytes", "peak_bytes")
    table = []
    for name, points in all_points.items():
        for value, p in points:
            time = Spread.of(p["seconds"]) if "seconds" in p else None
            loading = f"{MS * p['loading']:.4g}" if time else ""
            clocks = (*figures(time), time.count, loading) if time else ("", "", "", 0, "")
            table.append((name, f"{value:g}", p["verdict"], *(p.get(k, "") for k in keys), *clocks))
    header = ("family", "value", "verdict", *keys, "ms", "lower", "upper", "count", "loading_ms")
    write_csv("scale.csv", facts, header, table)
    write_csv(
        "scale_fits.csv",
        facts,
        ("family", "quantity", "kind", "slope", "lower", "upper", "points"),
        [
            (*row[:3], *(f"{v:.4g}" for v in (fit.slope, fit.lower, fit.upper)), fit.points)
            for *row, fit in rows
        ],
    )
    write_csv(
        "scale_repeated.csv",
        facts,
        ("scene", "query", "kept_ms", "fresh_ms", "cells"),
        [
            (r.scene, k + 1, f"{1e3 * kept:.4g}", f"{1e3 * fresh:.4g}", cells)
            for r in repeats
            for k, (kept, fresh, cells) in enumerate(zip(r.kept, r.fresh, r.cells, strict=True))
        ],
    )
    write_csv(
        "scale_inner_loop.csv",
        facts,
        ("scene", "cells", "evaluations_per_cell", "ns", "lower", "upper", "instructions"),
        [
            (
                *(i.scene, i.cells, f"{i.evaluations:.3f}"),
                *figures(i.ns, 1.0, ".1f"),
                "" if i.instructions is None else f"{i.instructions:.0f}",
            )
            for i in inner
        ],
    )
    draw(all_points, repeats, "scale.png")
    print(
        "\nwritten: scale.csv, scale_fits.csv, scale_repeated.csv, scale_inner_loop.csv, scale.png"
    )


def main() -> int:
    """Measure, fit and write."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="a minute, nothing written")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="families that begin so")
    arguments = parser.parse_args()
    quick, only = arguments.quick, tuple(arguments.only or ())
    facts = print_provenance()
    use_one_core()
    chosen = [f for f in families() if not only or f.name.startswith(only)]
    found = {family.name: run_family(family, quick) for family in chosen}
    rows = [row for family in chosen for row in fitted(family, found[family.name])]
    print_fits(rows)
    if only:
        return 0
    print("\nRepeated queries between random free configurations")
    repeats = []
    for name in REPEATED[1:] if quick else REPEATED:
        repeats.append(repeated(load_scene(name), 6 if quick else 60))
        print_repeated(repeats[-1])
    print("\nInner loop: labelling the cells of a search, for each separating-axis function")
    program = build("culling")
    inner = [
        inner_loop(program, name, 3 if quick else 9, not quick)
        for name in (INNER[:1] if quick else INNER)
    ]
    print_inner_loops(inner)
    if not quick:
        write(facts, found, rows, repeats, inner)
    return 0


if __name__ == "__main__":
    sys.exit(main())
