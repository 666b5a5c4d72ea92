"""Fenced blocks of a Markdown page, with the marks in the HTML comment above them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

MARKS = {
    "ci": "run by .ci/run itself, in a fresh environment",
    "file": "its name in the folder where the page is run",
    "needs": "module without which the block is left out",
    "not run": "the reason why",
}
_OPENING = re.compile(r"^```(\S*)(?: .*)?$")
_MARK = re.compile(r"^<!-- ([a-z ]+): (.+) -->$")


@dataclass(frozen=True)
class Block:
    """A fenced block: its page, the line of its first line, language, text and marks."""

    page: Path
    line: int
    language: str
    text: str
    marks: Mapping[str, str]

    @property
    def place(self) -> str:
        """Where it is, for messages."""
        return f"{self.page.name}:{self.line}"


def fenced_blocks(page: Path) -> list[Block]:
    """Return the blocks of a page in order; marks stand right above, blank lines aside."""
    return list(_blocks(page, page.read_text(encoding="utf-8").splitlines()))


def _blocks(page: Path, lines: list[str]) -> Iterator[Block]:
    marks: dict[str, str] = {}
    at = 0
    while at < len(lines):
        opening, mark = _OPENING.match(lines[at]), _MARK.match(lines[at])
        if mark and mark[1] in MARKS:
            marks[mark[1]] = mark[2]
        elif opening:
            end = lines.index("```", at + 1)
            text = "".join(f"{line}\n" for line in lines[at + 1 : end])
            yield Block(page, at + 2, opening[1], text, marks)
            marks, at = {}, end
        elif lines[at]:
            marks = {}
        at += 1
