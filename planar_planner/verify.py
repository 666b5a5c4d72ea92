"""The checker of certificates: docs/certificate.md as code. It shares nothing with the planner.

Whatever it accepts is an inequality between integers, and `demand` is its only way to reject (but
`find`, for names of nothing). Lengths are integers in units of 2^-UNIT, which hold the doubles of
scenes and the corners of boxes exactly; cosines and sines are integers in units of 2^-BITS, off by
at most one. For one vertex and one edge, at translation t and angle θ, the separating-axis function
is C + D cos θ + E sin θ, and linear in t.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import chain, pairwise, product
from typing import Any, NamedTuple

from planar_planner.certificate_form import LEVELS, UNIT, Finding, Source, read_certificate, units
from planar_planner.fingerprint import fingerprint
from planar_planner.goal import GoalRegion
from planar_planner.goal_check import GoalArea
from planar_planner.problem import Polygons, Problem, make_problem
from planar_planner.scene import Scene, load_scene
from planar_planner.validity import judged_by_geos

BITS, WORK = 120, 220  # bits after the binary point of cosines and of angles
MOST_CHOICES = 1024  # of separating edges in one joint claim
HALVINGS = 60  # of a box's angles, in search of one vertex for each part
ONE, HALF_TURN = 1 << UNIT, Fraction(1, 2)
NORMALS = {"x_min": (ONE, 0), "x_max": (-ONE, 0), "y_min": (0, ONE), "y_max": (0, -ONE)}  # of walls
OTHER = {"robot": "obstacle", "obstacle": "robot"}

Vector = tuple[int, int]
Rotation = tuple[int, int]  # cos, sin
Region = tuple[int, int, int, int]  # xmin, ymin, xmax, ymax
Polygon = list[list[Vector]]  # rings with the interior on the left: outer one, holes
Pose = tuple[Vector, float]  # translation, theta
Pair = tuple[int, int, int, int]  # p, i, q, j
Axis = tuple[str, int]  # an edge of a pair: owner and number
Box = tuple[tuple[int, int], tuple[int, int], tuple[int, int]]  # level and index on each axis
Domain = tuple["Case", tuple[int, int], tuple[int, int]]  # with lower left corner and size
Waypoint = tuple[int, int, float, int]  # x, y, theta, turns


class Rejected(Finding):
    """The first claim found that is false, or that the certificate does not prove."""


def demand(holds: bool, place: str, problem: str) -> None:
    """Reject the certificate unless a claim holds."""
    if not holds:
        raise Rejected(place, problem)


class Report(NamedTuple):
    """What a valid certificate proves."""

    verdict: str  # "path" or "no_path"
    proof: str  # "path", "separation", "disc" or "end"
    contact_tolerance: float  # the path's ends may be so far from start and goal
    claims: int  # that were checked: boxes, faces, pairs on intervals


def verify_certificate(
    scene: Source | Scene, certificate: Source, contact_tolerance: float = 0.0
) -> Report:
    """Check a certificate against a scene, in exact arithmetic.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    certificate : str, path or mapping
        A file (docs/certificate.md), or its content.
    contact_tolerance : float, optional
        A path may begin and end off contact by this length, if the certificate says so.

    Returns
    -------
    Report
        What is proven: ``verdict``, ``proof``, ``contact_tolerance`` and ``claims``, their number.

    Raises
    ------
    SceneError
        If the scene is not valid.
    CertificateError
        If the certificate cannot be read.
    Rejected
        If it does not prove what it claims.
    """
    problem = make_problem(scene if isinstance(scene, Scene) else load_scene(scene), judged_by_geos)
    content = read_certificate(certificate)
    case = make_case(problem, content)
    tolerance, proof = content.get("contact_tolerance", 0.0), content.get("claim", "path")
    demand(content["scene"] == fingerprint(problem), "scene", "is not the one certified")
    demand(0 <= tolerance <= contact_tolerance, "contact_tolerance", "is more than allowed")
    check_pieces(case, content)
    proofs = {"separation": check_separation, "disc": check_disc, "end": check_end}
    claims = proofs.get(proof, check_path)(case, content)
    return Report(content["verdict"], proof, tolerance, claims)


# --- Vectors and rotations ---


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1]


def _dot(a: Vector, b: Vector) -> int:
    return a[0] * b[0] + a[1] * b[1]


def _cross(a: Vector, b: Vector) -> int:
    return a[0] * b[1] - a[1] * b[0]


def _sides(ring: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def _region(points: Iterable[Vector]) -> Region:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _apart(a: Region, b: Region) -> bool:  # in their interiors
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def _atan_inverse(n: int) -> int:  # atan(1/n) in 2^-(WORK + 20), off by less than 2^10
    total, power, k = 0, (1 << (WORK + 20)) // n, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power, k = power // (n * n), k + 2
    return total


PI = (16 * _atan_inverse(5) - 4 * _atan_inverse(239)) >> 20  # in 2^-WORK, off by at most one


def fixed(radians: Fraction, turns: Fraction) -> int:
    """Return radians + 2π turns, both at most 2^22, in 2^-WORK: off by less than 2^24."""
    return math.floor(radians * (1 << WORK)) + math.floor(2 * turns * PI)


@lru_cache(1 << 16)
def rotation(radians: Fraction, turns: Fraction) -> Rotation:
    """Return cos and sin of radians + 2π turns."""
    angle = fixed(radians, turns)
    quarters = (4 * angle + PI) // (2 * PI)
    angle -= quarters * PI // 2  # now at most an eighth of a turn
    sums, term, k = [0, 0], 1 << WORK, 0
    while term not in (0, -1):  # Taylor's series alternates: the rest is less than the last term
        sums[k % 2] += term if k % 4 < 2 else -term
        term, k = (term * angle >> WORK) // (k + 1), k + 1
    c, s = ((part >> (WORK - BITS - 1)) + 1 >> 1 for part in sums)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


class Extent(NamedTuple):
    """A box, face or point: the corners of its translations; its angles, radians + 2π turns."""

    corners: list[Vector]
    first: Fraction  # turns
    last: Fraction
    radians: Fraction = Fraction()

    def ends(self) -> list[Rotation]:
        """Return the rotations at both ends, of a single angle only one."""
        return [rotation(self.radians, turns) for turns in sorted({self.first, self.last})]

    def halves(self) -> list[Extent]:
        """Return the halves of the angles."""
        middle = (self.first + self.last) / 2
        return [self._replace(last=middle), self._replace(first=middle)]


# --- The problem in integers, and its pieces ---


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
        raise Rejected(place, f"names what is not there: {names}") from None
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


# --- Configurations that are not free ---


def negative(D: int, E: int, C: int, ends: Sequence[Rotation]) -> bool:
    """Prove that C + D cos θ + E sin θ < 0 from one end to the other, at most half a turn on."""
    error = abs(D) + abs(E)
    if any(D * c + E * s + error + (C << BITS) >= 0 for c, s in ends):
        return False
    if len(ends) == 1 or (C < 0 and D * D + E * E < C * C):  # it is at most C plus the amplitude
        return True
    (c0, s0), (c1, s1) = ends  # its maximum is at one, if it falls at the first, rises at the last
    return E * c0 - D * s0 + error <= 0 or E * c1 - D * s1 >= error


def negative_edge(edge: Edge, vertices: list[Vector], at: Extent, halvings: int = HALVINGS) -> bool:
    """Prove an edge's function negative: on each part of the angles for some one vertex."""
    ends, corners = at.ends(), at.corners
    if edge.obstacle:  # the translation only adds to the term
        corners = [max(corners, key=lambda t: _dot(edge.normal, t))]
    if at.last - at.first <= HALF_TURN and any(
        all(negative(*edge.term(v, t), ends) for t in corners) for v in vertices
    ):
        return True
    if len(ends) == 1 or halvings == 0:
        return False
    return all(negative_edge(edge, vertices, half, halvings - 1) for half in at.halves())


