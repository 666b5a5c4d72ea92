"""Polygons whose edges almost touch, in doubles one unit apart.

The oracle is rational arithmetic over all pairs of edges. What is accepted must be a valid polygon,
and its convex pieces a partition of it: their boundaries, summed with signs on every line, are its.
"""

from __future__ import annotations

import math
import random
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise

import numpy as np

from attacks.stress_parts.common import Row, Settings, fail
from pdg import even_odd_pieces, polygon_defect

PART = "hostile"
Point = tuple[float, float]
Exact = tuple[Fraction, Fraction]
Rings = list[list[Point]]


def run(settings: Settings) -> list[Row]:
    """Compare with the oracle on grids, where rings meet often, and on rings one unit apart."""
    rows = []
    for name, make, full in (
        ("polygons on a grid against rational arithmetic", _on_a_grid, 30_000),
        ("polygons of almost touching edges, likewise", _almost_touching, 30_000),
    ):
        row = Row(PART, name)
        began = time.perf_counter()
        valid = 0
        for trial in range(settings.count(full, 500)):
            rng = random.Random(f"{settings.seed} {name} {trial}")
            rings = make(rng)
            if not all(map(_is_ring, rings)):
                continue
            row.tried += 1
            wrong, accepted = _compared(rings)
            valid += accepted
            row.refused += not accepted
            if wrong is not None:
                fail(settings, row, None, f"trial {trial}: {wrong}: {rings}")
        row.seconds = time.perf_counter() - began
        row.note = f"{valid} valid ones decomposed"
        rows.append(row)
    return rows


def _compared(rings: Rings) -> tuple[str | None, bool]:
    """Return what is wrong with the judgement or the pieces, and whether the polygon is valid."""
    coords = np.array([p for ring in rings for p in ring])
    starts = np.cumsum([0, *map(len, rings)]).astype(np.uint32)
    polygon = np.array([0, len(rings)], dtype=np.uint32)
    defect = polygon_defect(coords, starts, polygon)
    truth = oracle(rings)
    if (defect is None) != (truth is None):
        return f"judged {defect}, is {truth}", defect is None
    if truth is not None:
        return None, False
    for cover in (False, True):
        found = even_odd_pieces(rings, cover=cover)
        pieces = [[(x, y) for x, y in piece.tolist()] for piece in found]
        if not all(map(_is_convex, pieces)):
            return "a piece is not convex", True
        if not cover and _boundary(_oriented(rings)) != _boundary(pieces):
            return "the pieces are no partition", True
    return None, True


# --- The oracle -----------------------------------------------------------------------------------


def exact(point: Point) -> Exact:
    """Return a point in rational numbers."""
    return Fraction(point[0]), Fraction(point[1])


def side(a: Exact, b: Exact, c: Exact) -> int:
    """Return +1 if c is left of a → b, −1 if right, 0 if on the line."""
    turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (turn > 0) - (turn < 0)


def oracle(rings: Rings) -> str | None:
    """Return why a polygon is not valid, or None."""
    lines = [[exact(p) for p in ring] for ring in rings]
    if any(len(set(ring)) != len(ring) for ring in lines):
        return "a ring passes a point twice"
    edges = [(k, i, ring[i - 1], ring[i]) for k, ring in enumerate(lines) for i in range(len(ring))]
    touching: dict[Exact, set[int]] = defaultdict(set)  # rings at a point
    cuts: dict[tuple[int, int], set[Exact]] = defaultdict(set)  # points on an edge
    for n, (k, i, a, b) in enumerate(edges):
        for m, j, c, d in edges[:n]:
            common = _common_points(a, b, c, d)
            neighbours = k == m and (i - j) % len(lines[k]) in (1, len(lines[k]) - 1)
            if common is None or len(common) > 1 or (k == m and len(common) > neighbours):
                return "edges meet"
            for p in common if k != m else ():
                touching[p] |= {k, m}
                cuts[k, i].add(p)
                cuts[m, j].add(p)
    for k, i, a, b in edges:
        for p, q in pairwise(sorted({a, b} | cuts[k, i])):
            middle = (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
            rest = ((m, ring) for m, ring in enumerate(lines) if m != k)
            if any(_surrounds(ring, middle) != (m == 0) for m, ring in rest):
                return "a hole is misplaced"
    return "the interior is in parts" if _has_cycle(touching) else None


def _common_points(a: Exact, b: Exact, c: Exact, d: Exact) -> set[Exact] | None:
    """Return the ends at which two edges touch; None if they cross."""
    ends = ((c, a, b), (d, a, b), (a, c, d), (b, c, d))
    sides = [side(q, r, p) for p, q, r in ends]
    if sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0:
        return None
    on_line = (end for end, s in zip(ends, sides, strict=True) if s == 0)
    return {p for p, q, r in on_line if min(q, r) <= p <= max(q, r)}


def _surrounds(ring: Sequence[Exact], p: Exact) -> bool:
    """Whether an odd number of edges is right of the point, which is on none."""
    odd = False
    for a, b in pairwise([ring[-1], *ring]):
        if (a[1] > p[1]) != (b[1] > p[1]) and (side(a, b, p) > 0) == (b[1] > a[1]):
            odd = not odd
    return odd


def _has_cycle(touching: dict[Exact, set[int]]) -> bool:
    """Whether rings and the points they share form a cycle, which cuts something off."""
    root: dict[object, object] = {}

    def find(x: object) -> object:
        while root.setdefault(x, x) != x:
            x = root[x]
        return x

    for point, rings in touching.items():
        for ring in rings:
            here, there = find(point), find(ring)
            if here == there:
                return True
            root[here] = there
    return False


def _boundary(rings: Rings) -> dict[object, dict[Fraction, int]]:
    """Return, per line, the jumps of the number of edges along it, counted with their direction."""
    lines: dict[object, dict[Fraction, int]] = defaultdict(lambda: defaultdict(int))
    for ring in rings:
        points = [exact(p) for p in ring]
        for a, b in pairwise([points[-1], *points]):
            dx, dy = b[0] - a[0], b[1] - a[1]
            line = (dy / dx, a[1] - dy / dx * a[0]) if dx else a[0]
            lines[line][a[0] if dx else a[1]] += 1
            lines[line][b[0] if dx else b[1]] -= 1
    found = {line: {x: n for x, n in jumps.items() if n} for line, jumps in lines.items()}
    return {line: jumps for line, jumps in found.items() if jumps}


def _oriented(rings: Rings) -> Rings:
    """Return the rings with the interior on the left."""
    out = []
    for k, ring in enumerate(rings):
        points = [exact(p) for p in ring]
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise([points[-1], *points]))
        out.append(ring if (area > 0) == (k == 0) else ring[::-1])
    return out


