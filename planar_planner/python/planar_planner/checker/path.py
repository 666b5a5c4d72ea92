"""Claims that a path is free: each pair of pieces has a separating edge along each motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import product
from typing import Any, NamedTuple

from planar_planner.checker.arithmetic import (
    BITS,
    ONE,
    WORK,
    Region,
    Rotation,
    Vector,
    _apart,
    _cross,
    _dot,
    _minus,
    _region,
    fixed,
    rotation,
)
from planar_planner.checker.case import Case, Edge, Pair, demand
from planar_planner.checker.goal_area import GoalArea

Waypoint = tuple[int, int, float, int]  # x, y, theta, turns


class Motion(NamedTuple):
    """The configurations (t + λ g, θ + λ ω), |λ| ≤ 1; t and g are rounded, by less than a unit."""

    t: Vector
    g: Vector
    rotation: Rotation  # by θ
    omega: int  # ω in 2^-BITS, off by at most 2
    most: int  # |ω| at most


def check_path(case: Case, content: Mapping[str, Any]) -> int:
    """Check that the waypoints lead from the start to the goal and all segments are free."""
    waypoints, segments = content["waypoints"], content["segments"]
    follow = len(waypoints) == len(segments) + 1 > 1
    demand(follow, "segments", "do not lead from waypoint to waypoint")
    demand(waypoints[0][3] == 0, "waypoints[0]", "has turns")
    ends = [(0, case.start)]
    if isinstance(case.goal, GoalArea):
        check_arrival(case.goal, waypoints[-1])
    else:
        ends.append((-1, case.goal))
    for k, (t, theta) in ends:
        way, tolerance = _minus(waypoints[k][:2], t), Fraction(content["contact_tolerance"])
        demand(_dot(way, way) <= (tolerance * ONE) ** 2, f"waypoints[{k}]", "is elsewhere")
        demand(waypoints[k][2] == theta, f"waypoints[{k}]", "has another theta")
    for i, (x, y, theta, turns) in enumerate(waypoints):
        demand(case.in_bounds((x, y)), f"waypoints[{i}]", "is outside reference_bounds")
        still = case.turning or (theta, turns) == (case.start[1], 0)
        demand(still, f"waypoints[{i}]", "turns a robot that may not turn")
    for i, intervals in enumerate(segments):
        parts = [0, *(interval["to"] for interval in intervals)]
        chained = parts == [*(interval["from"] for interval in intervals), ONE]
        demand(chained, f"segments[{i}]", "the intervals do not lead from 0 to 1")
        check_segment(case, f"segments[{i}]", waypoints[i : i + 2], intervals)
    return sum(len(interval["apart"]) for intervals in segments for interval in intervals)


def check_arrival(goal: GoalArea, waypoint: Waypoint) -> None:
    """Check that a path ends in the region; theta as the region writes it, with any turns."""
    x, y, theta, _ = waypoint
    demand(goal.holds((x, y)), "waypoints[-1]", "is outside the goal")
    turned = goal.angles is None or goal.angles[0] <= theta <= goal.angles[1]
    demand(turned, "waypoints[-1]", "has a theta that is no goal's")


def check_segment(case: Case, place: str, ends: list[Waypoint], intervals: list[Any]) -> None:
    """Check that on every interval the robot is inside the walls and apart from every obstacle."""
    everywhere = swept(case.outline, make_motion(ends, 0, ONE))
    near = {q: _region(polygon[0]) for q, polygon in case.polygons["obstacle"].items()}
    near = {q: region for q, region in near.items() if not _apart(everywhere, region)}
    for i, interval in enumerate(intervals):
        motion = make_motion(ends, interval["from"], interval["to"])
        for wall, edge in case.walls.items():
            inside = all(not_negative(edge, v, motion) for v in case.outline)
            demand(inside, f"{place}[{i}], {wall}", "the robot may be beyond the wall")
        for k, apart in enumerate(interval["apart"]):
            at = f"{place}[{i}].apart[{k}]"
            edge, vertices = case.edge(at, apart[:4], apart[4:])
            separates = all(not_negative(edge, v, motion) for v in vertices)
            demand(separates, at, "the edge may not separate the pair")
        check_all_apart(
            case, f"{place}[{i}]", motion, near, {apart[:4] for apart in interval["apart"]}
        )


def check_all_apart(
    case: Case, place: str, motion: Motion, near: dict[str, Region], listed: set[Pair]
) -> None:
    """Check that polygons are apart by bounding boxes, or their pieces by those or as listed."""
    for p, polygon in case.polygons["robot"].items():
        body = swept(polygon[0], motion)
        close = [q for q, region in near.items() if not _apart(body, region)]
        robot = case.pieces["robot"].get(p, []) if close else []
        boxes = [swept(piece.vertices, motion) for piece in robot]
        for q in close:
            obstacle = case.pieces["obstacle"].get(q, [])
            demand(bool(robot and obstacle), f"{place}, polygons {p} and {q}", "have no pieces")
            for (i, box), (j, piece) in product(enumerate(boxes), enumerate(obstacle)):
                apart = _apart(box, piece.region) or (int(p), i, int(q), j) in listed
                demand(apart, f"{place}, pair {[p, i, q, j]}", "is not shown to be apart")


def make_motion(ends: list[Waypoint], first: int, last: int) -> Motion:
    """Return the part of a straight motion from parameter first to last, both in units."""
    (ax, ay, a_theta, a_turns), (bx, by, b_theta, b_turns) = ends
    s, h = Fraction(first + last, 2 * ONE), Fraction(last - first, 2 * ONE)
    radians, turns = Fraction(b_theta) - Fraction(a_theta), b_turns - a_turns
    t = ax + math.floor(s * (bx - ax)), ay + math.floor(s * (by - ay))
    g = math.floor(h * (bx - ax)), math.floor(h * (by - ay))
    omega = fixed(h * radians, h * turns) >> (WORK - BITS)
    turned = rotation(Fraction(a_theta) + s * radians, a_turns + s * turns)
    return Motion(t, g, turned, omega, abs(omega) + 2)


def swept(vertices: Iterable[Vector], motion: Motion) -> Region:
    """Return a box that holds the vertices during a motion."""
    (tx, ty), (gx, gy), (c, s), _, most = motion
    corners = []
    for x, y in vertices:
        u, v, e = x * c - y * s, x * s + y * c, (abs(x) + abs(y)) * (most + 1)
        corners += [(u - e, v - e), (u + e, v + e)]
    xmin, ymin, xmax, ymax = (side >> BITS for side in _region(corners))
    gx, gy = abs(gx) + 3, abs(gy) + 3  # for what is rounded
    return xmin + tx - gx, ymin + ty - gy, xmax + tx + gx, ymax + ty + gy


def not_negative(edge: Edge, vertex: Vector, motion: Motion) -> bool:
    """Prove that the edge's function, for the vertex, is at least 0 during the motion.

    With v and w its sinusoid's value and derivative at θ and the slope of the translation it is at
    least C + v − |slope + w ω| − max(v, 0) ω²/2 − |w| |ω|³/6; for an edge of the robot less what
    turning changes about the slope.
    """
    t, g, (c, s), omega, most = motion
    D, E, C = edge.term(vertex, t)
    v, w, error = D * c + E * s, E * c - D * s, abs(D) + abs(E)
    G, H = _dot(edge.normal, g), _cross(edge.normal, g)
    slope, spare = G << BITS, 4 * sum(map(abs, edge.normal)) << BITS  # t and g are rounded
    if not edge.obstacle:
        slope, off = -(G * c + H * s), abs(G) + abs(H)
        spare += off + ((abs(slope) + off) * most**2 >> 2 * BITS + 1)
        spare += (abs(H * c - G * s) + off) * most >> BITS
    spare += (max(v, 0) + error) * most**2 >> 2 * BITS + 1
    spare += (abs(w) + error) * most**3 // (6 << 3 * BITS)
    spare += error * ((most >> BITS) + 5) + 9  # v, w, ω and the divisions are rounded
    return (C << BITS) + v - abs(slope + (w * omega >> BITS)) >= spare
