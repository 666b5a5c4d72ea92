"""Transforms of attributes and of CSS as matrices, y downwards."""

from __future__ import annotations

import math
import re
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.outlines.curves import Affine
from planar_planner.formats.readers.svg.lengths import Size, numbers, parsed, split
from planar_planner.formats.readers.svg.style import Value, Values, word_of
from planar_planner.formats.reading import require

IDENTITY: Affine = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
_FUNCTION = re.compile(
    r"\s*([A-Za-z][A-Za-z0-9]*)\s*\(([^()]*)\)\s*(?:,(?=\s*[A-Za-z]))?", re.ASCII
)
_COUNTS = {
    "matrix": (6,),
    "translate": (1, 2),
    "scale": (1, 2),
    "rotate": (1, 3),
    "skewX": (1,),
    "skewY": (1,),
}
_DEGREES = {"deg": 1.0, "grad": 0.9, "turn": 360.0}
_SIDES = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}


def product(m: Affine, n: Affine) -> Affine:
    """Return the transform that applies n, then m."""
    a, b, c, d, e, f = m
    p, q, r, s, t, u = n
    return (
        a * p + c * q,
        b * p + d * q,
        a * r + c * s,
        b * r + d * s,
        a * t + c * u + e,
        b * t + d * u + f,
    )


def translation(x: float, y: float) -> Affine:
    """Return a move."""
    return 1.0, 0.0, 0.0, 1.0, x, y


def scaling(x: float, y: float) -> Affine:
    """Return a scaling about the origin."""
    return x, 0.0, 0.0, y, 0.0, 0.0


def turn(degrees: float) -> Affine:
    """Return a rotation about the origin, from the x axis to the y axis; quarters are exact."""
    quarters, rest = divmod(degrees % 360.0, 90.0)
    if rest == 0:
        cos, sin = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarters) % 4]
        return cos, sin, -sin, cos, 0.0, 0.0
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return cos, sin, -sin, cos, 0.0, 0.0


def determinant(m: Affine) -> float:
    """Return the factor of areas."""
    return m[0] * m[3] - m[1] * m[2]


def inverse(m: Affine) -> Affine:
    """Return the inverse of a transform whose determinant is not 0."""
    a, b, c, d, e, f = m
    det = determinant(m)
    return d / det, -b / det, -c / det, a / det, (c * f - d * e) / det, (b * e - a * f) / det


def transform_of(values: Values, size: Size, place: str) -> Affine:
    """Return an element's transform: translate, rotate, scale, transform about the origin.

    Source: CSS Transforms 2, section 4.1.

    Raises
    ------
    SceneError
        If a transform is not one of the plane, or refers to the element's own box.
    """
    parts = [_single(name, values[name], size, place) for name in _SINGLES if name in values]
    parts += [_transform(values["transform"], size, place)] if "transform" in values else []
    if all(part == IDENTITY for part in parts):
        return IDENTITY
    if word_of(values, "transform-box", "view-box") != "view-box":
        raise SceneError("transform-box: other boxes than view-box are not read", place)
    origin = values.get("transform-origin")
    x, y = _origin(origin, size, place) if origin is not None else (0.0, 0.0)
    result = translation(x, y) if x or y else IDENTITY
    for part in parts:
        result = product(result, part)
    result = product(result, translation(-x, -y)) if x or y else result
    if not all(map(math.isfinite, result)):
        raise SceneError("transform must have finite numbers", place)
    return result


_SINGLES = ("translate", "rotate", "scale")


def _transform(value: Value, size: Size, place: str) -> Affine:
    text = value.text
    if text.lower() in ("", "none"):
        return IDENTITY
    if value.css and re.search(r"\)\s*,|\s\(", text):
        raise SceneError("transform has a comma or space that CSS does not allow", place, cut(text))
    result, position = IDENTITY, 0
    while match := _FUNCTION.match(text, position):
        position = match.end()
        function = _css_function if value.css else _function
        result = product(result, function(match[1], match[2], size, f"{place}, transform"))
    if position != len(text):
        raise SceneError("transform cannot be read", place, cut(text))
    return result


def _function(name: str, inside: str, size: Size, place: str) -> Affine:
    """Return one function of a transform attribute (SVG 2, section 8.5)."""
    del size
    values = numbers(inside, place)
    if len(values) not in _COUNTS.get(name, ()):
        raise SceneError("cannot be read", place, cut(f"{name}({inside})"))
    if name == "rotate" and len(values) == 3:
        x, y = values[1:]
        return product(product(translation(x, y), turn(values[0])), translation(-x, -y))
    return _matrix(name, values)


