"""Random small scenes with free ends, by seed; every kind of robot, obstacle and workspace."""

from __future__ import annotations

import math

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from worlds.scene import Scene, plain

SIZE = 10.0  # side of the domain
TRIES = 400


def blob(rng: np.random.Generator, radius: float, *, convex: bool) -> shapely.Polygon:
    """A polygon about the origin: points of a circle, or a star-like ring with spikes."""
    count = int(rng.integers(3, 9))
    angles = np.sort((np.arange(count) + rng.uniform(0.0, 0.8, count)) * 2.0 * math.pi / count)
    radii = radius * (np.ones(count) if convex else rng.uniform(0.25, 1.0, count))
    stretch = rng.uniform(0.3, 1.0)
    ring = np.column_stack([radii * np.cos(angles), stretch * radii * np.sin(angles)])
    turn = rng.uniform(0.0, 2.0 * math.pi)
    c, s = math.cos(turn), math.sin(turn)
    return shapely.Polygon(ring @ np.array([[c, s], [-s, c]]))


def _moved(shape: BaseGeometry, x: float, y: float) -> BaseGeometry:
    moved: BaseGeometry = shapely.transform(shape, lambda p: p + np.array([x, y]))
    return moved


def _robot(rng: np.random.Generator, kind: str) -> BaseGeometry:
    radius = float(rng.uniform(0.5, 1.6))
    body = blob(rng, radius, convex=kind == "convex")
    if kind == "hole":
        body = shapely.Polygon(shapely.Point(0, 0).buffer(radius, quad_segs=2).exterior)
        body = body.difference(shapely.affinity.scale(body, 0.6, 0.5))
    if kind == "parts":
        other = _moved(blob(rng, 0.6 * radius, convex=True), *rng.uniform(-radius, radius, 2))
        body = shapely.MultiPolygon([body, other]) if body.disjoint(other) else body.union(other)
    if kind == "off":
        body = _moved(body, *rng.uniform(-2.0, 2.0, 2))
    return body


def _obstacles(rng: np.random.Generator) -> list[BaseGeometry]:
    out: list[BaseGeometry] = []
    if rng.random() < 0.6:  # a wall with a gate, so that some scenes have no path
        x, gate = rng.uniform(4.0, 6.0), rng.uniform(0.4, 3.0)
        y, thick = rng.uniform(1.0, SIZE - 1.0 - gate), rng.uniform(0.2, 1.0)
        out += [shapely.box(x, 0.0, x + thick, y), shapely.box(x, y + gate, x + thick, SIZE)]
    for _ in range(int(rng.integers(1, 6))):
        shape = blob(rng, float(rng.uniform(0.3, 1.8)), convex=bool(rng.random() < 0.5))
        out.append(_moved(shape, *rng.uniform(0.0, SIZE, 2)))
    if rng.random() < 0.2:  # a court with the way in through a hole's side, or none
        ring = shapely.box(1.0, 1.0, 6.0, 6.0).difference(shapely.box(1.3, 1.3, 5.7, 5.7))
        out.append(ring if rng.random() < 0.5 else ring.difference(shapely.box(3, 5, 4.5, 7)))
    return out


def _frame(rng: np.random.Generator, scene: Scene) -> None:
    kind = rng.random()
    if kind < 0.55:
        scene["workspace"] = {"box": [0.0, 0.0, SIZE, SIZE]}
    elif kind < 0.75:
        room = shapely.Polygon([(0, 0), (SIZE, 0), (SIZE, 7), (7, SIZE), (0, SIZE)])
        if rng.random() < 0.6:
            room = room.difference(_moved(blob(rng, 1.5, convex=True), 3.0, 6.0))
        scene["workspace"] = shapely.geometry.mapping(room)
    if kind >= 0.75 or rng.random() < 0.2:
        low, high = rng.uniform(0.0, 1.0, 2), rng.uniform(8.5, SIZE, 2)
        scene["reference_bounds"] = [*low.tolist(), *high.tolist()]


def _free_pose(rng: np.random.Generator, scene: Scene, theta: float | None) -> list[float] | None:
    robot = shapely.geometry.shape(scene["robot"])
    solid = shapely.union_all([shapely.geometry.shape(g) for g in scene["obstacles"]])
    room = scene.get("workspace")
    inside = None
    if room is not None:
        inside = shapely.box(*room["box"]) if "box" in room else shapely.geometry.shape(room)
    bounds = scene.get("reference_bounds", [-3.0, -3.0, SIZE + 3.0, SIZE + 3.0])
    for _ in range(TRIES):
        angle = float(rng.uniform(-4.0, 4.0)) if theta is None else theta
        x, y = (float(rng.uniform(bounds[k], bounds[k + 2])) for k in (0, 1))
        c, s = math.cos(angle), math.sin(angle)
        turn = np.array([[c, s], [-s, c]])
        placed = shapely.transform(
            robot, lambda p, turn=turn, x=x, y=y: p @ turn + np.array([x, y])
        )
        if placed.distance(solid) < 1e-3 or (inside is not None and not inside.contains(placed)):
            continue
        if inside is not None and placed.distance(inside.boundary) < 1e-3:
            continue
        return [x, y, angle]
    return None


def random_scene(seed: int) -> Scene:
    """A scene with free ends; every kind of robot, obstacle and workspace comes up."""
    rng = np.random.default_rng(seed)
    for _ in range(TRIES):
        kind = str(rng.choice(["convex", "spiky", "hole", "parts", "off"]))
        scene: Scene = {
            "format": "planar-planner/scene",
            "version": 1,
            "name": f"random-{seed}",
            "description": f"Seed {seed}.",
            "robot": shapely.geometry.mapping(_robot(rng, kind)),
            "obstacles": [shapely.geometry.mapping(g) for g in _obstacles(rng)],
        }
        _frame(rng, scene)
        if rng.random() < 0.25:
            scene["rotation"] = False
        theta = float(rng.uniform(-4.0, 4.0)) if "rotation" in scene else None
        start, goal = (_free_pose(rng, scene, theta) for _ in range(2))
        if start is None or goal is None:
            continue
        return plain({**scene, "start": start, "goal": goal})
    raise ValueError(f"no scene for seed {seed}")
