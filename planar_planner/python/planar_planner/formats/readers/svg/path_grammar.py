"""The grammar of path data (SVG 2, section 9.3.9), checked before a lenient parser takes it."""

from __future__ import annotations

import re
from collections.abc import Iterator

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


def without_empty_arcs(text: str) -> str:
    """Return checked path data whose arcs from a point to itself are lines without length.

    Viewers leave such arcs out (SVG 2, section 9.5.1); the parser refuses them.
    """
    if "a" not in text.lower():
        return text
    x = y = begin_x = begin_y = 0.0
    written: list[str] = []
    for letter, words in _commands(text):
        kind = letter.upper()
        arity = _ARGUMENTS[kind]
        if kind == "Z":
            x, y = begin_x, begin_y
            written.append(letter)
        for k in range(0, len(words), arity or 1):
            own = words[k : k + arity]
            from_x, from_y = (0.0, 0.0) if letter.isupper() else (x, y)
            before = x, y
            if kind != "V":
                x = from_x + float(own[-1 if kind == "H" else -2])
            if kind != "H":
                y = from_y + float(own[-1])
            if kind == "M" and k == 0:
                begin_x, begin_y = x, y
            if kind == "A" and (x, y) == before:
                written.append("l0 0")
            elif kind == "M" and k > 0:
                written.append(("L" if letter == "M" else "l") + " ".join(own))
            else:
                written.append(letter + " ".join(own))
    return " ".join(written)


def _commands(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yield each command's letter and its arguments."""
    position = 0
    while match := _COMMAND.match(text, position):
        letter, position = match[1], match.end()
        words: list[str] = []
        while True:
            flag = letter in "Aa" and len(words) % _ARGUMENTS["A"] in _FLAGS
            pattern = _FLAG if flag else (_NEXT if words else _FIRST)
            found = pattern.match(text, position)
            if found is None:
                break
            words.append(found[0].strip(" \t\r\n\f,"))
            position = found.end()
        yield letter, words
