"""Depths against oracles, error against time: ``python bench/depth_accuracy.py``.

PD^t of convex bodies against arithmetic in 50 places; the lower bound of PD^g by pieces against a
bracket by branch and bound; DISP against 50 places and the bounds of D_g against each other.
Writes ``bench/results/depth_accuracy.csv`` and ``depth_accuracy.png``. Exit status 1 if a depth is
off by more than `ALLOWED` roundings or a bound is on the wrong side. ``--quick`` takes 20 seconds.
"""

from __future__ import annotations

import argparse
import sys

from lib.provenance import print_provenance, write_csv
from parts.depth_accuracy import distances, generalized, picture, translational
from parts.depth_accuracy.common import Row, failures, show

SEED = 7


def main() -> int:
    """Measure, print, write, draw."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer bodies, wider brackets")
    arguments = parser.parse_args()
    facts = print_provenance()
    facts["seed"] = str(SEED)
    rows: list[Row] = []
    for part in (
        translational.rows(SEED, 10 if arguments.quick else 60),
        generalized.rows(0.1 if arguments.quick else 0.01, 1.0 if arguments.quick else 30.0),
        distances.rows(SEED, 200 if arguments.quick else 2000),
    ):
        for row in part:
            show(row)
            rows.append(row)
    suffix = "_quick" if arguments.quick else ""
    table = write_csv(f"depth_accuracy{suffix}.csv", facts, Row._fields, rows)
    print(f"\nwritten: {table.name}, {picture.draw(rows, f'depth_accuracy{suffix}.png').name}")
    wrong = failures(rows)
    for row in wrong:
        print(f"WRONG: {row}")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
