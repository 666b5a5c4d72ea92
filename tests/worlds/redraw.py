"""Other ways to draw the same scene: what is free does not change, nor is any number rounded."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import shapely

from worlds.maps import Point, box_polygon, double
from worlds.scene import Scene

Ring = list[list[float]]
Redraw = Callable[[Scene, random.Random], Scene]


def polygons(geometry: dict[str, Any]) -> list[list[Ring]]:
    """Return the polygons of a Polygon or MultiPolygon as lists of rings."""
    coordinates = geometry["coordinates"]
    return [coordinates] if geometry["type"] == "Polygon" else list(coordinates)


def geometry(parts: list[list[Ring]]) -> dict[str, Any]:
    """Return polygons as one geometry."""
    if len(parts) == 1:
        return {"type": "Polygon", "coordinates": parts[0]}
    return {"type": "MultiPolygon", "coordinates": parts}


def is_closed(ring: Ring) -> bool:
    """Whether the first vertex is repeated at the end, as GeoJSON writes it."""
    return ring[0] == ring[-1]


def open_ring(ring: Ring) -> Ring:
    """Return a ring without the repeated first vertex."""
    return ring[:-1] if is_closed(ring) else ring


def _shapes(scene: Scene) -> Iterator[dict[str, Any]]:
    yield scene["robot"]
    yield from scene["obstacles"]
    if "coordinates" in (scene.get("workspace") or {}):
        yield scene["workspace"]


def _each_ring(scene: Scene, change: Callable[[Ring], Ring]) -> Scene:
    out = copy.deepcopy(scene)
    for shape in _shapes(out):
        done = [[change(open_ring(ring)) for ring in part] for part in polygons(shape)]
        shape.update(geometry(done))
    return out


def shuffled(scene: Scene, rng: random.Random) -> Scene:
    """Start rings elsewhere, some the other way; reorder holes, parts and obstacles."""

    def redrawn(ring: Ring) -> Ring:
        first = rng.randrange(len(ring))
        ring = ring[first:] + ring[:first]
        if rng.random() < 0.5:
            ring.reverse()
        return [*ring, ring[0]] if rng.random() < 0.5 else ring

    out = _each_ring(scene, redrawn)
    for shape in _shapes(out):
        parts = polygons(shape)
        for part in parts:
            part[1:] = rng.sample(part[1:], len(part) - 1)
        shape.update(geometry(rng.sample(parts, len(parts))))
    out["obstacles"] = rng.sample(out["obstacles"], len(out["obstacles"]))
    return out


def _between(a: list[float], b: list[float], eighths: int) -> list[float]:
    """Return the point of an edge, exact; raise if it is no pair of doubles."""
    share = Fraction(eighths, 8)
    return [
        double(Fraction(p) + share * (Fraction(q) - Fraction(p))) for p, q in zip(a, b, strict=True)
    ]


def with_collinear(scene: Scene, rng: random.Random) -> Scene:
    """Add vertices in the middle of edges."""

    def redrawn(ring: Ring) -> Ring:
        out: Ring = []
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            cuts = sorted(rng.sample(range(1, 8), rng.randrange(4)))
            out += [a, *(_between(a, b, cut) for cut in cuts)]
        return out

    return _each_ring(scene, redrawn)


def with_duplicates(scene: Scene, rng: random.Random) -> Scene:
    """Repeat vertices, up to three times running."""
    return _each_ring(
        scene, lambda ring: [list(p) for p in ring for _ in range(rng.choice((1, 1, 2, 3)))]
    )


def _triangles(part: list[Ring]) -> list[Ring]:
    """Cut a polygon along diagonals: no new vertex, so the triangles' union is the polygon."""
    shape = shapely.Polygon(part[0], part[1:])
    cut = shapely.constrained_delaunay_triangles(shape)
    return [[list(p) for p in triangle.exterior.coords[:-1]] for triangle in cut.geoms]


def _quartered(triangle: Ring) -> list[Ring]:
    a, b, c = triangle
    d, e, f = _between(b, c, 4), _between(c, a, 4), _between(a, b, 4)
    return [[a, f, e], [f, b, d], [e, d, c], [d, e, f]]


def obstacles_cut(scene: Scene, rng: random.Random) -> Scene:
    """Cut obstacles into triangles, each an obstacle or a part of a multi-polygon."""
    out = copy.deepcopy(scene)
    obstacles: list[dict[str, Any]] = []
    for shape in out["obstacles"]:
        cut = [[triangle] for part in polygons(shape) for triangle in _triangles(part)]
        if rng.random() < 0.5:
            obstacles += [geometry([part]) for part in cut]
        else:
            obstacles.append(geometry(cut))
    out["obstacles"] = rng.sample(obstacles, len(obstacles))
    return out


def obstacles_cut_fine(scene: Scene, rng: random.Random) -> Scene:
    """Cut obstacles into triangles, those into quarters; repeat some obstacles as a whole."""
    out = copy.deepcopy(scene)
    obstacles = [
        geometry([[quarter]])
        for shape in scene["obstacles"]
        for part in polygons(shape)
        for triangle in _triangles(part)
        for quarter in _quartered(triangle)
    ]
    obstacles += [shape for shape in scene["obstacles"] if rng.random() < 0.3]
    out["obstacles"] = rng.sample(obstacles, len(obstacles))
    return out


def robot_cut(scene: Scene, rng: random.Random) -> Scene:
    """Cut the robot into triangles: without their sides its interior meets the same obstacles."""
    out = copy.deepcopy(scene)
    cut = [[triangle] for part in polygons(scene["robot"]) for triangle in _triangles(part)]
    out["robot"] = geometry(rng.sample(cut, len(cut)))
    return out


def walls_drawn(scene: Scene, _rng: random.Random) -> Scene:
    """Draw a workspace's box as an obstacle with a hole, thicker than the robot is."""
    out = copy.deepcopy(scene)
    room = scene.get("workspace") or {}
    if "box" not in room:
        return out
    x0, y0, x1, y1 = room["box"]
    vertices: list[Point] = [
        (Fraction(x), Fraction(y))
        for part in polygons(scene["robot"])
        for ring in part
        for x, y in ring
    ]
    reach = max(abs(v) for vertex in vertices for v in vertex)
    thick = 2.0
    while thick < 4 * reach:
        thick *= 2.0
    grown = [
        double(Fraction(v) + sign * Fraction(thick))
        for v, sign in zip((x0, y0, x1, y1), (-1, -1, 1, 1), strict=True)
    ]
    frame = [box_polygon(b)["coordinates"][0] for b in (grown, [x0, y0, x1, y1])]
    out["workspace"] = {"box": grown}
    out["obstacles"].append({"type": "Polygon", "coordinates": frame})
    return out
