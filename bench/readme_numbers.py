"""Put the last measurement of the targets into README.md: ``python bench/readme_numbers.py``.

Times are of the commit that was measured. Cells and answers do not depend on the machine: where
bench/counts.json has the scene they are taken from there, and ``bench/checks`` compares the page.
"""

from __future__ import annotations

import csv
import json
import re

from lib.provenance import RESULTS, ROOT

Cells = dict[tuple[str, str], dict[str, str]]  # (what, quantity) → row
SMALL = ("bug-trap", "piano", "slot", "corner", "comb", "snowflake")
TWINS = {"bug-trap": "bug-trap-closed", "corner": "corner-too-long"}
COUNTED = {  # a row of targets.csv and what bench/counts.json calls it
    "gear": "gear",
    "gear-jammed": "gear-jammed",
    "corner -1e-06 off critical": "corner -1e-06",
    "corner +1e-06 off critical": "corner +1e-06",
    "maze": "maze",
    "maze-blocked": "maze-blocked",
    "field": "field",
}
COUNTED |= {name: name for name in SMALL}
COUNTED |= {twin: twin for twin in (TWINS.get(name, f"{name}-jammed") for name in SMALL)}
SECTION = re.compile(r"(<!-- numbers -->\n).*(<!-- end of numbers -->)", re.DOTALL)


def read() -> tuple[dict[str, str], Cells]:
    """Return the provenance and the rows of the last measurement."""
    lines = (RESULTS / "targets.csv").read_text(encoding="utf-8").splitlines()
    facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    rows = csv.DictReader(line for line in lines if not line.startswith("# "))
    return facts, {(row["what"], row["quantity"]): row for row in rows}


def milliseconds(cells: Cells, what: str) -> float:
    """Return a median of core time."""
    return float(cells[what, "core time"]["value"])


def short(value: float) -> str:
    """Return two significant digits, all of them before the point."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"


def cells_of(cells: Cells, what: str) -> str:
    """Return today's number of cells, or else the one that was measured, which says so."""
    if what in COUNTED:
        counts = json.loads((ROOT / "bench" / "counts.json").read_text(encoding="utf-8"))
        return f"{counts['scenes'][COUNTED[what]]['cells']:,}"
    found = re.search(r"([\d,]+) cells", cells[what, "core time"]["note"])
    return f"{found[1]} at that commit" if found else ""


def line(cells: Cells, name: str, answer: str, what: str) -> str:
    """Return a row of the table: scene, answer, median with quartiles, cells."""
    row = cells[what, "core time"]
    lower, upper = (short(float(value)) for value in row["quartiles"].split())
    time = f"{short(float(row['value']))} ms ({lower}–{upper})"
    return f"| {name} | {answer} | {time} | {cells_of(cells, what)} |"


def table(cells: Cells) -> list[str]:
    """Return the table of scenes."""

    def slowest(names: list[str]) -> str:
        return max(names, key=lambda name: milliseconds(cells, name))

    open_scene = slowest(list(SMALL))
    twin = slowest([TWINS.get(name, f"{name}-jammed") for name in SMALL])
    decision = "gear family, slowest decision"
    count = re.search(r"of (\d+) decisions", cells[decision, "core time"]["note"])
    return [
        "| scene | answer | core time, median (quartiles) | cells |",
        "|---|---|---|---|",
        line(cells, "`gear`", "path", "gear"),
        line(cells, "`gear-jammed`", "no path", "gear-jammed"),
        line(
            cells, "`corner`, 10⁻⁶ below its critical length", "path", "corner -1e-06 off critical"
        ),
        line(cells, "`corner`, 10⁻⁶ above", "no path", "corner +1e-06 off critical"),
        line(
            cells,
            f"gear family bisected to 10⁻⁸, slowest of {count[1] if count else '?'} decisions",
            "both",
            decision,
        ),
        line(cells, f"{', '.join(SMALL)}: slowest, `{open_scene}`", "path", open_scene),
        line(cells, f"their twins: slowest, `{twin}`", "no path", twin),
        line(cells, "`maze`, 20 × 20", "path", "maze"),
        line(cells, "`maze-blocked`", "no path", "maze-blocked"),
        line(cells, "`field`, 2,000 polygons", "path", "field"),
        line(cells, "the same with an annex", "path", "field with annex"),
        line(
            cells,
            "… and 20,000 more polygons in it",
            "path",
            "field with annex, 20,000 far obstacles",
        ),
    ]


def other(cells: Cells) -> str:
    """Return memory and start-up in a sentence each."""
    sentences = []
    own = cells.get(("memory", "beyond constraints"))
    peak = cells.get(("memory", "peak, whole process"))
    if own and peak:
        reached = f"{float(cells['memory', 'cells reached']['value']) / 1e6:.2f} million cells"
        sentences.append(
            f"A query of {reached} peaks at {float(peak['value']):.2f} GiB; a cell takes "
            f"{float(own['value']):.0f} bytes beyond its constraints."
        )
    first = float(cells["check gear, first line", "wall time"]["value"])
    sentences.append(f"`planar-planner check gear` answers {first:.2f} s after it is started.")
    return " ".join(sentences)


def section(facts: dict[str, str], cells: Cells) -> str:
    """Return the section's text; targets that are missed are named."""
    missed = [
        f"{row['what']}, {row['quantity']}: {float(row['value']):.3g} {row['unit']}, "
        f"target {row['target']}"
        for row in cells.values()
        if row["met"] == "NO"
    ]
    paragraphs = [
        "Time in the core on one core: everything after the file has been read and checked. "
        f"Commit {facts['commit']}, {facts['machine']}, {facts['compiler']}, "
        f"{facts['measured']}; `python bench/targets.py` measures them again. "
        "Cells are those of the present program (`bench/counts.json`) unless the row says "
        "otherwise; a path that is found at the first try takes none.",
        "\n".join(table(cells)),
        other(cells),
    ]
    if missed:
        paragraphs.append("Targets missed: " + "; ".join(missed) + ".")
    return "\n\n".join(paragraphs) + "\n"


def main() -> None:
    """Rewrite the section of README.md."""
    readme = ROOT / "README.md"
    text = readme.read_text(encoding="utf-8")
    new, count = SECTION.subn(lambda found: found[1] + section(*read()) + found[2], text)
    if count != 1:
        raise SystemExit("README.md: no section between <!-- numbers --> marks")
    readme.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
