"""The second reader, run over generated drawings of every feature of a format.

``python tests/attacks/second_reader/run.py --format svg --count 200 --seed 1``
"""

from __future__ import annotations

import argparse
import contextlib
import random
import re
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # run as a file: the package's own home

from attacks.second_reader.formats import FORMATS, outcomes  # noqa: E402
from attacks.second_reader.model import Outcome, Verdict  # noqa: E402

QUICK = 1  # drawings a feature


def main(arguments: list[str] | None = None) -> int:
    """Run; return 1 if the importer differs silently or crashes anywhere."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--format", choices=(*FORMATS, "all"), default="all")
    parser.add_argument("--count", type=int, default=0, help="drawings; default 4 a feature")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="features whose names hold this")
    parser.add_argument("--quick", action="store_true", help="one drawing a feature")
    parser.add_argument("--keep", type=Path, help="folder for the smallest faulty files")
    parser.add_argument("--no-browser", action="store_true", help="SVG by resvg alone")
    parser.add_argument("--refusals", action="store_true", help="print each refusal once")
    given = parser.parse_args(arguments)
    faults = 0
    for name in FORMATS if given.format == "all" else (given.format,):
        began = time.monotonic()
        features = len(FORMATS[name].features(given.only))
        count = given.count or features * (QUICK if given.quick else 4)
        results = list(
            outcomes(
                name, random.Random(given.seed), count, given.only, browser=not given.no_browser
            )
        )
        faults += _report(name, results, refusals=given.refusals)
        if given.keep:
            _keep(given.keep / name, results)
        print(f"{name}: seed {given.seed}, {count} drawings, {time.monotonic() - began:.1f} s\n")
    return 1 if faults else 0


def _report(name: str, results: list[Outcome], *, refusals: bool) -> int:
    """Print a table by feature; return the number of faults."""
    table: dict[str, Counter[Verdict]] = defaultdict(Counter)
    for outcome in results:
        table[outcome.drawing.feature][outcome.verdict] += 1
    print(f"{name:32}" + "".join(f"{verdict.value:>9}" for verdict in Verdict))
    for feature, counts in table.items():
        print(f"{feature:32}" + "".join(f"{counts[v] or '·':>9}" for v in Verdict))
    total = sum(table.values(), Counter())
    print(f"{'all':32}" + "".join(f"{total[v] or '·':>9}" for v in Verdict))
    for outcome in _smallest(results):
        print(f"\n{outcome.verdict.value}: {outcome.drawing.feature}: {outcome.detail}")
        print("  notes: " + ("; ".join(outcome.notes) or "none"))
    if refusals:
        for feature, why in sorted(
            {(o.drawing.feature, _shape(o.detail)) for o in results if o.verdict is Verdict.REFUSED}
        ):
            print(f"refused: {feature}: {why}")
    return total[Verdict.SILENT] + total[Verdict.CRASHED]


def _shape(message: str) -> str:
    """Return a message without the folder it was in and without numbers."""
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", re.sub(r"/\S*/", "", message))


def _smallest(results: list[Outcome]) -> Iterator[Outcome]:
    """Yield the smallest faulty drawing of each feature and verdict."""
    best: dict[tuple[str, Verdict], Outcome] = {}
    for outcome in results:
        if outcome.verdict in (Verdict.SILENT, Verdict.CRASHED, Verdict.UNTOLD):
            key = (outcome.drawing.feature, outcome.verdict)
            if key not in best or _size(outcome) < _size(best[key]):
                best[key] = outcome
    yield from best.values()


def _size(outcome: Outcome) -> int:
    return sum(map(len, outcome.drawing.files.values()))


def _keep(folder: Path, results: list[Outcome]) -> None:
    for outcome in _smallest(results):
        own = folder / f"{outcome.drawing.feature}-{outcome.verdict.value}"
        own.mkdir(parents=True, exist_ok=True)
        for name, data in outcome.drawing.files.items():
            (own / name).write_bytes(data)
        (own / "why.txt").write_text(
            f"{outcome.detail}\noptions: {dict(outcome.drawing.options)}\n"
            + "".join(f"note: {note}\n" for note in outcome.notes)
        )


if __name__ == "__main__":
    with contextlib.suppress(BrokenPipeError):
        sys.exit(main())
