"""Scenes with regions for goals, and what an answer must show."""

from __future__ import annotations

import json
import math
from typing import Any

import shapely
from shapely.affinity import affine_transform

from planar_planner import Options, Planner
from planar_planner.checker.verify import verify_certificate
from planar_planner.planning.result import Result
from worlds.scene import Scene

LIMITS = Options(timeout=20.0)


def rectangle(x0: float, y0: float, x1: float, y1: float) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]]}


def shape(points: list[list[float]]) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": [points]}


def slot(height: float, goal: Any, **more: Any) -> Scene:
    """Return a bar of 2 by 0.5 before a wall with a slot of some height, 1 long."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 10]},
        "robot": rectangle(-1, -0.25, 1, 0.25),
        "obstacles": [rectangle(4.5, 0, 5.5, 4), rectangle(4.5, 4 + height, 5.5, 10)],
        "start": [2, 5, 0],
        "goal": goal,
        **more,
    }


def cage(gap: float, goal: Any) -> Scene:
    """Return a disc-like robot of diameter 2 in a C whose mouth is `gap` wide."""
    ring = [[math.cos(k * math.pi / 8), math.sin(k * math.pi / 8)] for k in range(16)]
    outline: list[list[float]] = [
        [0, 0],
        [8, 0],
        [8, 4 - gap / 2],
        [7, 4 - gap / 2],
        [7, 1],
        [1, 1],
        [1, 7],
    ]
    outline += [[7, 7], [7, 4 + gap / 2], [8, 4 + gap / 2], [8, 8], [0, 8]]
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "reference_bounds": [-5, -5, 13, 13],
        "robot": shape(ring),
        "obstacles": [shape(outline)],
        "start": [3, 4, 0.1],
        "goal": goal,
    }


def answer(scene: Scene, options: Options = LIMITS) -> Result:
    """Return the answer, after a look at its certificate and at where a path ends."""
    planner = Planner(scene)
    result = planner.solve(options=options, certificate=True)
    if result.verdict != "undecided":
        assert result.certificate is not None
        assert verify_certificate(scene, result.certificate).verdict == result.verdict
    if result.verdict == "path":
        assert in_goal(scene["goal"], result.path[-1].tolist())
        assert result.path[0].tolist() == scene["start"]
    return result


def in_goal(goal: Any, q: list[float]) -> bool:
    """Whether a configuration is in a goal that has polygons; by shapely, up to rounding."""
    point = shapely.Point(q[:2])
    if "escape" in goal:
        inside = shapely.from_geojson(shapely_text(goal["escape"])).buffer(-1e-9).contains(point)
        return not inside
    inside = bool(shapely.from_geojson(shapely_text(goal["region"])).buffer(1e-9).contains(point))
    angles = goal.get("theta", "any")
    if angles == "any":
        return inside
    middle, half = 0.5 * (angles[0] + angles[1]), 0.5 * (angles[1] - angles[0])
    return inside and abs(math.remainder(q[2] - middle, math.tau)) <= half + 1e-12


def shapely_text(geometry: dict[str, Any]) -> str:
    """Return GeoJSON with closed rings, as shapely wants them."""

    def closed(polygon: list[Any]) -> list[Any]:
        return [ring if ring[0] == ring[-1] else [*ring, ring[0]] for ring in polygon]

    if geometry["type"] == "Polygon":
        return json.dumps({"type": "Polygon", "coordinates": closed(geometry["coordinates"])})
    polygons = [closed(p) for p in geometry["coordinates"]]
    return json.dumps({"type": "MultiPolygon", "coordinates": polygons})


def moved(scene: Scene, angle: float, x: float, y: float) -> Scene:
    """Return a scene without a workspace, turned and moved as a whole; its bounds move along.

    The reference bounds become those of what they were, which is larger: a test has to have room.
    """
    c, s = math.cos(angle), math.sin(angle)
    matrix = [c, -s, s, c, x, y]

    def place(geometry: dict[str, Any]) -> dict[str, Any]:
        turned = affine_transform(shapely.from_geojson(shapely_text(geometry)), matrix)
        return dict(shapely.geometry.mapping(turned))

    def pose(q: list[float]) -> list[float]:
        return [c * q[0] - s * q[1] + x, s * q[0] + c * q[1] + y, q[2] + angle]

    low, high = scene["reference_bounds"][:2], scene["reference_bounds"][2:]
    corners = [pose([u, v, 0.0]) for u in (low[0], high[0]) for v in (low[1], high[1])]
    xs, ys = [q[0] for q in corners], [q[1] for q in corners]
    goal = dict(scene["goal"])
    for name in ("region", "escape"):
        if name in goal:
            goal[name] = place(goal[name])
    if goal.get("theta", "any") != "any":
        goal["theta"] = [a + angle for a in goal["theta"]]
    return {
        **scene,
        "reference_bounds": [min(xs), min(ys), max(xs), max(ys)],
        "obstacles": [place(o) for o in scene["obstacles"]],
        "start": pose(scene["start"]),
        "goal": goal,
    }
