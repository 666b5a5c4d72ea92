"""Generated files of the field's own formats: Yap, TPCAP, discopygal, dynobench, Moving AI.

The hints hold nothing of the geometry: the second reader takes it from the file's text.
"""

from __future__ import annotations

import json
import math
import random
from collections.abc import Callable, Iterator

from ..model import Drawing

Point = tuple[float, float]
Maker = Callable[[random.Random], Drawing]
YAP: dict[str, Maker] = {}
TPCAP: dict[str, Maker] = {}
DISCOPYGAL: dict[str, Maker] = {}
DYNOBENCH: dict[str, Maker] = {}
OCTILE: dict[str, Maker] = {}


def feature(table: dict[str, Maker]) -> Callable[[Maker], Maker]:
    """Register a maker of a file under its name."""

    def register(make: Maker) -> Maker:
        table[make.__name__] = make
        return make

    return register


def drawn(table: dict[str, Maker], rng: random.Random, count: int, only: str) -> Iterator[Drawing]:
    """Yield files, each feature in turn."""
    names = [name for name in table if only in name]
    for k in range(count):
        yield table[names[k % len(names)]](rng)


def drawings_yap(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    yield from drawn(YAP, rng, count, only)


def drawings_tpcap(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    yield from drawn(TPCAP, rng, count, only)


def drawings_discopygal(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    yield from drawn(DISCOPYGAL, rng, count, only)


def drawings_dynobench(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    yield from drawn(DYNOBENCH, rng, count, only)


def drawings_octile(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    yield from drawn(OCTILE, rng, count, only)


def ring(
    rng: random.Random, centre: Point, radius: float, *, clockwise: bool = False
) -> list[Point]:
    """Return a star-shaped ring, anticlockwise unless told."""
    n = rng.randint(3, 9)
    angles = sorted((k + rng.uniform(0, 0.8)) * math.tau / n for k in range(n))
    points = [
        (
            round(centre[0] + r * math.cos(t), 4),
            round(centre[1] + r * math.sin(t), 4),
        )
        for t in angles
        for r in (radius * rng.uniform(0.5, 1.0),)
    ]
    return points[::-1] if clockwise else points


# ---- Yap ---------------------------------------------------------------------------------------


def _yap(name: str, rings: list[list[Point]], style: str = "plain") -> Drawing:
    points = [p for own in rings for p in own]
    first, lines = 1, []
    for own in rings:
        indices = [str(first + k) for k in range(len(own))]
        half = len(indices) // 2
        if style == "joined":
            lines.append(" ".join(indices[:half]) + " \\\n  " + " ".join(indices[half:]))
        elif style == "commas":
            lines.append(", ".join(indices) + "  # a polygon")
        else:
            lines.append(" ".join(indices))
        first += len(own)
    between = " " if style == "one line" else "\n"
    places = between.join(f"{x} {y}" for x, y in points)
    comment = "# an environment\n" if style != "plain" else ""
    text = f"{comment}{len(points)}\n{places}\n{len(rings)}\n" + "\n".join(lines) + "\n"
    return Drawing(name, "world.txt", {"world.txt": text.encode()})


@feature(YAP)
def plain(rng: random.Random) -> Drawing:
    return _yap("plain", [ring(rng, (12.0 * k, 0), 5) for k in range(rng.randint(1, 4))])


@feature(YAP)
def overlapping(rng: random.Random) -> Drawing:
    return _yap("overlapping", [ring(rng, (3.0 * k, 1.0 * k), 5) for k in range(3)])


@feature(YAP)
def holes(rng: random.Random) -> Drawing:
    outer = [(-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (-20.0, 20.0)]
    inner = [ring(rng, (15.0 * k - 8, 0), 5, clockwise=True) for k in range(2)]
    order = [outer, *inner]
    rng.shuffle(order)
    return _yap("holes", order)


@feature(YAP)
def islands(rng: random.Random) -> Drawing:
    """An obstacle in a hole of an obstacle."""
    outer = [(-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (-20.0, 20.0)]
    hole = [(-15.0, -15.0), (-15.0, 15.0), (15.0, 15.0), (15.0, -15.0)]
    order = [outer, hole, ring(rng, (1, 2), 8)]
    rng.shuffle(order)
    return _yap("islands", order)


@feature(YAP)
def boundary(rng: random.Random) -> Drawing:
    """Everything outside a clockwise ring around all is an obstacle."""
    border = [(-30.0, -30.0), (-30.0, 30.0), (40.0, 30.0), (40.0, -30.0)]
    return _yap("boundary", [border, ring(rng, (0, 0), 5), ring(rng, (20, 5), 5)])


@feature(YAP)
def written(rng: random.Random) -> Drawing:
    style = rng.choice(["joined", "commas", "one line"])
    return _yap("written", [ring(rng, (12.0 * k, 0), 5) for k in range(2)], style)


# ---- TPCAP -------------------------------------------------------------------------------------


def _tpcap(name: str, rings: list[list[Point]], join: str = ",") -> Drawing:
    values = [-50.0, -50.0, 0.1, -45.5, -50.0, 0.2, len(rings), *map(len, rings)]
    values += [v for own in rings for p in own for v in p]
    text = join.join(str(v) for v in values) + "\n"
    return Drawing(name, "Case1.csv", {"Case1.csv": text.encode()})


@feature(TPCAP)
def tpcap_anticlockwise(rng: random.Random) -> Drawing:
    rings = [ring(rng, (12.0 * k, 0), 5) for k in range(rng.randint(1, 5))]
    return _tpcap("tpcap_anticlockwise", rings)


@feature(TPCAP)
def tpcap_clockwise(rng: random.Random) -> Drawing:
    rings = [ring(rng, (4.0 * k, k), 5, clockwise=True) for k in range(rng.randint(1, 5))]
    return _tpcap("tpcap_clockwise", rings)


@feature(TPCAP)
def tpcap_column(rng: random.Random) -> Drawing:
    """One number a line, as a spreadsheet may write a column; the first vertex may be repeated."""
    rings = [ring(rng, (12.0 * k, 0), 5) for k in range(2)]
    return _tpcap("tpcap_column", [[*rings[0], rings[0][0]], rings[1]], "\r\n")


# ---- discopygal --------------------------------------------------------------------------------


def _discopygal(name: str, obstacles: list[dict[str, object]], **options: object) -> Drawing:
    robot = {"__class__": "RobotDisc", "radius": 0.5, "start": [-50, 0], "end": [-45, 0]}
    content = {"__class__": "Scene", "obstacles": obstacles, "robots": [robot], "metadata": {}}
    return Drawing(name, "scene.json", {"scene.json": json.dumps(content).encode()}, options)


def _polygon(points: list[Point]) -> dict[str, object]:
    return {"__class__": "ObstaclePolygon", "poly": [list(p) for p in points], "data": {}}


@feature(DISCOPYGAL)
def disco_polygons(rng: random.Random) -> Drawing:
    rings = [ring(rng, (8.0 * k, k), 5, clockwise=rng.random() < 0.5) for k in range(3)]
    return _discopygal("disco_polygons", [_polygon(own) for own in rings])


@feature(DISCOPYGAL)
def disco_discs(rng: random.Random) -> Drawing:
    discs: list[dict[str, object]] = [
        {
            "__class__": "ObstacleDisc",
            "location": [round(rng.uniform(-20, 20), 3), round(rng.uniform(-20, 20), 3)],
            "radius": round(rng.uniform(1, 8), 3),
        }
        for _ in range(rng.randint(1, 5))
    ]
    flatten = rng.choice(["outwards", "inwards"])
    return _discopygal("disco_discs", discs, tolerance=0.01, flatten=flatten)


@feature(DISCOPYGAL)
def disco_mixed(rng: random.Random) -> Drawing:
    disc: dict[str, object] = {"__class__": "ObstacleDisc", "location": [3, 4], "radius": 2.5}
    things = [disc, _polygon(ring(rng, (0, 0), 5))]
    rng.shuffle(things)
    return _discopygal("disco_mixed", things, tolerance=0.01)


# ---- dynobench ---------------------------------------------------------------------------------


def _dynobench(name: str, boxes: list[tuple[Point, Point]], *, flow: bool) -> Drawing:
    lines = ["name: made", "environment:", "  max: [60, 60]", "  min: [-60, -60]", "  obstacles:"]
    for (x, y), (w, h) in boxes:
        if flow:
            lines.append(f"  - {{type: box, size: [{w}, {h}], center: [{x}, {y}]}}")
        else:
            lines += ["  - center:", f"    - {x}", f"    - {y}", f"    size: [{w}, {h}]"]
            lines.append("    type: box")
    lines += ["robots:", "- type: unicycle1_v0", "  start: [-50, 0, 0]", "  goal: [-45, 0, 0]"]
    return Drawing(name, "problem.yaml", {"problem.yaml": ("\n".join(lines) + "\n").encode()})


def _boxes(rng: random.Random) -> list[tuple[Point, Point]]:
    return [
        (
            (round(rng.uniform(-20, 20), 3), round(rng.uniform(-20, 20), 3)),
            (rng.choice([1, 0.25, 7.5]), round(rng.uniform(0.1, 9), 2)),
        )
        for _ in range(rng.randint(1, 6))
    ]


@feature(DYNOBENCH)
def dyno_blocks(rng: random.Random) -> Drawing:
    return _dynobench("dyno_blocks", _boxes(rng), flow=False)


@feature(DYNOBENCH)
def dyno_flow(rng: random.Random) -> Drawing:
    return _dynobench("dyno_flow", _boxes(rng), flow=True)


# ---- Moving AI ---------------------------------------------------------------------------------


def _octile(rng: random.Random, name: str, letters: str, newline: str = "\n") -> Drawing:
    rows, columns = rng.randint(1, 14), rng.randint(2, 14)
    cells = [[rng.choice(letters) for _ in range(columns)] for _ in range(rows)]
    cells[0][0], cells[-1][-1] = letters[-1], letters[0]
    lines = ["type octile", f"height {rows}", f"width {columns}", "map"]
    lines += ["".join(row) for row in cells]
    text = newline.join(lines) + rng.choice(["", newline])
    return Drawing(name, "grid.map", {"grid.map": text.encode()})


@feature(OCTILE)
def octile_plain(rng: random.Random) -> Drawing:
    return _octile(rng, "octile_plain", "..@")


@feature(OCTILE)
def octile_all_letters(rng: random.Random) -> Drawing:
    return _octile(rng, "octile_all_letters", "..GS@OTW")


@feature(OCTILE)
def octile_dense(rng: random.Random) -> Drawing:
    """Mostly blocked: holes, and cells that touch in corners."""
    return _octile(rng, "octile_dense", ".@@@")


@feature(OCTILE)
def octile_windows_lines(rng: random.Random) -> Drawing:
    return _octile(rng, "octile_windows_lines", ".T@", "\r\n")
