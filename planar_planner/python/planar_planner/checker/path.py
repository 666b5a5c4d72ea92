"""Claims that a path is free: on each interval every pair of polygons is apart.

docs/certificate.md, "Verdict path". The last functions here are its bounds that hold all along a
motion: bounding boxes, obstacle edges, robot edges.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from itertools import product
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import (
    ANGLE_BITS,
    ONE,
    ROTATION_BITS,
    Rectangle,
    Rotation,
    Vector,
    angle_units,
    bounding_box,
    cross,
    dot,
    interiors_apart,
    minus,
    quarter_turned,
    rotation,
)
from planar_planner.checker.case import Case, Pose
from planar_planner.checker.demands import demand
from planar_planner.checker.goal_area import GoalArea
from planar_planner.checker.pieces import Edge
from planar_planner.checker.records import (
    Interval,
    PairName,
    PathProof,
    SeparatingLine,
    Waypoint,
)
from planar_planner.errors import CertificateRejected


class Motion(NamedTuple):
    """The configurations (t + λ g, θ + λ ω), |λ| ≤ 1; t and g are rounded, by less than a unit."""

    middle: Vector  # t
    half_way: Vector  # g
    rotation: Rotation  # by θ
    half_turn: int  # ω in units of 2^-ROTATION_BITS, off by at most 2

    def most_turn(self) -> int:
        """Return an upper bound of |ω|."""
        return abs(self.half_turn) + 2


class ExactMotion(NamedTuple):
    """A translation of the robot at a quarter turn."""

    a: Vector
    b: Vector
    quarters: int


def check_path(case: Case, proof: PathProof) -> int:
    """Check that the waypoints lead from start to goal and that all segments are free.

    Returns the number of separating edges that were checked.
    """
    waypoints, segments = proof.waypoints, proof.segments
    follow = len(waypoints) == len(segments) + 1 > 1
    demand(follow, keys.SEGMENTS, "do not lead from waypoint to waypoint")
    check_path_ends(case, proof)
    for i, waypoint in enumerate(waypoints):
        place = f"{keys.WAYPOINTS}[{i}]"
        inside = case.in_bounds((waypoint.x, waypoint.y))
        demand(inside, place, "is outside reference_bounds")
        still = case.turning or waypoint.angle == case.start.angle
        demand(still, place, "turns a robot that may not turn")
    for i, intervals in enumerate(segments):
        place = f"{keys.SEGMENTS}[{i}]"
        parts = [0, *(interval.end for interval in intervals)]
        chained = parts == [*(interval.begin for interval in intervals), ONE]
        demand(chained, place, "the intervals do not lead from 0 to 1")
        check_segment(case, place, (waypoints[i], waypoints[i + 1]), intervals)
    return sum(
        len(interval.apart) + len(interval.along)
        for intervals in segments
        for interval in intervals
    )


def check_path_ends(case: Case, proof: PathProof) -> None:
    """Check that the first waypoint is the start, and the last one the goal or one of a region."""
    first, last = proof.waypoints[0], proof.waypoints[-1]
    demand(first.turns == 0, f"{keys.WAYPOINTS}[0]", "has turns")
    tolerance = Fraction(proof.contact_tolerance) * 10**case.decimal_places
    check_end_pose(f"{keys.WAYPOINTS}[0]", first, case.start, tolerance)
    place = f"{keys.WAYPOINTS}[-1]"
    if isinstance(case.goal, GoalArea):
        check_arrival(place, last, case.goal)
    else:
        check_end_pose(place, last, case.goal, tolerance)


def check_end_pose(place: str, waypoint: Waypoint, pose: Pose, tolerance: Fraction) -> None:
    """Check that a waypoint is a configuration, up to a translation and whole turns."""
    way = minus((waypoint.x, waypoint.y), pose.translation)
    demand(dot(way, way) <= (tolerance * ONE) ** 2, place, "is elsewhere")
    demand(waypoint.angle.is_same_but_turns(pose.angle), place, "has another theta")


def check_arrival(place: str, waypoint: Waypoint, goal: GoalArea) -> None:
    """Check that a path ends in the region; theta as the region writes it, with any turns."""
    demand(goal.holds((waypoint.x, waypoint.y)), place, "is outside the goal")
    turned = goal.angles is None or goal.angles[0] <= waypoint.theta <= goal.angles[1]
    demand(turned, place, "has a theta that is no goal's")


def check_segment(
    case: Case, place: str, ends: tuple[Waypoint, Waypoint], intervals: list[Interval]
) -> None:
    """Check that on every interval the robot is inside the walls and apart from every obstacle."""
    exact = exact_motion(*ends)
    everywhere = swept_box(case.outline, make_motion(*ends, 0, ONE))
    boxes = {q: bounding_box(polygon[0]) for q, polygon in case.obstacles.items()}
    near = {q: box for q, box in boxes.items() if not interiors_apart(everywhere, box)}
    for i, interval in enumerate(intervals):
        case.deadline.check()
        motion = make_motion(*ends, interval.begin, interval.end)
        for wall, edge in case.walls.items():
            inside = all(
                stays_outside(edge, vertex, motion) or is_outside(edge, vertex, exact)
                for vertex in case.outline
            )
            demand(inside, f"{place}[{i}], {wall}", "the robot may be beyond the wall")
        for k, separator in enumerate(interval.apart):
            own = f"{place}[{i}].{keys.APART}[{k}]"
            edge, vertices = case.pieces.edge(own, separator.pair, separator.edge)
            separates = all(stays_outside(edge, vertex, motion) for vertex in vertices)
            touches = all(is_outside(edge, vertex, exact) for vertex in vertices)
            demand(separates or touches, own, "the edge may not separate the pair")
        for k, line in enumerate(interval.along):
            check_line(case, f"{place}[{i}].{keys.ALONG}[{k}]", line, exact)
        separated = {separator.pair for separator in interval.apart}
        separated |= {line.pair for line in interval.along}
        check_all_apart(case, f"{place}[{i}]", motion, near, separated)


def exact_motion(a: Waypoint, b: Waypoint) -> ExactMotion | None:
    """Return a motion at a quarter turn, exactly; None of another."""
    quarters = a.angle.quarters
    if quarters is None or a.angle != b.angle:
        return None
    return ExactMotion((a.x, a.y), (b.x, b.y), quarters)


def is_outside(edge: Edge, vertex: Vector, motion: ExactMotion | None) -> bool:
    """Whether the edge's function at a quarter turn, for the vertex, is at least 0, exactly.

    It is linear in the translation: at least 0 at both ends of a motion, and so all along it.
    """
    if motion is None:
        return False
    c, s = quarter_turned((1, 0), motion.quarters)
    functions = [edge.sinusoid(vertex, translation) for translation in (motion.a, motion.b)]
    return all(C + D * c + E * s >= 0 for C, D, E in functions)


def check_line(case: Case, place: str, line: SeparatingLine, motion: ExactMotion | None) -> None:
    """Check that a segment's line has a pair's convex sum on one side: the segment misses it."""
    if motion is None or motion.a == motion.b:
        raise CertificateRejected(place, "the segment turns, or has no direction")
    robot, obstacle = case.pieces.pair(place, line.pair)
    turned = [quarter_turned(r, motion.quarters) for r in robot.vertices]
    a, b = motion.a, motion.b
    way = minus(b, a) if line.side == keys.LEFT else minus(a, b)
    beside = all(cross(way, minus(minus(o, r), a)) >= 0 for o in obstacle.vertices for r in turned)
    demand(beside, place, "the segment's line may not separate the pair")


def check_all_apart(
    case: Case,
    place: str,
    motion: Motion,
    near: dict[str, Rectangle],
    separated: set[PairName],
) -> None:
    """Check that all polygons are apart: by their boxes, or piece by piece by those or an edge.

    `near` has the bounding boxes of the obstacle polygons that are not apart by them all along the
    segment.
    """
    for p, polygon in case.robot.items():
        body = swept_box(polygon[0], motion)
        close = [q for q, box in near.items() if not interiors_apart(body, box)]
        robot = case.pieces.robot.get(p, []) if close else []
        swept = [swept_box(piece.vertices, motion) for piece in robot]
        for q in close:
            obstacle = case.pieces.obstacle.get(q, [])
            demand(bool(robot and obstacle), f"{place}, polygons {p} and {q}", "have no pieces")
            for (i, box), (j, piece) in product(enumerate(swept), enumerate(obstacle)):
                apart = interiors_apart(box, piece.box) or (int(p), i, int(q), j) in separated
                demand(apart, f"{place}, pair {[p, i, q, j]}", "is not shown to be apart")


def make_motion(a: Waypoint, b: Waypoint, begin: int, end: int) -> Motion:
    """Return the part of a straight motion from parameter begin to end, both in units."""
    s, h = Fraction(begin + end, 2 * ONE), Fraction(end - begin, 2 * ONE)
    radians, turns = b.angle.radians - a.angle.radians, b.angle.turns - a.angle.turns
    middle = a.x + math.floor(s * (b.x - a.x)), a.y + math.floor(s * (b.y - a.y))
    half_way = math.floor(h * (b.x - a.x)), math.floor(h * (b.y - a.y))
    half_turn = angle_units(h * radians, h * turns) >> (ANGLE_BITS - ROTATION_BITS)
    turned = rotation(a.angle.radians + s * radians, a.angle.turns + s * turns)
    return Motion(middle, half_way, turned, half_turn)


def swept_box(vertices: Iterable[Vector], motion: Motion) -> Rectangle:
    """Return a box that holds the vertices during a motion.

    A vertex a stays within its place in the middle ± (|g| + |a| |ω|) along either axis, and within
    ± (|g + ω (R a)^⊥| + |a| ω²/2): the better of both counts.
    """
    (tx, ty), (gx, gy), (c, s), omega = motion
    most = motion.most_turn()
    corners = []
    for x, y in vertices:
        u, v, length = x * c - y * s, x * s + y * c, abs(x) + abs(y)
        alone = length * most
        # Beside ω²/2: u and v are off by the length, ω is by 2, the shifts by 1 each.
        second = (length * most**2 >> ROTATION_BITS + 1) + (alone >> ROTATION_BITS) + 2 * length + 4
        dx, dy = (
            min((abs(g) << ROTATION_BITS) + alone, abs((g << ROTATION_BITS) + turn) + second)
            for g, turn in (
                (gx, -(v * omega >> ROTATION_BITS)),
                (gy, u * omega >> ROTATION_BITS),
            )
        )
        corners += [(u - dx - length, v - dy - length), (u + dx + length, v + dy + length)]
    xmin, ymin, xmax, ymax = (side >> ROTATION_BITS for side in bounding_box(corners))
    return xmin + tx - 3, ymin + ty - 3, xmax + tx + 3, ymax + ty + 3  # for t, g and the shift


def stays_outside(edge: Edge, vertex: Vector, motion: Motion) -> bool:
    """Prove that the edge's function, for the vertex, is at least 0 during the motion.

    With v and w its sinusoid's value and derivative at θ and the slope of the translation it is at
    least C + v − |slope + w ω| − max(v, 0) ω²/2 − |w| |ω|³/6; for an edge of the robot less what
    turning changes about the slope.
    """
    t, g, (c, s), omega = motion
    most = motion.most_turn()
    C, D, E = edge.sinusoid(vertex, t)
    v, w, error = D * c + E * s, E * c - D * s, abs(D) + abs(E)
    G, H = dot(edge.normal, g), cross(edge.normal, g)
    slope, spare = G << ROTATION_BITS, 4 * sum(map(abs, edge.normal)) << ROTATION_BITS  # t, g
    if not edge.of_obstacle:
        slope, off = -(G * c + H * s), abs(G) + abs(H)
        spare += off + ((abs(slope) + off) * most**2 >> 2 * ROTATION_BITS + 1)
        spare += (abs(H * c - G * s) + off) * most >> ROTATION_BITS
    spare += (max(v, 0) + error) * most**2 >> 2 * ROTATION_BITS + 1
    spare += (abs(w) + error) * most**3 // (6 << 3 * ROTATION_BITS)
    spare += error * ((most >> ROTATION_BITS) + 5) + 9  # v, w, ω and the divisions are rounded
    return (C << ROTATION_BITS) + v - abs(slope + (w * omega >> ROTATION_BITS)) >= spare
