"""Gates at any angle, straight, bent, tapered and toothed: ``python tests/attacks/slanted.py``.

Each family has one parameter, a width. A wider gate holds a narrower one, so verdicts are monotone.
The width at which they change is bracketed by bisection, and every decision is a verdict of the
planner. The table shows the families whose bracket stays wider than 1e-9, since a query in it stays
undecided within its cells. Verdicts that are not monotone are wrong, and end the attack.

Options: ``--families 500 --first 0 --cells 50000 --seconds 10``.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from shapely import affinity
from shapely.geometry import mapping
from shapely.geometry.base import BaseGeometry

from planar_planner import Options, load_scene, solve

KINDS = ("slot", "bent", "wedge", "gear", "zigzag")
ROOM = 9.0  # half the side
BEYOND = 15.0  # of the walls, which reach out of the room at any angle
NARROW, WIDE = 1e-2, 6.0
WANTED = 1e-9


@dataclass(frozen=True)
class Family:
    """A gate whose width is left open."""

    seed: int
    kind: str
    robot: BaseGeometry
    angle: float  # of the gate against the axes
    half: float  # of the gate's length
    bend: float
    taper: float
    phase: float
    thetas: tuple[float, float]

    def solid(self, width: float) -> list[BaseGeometry]:
        """Return the walls of a gate along x about the origin."""
        if self.kind == "gear":
            lower, upper = gear(14, 1.6, 2.0, self.phase), gear(14, 1.6, 2.0, 0.3)
            shift = width / 2 + 2.0
            return [
                affinity.translate(upper, 0, shift).union(shapely.box(-0.5, shift, 0.5, BEYOND)),
                affinity.translate(lower, 0, -shift).union(shapely.box(-0.5, -BEYOND, 0.5, -shift)),
            ]
        wall = shapely.box(-self.half, -BEYOND, self.half, BEYOND)
        return list(wall.difference(self.corridor(width)).geoms)

    def corridor(self, width: float) -> BaseGeometry:
        """Return what is cut out of the wall."""
        out, rise = self.half + 1.0, math.tan(self.bend)
        if self.kind == "slot":
            return shapely.box(-out, -width / 2, out, width / 2)
        if self.kind == "wedge":
            wide = width / 2 + self.taper
            return shapely.Polygon(
                [(-out, -wide), (out, -width / 2), (out, width / 2), (-out, wide)]
            )
        middle = [(-out, rise * out), (0.0, 0.0), (out, rise * out)]
        if self.kind == "zigzag":
            step = 0.5 * rise * self.half
            middle = [(-out, 0.0), (-self.half / 3, 0.0), (self.half / 3, step), (out, step)]
        return shapely.LineString(middle).buffer(
            width / 2, cap_style="flat", join_style="mitre", mitre_limit=20
        )

    def scene(self, width: float) -> dict[str, Any]:
        """Return the scene, turned by the angle."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        walls = [affinity.affine_transform(g, [c, -s, s, c, 0, 0]) for g in self.solid(width)]
        away = 6.0 if self.kind == "gear" else self.half + 3.0
        return {
            "format": "planar-planner/scene",
            "version": 1,
            "name": f"{self.kind}-{self.seed}",
            "workspace": {"box": [-ROOM, -ROOM, ROOM, ROOM]},
            "robot": mapping(self.robot),
            "obstacles": [mapping(g) for g in walls],
            "start": [-c * away, -s * away, self.thetas[0]],
            "goal": [c * away, s * away, self.thetas[1]],
        }


def gear(teeth: int, inner: float, outer: float, phase: float) -> shapely.Polygon:
    """Return a gear about the origin."""
    ring = []
    for k in range(4 * teeth):
        radius = outer if k % 4 >= 2 else inner
        turn = math.tau * k / (4 * teeth) + phase
        ring.append((radius * math.cos(turn), radius * math.sin(turn)))
    return shapely.Polygon(ring)