def _matrix(name: str, v: list[float]) -> Affine:
    if name == "matrix":
        return v[0], v[1], v[2], v[3], v[4], v[5]
    if name == "translate":
        return translation(v[0], v[1] if len(v) > 1 else 0.0)
    if name == "scale":
        return scaling(v[0], v[-1])
    if name == "rotate":
        return turn(v[0])
    if name == "skewX":
        return 1.0, 0.0, math.tan(math.radians(v[0])), 1.0, 0.0, 0.0
    return 1.0, math.tan(math.radians(v[0])), 0.0, 1.0, 0.0, 0.0


def _css_function(name: str, inside: str, size: Size, place: str) -> Affine:
    """Return one function of a CSS transform (CSS Transforms 1, section 9)."""
    word = name.lower()
    arguments = [part.strip() for part in inside.split(",")]
    least, most = _CSS_COUNTS.get(word, (1, 0))
    if not least <= len(arguments) <= most:
        raise SceneError("is not a transform of the plane that is read", place, cut(name))
    if word.startswith("translate"):
        x = "0" if word == "translatey" else arguments[0]
        y = arguments[0] if word == "translatey" else (arguments[1:] or ["0"])[0]
        return _moved(x, y, size, place)
    if word in ("matrix", "scale", "scalex", "scaley"):
        values = [_factor(text, place) for text in arguments]
        if word == "scalex":
            return scaling(values[0], 1.0)
        return scaling(1.0, values[0]) if word == "scaley" else _matrix(word, values)
    angles = [_degrees(text, place) for text in arguments]
    if word == "rotate":
        return turn(angles[0])
    x_turn = 0.0 if word == "skewy" else angles[0]
    y_turn = angles[0] if word == "skewy" else (angles[1:] or [0.0])[0]
    return 1.0, math.tan(math.radians(y_turn)), math.tan(math.radians(x_turn)), 1.0, 0.0, 0.0


_CSS_COUNTS = {
    "matrix": (6, 6),
    "translate": (1, 2),
    "translatex": (1, 1),
    "translatey": (1, 1),
    "scale": (1, 2),
    "scalex": (1, 1),
    "scaley": (1, 1),
    "rotate": (1, 1),
    "skew": (1, 2),
    "skewx": (1, 1),
    "skewy": (1, 1),
}


def _single(name: str, value: Value, size: Size, place: str) -> Affine:
    """Return one of the properties translate, rotate and scale."""
    where = f"{place}, {name}"
    words = value.text.split()
    if value.text.lower() == "none":
        return IDENTITY
    if len(words) > (1 if name == "rotate" else 2):
        raise SceneError("is not a transform of the plane that is read", where, cut(value.text))
    if name == "translate":
        return _moved(words[0], (words[1:] or ["0"])[0], size, where)
    if name == "rotate":
        return turn(_degrees(words[0], where))
    factors = [_factor(word, where) for word in words]
    return scaling(factors[0], factors[-1])


def _moved(x: str, y: str, size: Size, place: str) -> Affine:
    css = [Value(text, css=True) for text in (x, y)]
    return translation(parsed(css[0], size.width, place), parsed(css[1], size.height, place))


def _factor(text: str, place: str) -> float:
    number, unit = split(text, place)
    if unit not in ("", "%"):
        raise SceneError("must be a number", place, cut(text))
    return number / 100 if unit else number


def _degrees(text: str, place: str) -> float:
    number, unit = split(text, place)
    if unit == "rad":
        return math.degrees(number)
    if unit in _DEGREES:
        return number * _DEGREES[unit]
    if number == 0 and not unit:
        return 0.0
    raise SceneError("must be an angle with a unit", place, cut(text))


def _origin(value: Value, size: Size, place: str) -> tuple[float, float]:
    """Return a transform origin; percentages and words refer to the nearest viewport."""
    where = f"{place}, transform-origin"
    tinycss2: Any = require("tinycss2", "reading SVG", "svg")
    words = [
        tinycss2.serialize([token]).lower()
        for token in tinycss2.parse_component_value_list(value.text)
        if token.type != "whitespace" and token != ","
    ]
    if not 1 <= len(words) <= 2:
        raise SceneError("must be two lengths", where, cut(value.text))
    if words[0] in ("top", "bottom") or (len(words) > 1 and words[1] in ("left", "right")):
        words = [*words[1:], *(["center"] if len(words) == 1 else []), words[0]]
    x, y = ([*words, "center"])[:2]
    return (
        parsed(Value(_SIDES.get(x, x), value.css), size.width, where),
        parsed(Value(_SIDES.get(y, y), value.css), size.height, where),
    )