def check_full(case: Case, place: str, claim: Mapping[str, Any], at: Extent) -> None:
    """Check that no configuration of a box, face or point is free."""
    if "joint" in claim:
        check_joint(case, place, claim["joint"], at)
    elif "pair" in claim:
        check_overlap(case, place, claim["pair"], at)
    else:
        beyond = negative_edge(find(place, case.walls, claim["wall"]), case.outline, at)
        demand(beyond, place, "the robot may be inside the wall")


def check_overlap(case: Case, place: str, pair: Pair, at: Extent, but: Sequence[Axis] = ()) -> None:
    """Check FULL by a pair: every separating-axis function is negative, `but` for some edges'."""
    pieces = case.pair(place, pair)
    for owner, other in OTHER.items():
        for i, edge in enumerate(pieces[owner].edges):
            negated = (owner, i) in but or negative_edge(edge, pieces[other].vertices, at)
            demand(negated, f"{place}, edge {i} of the {owner}", "may separate the pair")


def check_joint(case: Case, place: str, joint: Mapping[str, Any], at: Extent) -> None:
    """Check FULL jointly: whichever of the edges listed separate their pairs, a sum refutes it."""
    for entry in joint["axes"]:  # where all is free, an edge of each pair separates: none but these
        check_overlap(case, place, entry["pair"], at, entry["edges"])
    edges = {entry["pair"]: entry["edges"] for entry in joint["axes"]}
    refuted = [check_sum(case, place, terms, at) for terms in joint["sums"]]
    few = math.prod(map(len, edges.values())) <= MOST_CHOICES
    demand(few, place, "leaves too many choices of separating edges")
    for choice in product(*edges.values()):
        chosen = dict(zip(edges, choice, strict=True))
        hit = any(used.items() <= chosen.items() for used in refuted)
        demand(hit, place, "does not refute every choice of separating edges")


