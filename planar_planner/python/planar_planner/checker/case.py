"""A certificate's case: the pieces, axes and normals it names, checked to be what they claim."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, pairwise
from typing import Any, NamedTuple

from planar_planner.checker.arithmetic import (
    ONE,
    Region,
    Vector,
    _cross,
    _dot,
    _minus,
    _region,
    _sides,
)
from planar_planner.checker.form import units
from planar_planner.checker.goal_area import GoalArea
from planar_planner.errors import CertificateRejected
from planar_planner.problem.goal import GoalRegion
from planar_planner.problem.make import Polygons, Problem

NORMALS = {"x_min": (ONE, 0), "x_max": (-ONE, 0), "y_min": (0, ONE), "y_max": (0, -ONE)}  # of walls


OTHER = {"robot": "obstacle", "obstacle": "robot"}


Polygon = list[list[Vector]]  # rings with the interior on the left: outer one, holes


Pose = tuple[Vector, float]  # translation, theta


Pair = tuple[int, int, int, int]  # p, i, q, j


Axis = tuple[str, int]  # an edge of a pair: owner and number


def demand(holds: bool, place: str, problem: str) -> None:
    """Reject the certificate unless a claim holds."""
    if not holds:
        raise CertificateRejected(place, problem)


class Edge(NamedTuple):
    """An edge of an obstacle or of the robot; a wall is an edge of an obstacle."""

    base: Vector  # its first vertex
    normal: Vector  # outward
    obstacle: bool

    def value(self, t: Vector) -> int:
        """Return n · (t − base)."""
        return _dot(self.normal, _minus(t, self.base))

    def term(self, v: Vector, t: Vector) -> tuple[int, int, int]:
        """Return D, E, C of its separating-axis function for one vertex, at translation t."""
        n = self.normal
        if self.obstacle:  # n · R v + n · (t − base)
            return _dot(n, v), _cross(v, n), self.value(t)
        u = _minus(v, t)  # R n · (v − t) − n · base
        return _dot(n, u), _cross(n, u), -_dot(n, self.base)


class Piece(NamedTuple):
    """A convex polygon."""

    vertices: list[Vector]
    edges: list[Edge]
    region: Region  # bounding box


def find(place: str, things: Any, *names: Any) -> Any:
    """Return what a certificate names."""
    try:
        for name in names:
            things = things[name]
    except LookupError:
        raise CertificateRejected(place, f"names what is not there: {names}") from None
    return things


@dataclass
class Case:
    """The scene in integers, and the certificate's pieces."""

    polygons: dict[str, dict[str, Polygon]]  # by owner and number
    walls: dict[str, Edge]
    bounds: dict[str, Edge]  # of the reference point
    turning: bool
    start: Pose
    goal: Pose | GoalArea
    pieces: dict[str, dict[str, list[Piece]]]

    def pair(self, place: str, pair: Pair) -> dict[str, Piece]:
        """Return the pieces that a pair names."""
        names = zip(OTHER, (pair[:2], pair[2:]), strict=True)
        return {owner: find(place, self.pieces[owner], str(n), i) for owner, (n, i) in names}

    def edge(self, place: str, pair: Pair, choice: Axis) -> tuple[Edge, list[Vector]]:
        """Return an edge of one piece of a pair, and the vertices of the other."""
        pieces, (owner, number) = self.pair(place, pair), choice
        return find(place, pieces[owner].edges, number), pieces[OTHER[owner]].vertices

    def in_bounds(self, t: Vector) -> bool:
        """Whether the reference point is within its bounds."""
        return all(edge.value(t) >= 0 for edge in self.bounds.values())

    @cached_property
    def outline(self) -> list[Vector]:
        """Vertices of the robot; its holes do not count."""
        return [v for polygon in self.polygons["robot"].values() for v in polygon[0]]


