"""Checks of single fields of a scene: numbers, boxes, configurations, truth values.

Each function takes the JSON value and the path of the field, returns the typed value, and raises
`SceneError` without a source.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterable, Mapping

from planar_planner.errors import SceneError, cut, shown
from planar_planner.scene.input_limits import MAX_ANGLE, MAX_COORDINATE, MIN_COORDINATE

Box = tuple[float, float, float, float]
Configuration = tuple[float, float, float]

_TAU = 628318530717958647692528676655900576839433879875021164194988, 10**59
"""2π to 60 digits, as a quotient, so that an angle is the double nearest to the exact one."""
_UNITS = {"deg": (_TAU[0], 360 * _TAU[1]), "turn": _TAU, "turns": _TAU, "rad": (1, 1)}
_ANGLE = re.compile(
    r"\s*([-+]?)(?=\.?\d)(\d*)\.?(\d*)(?:[eE]([-+]?\d{1,3}))?\s*([a-z]+)\s*", re.ASCII
)
_LONGEST = 64

ANGLE_FORMS = '"90deg" or "0.25turn"'


def number(value: object, field: str) -> float:
    """Return a finite double; truth values, strings and null are not numbers."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise SceneError("must be a number", field, shown(value))
    try:
        result = float(value)
    except OverflowError:
        raise SceneError("is too large for a double", field, shown(value)) from None
    if not math.isfinite(result):
        raise SceneError("must be a finite number", field, shown(value))
    return result


def coordinate(value: object, field: str) -> float:
    """Return a length within `MAX_COORDINATE`, zero or at least `MIN_COORDINATE` in magnitude."""
    result = number(value, field)
    if abs(result) > MAX_COORDINATE:
        raise SceneError(f"magnitude must not exceed {MAX_COORDINATE:g}", field, shown(value))
    if 0 < abs(result) < MIN_COORDINATE:
        raise SceneError(
            f"must be 0 or at least {MIN_COORDINATE:g} in magnitude", field, shown(value)
        )
    return result + 0.0  # -0.0 becomes 0.0


def angle(value: object, field: str) -> float:
    """Return an angle in radians within `MAX_ANGLE`; as text it states its unit."""
    written = radians_of(value) if isinstance(value, str) else None
    if isinstance(value, str) and written is None:
        raise SceneError(
            f"must be a number of radians, or text such as {ANGLE_FORMS}", field, shown(value)
        )
    result = number(value if written is None else written, field)
    if abs(result) > MAX_ANGLE:
        raise SceneError(f"angle must not exceed {MAX_ANGLE:g} rad", field, shown(value))
    return result


def radians_of(text: str) -> float | None:
    """Return the double nearest to an angle such as ``90deg`` or ``0.25 turn``; None if it is none.

    Multiples of 90° are thus the doubles that mean quarter turns.
    """
    found = _ANGLE.fullmatch(text) if len(text) <= _LONGEST else None
    if found is None or found[5] not in _UNITS:
        return None
    above, below = _UNITS[found[5]]
    digits = int(found[1] + found[2] + found[3])
    power = int(found[4] or 0) - len(found[3])
    try:  # the quotient of two integers is rounded once
        radians: float = digits * 10 ** max(power, 0) * above / (below * 10 ** max(-power, 0))
    except OverflowError:
        return math.inf
    return radians


def box(value: object, field: str) -> Box:
    """Return (xmin, ymin, xmax, ymax) of a box with positive width and height."""
    if not isinstance(value, list) or len(value) != 4:
        raise SceneError("must be [xmin, ymin, xmax, ymax]", field, shown(value))
    xmin, ymin, xmax, ymax = (coordinate(v, f"{field}[{i}]") for i, v in enumerate(value))
    if xmin >= xmax:
        raise SceneError("xmin must be less than xmax", field, shown(value))
    if ymin >= ymax:
        raise SceneError("ymin must be less than ymax", field, shown(value))
    return xmin, ymin, xmax, ymax


def configuration(value: object, field: str) -> Configuration:
    """Return (x, y, theta) of the robot's frame in the world; theta in radians."""
    if not isinstance(value, list) or len(value) != 3:
        raise SceneError("must be [x, y, theta]", field, shown(value))
    x, y, theta = value
    return (
        coordinate(x, f"{field}[0]"),
        coordinate(y, f"{field}[1]"),
        angle(theta, f"{field}[2]"),
    )


def truth(value: object, field: str) -> bool:
    """Return a truth value."""
    if not isinstance(value, bool):
        raise SceneError("must be true or false", field, shown(value))
    return value


def text(value: object, field: str) -> str:
    """Return a string."""
    if not isinstance(value, str):
        raise SceneError("must be a string", field, shown(value))
    return value


def mapping(value: object, field: str) -> Mapping[str, object]:
    """Return a JSON object."""
    if not isinstance(value, dict):
        raise SceneError("must be a JSON object", field, shown(value))
    return value


def require(members: Mapping[str, object], names: Iterable[str]) -> None:
    """Reject the absence of any of the named members."""
    for name in names:
        if name not in members:
            raise SceneError("field is missing", name)


def only_known(found: Iterable[str], known: Iterable[str], parent: str) -> None:
    """Reject the first member that is not known, and suggest the one that was probably meant."""
    legal = sorted(known)
    for name in found:
        if name not in legal:
            field = f"{parent}.{cut(name)}" if parent else cut(name)
            raise SceneError(f"unknown field{suggestion(name, legal)}", field)


def suggestion(name: str, known: Iterable[str]) -> str:
    """Return ``; did you mean 'x'?`` for the closest known names, else the list of known names."""
    names = sorted(known)
    close = close_matches(name, names)
    if close:
        return close
    return "; expected one of " + ", ".join(names) if names else ""


def close_matches(name: str, known: Iterable[str]) -> str:
    """Return ``; did you mean 'x'?`` for the closest known names, else nothing."""
    close = difflib.get_close_matches(cut(name), list(known), n=3)
    return "; did you mean " + " or ".join(map(repr, close)) + "?" if close else ""
