"""Claims that FULL boxes and faces separate start and goal (docs/certificate.md, "separation")."""

from __future__ import annotations

import math
from fractions import Fraction

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import TURNS_ERROR, Angle, turns_of
from planar_planner.checker.case import WALL_NORMALS, Case, Pose
from planar_planner.checker.collisions import check_full, is_negative_edge
from planar_planner.checker.cover import check_cover
from planar_planner.checker.demands import demand
from planar_planner.checker.extents import THETA, Domain
from planar_planner.checker.goal_area import GoalArea
from planar_planner.checker.records import Box, Separation, Span

Range = tuple[Fraction, Fraction]
"""From the first to the second, along an axis of the domain: parts of its size, or turns."""
Place = tuple[Range, Range, Range]
"""Holds a configuration; without extent along an axis if it is known exactly there."""


def check_separation(case: Case, separation: Separation) -> int:
    """Check that FULL boxes and faces separate the start from the goal; return their number."""
    check_distinct(separation)
    only_angle = None if case.turning else case.start.angle
    domain = Domain(separation.low, separation.size, only_angle)
    check_domain(case, domain)
    check_ends(case, domain, separation.start_side)
    for name, claims in (
        (keys.FULL, separation.full),
        (keys.FULL_FACES, separation.full_faces),
    ):
        for i, claim in enumerate(claims):
            place = f"{name}[{i}]"
            check_full(case, place, claim.collision, domain.extent(place, claim.box, claim.axis))
    check_cover(separation, case.deadline)
    return len(separation.start_side) + len(separation.full) + len(separation.full_faces)


def check_distinct(separation: Separation) -> None:
    """Check that no box or face is listed twice, before there is work on any of them."""
    listed: dict[str, list[tuple[Box, int | None]]] = {
        keys.START_SIDE: [(box, None) for box in separation.start_side],
        keys.FULL: [(claim.box, claim.axis) for claim in separation.full],
        keys.FULL_FACES: [(claim.box, claim.axis) for claim in separation.full_faces],
    }
    for name, places in listed.items():
        demand(len(set(places)) == len(places), name, "lists something twice")


def check_domain(case: Case, domain: Domain) -> None:
    """Check step 1: at each side of the domain, and so beyond it, no configuration is free."""
    for i, side in enumerate(WALL_NORMALS):
        spans: list[Span] = [(0, 0), (0, 0), (0, 0)]
        spans[i // 2] = (0, i % 2)
        extent = domain.extent(keys.DOMAIN, (spans[0], spans[1], spans[2]), i // 2)
        bound, wall = case.bounds.get(side), case.walls.get(side)
        at_bound = bound is not None and all(bound.height(t) <= 0 for t in extent.corners)
        in_wall = wall is not None and is_negative_edge(wall, case.outline, extent)
        demand(at_bound or in_wall, keys.DOMAIN, "free configurations may lie beyond it")


def check_ends(case: Case, domain: Domain, start_side: list[Box]) -> None:
    """Check step 2: the start lies in a box of its side, the goal, or any of a region, in none."""
    starts, goal, held = places_of(case.start, domain), case.goal, False
    goals = [] if isinstance(goal, GoalArea) else places_of(goal, domain)
    for i, box in enumerate(start_side):
        case.deadline.check()
        place = f"{keys.START_SIDE}[{i}]"
        extent, ranges = domain.extent(place, box), ranges_of(box)
        if isinstance(goal, GoalArea):
            rectangle = extent.box_of_origin(case.reference)
            met = goal.meets(rectangle) and goal.may_have_angle(*ranges[THETA])
        else:
            met = any(may_meet(end, ranges) for end in goals)
        demand(not met, place, "may hold the goal")
        held = held or any(surely_in(end, ranges) for end in starts)
    demand(held, keys.START_SIDE, "does not hold the start")


def places_of(pose: Pose, domain: Domain) -> list[Place]:
    """Return three places of a configuration in parts of the domain, a turn apart.

    Quarter turns are exact. No other angle is on a box's boundary, so those need not be. An angle
    below `TURNS_ERROR` is on the side of 0 that its sign says.
    """
    (x, y), angle, spread = pose
    if domain.only_angle is not None:
        angle = Angle(Fraction(), Fraction())
    u, v = (
        (Fraction(at - spread - low, size), Fraction(at + spread - low, size))
        for at, low, size in zip((x, y), domain.low, domain.size, strict=True)
    )
    turns, error = turns_of(angle), TURNS_ERROR if angle.radians else Fraction()
    low = turns - error if angle.radians <= 0 else max(turns - error, Fraction())
    high = turns + error if angle.radians >= 0 else min(turns + error, Fraction())
    whole = math.floor(turns)
    return [(u, v, (low - whole + n, high - whole + n)) for n in (-1, 0, 1)]


def ranges_of(box: Box) -> Place:
    """Return what a box spans along each axis."""
    x, y, theta = ((Fraction(k, 1 << level), Fraction(k + 1, 1 << level)) for level, k in box)
    return x, y, theta


def surely_in(place: Place, box: Place) -> bool:
    """Whether a box holds a place."""
    return all(
        first <= low and high <= last for (low, high), (first, last) in zip(place, box, strict=True)
    )


def may_meet(place: Place, box: Place) -> bool:
    """Whether a box and a place have a point in common."""
    return all(
        first <= high and low <= last for (low, high), (first, last) in zip(place, box, strict=True)
    )
