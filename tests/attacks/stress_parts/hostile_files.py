"""Files made to hurt a reader: deep, wide, long, doubled, at the ends of the numbers, no text."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

Ring = list[list[float]]
LONG = 5_000_000  # characters of the long ones
MILLION = 1_000_000


def square(x: float, y: float, half: float) -> Ring:
    """Return a ring."""
    return [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]


def polygon(*rings: Any) -> dict[str, Any]:
    """Return a GeoJSON polygon."""
    return {"type": "Polygon", "coordinates": list(rings)}


def scene(*obstacles: Any, **fields: Any) -> bytes:
    """Return a small scene as the bytes of a file."""
    content = {
        "format": "planar-planner/scene",
        "version": 1,
        "reference_bounds": [-30, -30, 30, 30],
        "robot": polygon(square(0, 0, 0.5)),
        "obstacles": list(obstacles),
        "start": [-20, -20, 0],
        "goal": [20, 20, 0],
    }
    return json.dumps(content | fields).encode()


def scenes(*, quick: bool) -> Iterator[tuple[str, bytes]]:
    """Yield name and content of each hostile scene file."""
    plain = scene(polygon(square(0, 0, 1)))
    yield from _texts(plain, b'"obstacles": [')
    yield from _numbers(plain, b"[-20, -20, 0]")
    yield from _polygons(1000 if quick else MILLION)


def certificates(*, quick: bool) -> Iterator[tuple[str, bytes]]:
    """Yield name and content of each hostile certificate, for the scene `corner`."""
    plain = json.dumps(
        {
            "format": "planar-planner/certificate",
            "version": 1,
            "made_by": "a stranger",
            "scene": "0" * 64,
            "verdict": "path",
            "robot_pieces": {"0": [square(0, 0, 1)]},
            "obstacle_pieces": {},
            "contact_tolerance": 0.0,
            "waypoints": [[0, 0, 0, 0], [1, 1, 0, 0]],
            "segments": [[{"from": 0, "to": 1, "apart": []}]],
        }
    ).encode()
    yield from _texts(plain, b'"segments": [')
    yield from _numbers(plain, b"[0, 0, 0, 0]")
    if not quick:
        yield "million waypoints", plain.replace(b"[0, 0, 0, 0],", b"[0, 0, 0, 0]," * MILLION)


def _texts(plain: bytes, inside: bytes) -> Iterator[tuple[str, bytes]]:
    """Yield what breaks parsers: `inside` ends with the bracket of a list that takes more."""
    yield "empty", b""
    yield "cut off", plain[:-20]
    yield "nulls", bytes(LONG)
    yield "latin", plain.replace(b'"version"', b'"n\xe4me": 1, "version"')
    yield "UTF-16", plain.decode().encode("utf-16")
    yield "byte order mark", b"\xef\xbb\xbf" + plain
    yield "10 MB of brackets", b"[" * LONG + b"]" * LONG
    yield "10 MB of braces", b'{"a":' * (LONG // 3) + b"1" + b"}" * (LONG // 3)
    yield "900 brackets", plain.replace(inside, inside + b"[" * 900 + b"]" * 900 + b",")
    yield "wide list", plain.replace(inside, inside + b"1," * LONG)
    yield "wide list of objects", plain.replace(inside, inside + b"{}," * MILLION)
    names = b",".join(b'"%d":1' % k for k in range(MILLION))
    yield "many fields", b"{" + names + b"}"
    yield "many fields, the last twice", b"{" + names + b',"999999":1}'
    yield "long name of a field", plain.replace(b'"version"', b'"' + b"x" * LONG + b'":1,"version"')
    yield "surrogate", plain.replace(b'"version"', b'"\\ud800":1,"version"')
    yield "control characters", plain.replace(b'"version"', b'"\\u001b[31m\\n":1,"version"')
    for value in (b"null", b"true", b'"1"', b"[1]", b"{}", b"1.5", b"1e400", b"-1", b"NaN"):
        name = f"version {value.decode()}"
        yield name, plain.replace(b'"version": 1', b'"version": ' + value)


def _numbers(plain: bytes, triple: bytes) -> Iterator[tuple[str, bytes]]:
    values = [b"1e308", b"-1e308", b"1e-320", b"5e-324", b"-0.0", b"NaN", b"-Infinity", b"1e99999"]
    values += [b"9" * 400, b"9" * 5000, b"9" * LONG, b"1." + b"9" * LONG, b"true", b'"1"', b"null"]
    for value in values:
        name = f"number {value[:10].decode()}, {len(value)} characters"
        yield name, plain.replace(triple, triple.replace(b"0", value, 1), 1)


def _polygons(count: int) -> Iterator[tuple[str, bytes]]:
    """Yield polygons of `count` vertices or rings."""
    turns = [2 * math.pi * k / count for k in range(count)]
    yield "circle", scene(polygon([[10 * math.cos(a), 10 * math.sin(a)] for a in turns]))
    radii = [5 + 5 * ((k * 7919) % 1009) / 1009 for k in range(count)]
    star = [[r * math.cos(a), r * math.sin(a)] for r, a in zip(radii, turns, strict=True)]
    yield "star", scene(polygon(star))
    step = 20 / count
    comb = [[9.0 if k % 2 else -9.0, -10 + step * k] for k in range(count)]
    yield "comb", scene(polygon([*comb, [-10, 10], [-10, -10]]))
    upright = [[y, x] for x, y in comb]
    yield "upright comb", scene(polygon([*upright, [10, -10], [-10, -10]]))
    side = math.isqrt(count // 4)
    grid = [
        square(-9 + 18 * i / side, -9 + 18 * j / side, 4 / side)
        for i in range(side)
        for j in range(side)
    ]
    yield "holes", scene(polygon(square(0, 0, 10), *grid))
    yield "squares", scene({"type": "MultiPolygon", "coordinates": [[ring] for ring in grid]})
    few = count // 10
    yield "equal holes", scene(polygon(square(0, 0, 10), *([square(0, 0, 5)] * few)))
    nested = [square(0, 0, 5 + 1e-6 * k) for k in range(few)]
    yield "nested holes", scene(polygon(square(0, 0, 10), *nested))
    yield "equal squares", scene(*([polygon(square(0, 0, 5))] * few))
    yield "one point", scene(polygon([[1.0, 1.0]] * count))
    yield "one line", scene(polygon([[0.1 * k, 0.3 * k] for k in range(few)]))
    yield "to and fro", scene(polygon([[k % 2, k % 3] for k in range(few)]))
    yield "spike", scene(polygon([[0, 0], [2, 0], [2, 1], [5, 1], [2, 1], [2, 2], [0, 2]]))
    yield "empty rings", scene(polygon(square(0, 0, 5), *([[]] * count)))
    yield "rings of numbers", scene(polygon(*([1] * count)))
    yield "robot of too many vertices", scene(robot=polygon(star))
