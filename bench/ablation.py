"""The paper's Table 2, and what each part is worth: ``python bench/ablation.py [--quick]``.

For every shipped scene: the cell culling ratio of each C-obstacle query and what a query costs; the
published method without and with a query; the planner without each of its parts. Builds
``bench/native/culling`` first (needs cmake and a C++20 compiler; valgrind counts instructions where
it is installed). Writes ``culling.csv``, ``table2.csv``, ``ablation.csv`` and ``ablation.png`` into
``bench/results/``. ``--quick``: three scenes, small limits, under a minute, nothing is written.
"""

from __future__ import annotations

import argparse
import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from lib.native import build
from lib.provenance import print_provenance, use_one_core, write_csv
from lib.tables import figures
from parts.ablation.culling import DRIVER, QUERIES, Culling, culling
from parts.ablation.picture import draw
from parts.ablation.variants import ABLATIONS, TABLE_2, Outcome, Variant, outcome
from planar_planner import Options, load_scene
from planar_planner.problem.make import make_problem
from planar_planner.scene.builtin import manifest
from worlds.shipped import with_point_goals

GEAR = "gear"
PUBLISHED = (
    "published (Pentium, their gear): 75.21 %, 0.12 ms, 261.4 s, 110.4 s, 2.4x, 13.3 s in queries"
)


@dataclass(frozen=True)
class Settings:
    """How much to do: scenes, cells of a walk, seconds a query may take and may be repeated."""

    scenes: tuple[str, ...]
    cells: int
    gear_cells: int
    limit: float
    gear_limit: float
    budget: float
    repeats: int
    count: bool


def settings(quick: bool) -> Settings:
    """Return the settings of a full or a quick run."""
    if quick:
        return Settings(("gear", "slot-jammed", "corner"), 4_000, 15_000, 1.0, 1.0, 0.02, 1, False)
    return Settings(tuple(with_point_goals()), 20_000, 400_000, 5.0, 120.0, 0.3, 5, True)


def cullings_of(program: Path, scene: str, how: Settings) -> list[Culling]:
    """Measure one scene: the published method's cells, and those of our own search."""
    cells = how.gear_cells if scene == GEAR else how.cells
    drivers = (DRIVER, "displacement", "per_normal_joint") if scene == GEAR else (DRIVER,)

    def counts(driver: str) -> bool:
        return how.count and scene == GEAR and driver == DRIVER

    found = [
        culling(
            program, scene, cells=cells, repeats=how.repeats, driver=driver, count=counts(driver)
        )
        for driver in drivers
    ]
    return [*found, culling(program, scene, cells=0, repeats=how.repeats, driver=None)]


def print_culling(found: Culling) -> None:
    """Print a line for the cells and one for each query."""
    print(
        f"{found.scene}, {found.walk}: {found.cells:,} cells, {found.obstacle:,} in C-obstacle, "
        f"{found.undecided:,} undecided; per normal misses by cause (sample): "
        + ", ".join(f"{name} {number}" for name, number in found.misses.items())
    )
    for query, label in QUERIES.items():
        ratio, cost = found.ratio(query), found.costs[query]
        shown = "       -" if ratio is None else f"{100 * ratio:7.2f}%"
        counted = "" if cost.instructions is None else f"{cost.instructions:10,.0f} instructions"
        print(
            f"  {label:<32}{shown} {cost.ns.median:9,.0f} ns "
            f"({cost.ns.lower:,.0f} to {cost.ns.upper:,.0f}) {counted}",
            flush=True,
        )


def outcomes_of(
    scene: str, variants: Sequence[Variant], how: Settings, limit: float
) -> list[Outcome]:
    """Ask every variant the scene's query; wrong verdicts are an error, not a measurement."""
    problem = make_problem(load_scene(scene))
    expected = manifest()[scene]["expected"]
    limits = Options(timeout=limit)
    found = []
    for variant in variants:
        each = outcome(problem, variant, limits, how.budget)
        if each.decided and each.verdict != expected:
            raise RuntimeError(f"{scene}, {variant.name}: {each.verdict}, expected {expected}")
        found.append(each)
    return found


def print_outcomes(scene: str, outcomes: Sequence[Outcome]) -> None:
    """Print a line for each variant."""
    first = outcomes[0]
    for each in outcomes:
        # A limit is a lower bound of the time; a ratio of two of them would say nothing.
        ratio = each.seconds.median / first.seconds.median
        bound = (
            (">" if not each.decided else "") if first.decided else ("<" if each.decided else "")
        )
        known = each is not first and (first.decided or each.decided)
        print(
            f"{scene:<18} {each.variant.name:<26} {each.verdict:<10} "
            f"{each.stats.cells:>10,} cells {each.stats.labelled_cells:>11,} labelled "
            f"{1e3 * each.seconds.median:>11,.2f} ms "
            f"{1e3 * each.stats.seconds.labelling:>10,.2f} ms labelling "
            + (f"{bound}{ratio:.3g}x" if known else ""),
            flush=True,
        )


