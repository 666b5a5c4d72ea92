"""Random small scenes, one kind for each thing that has broken planners: see `KINDS`.

Lengths are around 1 in a world of `SIDE`. Start and goal are drawn blindly: the planner's gate says
whether they are free. Scenes are small so that thousands take minutes, with their certificates.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

from worlds.scene import Scene

SIDE = 8.0
Ring = list[list[float]]
Geometry = dict[str, Any]


def polygon(*rings: Ring) -> Geometry:
    """Return a GeoJSON Polygon; rings stay as open as they are."""
    return {"type": "Polygon", "coordinates": list(rings)}


def rectangle(x0: float, y0: float, x1: float, y1: float) -> Ring:
    """Return the corners of an axis-parallel rectangle."""
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def star(rng: Random, radius: float, at: Sequence[float] = (0.0, 0.0), least: float = 0.3) -> Ring:
    """Return a simple ring that its centre sees whole; spiky if `least` is small."""
    count = rng.randrange(3, 8)
    turn, flat = rng.uniform(0.0, math.tau), rng.uniform(0.4, 1.0)
    ring = []
    for k in range(count):
        angle = math.tau * (k + rng.uniform(0.0, 0.7)) / count
        r = radius * rng.uniform(least, 1.0)
        x, y = r * math.cos(angle), flat * r * math.sin(angle)
        c, s = math.cos(turn), math.sin(turn)
        ring.append([at[0] + c * x - s * y, at[1] + s * x + c * y])
    return ring


def _place(rng: Random) -> list[float]:
    return [rng.uniform(0.0, SIDE), rng.uniform(0.0, SIDE)]


def _end(rng: Random, end: str) -> list[float]:
    """Return a place for an end: the start on the left, the goal on the right."""
    low = 0.0 if end == "start" else 0.55 * SIDE
    return [low + rng.uniform(0.0, 0.45 * SIDE), rng.uniform(0.0, SIDE)]


def _gate(rng: Random, width: float) -> list[Ring]:
    """Return a wall across the world with a gate of about the given width."""
    x, thick = rng.uniform(3.0, 4.5), rng.choice((0.05, 0.25, 0.5))
    y = round(rng.uniform(1.0, SIDE - 1.0 - width), 2)
    return [rectangle(x, -1.0, x + thick, y), rectangle(x, y + width, x + thick, SIDE + 1.0)]


def _base(rng: Random) -> Scene:
    """Return a scene in a box: a star among a few, often before a gate."""
    rings = [star(rng, rng.uniform(0.3, 1.2), _place(rng)) for _ in range(rng.randrange(3))]
    if rng.random() < 0.85:
        rings += _gate(rng, 2.0 * rng.random() ** 2)
    scene: Scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0.0, 0.0, SIDE, SIDE]},
        "robot": polygon(star(rng, rng.uniform(0.5, 1.3))),
        "obstacles": [polygon(ring) for ring in rings],
    }
    if rng.random() < 0.25:
        scene["rotation"] = False
    return scene


def _plain(_rng: Random, scene: Scene) -> None:
    """Leave the scene as it is."""


def _holes(rng: Random, scene: Scene) -> None:
    """Give the robot a hole, often with a peg in it at the start, and an obstacle one."""
    outer = star(rng, rng.uniform(0.9, 1.4), least=0.7)
    scale = rng.uniform(0.3, 0.8)
    scene["robot"] = polygon(outer, [[scale * x, scale * y] for x, y in outer])
    at = _place(rng)
    court = star(rng, 3.0, at, least=0.8)
    inner = [[a + 0.8 * (p - a) for p, a in zip(v, at, strict=True)] for v in court]
    if rng.random() < 0.5:
        scene["obstacles"].append(polygon(court, inner))
    else:
        scene["obstacles"].append(polygon(star(rng, 0.15, at)))
        scene["start"] = [at[0] + 0.01, at[1], rng.uniform(-4.0, 4.0)]


def _parts(rng: Random, scene: Scene) -> None:
    """Make the robot of parts that lie apart, touch or overlap; obstacles multi-polygons."""
    parts = [[star(rng, 0.5, (rng.uniform(-1, 1), rng.uniform(-1, 1)))] for _ in range(2)]
    if rng.random() < 0.5:
        parts = [[rectangle(-0.6, -0.2, 0.0, 0.2)], [rectangle(0.0, -0.2, 0.2, 0.6)]]
    scene["robot"] = {"type": "MultiPolygon", "coordinates": parts}
    rings = [shape["coordinates"] for shape in scene["obstacles"]]
    rings += [[star(rng, 0.5, _place(rng))] for _ in range(2)]
    scene["obstacles"] = [{"type": "MultiPolygon", "coordinates": rings}]


def _slivers(rng: Random, scene: Scene) -> None:
    """Add needles down to 1e-12 thin, as obstacles or as the robot."""
    for _ in range(rng.randrange(1, 4)):
        (x, y), angle = _place(rng), rng.choice((0.0, 0.5 * math.pi, rng.uniform(0.0, 3.0)))
        long, thin = rng.uniform(1.0, 6.0), 10.0 ** rng.uniform(-12, -2)
        c, s = math.cos(angle), math.sin(angle)
        needle = [
            [x, y],
            [x + long * c, y + long * s],
            [x + 0.5 * c - thin * s, y + 0.5 * s + thin * c],
        ]
        scene["obstacles"].append(polygon(needle))
    if rng.random() < 0.3:
        thin = 10.0 ** rng.uniform(-12, -2)
        scene["robot"] = polygon([[-0.8, 0.0], [0.9, -0.5 * thin], [0.7, thin]])


def _features(rng: Random, scene: Scene) -> None:
    """Split vertices into two or three at 1e-12 to 1e-9: hairline edges, notches and spikes."""

    def rough(ring: Ring) -> Ring:
        out: Ring = []
        for x, y in ring:
            tiny = 10.0 ** rng.uniform(-12, -9)
            out.append([x, y])
            if rng.random() < 0.5:
                out.append([x + rng.uniform(-tiny, tiny), y + rng.uniform(-tiny, tiny)])
        return out

    scene["robot"]["coordinates"] = [rough(ring) for ring in scene["robot"]["coordinates"]]
    for shape in scene["obstacles"]:
        shape["coordinates"] = [rough(ring) for ring in shape["coordinates"]]


def _walls(rng: Random, scene: Scene) -> None:
    """Add parallel walls that nearly touch, and a gate as wide as the robot, more or less."""
    gap = rng.choice((-1, 1)) * 10.0 ** rng.uniform(-12, -3)
    x = rng.uniform(2.0, 5.0)
    scene["obstacles"] = [
        polygon(rectangle(x, -1.0, x + 0.25, rng.choice((SIDE + 1.0, 5.0)))),
        polygon(rectangle(x + 0.25 + abs(gap), -1.0, x + 0.5, 6.0)),
    ]
    width = rng.choice((0.5, 0.75, 1.0))
    scene["robot"] = polygon(rectangle(-0.75, -0.5 * width, 0.5, 0.5 * width))
    if rng.random() < 0.7:
        x, y = 5.5, rng.randrange(1, 6) + rng.choice((0.0, 0.1))
        walls = [rectangle(x, -1.0, x + 0.25, y), rectangle(x, y + width + gap, x + 0.25, 9.0)]
        scene["obstacles"] = [polygon(ring) for ring in walls]


def _shared(rng: Random, scene: Scene) -> None:
    """Build walls of bricks and fans of triangles that share edges exactly."""
    x, y = rng.uniform(2.5, 5.0), rng.uniform(-0.5, 0.5)
    bricks = [polygon(rectangle(x, y + k, x + 0.5, y + k + 1.0)) for k in range(9)]
    del bricks[rng.randrange(1, 8)]
    if rng.random() < 0.3:
        del bricks[rng.randrange(1, 7)]
    centre = _place(rng)
    ring = star(rng, 1.2, centre, least=0.6)
    fan = [polygon([centre, a, b]) for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    scene["obstacles"] = bricks + fan


def _workspace(rng: Random, scene: Scene) -> None:
    """Make the workspace a polygon with holes."""
    room = star(rng, 0.75 * SIDE, (0.5 * SIDE, 0.5 * SIDE), least=0.75)
    holes = [star(rng, 0.6, (0.5 * SIDE + dx, 0.5 * SIDE)) for dx in (-1.0, 1.0)]
    scene["workspace"] = polygon(room, *holes[: rng.randrange(3)])
    scene["obstacles"] = scene["obstacles"][-2:]  # the gate, if there is one


def _bounds(rng: Random, scene: Scene) -> None:
    """Bound the reference point, which may lie off the robot's body."""
    low, high = rng.uniform(-1.0, 1.0), rng.uniform(SIDE - 1.0, SIDE + 1.0)
    scene["reference_bounds"] = [low, low, high, high]
    if rng.random() < 0.7:
        del scene["workspace"]
    away = [rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)]
    scene["robot"] = polygon(star(rng, 0.9, away))


