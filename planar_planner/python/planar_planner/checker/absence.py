"""Claims that a disc has no path, that a chain separates the ends, that an end is not free.

docs/certificate.md, "disc", "odd_chain" and "end". The disc is inside the robot. The chain is
closed, and of convex sets of translations that are not free; its numbers are integers or fractions.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import (
    ONE,
    Angle,
    Ring,
    Vector,
    cyclic_pairs,
    dot,
    minus,
    quarter_turned,
)
from planar_planner.checker.case import Case
from planar_planner.checker.collisions import check_full
from planar_planner.checker.demands import demand, find
from planar_planner.checker.extents import Extent
from planar_planner.checker.form import MAX_LENGTH
from planar_planner.checker.goal_area import GoalArea
from planar_planner.checker.pieces import Piece, convex_piece
from planar_planner.checker.records import ChainLink, ChainProof, DiscProof, EndProof
from planar_planner.checker.separation import check_separation
from planar_planner.errors import CertificateRejected

Number = int | Fraction
Point = tuple[Number, Number]

_FAR = ONE * MAX_LENGTH * 16
NO_TURN = Angle(Fraction(), Fraction())
FAR: list[Point] = [(-_FAR, -_FAR), (_FAR, -_FAR), (_FAR, _FAR), (-_FAR, _FAR)]
"""A square that holds every translation that matters in its interior."""


class HalfPlane(NamedTuple):
    """The points p with normal · p > offset."""

    normal: Point
    offset: Number

    def height(self, point: Point) -> Number:
        """Return normal · point − offset."""
        return self.normal[0] * point[0] + self.normal[1] * point[1] - self.offset


class OpenSet(NamedTuple):
    """The interior of a convex polygon."""

    sides: list[HalfPlane]
    corners: Sequence[Point]


def check_disc(case: Case, proof: DiscProof) -> int:
    """Check that a disc inside the robot, in place of it, has no path."""
    polygon, number = proof.inside
    holder: Piece = find(keys.INSIDE, case.pieces.robot, str(polygon), number)
    demand(is_inside(proof.disc, holder), keys.DISC, "is not inside that piece")
    disc = convex_piece(keys.DISC, proof.disc, of_obstacle=False)
    goal = case.goal
    smaller = replace(
        case,
        robot={"0": [proof.disc]},
        pieces=case.pieces._replace(robot={"0": [disc]}),
        turning=False,
        start=case.start._replace(angle=NO_TURN),
        goal=(
            GoalArea(goal.polygons, None)
            if isinstance(goal, GoalArea)
            else goal._replace(angle=NO_TURN)
        ),
    )
    return check_separation(smaller, proof.separation)


def is_inside(disc: Ring, holder: Piece) -> bool:
    """Whether a piece holds the origin, and no vertex is farther from it than its boundary."""
    farthest = max((dot(vertex, vertex) for vertex in disc), default=0)  # squared
    for edge in holder.edges:
        distance = dot(edge.normal, edge.base)  # of the edge's line, times the normal's length
        if distance < 0 or distance**2 < farthest * dot(edge.normal, edge.normal):
            return False
    return True


def check_end(case: Case, proof: EndProof) -> int:
    """Check that the start or the goal is not free."""
    end = case.start if proof.end == keys.START else case.goal
    if isinstance(end, GoalArea):
        raise CertificateRejected(keys.END, "is a region, not a configuration")
    if proof.collision is None:
        outside = not case.in_bounds(end.translation)
        demand(outside, keys.REFERENCE_BOUNDS, "the reference point is not outside")
    else:
        radians, turns = end.angle
        extent = Extent([end.translation], turns, turns, radians)
        check_full(case, proof.end, proof.collision, extent)
    return 1


def check_chain(case: Case, proof: ChainProof) -> int:
    """Check that each set overlaps the next, and that the chain winds oddly.

    The closed polygon through a point of each overlap lies in the sets, because they are convex. It
    winds round one of start and goal an odd number of times, and round the other an even number.
    Polygons of a goal region are connected: it does not meet them, and winds round all points of
    one as often.
    """
    quarters = None if case.turning else case.start.angle.quarters
    if quarters is None:
        raise CertificateRejected(
            keys.CHAIN, "is about a robot that may not turn, at a quarter turn"
        )
    sets = [
        open_set(case, f"{keys.CHAIN}[{k}]", link, quarters) for k, link in enumerate(proof.chain)
    ]
    polygon = [
        common_point(f"{keys.CHAIN}[{k}]", a, b) for k, (a, b) in enumerate(cyclic_pairs(sets))
    ]
    inside = winds_oddly(polygon, case.start.translation)
    goal = case.goal
    if isinstance(goal, GoalArea):
        demand(not goal.meets_curve(polygon), keys.CHAIN, "may meet the goal region")
        places = [area[0][0] for area in goal.polygons]
    else:
        places = [goal.translation]
    odd = all(winds_oddly(polygon, place) != inside for place in places)
    demand(odd, keys.CHAIN, "does not separate start from goal")
    return len(sets)


def open_set(case: Case, place: str, link: ChainLink, quarters: int) -> OpenSet:
    """Return translations at which a pair overlaps, or that are beyond a side of the bounds."""
    if link.pair is None:
        return beyond(case, link.side or "", quarters)
    robot, obstacle = case.pieces.pair(place, link.pair)
    turned = [quarter_turned(r, quarters) for r in robot.vertices]
    return interior(convex_hull(minus(o, r) for o in obstacle.vertices for r in turned))


def beyond(case: Case, side: str, quarters: int) -> OpenSet:
    """Return translations beyond a side: of the reference bounds, or with a vertex past a wall."""
    beyonds = []
    if side in case.bounds:
        edge = case.bounds[side]
        beyonds.append(clipped(FAR, HalfPlane(opposite(edge.normal), -dot(edge.normal, edge.base))))
    if side in case.walls:
        edge = case.walls[side]
        least = min(dot(edge.normal, quarter_turned(v, quarters)) for v in case.outline)
        offset = least - dot(edge.normal, edge.base)
        beyonds.append(clipped(FAR, HalfPlane(opposite(edge.normal), offset)))
    return interior(convex_hull(chain.from_iterable(beyonds)))


def opposite(v: Vector) -> Vector:
    """Return the opposite vector."""
    return -v[0], -v[1]


def interior(corners: Sequence[Point]) -> OpenSet:
    """Return the interior of a convex polygon, counter-clockwise."""
    sides = []
    for a, b in cyclic_pairs(corners):
        normal = (a[1] - b[1], b[0] - a[0])
        sides.append(HalfPlane(normal, normal[0] * a[0] + normal[1] * a[1]))
    return OpenSet(sides, corners)


def convex_hull(points: Iterable[Point]) -> list[Point]:
    """Return the corners of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    hull: list[Point] = []
    for half in (ordered, ordered[::-1]):
        base = len(hull)
        for p in half:
            while len(hull) - base >= 2 and area(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        hull.pop()
    return hull


def area(a: Point, b: Point, c: Point) -> Number:
    """Return twice the area of a triangle, positive if c is left of the line from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def common_point(place: str, a: OpenSet, b: OpenSet) -> Point:
    """Return a point of both sets."""
    corners = list(a.corners)
    for side in b.sides:
        corners = clipped(corners, side)
    point = mean(corners) if corners else a.corners[0]
    inside = all(side.height(point) > 0 for side in (*a.sides, *b.sides))
    demand(inside, place, "does not overlap the next set")
    return point


def clipped(corners: Sequence[Point], side: HalfPlane) -> list[Point]:
    """Return the corners of a convex polygon's part in the closed half-plane."""
    kept: list[Point] = []
    for p, q in cyclic_pairs(corners):
        above, after = side.height(p), side.height(q)
        if above >= 0:
            kept.append(p)
        if above * after < 0:
            s = Fraction(above) / (above - after)
            kept.append((p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])))
    return kept


def mean(points: Sequence[Point]) -> Point:
    """Return the mean of points: in the interior of their convex hull, if that has one."""
    x, y = (sum(coordinates, Fraction()) for coordinates in zip(*points, strict=True))
    return x / len(points), y / len(points)


def winds_oddly(polygon: Sequence[Point], p: Vector) -> bool:
    """Whether a closed polygon crosses the upward ray from a point an odd number of times."""
    odd = False
    for a, b in cyclic_pairs(polygon):
        if (a[0] <= p[0]) != (b[0] <= p[0]):
            odd ^= area(a, b, p) < 0 if b[0] > a[0] else area(a, b, p) > 0
    return odd
