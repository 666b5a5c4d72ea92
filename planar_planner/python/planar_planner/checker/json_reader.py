"""From bytes to JSON values, and from those to what they stand for; bounded in time and memory.

A reader takes a JSON value and returns what it stands for, or raises `CertificateError` with the
place below that value. Readers are combined into the reader of a whole form. Anything that is not
expected is refused: unknown and missing fields, lists of another length, truth values for numbers,
numbers out of range.
"""

from __future__ import annotations

import gzip
import json
import os
import reprlib
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from planar_planner.errors import CertificateError

MAX_BYTES = 2**28
"""Bytes of a certificate, uncompressed."""
MAX_MEMORY = 2**30
"""Bytes that a certificate's values may take, by the estimate of `MEMORY_OF`."""
MAX_ITEMS = 10**7
"""Commas of a certificate; reading ends before a time limit is looked at, so it has to be short."""
MEMORY_OF = {b"[": 110, b"{": 300, b",": 40, b":": 250}
"""Bytes that a list, an object, an item and a field take once they are read; measured on CPython
3.11, where the empty list takes 56, the tuple made of it 48, a dict 232, a field's key and entry
about 250."""
MOST_FIELDS = 64
"""Fields of an object whose fields have names; no form has half as many."""

_GZIP_MAGIC = b"\x1f\x8b"
_LONGEST_SHOWN = 60

Reader = Callable[[Any], Any]
Fields = Mapping[str, Reader]
"""The fields of an object by their keys."""


def read_json(file: str | os.PathLike[str]) -> Any:
    """Return the content of a JSON file, compressed by gzip or not.

    Raises
    ------
    CertificateError
        If it cannot be opened, is too large or no JSON, or has a field twice in one object.
    """
    try:
        return json.loads(_text(Path(file)), object_pairs_hook=_unique)
    except (OSError, ValueError, EOFError, zlib.error, RecursionError) as error:
        reason = getattr(error, "strerror", "") or str(error)
        raise CertificateError("", f"cannot be read: {reason}") from None


def _text(path: Path) -> bytes:
    with path.open("rb") as file:
        zipped = file.read(2) == _GZIP_MAGIC
        file.seek(0)
        text: bytes = (gzip.GzipFile(fileobj=file) if zipped else file).read(MAX_BYTES + 1)
    if len(text) > MAX_BYTES:
        raise ValueError("is too large")
    if text.count(b",") > MAX_ITEMS:
        raise ValueError("is too large")
    if sum(size * text.count(sign) for sign, size in MEMORY_OF.items()) > MAX_MEMORY:
        raise ValueError("is too large")
    return text


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    fields = dict(pairs)
    if len(fields) != len(pairs):
        raise ValueError("a field stands twice")
    return fields


def same(value: Any) -> Any:
    """Return the value as it is."""
    return value


def leaf(what: str, fits: Callable[[Any], bool], convert: Reader = same) -> Reader:
    """Read a value that `fits`; `what` says what that is."""

    def read(value: Any) -> Any:
        if not fits(value):
            raise _unexpected(what, value)
        return convert(value)

    return read


def integer(low: int, high: int) -> Reader:
    """Read an integer from low to high; a truth value is none."""
    return leaf("an integer within limits", lambda v: type(v) is int and low <= v <= high)


def number(limit: int, bits: int, convert: Callable[[float], Any] = float) -> Reader:
    """Read a number of magnitude at most `limit` that is a multiple of 2^-bits."""

    def fits(v: Any) -> bool:
        bounded = type(v) in (int, float) and abs(v) <= limit
        return bounded and float(v).as_integer_ratio()[1] <= 1 << bits

    return leaf("a number within limits", fits, lambda v: convert(float(v)))


def word(*words: str) -> Reader:
    """Read one of some words."""
    return leaf(" or ".join(words), lambda v: isinstance(v, str) and v in words)


def list_of(item: Reader) -> Reader:
    """Read a list of any length; returns a list."""

    def read(value: Any) -> Any:
        if not isinstance(value, list):
            raise _unexpected("a list", value)
        return [_below(i, each, item) for i, each in enumerate(value)]

    return read


def tuple_of(*items: Reader, convert: Reader = same) -> Reader:
    """Read a list of as many items; returns a tuple."""

    def read(value: Any) -> Any:
        if not isinstance(value, list) or len(value) != len(items):
            raise _unexpected(f"a list of {len(items)}", value)
        return convert(
            tuple(
                _below(i, each, item)
                for i, (each, item) in enumerate(zip(value, items, strict=True))
            )
        )

    return read


def mapping_of(item: Reader) -> Reader:
    """Read an object whose keys are free."""

    def read(value: Any) -> Any:
        if not isinstance(value, dict):
            raise _unexpected("an object", value)
        return {name: _below(name, each, item) for name, each in value.items()}

    return read


def object_of(*variants: Fields, convert: Reader = same) -> Reader:
    """Read an object with just the fields of one of the variants, the one it is nearest to."""

    def read(value: Any) -> Any:
        if not isinstance(value, dict):
            raise _unexpected("an object", value)
        if len(value) > MOST_FIELDS:
            raise CertificateError("", f"has {len(value)} fields")
        fields = min(variants, key=lambda variant: len(variant.keys() ^ value.keys()))
        for name in sorted(map(str, fields.keys() ^ value.keys())):
            problem = "is missing" if name in fields else "is an unknown field"
            raise CertificateError(name[:_LONGEST_SHOWN], problem)
        return convert({name: _below(name, value[name], item) for name, item in fields.items()})

    return read


def _unexpected(what: str, value: Any) -> CertificateError:
    shown = reprlib.repr(value)[:_LONGEST_SHOWN]
    return CertificateError("", f"must be {what} (got {shown})")


def _below(name: str | int, value: Any, reader: Reader) -> Any:
    """Read a part of a value, with its name in the place of an error."""
    try:
        return reader(value)
    except CertificateError as error:
        own = f"[{name}]" if isinstance(name, int) else str(name)[:_LONGEST_SHOWN]
        dot = "." if error.place and not error.place.startswith("[") else ""
        raise CertificateError(own + dot + error.place, error.problem) from None
