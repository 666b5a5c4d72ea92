"""The grammar of path data (SVG 2, section 9.3.9), checked before a lenient parser takes it."""

from __future__ import annotations

import re

from planar_planner.errors import SceneError, cut
from planar_planner.formats.readers.svg.lengths import NUMBER

_ARGUMENTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_SPACE = r"[ \t\r\n\f]*"
_COMMAND = re.compile(rf"{_SPACE}([MLHVCSQTAZmlhvcsqtaz])")
_FIRST = re.compile(rf"{_SPACE}{NUMBER}", re.ASCII)
_NEXT = re.compile(rf"{_SPACE},?{_SPACE}{NUMBER}", re.ASCII)
_FLAG = re.compile(rf"{_SPACE},?{_SPACE}[01]")
_FLAGS = (3, 4)
"""Which arguments of an arc are flags, which need no separator."""


def check(text: str, place: str) -> None:
    """Check path data.

    Raises
    ------
    SceneError
        If viewers would stop within the text: they draw what stands before an error.
    """
    position = 0
    while match := _COMMAND.match(text, position):
        letter = match[1].upper()
        if position == 0 and letter != "M":
            break
        end, count = _arguments(text, match.end(), letter)
        arity = _ARGUMENTS[letter]
        if count % arity if arity else count:
            break
        if arity and not count:
            break
        position = end
    rest = text[position:].strip(" \t\r\n\f")
    if rest:
        raise SceneError("path data cannot be read", place, cut(rest))


def _arguments(text: str, position: int, letter: str) -> tuple[int, int]:
    """Return where the arguments of a command end, and how many there are."""
    count = 0
    while True:
        flag = letter == "A" and count % _ARGUMENTS["A"] in _FLAGS
        pattern = _FLAG if flag else (_NEXT if count else _FIRST)
        match = pattern.match(text, position)
        if match is None:
            return position, count
        position, count = match.end(), count + 1
