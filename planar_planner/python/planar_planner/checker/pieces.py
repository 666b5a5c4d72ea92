"""Convex pieces and their edges (docs/certificate.md, "Legitimate pieces", "Separating axes")."""

from __future__ import annotations

import math
from collections import defaultdict
from itertools import chain
from typing import Any, NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import (
    Polygon,
    Rectangle,
    Ring,
    Vector,
    bounding_box,
    cross,
    cyclic_pairs,
    dot,
    minus,
)
from planar_planner.checker.demands import demand, find
from planar_planner.checker.records import EdgeName, PairName
from planar_planner.checker.records import Pieces as PieceLists

Sinusoid = tuple[int, int, int]
"""C, D, E of the function C + D cos θ + E sin θ."""


class Edge(NamedTuple):
    """An edge of an obstacle or of the robot; a wall is an edge of an obstacle."""

    base: Vector  # its first vertex
    normal: Vector  # outward
    of_obstacle: bool

    def height(self, point: Vector) -> int:
        """Return n · (point − base)."""
        return dot(self.normal, minus(point, self.base))

    def sinusoid(self, vertex: Vector, translation: Vector) -> Sinusoid:
        """Return the separating-axis function's value for one vertex of the other piece."""
        n = self.normal
        if self.of_obstacle:  # n · R v + n · (t − base)
            return self.height(translation), dot(n, vertex), cross(vertex, n)
        u = minus(vertex, translation)  # R n · (v − t) − n · base
        return -dot(n, self.base), dot(n, u), cross(n, u)


class Piece(NamedTuple):
    """A convex polygon."""

    vertices: Ring  # counter-clockwise
    edges: list[Edge]
    box: Rectangle  # the least that holds it


class Pieces(NamedTuple):
    """The pieces of robot and obstacles, by the numbers of their polygons."""

    robot: dict[str, list[Piece]]
    obstacle: dict[str, list[Piece]]

    def pair(self, place: str, pair: PairName) -> tuple[Piece, Piece]:
        """Return the pieces of robot and obstacle that a pair names."""
        p, i, q, j = pair
        robot: Piece = find(place, self.robot, str(p), i)
        obstacle: Piece = find(place, self.obstacle, str(q), j)
        return robot, obstacle

    def edge(self, place: str, pair: PairName, name: EdgeName) -> tuple[Edge, Ring]:
        """Return an edge of one piece of a pair, and the vertices of the other."""
        robot, obstacle = self.pair(place, pair)
        owner, number = name
        own, other = (robot, obstacle) if owner == keys.ROBOT else (obstacle, robot)
        edge: Edge = find(place, own.edges, number)
        return edge, other.vertices


def checked_pieces(
    place: str, polygons: dict[str, Polygon], listed: PieceLists, *, of_obstacle: bool
) -> dict[str, list[Piece]]:
    """Return the pieces listed, having checked that they are convex and partition their polygon."""
    checked = {}
    for number, pieces in listed.items():
        own = f"{place}.{number}"
        check_partition(own, find(own, polygons, number), pieces)
        checked[number] = [
            convex_piece(f"{own}[{i}]", piece, of_obstacle=of_obstacle)
            for i, piece in enumerate(pieces)
        ]
    return checked


def convex_piece(place: str, vertices: Ring, *, of_obstacle: bool) -> Piece:
    """Return a piece, having checked that it turns left only, and once round."""
    sides = [minus(b, a) for a, b in cyclic_pairs(vertices)]
    upper = [y > 0 or (y == 0 and x > 0) for x, y in sides]
    left = all(cross(a, b) > 0 or (cross(a, b) == 0 < dot(a, b)) for a, b in cyclic_pairs(sides))
    once = sum(b and not a for a, b in cyclic_pairs(upper)) == 1
    demand(left and once, place, "is not convex, counter-clockwise")
    edges = [Edge(a, (dy, -dx), of_obstacle) for a, (dx, dy) in zip(vertices, sides, strict=True)]
    return Piece(vertices, edges, bounding_box(vertices))


def check_partition(place: str, polygon: Polygon, pieces: list[Ring]) -> None:
    """Check that the boundaries of the pieces add up to the polygon's, on every line.

    A directed segment from a to b makes the sum over its line jump by +1 at a and by −1 at b,
    whichever way it runs. A sum that is zero far out is zero everywhere if its jumps cancel.
    """
    jumps: dict[Any, int] = defaultdict(int)
    for sign, rings in ((1, pieces), (-1, polygon)):
        for a, b in chain.from_iterable(map(cyclic_pairs, rings)):
            dx, dy = minus(b, a)
            scale = math.gcd(dx, dy) * (1 if (dx, dy) > (0, 0) else -1) or 1
            direction = dx // scale, dy // scale
            line = *direction, cross(direction, a)
            jumps[line, a] += sign
            jumps[line, b] -= sign
    demand(not any(jumps.values()), place, "the pieces do not partition the polygon")
