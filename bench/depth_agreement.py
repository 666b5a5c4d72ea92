"""PD^t of convex pairs against its oracles: ``python bench/depth_agreement.py``.

100,000 random and degenerate pairs, in eight families. The deviation from exact integer arithmetic
is relative to the depth (or distance) itself, of the vertices as placed in doubles; that from
shapely, SciPy's hull and pymunk is relative to the pair's extent, since they round coordinates.
Writes ``bench/results/depth_agreement.csv``. Exit status 1 if anything is off by more than 1e-12,
or a state is wrong. ``--quick`` takes a fiftieth of the pairs.
"""

from __future__ import annotations

import argparse
import sys
import time
from importlib.metadata import version

from lib.provenance import print_provenance, write_csv
from support.depth_agreement import ALLOWED, Deviation, failures, measure
from worlds.bodies.convex_pairs import FAMILIES

SEED = 11
PAIRS = 100_000


def main() -> int:
    """Compare, print, write."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="a fiftieth of the pairs")
    parser.add_argument("--seed", type=int, default=SEED)
    arguments = parser.parse_args()
    facts = print_provenance()
    facts["seed"] = str(arguments.seed)
    facts["oracles"] = ", ".join(
        f"{name} {version(name)}" for name in ("shapely", "scipy", "pymunk")
    )
    for key in ("seed", "oracles"):
        print(f"{key + ':':10} {facts[key]}")
    each = PAIRS // len(FAMILIES) // (50 if arguments.quick else 1)
    print(f"\n{'family':22}" + "".join(f"{name:>10}" for name in Deviation._fields[1:]))
    rows: list[Deviation] = []
    for family in FAMILIES:
        began = time.perf_counter()
        row = measure(family, arguments.seed, each)
        rows.append(row)
        cells = [f"{v:10}" if isinstance(v, int) else f"{v:10.1e}" for v in row[1:]]
        print(f"{family:22}{''.join(cells)}   {time.perf_counter() - began:.0f} s", flush=True)
    total = sum(row.pairs for row in rows)
    print(f"\n{total} pairs, largest deviation {max(row.exact for row in rows):.1e} of the depth")
    suffix = "_quick" if arguments.quick else ""
    print(
        f"written: {write_csv(f'depth_agreement{suffix}.csv', facts, Deviation._fields, rows).name}"
    )
    wrong = [(row.family, failures(row)) for row in rows if failures(row)]
    for family, what in wrong:
        print(f"WRONG (beyond {ALLOWED:g}): {family}: {', '.join(what)}")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
