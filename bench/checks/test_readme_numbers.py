"""README.md says what the results file says, and the cells that it counts are today's."""

from __future__ import annotations

import json

import pytest

import readme_numbers
from lib.provenance import ROOT

COUNTS = json.loads((ROOT / "bench" / "counts.json").read_text(encoding="utf-8"))["scenes"]


def test_the_readme_is_what_the_command_writes() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    found = readme_numbers.SECTION.search(text)
    assert found is not None
    written = found[0].removeprefix(found[1]).removesuffix(found[2])
    assert written == readme_numbers.section(*readme_numbers.read()), (
        "python bench/readme_numbers.py writes it"
    )


@pytest.mark.parametrize(
    ("row", "name"),
    [
        ("`gear`", "gear"),
        ("`gear-jammed`", "gear-jammed"),
        ("`corner`, 10⁻⁶ below", "corner -1e-06"),
        ("`corner`, 10⁻⁶ above", "corner +1e-06"),
        ("`maze`, 20", "maze"),
        ("`maze-blocked`", "maze-blocked"),
        ("`field`", "field"),
    ],
)
def test_cells_and_answers_are_those_on_record(row: str, name: str) -> None:
    """Read off the page; bench/counts.py compares the record with the program."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (line,) = (each for each in text.splitlines() if each.startswith(f"| {row}"))
    _, answer, _, cells = (part.strip() for part in line.strip("|").split("|"))
    assert answer.replace(" ", "_") == COUNTS[name]["verdict"]
    assert cells == f"{COUNTS[name]['cells']:,}"