def _is_convex(piece: list[Point]) -> bool:
    points = [exact(p) for p in piece]
    n = len(points)
    turns = (side(points[i - 2], points[i - 1], points[i]) > 0 for i in range(n))
    falls = [points[i - 1] < points[i] for i in range(n)]
    return n >= 3 and all(turns) and sum(falls[i] != falls[i - 1] for i in range(n)) == 2


# --- What it is asked -----------------------------------------------------------------------------


def _is_ring(ring: list[Point]) -> bool:
    """Whether the gate would look at the shape: area, and no vertex equal to the next."""
    points = [exact(p) for p in ring]
    repeats = any(a == b for a, b in pairwise([points[-1], *points]))
    return not repeats and any(side(points[0], points[1], p) for p in points[2:])


def _on_a_grid(rng: random.Random) -> Rings:
    """Draw a square with triangles and quadrangles in it or not, or anything; few coordinates."""
    unit = rng.choice((1.0, 0.1, 1 / 3, 1e11, 1e-20))
    most = rng.randint(2, 12)

    def point(low: int, high: int) -> Point:
        return rng.randint(low, high) * unit, rng.randint(low, high) * unit

    if rng.random() < 0.4:
        return [
            [point(0, 4) for _ in range(rng.randint(3, 8))] for _ in range(rng.choice((1, 1, 2)))
        ]
    end = most * unit
    rings = [[(0.0, 0.0), (end, 0.0), (end, end), (0.0, end)]]
    for _ in range(rng.randint(1, 5)):
        x, y = rng.randint(0, most - 1), rng.randint(0, most - 1)
        size = rng.randint(1, 3)
        corners = [
            (min(most, x + rng.randint(0, size)), min(most, y + rng.randint(0, size)))
            for _ in range(rng.choice((3, 3, 4)))
        ]
        rings.append([(a * unit, b * unit) for a, b in corners])
    return rings


def _almost_touching(rng: random.Random) -> Rings:
    """Grow a ring by vertices on, or a unit off, its own edges and vertices; holes likewise."""
    draw = rng.choice(_DRAWS)
    ring = [_legal(draw(rng)) for _ in range(3)]
    for _ in range(rng.randint(1, 20)):
        grown = list(ring)
        grown.insert(rng.randrange(len(ring)), _near(rng, ring, draw))
        if all(map(_is_ring, [grown])) and oracle([grown]) is None:
            ring = grown
        if len(ring) > 9:
            break
    rings = [ring]
    for _ in range(rng.choice((0, 0, 1, 3))):
        hole = [_near(rng, ring, draw) for _ in range(3)]
        if _is_ring(hole) and (oracle([*rings, hole]) is None or rng.random() < 0.1):
            rings.append(hole)
    if rng.random() < 0.4:  # and one vertex moved by so little that it may or may not matter
        moved = rng.choice(rings)
        i = rng.randrange(len(moved))
        moved[i] = _legal((_unit_off(rng, moved[i][0]), _unit_off(rng, moved[i][1])))
    return rings


def _near(rng: random.Random, ring: list[Point], draw: Callable[[random.Random], Point]) -> Point:
    i = rng.randrange(len(ring))
    (ax, ay), (bx, by) = ring[i - 1], ring[i]
    t = rng.choice((0.0, 0.0, 0.25, 0.5, rng.random(), rng.random()))
    x, y = draw(rng) if rng.random() < 0.4 else (ax + t * (bx - ax), ay + t * (by - ay))
    return _legal((_unit_off(rng, x), _unit_off(rng, y)))


def _unit_off(rng: random.Random, x: float) -> float:
    return math.nextafter(x, rng.choice((x, math.inf, -math.inf)))


def _legal(point: Point) -> Point:
    x, y = (v + 0.0 if 1e-50 <= abs(v) <= 1e12 else 0.0 for v in point)
    return x, y


def _any_size(rng: random.Random) -> float:
    sizes = (0.0, 1e12, 1e-50, 1e-20, 0.1, 1.0, 3e-7, 1e5, 2.0 ** rng.randint(-160, 39))
    return rng.choice((1.0, -1.0)) * rng.choice(sizes)


_DRAWS: tuple[Callable[[random.Random], Point], ...] = (
    lambda rng: (rng.uniform(-1, 1), rng.uniform(-1, 1)),
    lambda rng: (float(rng.randint(-4, 4)), float(rng.randint(-4, 4))),
    lambda rng: (1e12 - rng.randint(0, 9) * 2.0**-13, rng.randint(-3, 3) * 2.0**-13),
    lambda rng: (_any_size(rng), _any_size(rng)),
    lambda rng: (rng.randint(0, 6) / 7, rng.randint(0, 6) * 3 / 7 + 0.1),
)
