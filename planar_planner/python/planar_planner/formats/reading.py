"""Conversions of bytes to text and numbers; errors state the place but not yet the source."""

from __future__ import annotations

import importlib
from types import ModuleType

from planar_planner.errors import SceneError, shown
from planar_planner.formats.parts import Point
from planar_planner.scene import fields


def text_of(data: bytes) -> str:
    """Return the text of a UTF-8 file, with or without byte order mark."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise SceneError(f"is not UTF-8 text: byte {error.start}") from None


def coordinate(text: str, place: str) -> float:
    """Return a length written as decimal text, checked like a scene's."""
    return fields.coordinate(_number(text, place), place)


def angle(text: str, place: str) -> float:
    """Return an angle in radians written as decimal text."""
    return fields.angle(_number(text, place), place)


def whole(text: str, place: str, least: int, most: int) -> int:
    """Return an integer within bounds; files also write it as ``4.0``."""
    value = _number(text, place)
    if not (abs(value) < 2**53 and value.is_integer()):
        raise SceneError("must be a whole number", place, shown(text))
    if not least <= value <= most:
        raise SceneError(f"must be between {least} and {most}", place, shown(text))
    return int(value)


def point(x: str, y: str, place: str) -> Point:
    """Return a point."""
    return coordinate(x, f"{place}, x"), coordinate(y, f"{place}, y")


def _number(text: str, place: str) -> float:
    if "_" in text:  # Python accepts an underscore, but no file format does
        raise SceneError("must be a number", place, shown(text))
    try:
        return float(text)
    except ValueError:
        raise SceneError("must be a number", place, shown(text)) from None


def require(module: str, what: str, extra: str) -> ModuleType:
    """Import an optional library.

    Raises
    ------
    SceneError
        If it is not installed; the message names the extra that installs it.
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        raise SceneError(
            f"{what} needs {package}, which is not installed: pip install 'planar-planner[{extra}]'"
        ) from None
