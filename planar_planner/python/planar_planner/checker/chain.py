"""The claim that a closed chain of convex sets separates start from goal.

docs/certificate.md, "odd_chain". Translations in the sets are not free. All numbers are integers or
fractions.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import ONE, Vector, cross, cyclic_pairs, dot, minus
from planar_planner.checker.case import Case, Pose
from planar_planner.checker.demands import demand
from planar_planner.checker.records import ChainLink, ChainProof
from planar_planner.errors import CertificateRejected

Point = tuple[Fraction, Fraction]


class HalfPlane(NamedTuple):
    """The points p with normal · p > offset."""

    normal: Vector
    offset: int

    def height(self, point: Point) -> Fraction:
        """Return normal · point − offset."""
        return self.normal[0] * point[0] + self.normal[1] * point[1] - self.offset


class OpenSet(NamedTuple):
    """The intersection of half-planes; its corners if it is bounded."""

    sides: list[HalfPlane]
    corners: list[Vector]


def check_chain(case: Case, proof: ChainProof) -> int:
    """Check that each set overlaps the next, and that the chain winds oddly.

    The closed polygon through a point of each overlap lies in the sets, because they are convex. It
    winds round one of start and goal an odd number of times, and round the other an even number.
    """
    still = not case.turning and case.start.theta == 0
    demand(still, keys.CHAIN, "is about a robot at angle 0 that may not turn")
    if not isinstance(case.goal, Pose):
        raise CertificateRejected(keys.CHAIN, "is about a goal that is a configuration")
    sets = [open_set(case, f"{keys.CHAIN}[{k}]", link) for k, link in enumerate(proof.chain)]
    polygon = [
        common_point(f"{keys.CHAIN}[{k}]", a, b) for k, (a, b) in enumerate(cyclic_pairs(sets))
    ]
    start, goal = case.start.translation, case.goal.translation
    odd = winds_oddly(polygon, start) != winds_oddly(polygon, goal)
    demand(odd, keys.CHAIN, "does not separate start from goal")
    return len(sets)


def open_set(case: Case, place: str, link: ChainLink) -> OpenSet:
    """Return the translations at which a pair overlaps, or that are beyond a side of the bounds."""
    if link.pair is None:
        return OpenSet([beyond(case, place, link.side or "")], [])
    robot, obstacle = case.pieces.pair(place, link.pair)
    corners = convex_hull(minus(o, r) for o in obstacle.vertices for r in robot.vertices)
    return OpenSet([left_of(a, b) for a, b in cyclic_pairs(corners)], corners)


def beyond(case: Case, place: str, side: str) -> HalfPlane:
    """Return the translations beyond a side, of the reference bounds or with a vertex past a wall.

    Both are half-planes of one direction, and one holds the other.
    """
    offsets = []
    if side in case.bounds:
        edge = case.bounds[side]
        offsets.append(dot(edge.normal, edge.base))
    if side in case.walls:
        edge = case.walls[side]
        offsets.append(
            dot(edge.normal, edge.base) - min(dot(edge.normal, vertex) for vertex in case.outline)
        )
    demand(bool(offsets), place, "there is no bound on that side")
    x, y = (edge.normal[0], edge.normal[1])
    return HalfPlane((-x, -y), -max(offsets))


def left_of(a: Vector, b: Vector) -> HalfPlane:
    """Return the half-plane left of a directed line."""
    normal = (a[1] - b[1], b[0] - a[0])
    return HalfPlane(normal, dot(normal, a))


def turns_left(a: Vector, b: Vector, c: Vector) -> bool:
    """Whether c is to the left of the line from a to b."""
    return cross(minus(b, a), minus(c, b)) > 0


def convex_hull(points: Iterable[Vector]) -> list[Vector]:
    """Return the corners of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    hull: list[Vector] = []
    for half in (ordered, ordered[::-1]):
        base = len(hull)
        for p in half:
            while (
                len(hull) - base >= 2 and cross(minus(hull[-1], hull[-2]), minus(p, hull[-1])) <= 0
            ):
                hull.pop()
            hull.append(p)
        hull.pop()
    return hull


def common_point(place: str, a: OpenSet, b: OpenSet) -> Point:
    """Return a point of both sets."""
    sides = [*a.sides, *b.sides]
    if a.corners or b.corners:
        corners: list[Point] = [(Fraction(x), Fraction(y)) for x, y in a.corners or b.corners]
        for side in sides:
            corners = clipped(corners, side)
        demand(bool(corners), place, "does not overlap the next set")
        point = mean(corners)
    else:
        point = far_corner(place, a.sides[0], b.sides[0])
    inside = all(side.height(point) > 0 for side in sides)
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
            s = above / (above - after)
            kept.append((p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])))
    return kept


def mean(points: Sequence[Point]) -> Point:
    """Return the mean of points: in the interior of their convex hull, if that has one."""
    x, y = (sum(coordinates, Fraction()) for coordinates in zip(*points, strict=True))
    return x / len(points), y / len(points)


def far_corner(place: str, a: HalfPlane, b: HalfPlane) -> Point:
    """Return a point beyond two sides of the bounds that are not parallel."""
    demand(dot(a.normal, b.normal) == 0, place, "does not overlap the next set")
    far = ONE * ONE  # a normal has the length ONE
    (ax, ay), (bx, by) = a.normal, b.normal
    scale_a, scale_b = a.offset + far, b.offset + far
    return (
        Fraction(ax * scale_a + bx * scale_b, far),
        Fraction(ay * scale_a + by * scale_b, far),
    )


def winds_oddly(polygon: Sequence[Point], p: Vector) -> bool:
    """Whether a closed polygon crosses the upward ray from a point an odd number of times."""
    odd = False
    for a, b in cyclic_pairs(polygon):
        if (a[0] <= p[0]) != (b[0] <= p[0]):
            area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            odd ^= area < 0 if b[0] > a[0] else area > 0
    return odd
