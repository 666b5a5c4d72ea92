"""Lengths with units, in user units; one user unit without viewBox is a CSS pixel, 1/96 inch."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats.readers.svg.style import Value, Values
from planar_planner.formats.reading import coordinate

NUMBER = r"[-+]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][-+]?\d+)?"
SPACE = " \t\r\n\f"
_LENGTH = re.compile(rf"[{SPACE}]*({NUMBER})([a-zA-Z%]*)[{SPACE}]*", re.ASCII)
_FIRST = re.compile(rf"[{SPACE}]*({NUMBER})", re.ASCII)
_NEXT = re.compile(rf"[{SPACE}]*,?[{SPACE}]*({NUMBER})", re.ASCII)
_PIXELS = {  # numerator and denominator, so that whole inches stay exact (CSS Values 4, section 6)
    "": (1.0, 1.0),
    "px": (1.0, 1.0),
    "in": (96.0, 1.0),
    "cm": (96.0, 2.54),
    "mm": (96.0, 25.4),
    "q": (96.0, 101.6),
    "pt": (96.0, 72.0),
    "pc": (16.0, 1.0),
}
_SIZES = ("width", "height", "r", "rx", "ry")
PHYSICAL = ("in", "cm", "mm", "q", "pt", "pc")


@dataclass(frozen=True)
class Size:
    """Width and height of the nearest viewport in its user units; None where not stated."""

    width: float | None
    height: float | None

    @property
    def diagonal(self) -> float | None:
        """The length that percentages of a radius refer to (SVG 2, section 8.9)."""
        if self.width is None or self.height is None:
            return None
        return math.hypot(self.width, self.height) / math.sqrt(2)

    def base(self, name: str) -> float | None:
        """Return the length that percentages of a property refer to."""
        if name in ("x", "cx", "width", "rx", "x1", "x2"):
            return self.width
        if name in ("y", "cy", "height", "ry", "y1", "y2"):
            return self.height
        return self.diagonal


def split(text: str, place: str) -> tuple[float, str]:
    """Return number and unit of a length, the unit in lower case."""
    match = _LENGTH.fullmatch(text)
    if match is None:
        raise SceneError("must be a length", place, shown(cut(text)))
    return coordinate(match[1], place), match[2].lower()


def parsed(value: Value, base: float | None, place: str) -> float:
    """Return a length in user units.

    Raises
    ------
    SceneError
        If it is not a length, or depends on a font, a window or a size that is not stated.
    """
    number, unit = split(value.text, place)
    if unit == "%":
        if base is None:
            raise SceneError("is a share of a size that is not stated", place, cut(value.text))
        return number * base / 100
    if unit not in _PIXELS:
        raise SceneError("has a unit that is not read", place, cut(value.text))
    if not unit and number and value.css:
        raise SceneError("needs a unit in CSS", place, cut(value.text))
    numerator, denominator = _PIXELS[unit]
    return number * numerator / denominator


def stated(values: Values, name: str, size: Size, place: str) -> float | None:
    """Return a geometry property in user units; None if it is ``auto`` or not stated."""
    value = values.get(name)
    if name in ("rx", "ry") and value == Value("auto", css=False):
        raise SceneError("is read differently by viewers", f"{place}, {name}", "auto")
    if value is None or (value.text.lower() == "auto" and name in _SIZES):
        return None
    length = parsed(value, size.base(name), f"{place}, {name}")
    if length < 0 and value.css and name in _SIZES:
        raise SceneError("must not be negative in CSS", f"{place}, {name}", cut(value.text))
    return length


def numbers(text: str, place: str) -> list[float]:
    """Return the numbers of a list; ``10-10.5.5`` are three."""
    return list(_numbers(text, place))


def _numbers(text: str, place: str) -> Iterator[float]:
    position = 0
    while match := (_NEXT if position else _FIRST).match(text, position):
        position = match.end()
        yield coordinate(match[1], place)
    if text[position:].strip(SPACE):
        raise SceneError("must be numbers", place, cut(text[position:].strip(SPACE)))
