"""Time and cells against the distance from the critical parameter: ``python bench/families.py``.

Two families, both verdicts: the rectangle round a corner, whose critical length has a formula, and
the gear between gears, whose critical gap is bisected first. Writes ``bench/results/families.csv``
and ``families.png``. Undecided queries are measured too; at the default resolution they begin
where the distance comes near it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from matplotlib.axes import Axes

from lib.bisection import bisect
from lib.pictures import GREY, VERDICT_COLOURS, finish, new_panels, save
from lib.provenance import print_provenance, use_one_core, write_csv
from lib.tables import MS, figures
from lib.timing import Measured, measure
from planar_planner import Options
from scenarios import corner, gear
from scenarios.model import Scene

GEAR_BRACKET = 1e-10
FINE = Options(resolution=1e-13)  # for that bracket; what is shown is at the default
STYLES = {"corner": "o-", "gear": "s--"}


@dataclass(frozen=True)
class Point:
    """One query: `distance` from critical, on the side where `expected` is the true answer."""

    family: str
    expected: str
    distance: float
    measured: Measured

    @property
    def verdict(self) -> str:
        """What the planner said."""
        return self.measured.result.verdict


def sweep(
    family: str,
    make: Callable[[float], Scene],
    critical: float,
    passing: int,
    exponents: list[float],
) -> Iterator[Point]:
    """Measure at ``critical ± 10**-k``; `passing` is the sign of the side that has a path."""
    for expected, sign in (("path", passing), ("no_path", -passing)):
        for exponent in exponents:
            distance = 10.0**-exponent
            measured = measure(make(critical + sign * distance), most=15)
            if measured.result.verdict not in (expected, "undecided"):
                raise RuntimeError(
                    f"{family} at {sign * distance:+g} of critical: {measured.result.verdict}"
                )
            yield Point(family, expected, distance, measured)


def halves(first: int, last: int) -> list[float]:
    """Return exponents in steps of a half."""
    return [0.5 * k for k in range(2 * first, 2 * last + 1)]


def draw(axes: Axes, points: list[Point], quantity: Callable[[Point], float], label: str) -> None:
    """Draw one quantity of all families against the distance."""
    for family, style in STYLES.items():
        for verdict, colour in VERDICT_COLOURS.items():
            chosen = [p for p in points if p.family == family and p.verdict == verdict]
            axes.loglog(
                [p.distance for p in chosen],
                [quantity(p) for p in chosen],
                style,
                color=colour,
                markersize=4,
                label=f"{family}, {verdict.replace('_', ' ')}",
            )
    undecided = [p for p in points if p.verdict == "undecided"]
    if undecided:
        axes.loglog(
            [p.distance for p in undecided],
            [quantity(p) for p in undecided],
            "x",
            color=GREY,
            label="undecided",
        )
    axes.set_xlabel("distance from the critical parameter")
    axes.set_ylabel(label)
    axes.invert_xaxis()
    finish(axes)


def main() -> None:
    """Measure, write the table, draw the picture."""
    facts = print_provenance()
    use_one_core()
    found = bisect(
        gear.gear, gear.JAMMED_GAP, gear.PATH_GAP, GEAR_BRACKET, repetitions=1, options=FINE
    )
    gear_critical = 0.5 * (found.blocked + found.passing)
    facts["gear"] = f"critical gap in [{found.blocked:.12f}, {found.passing:.12f}], middle taken"
    corner_critical = corner.critical_length(corner.DEFAULT_WIDTH)
    points = [
        *sweep("corner", corner.corner, corner_critical, -1, halves(1, 11)),
        *sweep("gear", gear.gear, gear_critical, +1, halves(2, 9)),
    ]
    header = ("family", "expected", "distance", "verdict", "cells", "ms", "lower", "upper", "count")
    rows = [
        (
            p.family,
            p.expected,
            f"{p.distance:.3e}",
            p.verdict,
            p.measured.cells,
            *figures(core),
            core.count,
        )
        for p in points
        for core in [p.measured.core]
    ]
    for row in rows:
        print("{:8} {:8} {:>10} {:10} {:>8,} {:>9} ms".format(*row[:6]))
    file = write_csv("families.csv", facts, header, rows)

    figure, (left, right) = new_panels(1, 2, 10, 4.2)
    draw(left, points, lambda p: p.measured.cells, "cells")
    draw(right, points, lambda p: MS * p.measured.core.median, "core time (ms)")
    left.legend(frameon=False, fontsize=8)
    picture = save(figure, "families.png")
    print(f"\nwritten: {file.name}, {picture.name}")


if __name__ == "__main__":
    main()