def _fixed(rng: Random, scene: Scene) -> None:
    """Forbid turning."""
    scene["rotation"] = False
    scene["obstacles"] += [polygon(star(rng, 0.8, _place(rng), least=0.1)) for _ in range(3)]


def _lattice(rng: Random, scene: Scene) -> None:
    """Put everything on a coarse lattice: aligned edges, exact fits, ends in contact."""
    w, h = rng.choice((0.5, 1.0, 1.5)), rng.choice((0.5, 1.0, 2.0))
    scene["robot"] = polygon(rectangle(0.0, 0.0, w, h))
    boxes = [(rng.randrange(8), rng.randrange(8)) for _ in range(rng.randrange(2, 9))]
    scene["obstacles"] = [
        polygon(rectangle(x, y, x + rng.choice((1.0, 2.0)), y + rng.choice((1.0, 3.0))))
        for x, y in boxes
    ]
    for end in ("start", "goal"):
        theta = 0.0 if "rotation" in scene or rng.random() < 0.7 else rng.uniform(-3.0, 3.0)
        scene[end] = [0.5 * rng.randrange(15), 0.5 * rng.randrange(13), theta]


def _far(rng: Random, scene: Scene) -> None:
    """Put the scene far from the origin, or in other units, its ends wound many times."""
    far, unit = 10.0 ** rng.uniform(0, 7), 10.0 ** rng.uniform(-9, 4)

    def moved(point: Sequence[float]) -> list[float]:
        return [unit * (point[0] + far), unit * (point[1] - far)]

    for shape in scene["obstacles"]:
        shape["coordinates"] = [[moved(p) for p in ring] for ring in shape["coordinates"]]
    scene["robot"]["coordinates"] = [
        [[unit * x, unit * y] for x, y in ring] for ring in scene["robot"]["coordinates"]
    ]
    scene["workspace"] = {"box": [*moved([0.0, 0.0]), *moved([SIDE, SIDE])]}
    theta = rng.uniform(-1.0, 1.0) * 10.0 ** rng.uniform(0, 6)
    for end in ("start", "goal"):
        fixed = "rotation" in scene or end == "start"
        scene[end] = [*moved(_end(rng, end)), theta if fixed else rng.uniform(-9.0, 9.0)]


KINDS: dict[str, Callable[[Random, Scene], None]] = {
    "plain": _plain,
    "robot or obstacle with a hole": _holes,
    "several parts, multi-polygons": _parts,
    "slivers to 1e-12": _slivers,
    "features of 1e-12": _features,
    "near-touching parallel walls": _walls,
    "obstacles that share edges": _shared,
    "polygonal workspace with holes": _workspace,
    "reference bounds": _bounds,
    "turning forbidden": _fixed,
    "on a lattice, in contact": _lattice,
    "far away, in other units, wound": _far,
}


def random_world(kind: str, rng: Random) -> Scene:
    """Return a scene of a kind; its ends may collide, and its polygons be invalid by bad luck."""
    scene = _base(rng)
    KINDS[kind](rng, scene)
    theta = rng.uniform(-4.0, 4.0)
    for end in ("start", "goal"):
        angle = theta if "rotation" in scene else rng.uniform(-4.0, 4.0)
        scene.setdefault(end, [*_end(rng, end), angle])
    if "rotation" in scene:
        scene["goal"][2] = scene["start"][2]
    return scene