def body(rng: np.random.Generator) -> BaseGeometry:
    """Return a rectangle, a convex polygon, an L or a T about its centroid."""
    kind = str(rng.choice(["rectangle", "convex", "L", "T"]))
    long, high, thin = rng.uniform(1, 2.5), rng.uniform(0.6, 1.5), rng.uniform(0.2, 0.5)
    shape: BaseGeometry = shapely.box(-long / 2, -high / 3, long / 2, high / 3)
    if kind == "convex":
        count = int(rng.integers(3, 9))
        turns = (np.arange(count) + rng.uniform(0, 0.8, count)) * math.tau / count
        flat = rng.uniform(0.3, 1.0)
        shape = shapely.Polygon(np.column_stack([np.cos(turns), flat * np.sin(turns)]) * high)
    if kind == "L":
        shape = shapely.box(0, 0, long, thin).union(shapely.box(0, 0, thin, high))
    if kind == "T":
        shape = shapely.box(-long / 2, 0, long / 2, thin)
        shape = shape.union(shapely.box(-thin / 2, 0, thin / 2, high))
    return affinity.translate(shape, -shape.centroid.x, -shape.centroid.y)


def family(seed: int) -> Family:
    """Return a family by its seed."""
    rng = np.random.default_rng(seed)
    kind = KINDS[seed % len(KINDS)]
    phase = float(rng.uniform(0, 1))
    teeth = int(rng.integers(5, 11))
    return Family(
        seed=seed,
        kind=kind,
        robot=gear(teeth, 0.7, 1.0, phase) if kind == "gear" else body(rng),
        angle=float(rng.uniform(0, math.tau)),
        half=float(rng.uniform(0.5, 3.0)),
        bend=float(rng.uniform(-1.2, 1.2)),
        taper=float(rng.uniform(0.0, 0.6)),
        phase=phase,
        thetas=(float(rng.uniform(-3, 3)), float(rng.uniform(-3, 3))),
    )


@dataclass(frozen=True)
class Bracket:
    """No path at `low`, a path at `high`; undecided in between if it is wide."""

    low: float
    high: float
    most_cells: int

    @property
    def width(self) -> float:
        """Return its relative width."""
        return (self.high - self.low) / self.high


def bracket(gate: Family, options: Options) -> Bracket | None:
    """Bracket the width at which the verdict changes; None if it does not."""
    most = 0
    shut, wide = NARROW, WIDE

    def verdict(width: float) -> str:
        nonlocal most, shut, wide
        result = solve(load_scene(gate.scene(width)), options)
        most = max(most, result.stats.cells)
        if result.verdict == "no_path":
            shut = max(shut, width)
        if result.verdict == "path":
            wide = min(wide, width)
        if wide < shut:
            raise AssertionError(f"family {gate.seed} is not monotone: {wide!r}, {shut!r}")
        return result.verdict

    if (verdict(NARROW), verdict(WIDE)) != ("no_path", "path"):
        return None
    undecided = 0.0
    while wide - shut > WANTED / 4 * wide and not undecided:
        middle = 0.5 * (shut + wide)
        if verdict(middle) == "undecided":
            undecided = middle
    for side in ("no_path", "path") if undecided else ():
        known, unknown = shut if side == "no_path" else wide, undecided
        while abs(unknown - known) > WANTED / 4 * wide:
            middle = 0.5 * (known + unknown)
            if verdict(middle) == side:
                known = middle
            else:
                unknown = middle
    return Bracket(shut, wide, most)


def main(arguments: list[str] | None = None) -> int:
    """Bracket families and print those that stay wide; 1 if more than one in a hundred does."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--families", type=int, default=500)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--cells", type=int, default=50_000)
    parser.add_argument("--seconds", type=float, default=10.0)
    asked = parser.parse_args(arguments)
    options = Options(resolution=1e-13, max_cells=asked.cells, timeout=asked.seconds)
    asked_of: Counter[str] = Counter()
    wide: Counter[str] = Counter()
    for seed in range(asked.first, asked.first + asked.families):
        gate = family(seed)
        found = bracket(gate, options)
        if found is None:
            print(f"{seed:4} {gate.kind:7} has no change of verdict")
            continue
        asked_of[gate.kind] += 1
        if found.width > WANTED:
            wide[gate.kind] += 1
            print(f"{seed:4} {gate.kind:7} {found.width:.1e} {found.high!r}", flush=True)
    for kind in KINDS:
        print(f"{kind:7} {wide[kind]:4} of {asked_of[kind]:4} wider than {WANTED:g}")
    return int(100 * wide.total() > asked_of.total())


if __name__ == "__main__":
    sys.exit(main())
