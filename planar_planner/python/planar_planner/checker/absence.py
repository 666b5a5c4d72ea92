"""Claims that no path exists: boxes that separate, a disc inside the robot, a colliding end."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import chain, product
from typing import Any

from planar_planner.checker.arithmetic import PI, Extent, Region, _apart, _dot, _region, fixed
from planar_planner.checker.case import NORMALS, Case, Pose, convex_piece, demand, find
from planar_planner.checker.collisions import check_full, negative_edge
from planar_planner.checker.form import LEVELS, UNIT
from planar_planner.checker.goal_area import GoalArea
from planar_planner.errors import CertificateRejected

Box = tuple[tuple[int, int], tuple[int, int], tuple[int, int]]  # level and index on each axis


Domain = tuple["Case", tuple[int, int], tuple[int, int]]  # with lower left corner and size


def check_separation(case: Case, content: Mapping[str, Any]) -> int:
    """Check that FULL boxes and faces separate the start from the goal."""
    low, size = ([m << (e + UNIT) for m, e in content["domain"][k]] for k in ("low", "size"))
    domain: Domain = case, (low[0], low[1]), (size[0], size[1])
    inside, full, faces = content["start_side"], content["full"], content["full_faces"]
    check_domain(domain)
    check_ends(domain, inside)
    for i, box in enumerate(inside):
        extent(f"start_side[{i}]", domain, box)
    for name in ("full", "full_faces"):
        for i, claim in enumerate(content[name]):
            at = extent(f"{name}[{i}]", domain, claim["box"], claim.get("axis", -1))
            check_full(case, f"{name}[{i}]", claim, at)
    check_cover(inside, full, faces)
    return len(inside) + len(full) + len(faces)


def check_domain(domain: Domain) -> None:
    """Check that at each side of the domain, and so beyond it, no configuration is free."""
    case = domain[0]
    for i, side in enumerate(NORMALS):
        box: Any = [(0, 0)] * 3
        box[i // 2] = (0, i % 2)
        at = extent("domain", domain, box, i // 2)
        bound, wall = case.bounds.get(side), case.walls.get(side)
        out = bound and all(bound.value(t) <= 0 for t in at.corners)  # at or beyond its bounds
        out = out or (wall and negative_edge(wall, case.outline, at))  # the robot is partly beyond
        demand(bool(out), "domain", "free configurations may lie beyond it")


def extent(place: str, domain: Domain, box: Box, axis: int = -1) -> Extent:
    """Return the configurations of a box, or of a face normal to `axis`, in the domain."""
    case, low, size = domain
    inside = all(k + (a != axis) <= 1 << level for a, (level, k) in enumerate(box))
    demand(inside, place, "reaches beyond the domain")
    demand(case.turning or (box[2] == (0, 0) and axis != 2), place, "has angles in a fixed scene")
    ends = [(k,) if a == axis else (k, k + 1) for a, (_, k) in enumerate(box)]
    steps = [size[a] >> box[a][0] for a in (0, 1)]  # exact: the units are fine enough
    xs, ys = ([low[a] + steps[a] * k for k in ends[a]] for a in (0, 1))
    corners = list(product(xs, ys))
    first, *last = (Fraction(k, 1 << box[2][0]) for k in ends[2])
    if not case.turning:
        return Extent(corners, first, first, Fraction(case.start[1]))
    return Extent(corners, first, last[0] if last else first)


def check_ends(domain: Domain, inside: list[Box]) -> None:
    """Check that the start lies in a box of its side, the goal, or any of a region, in none."""
    case, low, size = domain
    goal = case.goal

    # Three, a turn apart, in parts of the domain. No angle but 0 is on a box's boundary, so angles
    # need not be exact.
    def places(pose: Pose) -> list[list[tuple[Fraction, Fraction]]]:
        exact = [(Fraction(pose[0][a] - low[a], size[a]),) * 2 for a in (0, 1)]
        theta = pose[1] if case.turning else 0
        turns = Fraction(fixed(Fraction(theta), Fraction()), 2 * PI) % 1
        error = Fraction(1 if theta else 0, 1 << 180)
        return [[*exact, (turns + n - error, turns + n + error)] for n in (-1, 0, 1)]

    start, held = places(case.start), False
    goal_at = [] if isinstance(goal, GoalArea) else places(goal)
    for i, box in enumerate(inside):
        spans = [(Fraction(k, 1 << level), Fraction(k + 1, 1 << level)) for level, k in box]
        starts, goals = ([list(zip(spans, p, strict=True)) for p in ps] for ps in (start, goal_at))
        held = held or any(all(a <= u and v <= b for (a, b), (u, v) in each) for each in starts)
        apart = all(any(v < a or b < u for (a, b), (u, v) in each) for each in goals)
        if isinstance(goal, GoalArea):
            at = extent(f"start_side[{i}]", domain, box)
            apart = not (has_angle(goal, spans[2]) and goal.meets(_region(at.corners)))
        demand(apart, f"start_side[{i}]", "may hold the goal")
    demand(held, "start_side", "does not hold the start")


def has_angle(goal: GoalArea, span: tuple[Fraction, Fraction]) -> bool:
    """Whether some angle of a region may lie in a span of turns."""
    if goal.angles is None:
        return True
    low, high = (Fraction(fixed(Fraction(a), Fraction()), 2 * PI) for a in goal.angles)
    low, high, error = low % 1, high - low + low % 1, Fraction(1, 1 << 180)
    return any(low + n - error <= span[1] and span[0] <= high + n + error for n in (-1, 0, 1))


def check_cover(inside: list[Box], full: list[Any], faces: list[Any]) -> None:
    """Check that every face of the start's side bounds the domain or is covered from beyond."""

    def faces_of(box: Box) -> Iterator[tuple[int, int, int, Region]]:
        spans = [(k << (LEVELS - level), (k + 1) << (LEVELS - level)) for level, k in box]
        for axis in range(3):
            (u0, u1), (v0, v1) = spans[:axis] + spans[axis + 1 :]
            for end, plane in enumerate(spans[axis]):  # turn 1 is turn 0
                yield axis, end, plane % (1 << LEVELS) if axis == 2 else plane, (u0, v0, u1, v1)

    needs, covers = defaultdict(set), defaultdict(set)  # by axis, plane, end of the boxes in need
    for axis, end, plane, face in chain.from_iterable(map(faces_of, inside)):
        needs[axis, plane, end].add(face)
        covers[axis, plane, 1 - end].add(face)
    for axis, end, plane, face in chain.from_iterable(faces_of(claim["box"]) for claim in full):
        covers[axis, plane, 1 - end].add(face)
    for claim in faces:
        axis, _, plane, face = list(faces_of(claim["box"]))[2 * claim["axis"]]
        for end in (0, 1):
            covers[axis, plane, end].add(face)
    for (axis, plane, end), open_faces in needs.items():
        known = covers[axis, plane, end]
        rest = open_faces - known if axis == 2 or 0 < plane < 1 << LEVELS else set()
        closed = covered(rest, known, (0, 0, 1 << LEVELS, 1 << LEVELS))
        place = f"start_side, {('x', 'y', 'theta')[axis]} = {plane / 2**LEVELS!r}"
        demand(closed, place, "has a face that is neither shared nor FULL")


