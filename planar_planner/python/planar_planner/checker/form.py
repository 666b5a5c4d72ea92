"""The form of a certificate (docs/certificate.md): JSON → checked values; nothing of its truth.

A certificate is hostile input: whatever cannot be read gives a `CertificateError` with the field,
within bounds on time and memory. Lengths become integers in units of 2^-UNIT.
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

UNIT = 320  # bits after the binary point of lengths: they hold scenes' doubles and corners of boxes
LEVELS = 60  # deepest dyadic box
MAX_BYTES, MAX_VALUES = 2**28, 2**24  # of a certificate, uncompressed: they bound time and memory
WALLS = ("x_min", "x_max", "y_min", "y_max")

Source = str | os.PathLike[str] | Mapping[str, Any]


def units(number: float) -> int:
    """Return a double in units of length; those of scenes are multiples of 2^-219."""
    above, below = number.as_integer_ratio()
    return above << (UNIT + 1 - below.bit_length())


def _leaf(
    what: str, fits: Callable[[Any], bool], convert: Callable[[Any], Any] = lambda v: v
) -> Any:
    def read(value: Any) -> Any:
        if not fits(value):
            raise CertificateError("", f"must be {what} (got {reprlib.repr(value)[:60]})")
        return convert(value)

    return read


def _integer(low: int, high: int) -> Any:
    return _leaf("an integer within limits", lambda v: type(v) is int and low <= v <= high)


def _number(limit: int, bits: int, convert: Callable[[float], Any] = float) -> Any:
    def fits(v: Any) -> bool:
        bounded = type(v) in (int, float) and abs(v) <= limit
        return bounded and float(v).as_integer_ratio()[1] <= 1 << bits

    return _leaf("a number within limits", fits, lambda v: convert(float(v)))


def _one_of(*names: str) -> Any:
    return _leaf(" or ".join(names), lambda v: isinstance(v, str) and v in names)


def _any_of(*specs: dict[str, Any]) -> Any:
    def read(value: Any) -> Any:  # as the spec that its fields fit best
        names = value.keys() if isinstance(value, dict) else set()
        return _read(value, min(specs, key=lambda spec: len(spec.keys() ^ names)))

    return read


def _read(value: Any, spec: Any) -> Any:
    """Return `value` as a leaf, a dict {name: spec} or {"*": spec}, a list [spec] or (spec, …)."""
    if callable(spec):
        return spec(value)
    kind: Any = dict if isinstance(spec, dict) else list
    size: Any = len(spec) if isinstance(spec, tuple) else None
    if not isinstance(value, kind) or size not in (None, len(value)):
        what = f"{'an object' if kind is dict else 'a list'}{f' of {size}' if size else ''}"
        raise CertificateError("", f"must be {what} (got {reprlib.repr(value)[:60]})")
    if kind is list:
        read = [_inner(i, each, spec[i if size else 0]) for i, each in enumerate(value)]
        return tuple(read) if size else read
    names = value.keys() if "*" in spec else spec.keys()
    for name in sorted(map(str, names ^ value.keys())):
        raise CertificateError(name[:60], "is missing" if name in spec else "is an unknown field")
    return {name: _inner(name, value[name], spec.get(name, spec.get("*"))) for name in names}


def _inner(name: str | int, value: Any, spec: Any) -> Any:
    try:
        return _read(value, spec)
    except CertificateError as error:
        place, problem = error.place, error.problem
        own = f"[{name}]" if isinstance(name, int) else name[:60]
        dot = "." if place and place[0] != "[" else ""
        raise CertificateError(own + dot + place, problem) from None


_INDEX, _SPAN = _integer(0, 2**31), (_integer(0, LEVELS), _integer(0, 2**LEVELS))
_LENGTH, _PART = (_number(limit, UNIT - LEVELS, units) for limit in (2**100, 1))
_FINITE, _ANGLE = _number(2**1000, 1100), _number(2**20, 1100)
_TEXT = _leaf("a string", lambda v: isinstance(v, str))
_POINT, _PAIR, _BOX = (_LENGTH,) * 2, (_INDEX,) * 4, (_SPAN,) * 3
_DYADICS = [((_integer(low, 2**200), _integer(LEVELS - UNIT, 100)),) * 2 for low in (-(2**200), 1)]
_OWNER, _WALL, _NO_PATH = _one_of("obstacle", "robot"), _one_of(*WALLS), _one_of("no_path")
_TERM = {"pair": _PAIR, "owner": _OWNER, "edge": _INDEX, "vertex": _INDEX, "weight": _FINITE}
_TERMS = [_any_of(_TERM, {"wall": _WALL, "vertex": _POINT, "weight": _FINITE})]
_JOINT = {"axes": [{"pair": _PAIR, "edges": [(_OWNER, _INDEX)]}], "sums": [_TERMS]}
_CLAIMS: list[dict[str, Any]] = [{"pair": _PAIR}, {"wall": _WALL}, {"joint": _JOINT}]
_PATH = {
    "verdict": _one_of("path"),
    "contact_tolerance": _FINITE,
    "waypoints": [(_LENGTH, _LENGTH, _ANGLE, _integer(-(2**20), 2**20))],
    "segments": [[{"from": _PART, "to": _PART, "apart": [(*_PAIR, _OWNER, _INDEX)]}]],
}
_SEPARATION = {
    "verdict": _NO_PATH,
    "claim": _one_of("separation"),
    "domain": {"low": _DYADICS[0], "size": _DYADICS[1]},
    "start_side": [_BOX],
    "full": [_any_of(*({"box": _BOX} | claim for claim in _CLAIMS))],
    "full_faces": [_any_of(*({"box": _BOX, "axis": _integer(0, 2)} | c for c in _CLAIMS))],
}
_DISC = _SEPARATION | {"claim": _one_of("disc"), "disc": [_POINT], "inside": (_INDEX, _INDEX)}
_END = {"verdict": _NO_PATH, "claim": _one_of("end"), "end": _one_of("start", "goal")}
_BOUNDS = {"reference_bounds": _leaf("true", lambda v: v is True)}
_COMMON = {
    "format": _one_of("planar-planner/certificate"),
    "version": _integer(1, 1),
    "made_by": _TEXT,
    "scene": _TEXT,
    "robot_pieces": {"*": [[_POINT]]},
    "obstacle_pieces": {"*": [[_POINT]]},
}
_KINDS = [_PATH, _SEPARATION, _DISC, *(_END | claim for claim in (*_CLAIMS[:2], _BOUNDS))]
_OUTSIDE: list[dict[str, Any]] = [{}, {"outside": (_LENGTH,) * 4}]
_CERTIFICATE = _any_of(*(_COMMON | kind | more for kind in _KINDS for more in _OUTSIDE))


def _text(path: Path) -> bytes:
    with path.open("rb") as file:
        zipped = file.read(2) == b"\x1f\x8b"
        file.seek(0)
        text: bytes = (gzip.GzipFile(fileobj=file) if zipped else file).read(MAX_BYTES + 1)
    if len(text) > MAX_BYTES or sum(map(text.count, (b"[", b"{", b","))) > MAX_VALUES:
        raise ValueError("is too large")
    return text


def read_certificate(source: Source) -> Any:
    """Return a certificate's content, lengths in units and short lists as tuples."""

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        if len(dict(pairs)) != len(pairs):
            raise ValueError("a field stands twice")
        return dict(pairs)

    if isinstance(source, Mapping):
        return _CERTIFICATE(source)
    try:
        content = json.loads(_text(Path(source)), object_pairs_hook=unique)
    except (OSError, ValueError, EOFError, zlib.error, RecursionError) as error:
        reason = getattr(error, "strerror", "") or str(error)
        raise CertificateError("", f"cannot be read: {reason}") from None
    return _CERTIFICATE(content)
