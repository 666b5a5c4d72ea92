"""Margins of all shipped scenes, and what re-use spares: ``python bench/margins.py``.

Each scene is bracketed twice, with and without re-use of paths (their clearance, and their
certification for the next body). Writes ``bench/results/margins.csv``.
"""

from __future__ import annotations

from provenance import print_provenance, use_one_core, write_csv
from shipped import with_point_goals

from lib.provenance import print_provenance, use_one_core, write_csv
from planar_planner import Margin, Options, load_scene, margin
from planar_planner.margins.find import Asked, bracketed
from planar_planner.problem.make import make_problem
from worlds.shipped import with_point_goals

HEADER = (
    "scene",
    "lower",
    "upper",
    "width",
    "binding",
    "reason",
    "queries",
    "recertified",
    "cells",
    "seconds",
    "queries without",
    "cells without",
    "seconds without",
)


def row(scene: str, found: Margin, without: Margin) -> tuple[object, ...]:
    """Return one line of the table."""
    return (
        scene,
        f"{found.lower:.6g}",
        f"{found.upper:.6g}",
        f"{found.width:.3g}",
        found.binding,
        found.reason,
        found.counts["queries"],
        found.counts["recertified"],
        found.counts["cells"],
        f"{found.seconds:.2f}",
        without.counts["queries"],
        without.counts["cells"],
        f"{without.seconds:.2f}",
    )


def main() -> None:
    """Bracket every scene, print and write the table."""
    facts = print_provenance()
    use_one_core()
    rows = []
    for scene in with_point_goals():
        found, without = (
            margin(scene),
            bracketed(make_problem(load_scene(scene)), Options(), Asked(reuse=False)),
        )
        rows.append(row(scene, found, without))
        print(
            "{:17} [{:>10}, {:>10}] {:8} {:>3} {:>3} {:>7} {:>6} | {:>3} {:>7} {:>6}".format(
                *rows[-1][:3], rows[-1][4], *rows[-1][6:]
            ),
            flush=True,
        )
    print(f"\nwritten: {write_csv('margins.csv', facts, HEADER, rows).name}")


if __name__ == "__main__":
    main()