def covered(needs: Iterable[Region], covers: Iterable[Region], cell: Region) -> bool:
    """Whether rectangles, as far as they are in a cell, lie in the union of others."""
    needs = [r for r in needs if not _apart(r, cell)]
    covers = [r for r in covers if not _apart(r, cell)]
    if not needs or any(_region([r[:2], r[2:], cell[:2], cell[2:]]) == r for r in covers):
        return True
    if not covers:
        return False
    xs, ys = (
        sorted({c for r in needs + covers for c in r[a::2] if cell[a] < c < cell[a + 2]})
        for a in (0, 1)
    )  # not both empty: a cover meets the cell and does not hold it
    axis, cuts = (0, xs) if len(xs) > len(ys) else (1, ys)
    parts: list[Any] = [list(cell), list(cell)]
    parts[0][axis + 2] = parts[1][axis] = cuts[len(cuts) // 2]
    return all(covered(needs, covers, part) for part in parts)


def check_disc(case: Case, content: Mapping[str, Any]) -> int:
    """Check that a disc inside the robot, in place of it, has no path."""
    disc, (p, i) = content["disc"], content["inside"]
    farthest = max((_dot(v, v) for v in disc), default=0)
    for base, n, _ in find("inside", case.pieces["robot"], str(p), i).edges:
        near = _dot(n, base) < 0 or _dot(n, base) ** 2 < farthest * _dot(n, n)
        demand(not near, "disc", "is not inside that piece")
    polygons = case.polygons | {"robot": {"0": [disc]}}
    pieces = case.pieces | {"robot": {"0": [convex_piece("disc", disc, obstacle=False)]}}
    start = case.start[0], 0.0
    goal = GoalArea(case.goal[0], None) if isinstance(case.goal, GoalArea) else (case.goal[0], 0.0)
    smaller = Case(polygons, case.walls, case.bounds, False, start, goal, pieces)
    return check_separation(smaller, content)


def check_end(case: Case, content: Mapping[str, Any]) -> int:
    """Check that the start or the goal is not free."""
    end = case.start if content["end"] == "start" else case.goal
    if isinstance(end, GoalArea):
        raise CertificateRejected("end", "is a region, not a configuration")
    t, theta = end
    if "reference_bounds" in content:
        demand(not case.in_bounds(t), "reference_bounds", "the reference point is not outside")
    else:
        at = Extent([t], Fraction(), Fraction(), Fraction(theta))
        check_full(case, content["end"], content, at)
    return 1