def make_case(problem: Problem, content: Mapping[str, Any]) -> Case:
    """Turn the scene's doubles into integers, orient its rings, number what lies outside."""

    def polygons(shapes: Polygons | None) -> Iterator[Polygon]:
        if shapes is None:
            return
        points = [(units(x), units(y)) for x, y in shapes.coords.tolist()]
        rings = [points[a:b] for a, b in pairwise(shapes.ring_starts.tolist())]
        for first, end in pairwise(shapes.polygon_starts.tolist()):
            left = [sum(_cross(a, b) for a, b in _sides(ring)) > 0 for ring in rings[first:end]]
            yield [r if left[k] == (k == 0) else r[::-1] for k, r in enumerate(rings[first:end])]

    def edges(box: Any) -> dict[str, Edge]:
        corners = {"min": box[:2], "max": box[2:]} if box else {}
        return {w: Edge(corners[w[2:]], n, True) for w, n in NORMALS.items() if box}

    boxes = problem.workspace_box, problem.reference_bounds
    walls, bounds = (box and tuple(map(units, box)) for box in boxes)
    obstacles = list(polygons(problem.obstacles))
    for outer, *holes in polygons(problem.workspace):
        walls = _region(outer)
        xmin, ymin, xmax, ymax = outside = content.get("outside", walls)
        frame = [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]
        larger = all(map(int.__lt__, outside[:2] + walls[2:], walls[:2] + outside[2:]))
        demand(larger, "outside", "does not hold the workspace in its interior")
        obstacles += [[frame, outer[::-1]], *([hole[::-1]] for hole in holes)]

    def pose(x: float, y: float, theta: float) -> Pose:
        return (units(x), units(y)), theta

    goal: Pose | GoalArea
    if isinstance(problem.goal, GoalRegion):
        angles = problem.goal.angles if problem.rotation else None
        goal = GoalArea(list(polygons(problem.goal.polygons)), angles)
    else:
        goal = pose(*problem.goal)
    owned = {"robot": polygons(problem.robot), "obstacle": obstacles}
    numbered = {o: {str(i): shape for i, shape in enumerate(of)} for o, of in owned.items()}
    pieces: Any = {owner: {} for owner in OTHER}
    start = pose(*problem.start)
    return Case(numbered, edges(walls), edges(bounds), problem.rotation, start, goal, pieces)


def check_pieces(case: Case, content: Mapping[str, Any]) -> None:
    """Check that the pieces of a polygon are convex and partition it."""
    for owner, polygons in case.polygons.items():
        for number, pieces in content[f"{owner}_pieces"].items():
            place = f"{owner}_pieces.{number}"
            check_partition(place, find(place, polygons, number), pieces)
            case.pieces[owner][number] = [
                convex_piece(f"{place}[{i}]", piece, owner == "obstacle")
                for i, piece in enumerate(pieces)
            ]


def convex_piece(place: str, vertices: list[Vector], obstacle: bool) -> Piece:
    """Return a piece, having checked that it turns left only, and once round."""
    sides = [_minus(b, a) for a, b in _sides(vertices)]
    upper = [y > 0 or (y == 0 and x > 0) for x, y in sides]
    left = all(_cross(a, b) > 0 or (_cross(a, b) == 0 < _dot(a, b)) for a, b in _sides(sides))
    once = sum(b and not a for a, b in _sides(upper)) == 1
    demand(left and once, place, "is not convex, counter-clockwise")
    edges = [Edge(a, (dy, -dx), obstacle) for a, (dx, dy) in zip(vertices, sides, strict=True)]
    return Piece(vertices, edges, _region(vertices))


def check_partition(place: str, polygon: Polygon, pieces: list[list[Vector]]) -> None:
    """Check that the boundaries of the pieces add up to the polygon's, on every line."""
    # A directed segment from a to b makes the sum over its line jump by +1 at a and −1 at b, either
    # way it runs; and a sum that is zero far out is zero if its jumps cancel.
    jumps: dict[Any, int] = defaultdict(int)
    for sign, rings in ((1, pieces), (-1, polygon)):
        for a, b in chain.from_iterable(map(_sides, rings)):
            dx, dy = _minus(b, a)
            scale = math.gcd(dx, dy) * (1 if (dx, dy) > (0, 0) else -1) or 1
            line = dx // scale, dy // scale, _cross((dx // scale, dy // scale), a)
            jumps[line, a] += sign
            jumps[line, b] -= sign
    demand(not any(jumps.values()), place, "the pieces do not partition the polygon")
