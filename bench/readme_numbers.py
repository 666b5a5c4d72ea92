"""Put the last measurement of the targets into README.md: ``python bench/readme_numbers.py``."""

from __future__ import annotations

import csv
import re

from lib.provenance import RESULTS, ROOT

Cells = dict[tuple[str, str], dict[str, str]]  # (what, quantity) → row
SMALL = ("bug-trap", "piano", "slot", "corner", "comb", "snowflake")
TWINS = {"bug-trap": "bug-trap-closed", "corner": "corner-too-long"}
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


def line(cells: Cells, name: str, answer: str, what: str) -> str:
    """Return a row of the table: scene, answer, median with quartiles, cells."""
    row = cells[what, "core time"]
    lower, upper = (short(float(value)) for value in row["quartiles"].split())
    found = re.search(r"([\d,]+) cells", row["note"])
    time = f"{short(float(row['value']))} ms ({lower}–{upper})"
    return f"| {name} | {answer} | {time} | {found[1] if found else ''} |"


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
        f"{facts['measured']}; `python bench/targets.py` measures them again.",
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
