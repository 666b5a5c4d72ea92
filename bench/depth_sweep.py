"""The experiment of the 2006 paper in the plane: ``python bench/depth_sweep.py``.

[PDG] section 7 moves a hammer, a spoon and a pawn through fixed bodies and computes a lower bound
and two upper bounds of PD^g at 101 interpolated configurations. This does the same with the planar
outlines of ``bench/depth_models.py``, with our bracket of PD^g between them. It prints a table in
the form of the paper's Table 1, and writes ``bench/results/depth_sweep.csv`` (bounds at each
configuration), ``depth_sweep_costs.csv`` (the table) and ``depth_sweep.png`` (as Figures 7 and 11
to 13). Exit status 1 if bounds are out of order. Nothing is random.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Sequence

from lib.provenance import print_provenance, use_one_core, write_csv
from parts.depth_sweep.picture import draw
from parts.depth_sweep.sweep import Cost, Prepared, Sample, broken, cost, samples
from worlds.bodies.paper_models import SAMPLES, models


def main() -> int:
    """Compute, time, print, write, draw."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--samples", type=int, default=SAMPLES, help="configurations a model")
    count: int = parser.parse_args().samples
    use_one_core()
    facts = print_provenance()
    facts["seed"] = "none: nothing is random"
    prepared = [Prepared.of(model) for model in models()]
    found = [sample for model in prepared for sample in samples(model, count)]
    costs = [cost(model, count) for model in prepared]
    show(costs, found)
    suffix = "" if count == SAMPLES else f"_{count}"
    written = [
        write_csv(f"depth_sweep{suffix}.csv", facts, Sample._fields, found),
        write_csv(f"depth_sweep_costs{suffix}.csv", facts, Cost._fields, costs),
        draw([p.model for p in prepared], found, f"depth_sweep{suffix}.png"),
    ]
    print(f"\nwritten: {', '.join(file.name for file in written)}")
    wrong = [(sample, what) for sample in found if (what := broken(sample))]
    for sample, what in wrong:
        print(f"WRONG: {sample.model} at t = {sample.t:.2f}: {what}")
    return int(bool(wrong))


def show(costs: Sequence[Cost], found: Sequence[Sample]) -> None:
    """Print the table: pieces, separators, milliseconds for a query with quartiles, and gaps."""
    columns = "".join(f"{name + ' ms':>27}" for name in ("LB1", "UB1", "UB2", "bracket"))
    print(f"{'':24} {'pieces':>9} {'separators':>10}{columns}")
    for row in costs:
        print(
            f"{row.model:24} {row.pieces_a:4} {row.pieces_b:4} {row.separators:10} "
            f"{spread(row.lb, row.lb_lower, row.lb_upper)} "
            f"{spread(row.ub1, row.ub1_lower, row.ub1_upper)} "
            f"{spread(row.ub2, row.ub2_lower, row.ub2_upper)} "
            f"{spread(row.bracket, row.bracket_lower, row.bracket_upper)}"
        )
    print("\nmedians over the configurations that collide, in units of UB2:")
    for row in costs:
        own = [s for s in found if s.model == row.model and s.lb > 0]
        shares = ", ".join(
            f"{label} {statistics.median(getattr(s, name) / s.ub2 for s in own):.3f}"
            for label, name in (
                ("LB", "lb"),
                ("lo", "lo"),
                ("hi", "hi"),
                ("best", "best"),
                ("UB1", "ub1"),
            )
        )
        print(f"{row.model:24} {shares}  of {len(own)} configurations")


def spread(median: float, lower: float, upper: float) -> str:
    """Return a median with quartiles."""
    return f"{median:8.4g} [{lower:.4g}, {upper:.4g}]".rjust(26)


if __name__ == "__main__":
    sys.exit(main())
