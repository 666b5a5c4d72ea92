"""The reader of well-known text: one geometry per line, an optional role before it, ``#`` comments.

The statements are ``robot POLYGON ((…))``, ``obstacle …``, ``workspace …``,
``reference_bounds …``, ``start POINT Z (x y theta)``, ``goal POINT Z (x y theta)`` and
``rotation false``. A geometry without a role is an obstacle. A geometry may continue over several
lines until its brackets close.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.parts import ImportOptions, Notes, Parts
from planar_planner.formats.readers import geojson_features
from planar_planner.formats.reading import angle, coordinate, text_of

_READ = "POINT|POLYGON|MULTIPOLYGON|GEOMETRYCOLLECTION"
_WITHOUT_AREA = ("LINESTRING", "MULTILINESTRING", "MULTIPOINT", "LINEARRING")
_OTHERS = (
    f"{'|'.join(_WITHOUT_AREA)}|TRIANGLE|TIN|POLYHEDRALSURFACE|CIRCULARSTRING|COMPOUNDCURVE|"
    "CURVEPOLYGON|MULTICURVE|MULTISURFACE"
)
_WORD = rf"(?:SRID=\d+;\s*)?(?:{_READ}|{_OTHERS})(?:ZM|Z|M)?\b"
_ROLE = re.compile(
    rf"(?:([a-z_]+)(?:\s*:\s*|\s+))?(?={_WORD})(.*)", re.DOTALL | re.IGNORECASE | re.ASCII
)
_KIND = re.compile(
    rf"(?:SRID=\d+;)?\s*({_READ}|{_OTHERS})\s*(ZM|Z|M)?\b\s*(.*)",
    re.DOTALL | re.IGNORECASE | re.ASCII,
)
_SRID = re.compile(r"SRID=\d+;", re.IGNORECASE)
_TOKEN = re.compile(r"[(),]|[^\s(),]+")
_NAMES = {"POLYGON": "Polygon", "MULTIPOLYGON": "MultiPolygon"}
_STATES = 500  # most brackets inside each other; legal text needs at most four


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read the geometries and their roles."""
    del path, options
    features: list[dict[str, Any]] = []
    content: dict[str, Any] = {"type": "FeatureCollection", "features": features}
    places: list[str] = []
    for line, statement in _statements(text_of(data)):
        place = f"line {line}"
        if re.fullmatch(r"rotation\s+false", statement):
            content["rotation"] = False
            continue
        match = _ROLE.fullmatch(statement)
        if match is None:
            raise SceneError(
                "expected a role and a geometry such as POLYGON ((…))", place, cut(statement)
            )
        role, geometry = (match[1] or "obstacle").lower(), match[2]
        if match[1] is None:
            notes.count("geometries without a role taken as obstacles")
        srid = _SRID.match(geometry)
        if srid is not None:
            notes.say(f"{srid[0].rstrip(';')} is not used: coordinates are taken as they are")
        for feature in _features(role, geometry, place, notes):
            features.append(feature)
            places.append(place)
    try:
        return geojson_features.parts_of(content, notes)
    except SceneError as error:
        raise _placed(error, places) from None


def _placed(error: SceneError, places: list[str]) -> SceneError:
    """Return the error with the line in place of the number of the feature."""
    match = re.match(r"features\[(\d+)\]\.?(?:geometry\.?)?(.*)", error.field)
    if match is None:
        return error
    rest = match[2].replace("coordinates", "").lstrip(".")
    where = f"{places[int(match[1])]}, {rest}" if rest else places[int(match[1])]
    return SceneError(error.problem, where, error.value)


def _statements(text: str) -> Iterator[tuple[int, str]]:
    """Yield (number of the first line, text) of each statement; brackets keep one together."""
    pending, first, depth = "", 0, 0
    for number, line in enumerate(text.splitlines(), start=1):
        content = line.partition("#")[0].strip().rstrip(";")
        if not content:
            continue
        if not pending:
            first = number
        pending = f"{pending} {content}" if pending else content
        depth += content.count("(") - content.count(")")
        if depth <= 0:
            yield first, pending
            pending, depth = "", 0
    if pending:
        raise SceneError("a bracket is not closed", f"line {first}", cut(pending))


def _features(role: str, text: str, place: str, notes: Notes) -> Iterator[dict[str, Any]]:
    match = _KIND.fullmatch(text)
    kind = "" if match is None else match[1].upper()
    if role == "obstacle" and (kind in _WITHOUT_AREA or kind == "POINT"):
        notes.pass_over(f"{kind} geometries left out, which have no area")
        return
    if match is None or kind not in _READ.split("|"):
        raise SceneError(
            "expected POINT, POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION", place, cut(text)
        )
    dimension, body = (match[2] or "").upper(), match[3]
    if body.strip().upper() == "EMPTY" and role == "obstacle":
        notes.pass_over("empty geometries left out")
        return
    if kind == "GEOMETRYCOLLECTION":
        for part in _members(body, place):
            yield from _features(role, part, place, notes)
        return
    properties: dict[str, Any] = {"role": role, "name": place}
    if kind == "POINT":
        numbers = body.strip().removeprefix("(").removesuffix(")").split()
        if len(numbers) not in (2, 3) or (len(numbers) == 3 and "M" in dimension):
            raise SceneError("a POINT has x, y and, as Z, theta", place, cut(text))
        x, y = (coordinate(number, place) for number in numbers[:2])
        geometry: dict[str, Any] = {"type": "Point", "coordinates": [x, y]}
        properties["theta"] = angle(numbers[2], place) if len(numbers) == 3 else 0.0
    else:
        nested = _nested(body, place, len(dimension), notes)
        geometry = {"type": _NAMES[kind], "coordinates": nested}
    yield {"type": "Feature", "properties": properties, "geometry": geometry}


def _members(body: str, place: str) -> list[str]:
    """Split the inside of a collection's brackets at its commas."""
    inner = body.strip()
    if not (inner.startswith("(") and inner.endswith(")")):
        raise SceneError("a collection's members stand in brackets", place, cut(body))
    parts, depth, begin = [], 0, 1
    for i, character in enumerate(inner[1:-1], start=1):
        depth += (character == "(") - (character == ")")
        if character == "," and depth == 0:
            parts.append(inner[begin:i].strip())
            begin = i + 1
    return [*parts, inner[begin:-1].strip()]


def _nested(body: str, place: str, extra: int, notes: Notes) -> list[Any]:
    """Return the brackets as nested lists, positions as [x, y]."""
    stack: list[list[Any]] = [[]]
    numbers: list[float] = []

    def position() -> None:
        if numbers:
            if not 2 <= len(numbers) <= 2 + max(extra, 2):
                raise SceneError("a position must be x y", place, cut(str(numbers)))
            stack[-1].append(numbers[:2])
            notes.count("positions of which only x and y are read", int(len(numbers) > 2))
            numbers.clear()

    for token in _TOKEN.findall(body):
        if token == "(":
            stack[-1].append([])
            stack.append(stack[-1][-1])
            if len(stack) > _STATES:
                raise SceneError("is nested too deeply", place)
        elif token in "),":
            position()
            if token == ")":
                stack.pop()
                if not stack:
                    raise SceneError("a bracket closes that was not opened", place)
        elif token.upper() == "EMPTY":
            notes.pass_over("empty geometries left out")
        else:
            numbers.append(coordinate(token, place))
    position()
    if len(stack) != 1 or len(stack[0]) != 1 or not isinstance(stack[0][0], list):
        raise SceneError("brackets do not match", place, cut(body))
    found: list[Any] = stack[0][0]
    return found