def summary(outcomes: dict[str, list[Outcome]]) -> None:
    """Print geometric means over the scenes that the variant decides too, and how many it loses."""
    print(f"\n{'without a part':<26} {'labelled':>9} {'time':>7}  undecided   (geometric means)")
    for place, variant in enumerate(ABLATIONS):
        pairs = [(scene[0], scene[place]) for scene in outcomes.values() if scene[0].decided]
        both = [(whole, part) for whole, part in pairs if part.decided]
        cells = [part.work / whole.work for whole, part in both if whole.work > 0]
        times = [part.seconds.median / whole.seconds.median for whole, part in both]
        print(
            f"{variant.name:<26} {_mean(cells):>8.2f}x {_mean(times):>6.2f}x "
            f"{len(pairs) - len(both):>6} of {len(pairs)}"
        )


def _mean(ratios: Sequence[float]) -> float:
    return math.exp(statistics.fmean(math.log(ratio) for ratio in ratios)) if ratios else math.nan


CULLING_HEADER = (
    *("scene", "walk", "cells", "obstacle", "undecided", "query", "culled", "ratio"),
    *("ns", "ns_lower", "ns_upper", "count", "evaluations", "instructions"),
)
OUTCOME_HEADER = (
    *("scene", "variant", "verdict", "cells", "labelled", "evaluations", "rounds", "expansions"),
    *("ms", "lower", "upper", "count", "labelling_ms", "search_ms", "memory_bytes"),
)


def culling_rows(found: Culling) -> list[tuple[object, ...]]:
    """Return the rows of the table."""
    rows: list[tuple[object, ...]] = []
    for query, cost in found.costs.items():
        ratio = found.ratio(query)
        rows.append(
            (
                *(found.scene, found.walk, found.cells, found.obstacle, found.undecided),
                *(query, found.culled[query], "" if ratio is None else f"{ratio:.4f}"),
                *figures(cost.ns, 1.0, ".0f"),
                *(cost.ns.count, f"{cost.evaluations:.2f}"),
                "" if cost.instructions is None else f"{cost.instructions:.0f}",
            )
        )
    return rows


def outcome_row(scene: str, each: Outcome) -> tuple[object, ...]:
    """Return one row of the table."""
    stats, seconds = each.stats, each.seconds
    return (
        *(scene, each.variant.name, each.verdict, stats.cells, stats.labelled_cells),
        *(stats.separation_evaluations, stats.search_rounds, stats.search_expansions),
        *figures(seconds),
        seconds.count,
        *(f"{1e3 * getattr(stats.seconds, clock):.4g}" for clock in ("labelling", "search")),
        stats.memory_bytes,
    )


def main() -> None:
    """Measure and write."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="a minute, nothing written")
    quick = parser.parse_args().quick
    how = settings(quick)
    facts = print_provenance()
    use_one_core()
    program = build("culling")

    print(f"Cell culling ratio, time a query. {PUBLISHED}\n")
    cullings: list[Culling] = []
    for scene in how.scenes:
        for found in cullings_of(program, scene, how):
            print_culling(found)
            cullings.append(found)

    print("\nThe published method on our core, and ours\n")
    table_2: dict[str, list[Outcome]] = {}
    for scene in how.scenes:
        limit = how.gear_limit if scene == GEAR else how.limit
        table_2[scene] = outcomes_of(scene, TABLE_2, how, limit)
        print_outcomes(scene, table_2[scene])

    print("\nThe planner without a part\n")
    ablations: dict[str, list[Outcome]] = {}
    for scene in how.scenes:
        ablations[scene] = outcomes_of(scene, ABLATIONS, how, how.limit)
        print_outcomes(scene, ablations[scene])
    summary(ablations)
    if quick:
        return

    rows = [row for found in cullings for row in culling_rows(found)]
    write_csv("culling.csv", facts, CULLING_HEADER, rows)
    for name, table in (("table2.csv", table_2), ("ablation.csv", ablations)):
        each_row = [outcome_row(scene, each) for scene, all_ in table.items() for each in all_]
        write_csv(name, facts, OUTCOME_HEADER, each_row)
    draw([c for c in cullings if c.walk.endswith(DRIVER)], ablations, "ablation.png")
    print("\nwritten: culling.csv, table2.csv, ablation.csv, ablation.png")


if __name__ == "__main__":
    main()