def check_sum(case: Case, place: str, terms: list[Any], at: Extent) -> dict[Pair, Axis]:
    """Check that a weighted sum of terms is negative, and return which edge it has of each pair."""
    used: dict[Pair, Axis] = {}
    parts: list[tuple[int, Edge, Vector]] = []
    scale = math.lcm(*(Fraction(term["weight"]).denominator for term in terms))
    for term in terms:
        if "wall" in term:
            edge, vertex = find(place, case.walls, term["wall"]), term["vertex"]
            own = any(vertex in ring for ring in chain(*case.polygons["robot"].values()))
            demand(own, place, "has a vertex that is not the robot's")
        else:
            choice = term["owner"], term["edge"]
            only = used.setdefault(term["pair"], choice) == choice
            demand(only, place, "has two edges of a pair in one sum")
            edge, vertices = case.edge(place, term["pair"], choice)
            vertex = find(place, vertices, term["vertex"])
        demand(term["weight"] >= 0, place, "has a negative weight")
        parts.append((int(Fraction(term["weight"]) * scale), edge, vertex))
    for t, part in product(at.corners, at.halves() if at.last - at.first > HALF_TURN else [at]):
        weighted = [[weight * x for x in edge.term(v, t)] for weight, edge, v in parts]
        D, E, C = (sum(term[k] for term in weighted) for k in range(3))
        demand(negative(D, E, C, part.ends()), place, "the weighted sum may be 0 or more")
    return used


# --- Verdict no_path ---


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
        raise Rejected("end", "is a region, not a configuration")
    t, theta = end
    if "reference_bounds" in content:
        demand(not case.in_bounds(t), "reference_bounds", "the reference point is not outside")
    else:
        at = Extent([t], Fraction(), Fraction(), Fraction(theta))
        check_full(case, content["end"], content, at)
    return 1


# --- Verdict path ---


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
