"""Objects of Python → what JSON has: lists, dicts with names, text, numbers, truth values, None."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from itertools import chain
from typing import Any

from planar_planner.errors import SceneError, cut, shown
from planar_planner.scene.collector import collector_paused

_AS_THEY_ARE = frozenset((float, int, str, bool, type(None)))
_LISTS = frozenset((list, tuple))
_LARGEST_NUMBER = 8  # bytes; a long double stays numpy's own


def plain(value: object, field: str = "") -> Any:
    """Return a copy of `value` in JSON's own types, as if it were read from a file.

    Tuples and arrays (whatever has ``tolist`` or ``__array__``) become lists; geometry objects
    (``__geo_interface__``) become GeoJSON.

    Parameters
    ----------
    value : object
        Anything.
    field : str, optional
        Path of the field, for messages.

    Raises
    ------
    SceneError
        If part of it has no such form, with the place and value of that; without a source.
    """
    try:
        with collector_paused():
            return _copied(value)
    except RecursionError:
        raise SceneError("is nested too deeply", field) from None
    except SceneError:
        raise _placed(value, field) from None


def _copied(value: Any) -> Any:
    if type(value) in _AS_THEY_ARE:
        return value
    if isinstance(value, (list, tuple)):
        return _copied_list(value)
    if isinstance(value, Mapping):
        return {_name(name): _copied(item) for name, item in value.items()}
    for kind in (float, int):  # derived types: numpy's float64, enumerations
        if isinstance(value, kind):
            return kind(value)
    if isinstance(value, str):
        return str.__str__(value)
    return _converted(value)


def _copied_list(value: list[Any] | tuple[Any, ...]) -> list[Any]:
    """Return a copy of a list; a ring of positions is copied without a loop in Python."""
    kinds = set(map(type, value))
    if kinds <= _AS_THEY_ARE:
        return list(value)
    if kinds <= _LISTS and set(map(type, chain.from_iterable(value))) <= _AS_THEY_ARE:
        return list(map(list, value))
    return [item if type(item) in _AS_THEY_ARE else _copied(item) for item in value]


def _name(name: object) -> str:
    if not isinstance(name, str):
        raise SceneError("names of fields must be strings", "", shown(name))
    return str.__str__(name)


def _converted(value: Any) -> Any:
    """Ask an object for its own plain form; classes have none, though they have the methods."""
    if not isinstance(value, type):
        if hasattr(value, "__geo_interface__"):
            return _copied(value.__geo_interface__)
        if hasattr(value, "tolist"):
            listed = value.tolist()
            # Numbers of an array of numbers are Python's own already.
            return listed if _is_numeric(value) else _copied(listed)
        if hasattr(value, "__array__"):
            return _copied(value.__array__().tolist())
    raise SceneError(f"a {type(value).__name__} has no JSON form", "", shown(value))


def _is_numeric(value: Any) -> bool:
    """Whether an object is a numpy array of numbers that `tolist` turns into Python's own."""
    numpy = sys.modules.get("numpy")
    return (
        numpy is not None
        and type(value) is numpy.ndarray
        and value.dtype.kind in "iuf"
        and value.dtype.itemsize <= _LARGEST_NUMBER
    )


def _placed(value: object, field: str) -> SceneError:
    """Return the error of the first part of `value` that has no plain form, with its place."""
    wrong: tuple[str, object] | None = (field, value)
    while wrong is not None:
        field, value = wrong
        wrong = next((part for part in _parts(value, field) if _error_of(part[1])), None)
    error = _error_of(value)
    assert error is not None
    return SceneError(error.problem, field, error.value)


def _error_of(value: object) -> SceneError | None:
    try:
        _copied(value)
    except SceneError as error:
        return error
    return None


def _parts(value: object, field: str) -> Iterator[tuple[str, object]]:
    if isinstance(value, Mapping):
        for name, item in value.items():
            yield f"{field}.{cut(str(name))}" if field else cut(str(name)), item
    elif isinstance(value, (list, tuple)):
        for i, item in enumerate(value):
            yield f"{field}[{i}]", item
