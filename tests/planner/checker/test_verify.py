"""The checker's parts against oracles: decimals, samples, shapely, brute force, a whole grid."""

from __future__ import annotations

import math
import random
from collections import deque
from decimal import Decimal, getcontext
from fractions import Fraction
from itertools import product
from typing import Any

import pytest
import shapely
from shapely import affinity

from planar_planner.checker.arithmetic import (
    ANGLE_BITS,
    ONE,
    PI,
    ROTATION_BITS,
    angle_of,
    cross,
    minus,
    rotation,
    units,
)
from planar_planner.checker.case import Case, Pose, make_case
from planar_planner.checker.collisions import check_full, check_overlap, is_negative
from planar_planner.checker.cover import covered
from planar_planner.checker.extents import Domain, Extent
from planar_planner.checker.form import read_certificate
from planar_planner.checker.path import make_motion, stays_outside, swept_box
from planar_planner.checker.pieces import Piece, Pieces, check_partition, convex_piece
from planar_planner.checker.records import Collision, Waypoint
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateRejected, OptionsError
from planar_planner.load import load_scene
from planar_planner.problem.make import make_problem
from worlds.hand_made_certificates import HAND_MADE, Json, hand_made, rectangle, signed

PI_TO_80_DIGITS = Decimal(
    "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899"
)
Points = list[tuple[float, float]]


def decimal_cos_sin(angle: Decimal) -> tuple[Decimal, Decimal]:
    angle %= 2 * PI_TO_80_DIGITS
    sums, term, k = [Decimal(0), Decimal(0)], Decimal(1), 0
    while abs(term) > Decimal(10) ** -60 or k < 8:
        sums[k % 2] += term * (1 if k % 4 < 2 else -1)
        k += 1
        term = term * angle / k
    return sums[0], sums[1]


def test_rotations_are_within_a_unit() -> None:
    getcontext().prec = 70
    rng = random.Random(1)
    one = Decimal(2) ** ROTATION_BITS
    for _ in range(200):
        turns = Fraction(rng.randrange(-(2**20), 2**20), 2 ** rng.randrange(20))
        radians = Fraction(rng.choice([0.0, rng.uniform(-4, 4), rng.uniform(-1e6, 1e6)]))
        angle = Decimal(radians.numerator) / radians.denominator
        angle += 2 * PI_TO_80_DIGITS * turns.numerator / turns.denominator
        for found, true in zip(rotation(radians, turns), decimal_cos_sin(angle), strict=True):
            assert abs(found - true * one) <= 1


def test_pi() -> None:
    getcontext().prec = 75
    assert abs(PI - PI_TO_80_DIGITS * Decimal(2) ** ANGLE_BITS) <= 1


@pytest.mark.parametrize("seed", range(3))
def test_negative_is_sound_and_sharp(seed: int) -> None:
    """C + D cos θ + E sin θ on an arc: against its maximum in closed form."""
    rng = random.Random(seed)
    for _ in range(1000):
        level = rng.randrange(1, 12)
        first = Fraction(rng.randrange(1 << level), 1 << level)
        last = first + Fraction(1, 1 << level)
        D, E = rng.gauss(0, 1), rng.gauss(0, 1)
        low, high = 2 * math.pi * float(first), 2 * math.pi * float(last)
        peak = math.atan2(E, D) % (2 * math.pi)
        inside = any(low <= peak + 2 * math.pi * k <= high for k in (0, 1))
        ends = (D * math.cos(a) + E * math.sin(a) for a in (low, high))
        most = math.hypot(D, E) if inside else max(ends)
        margin = rng.choice([-1, 1]) * 10.0 ** rng.uniform(-12, 0)
        C = -most + margin
        scaled = tuple(round(math.ldexp(x, 100)) for x in (C, D, E))
        found = is_negative(scaled, Extent([], first, last).end_rotations())
        assert found == (margin < 0)


def random_convex(rng: random.Random, reach: float, count: int) -> Points:
    hull = shapely.MultiPoint(
        [(rng.uniform(-reach, reach), rng.uniform(-reach, reach)) for _ in range(count)]
    ).convex_hull
    ring = shapely.Polygon(hull).exterior.coords[:-1]
    return ring if shapely.LinearRing(ring).is_ccw else ring[::-1]


def piece_of(points: Points, obstacle: bool) -> Piece:
    return convex_piece("", [(units(x), units(y)) for x, y in points], of_obstacle=obstacle)


def case_of(robot: Points, obstacle: Points) -> Case:
    """Return a case of one piece each."""
    nowhere = Pose((0, 0), angle_of(0.0))
    mine, other = piece_of(robot, False), piece_of(obstacle, True)
    pieces = Pieces({"0": [mine]}, {"0": [other]})
    polygons = {"0": [mine.vertices]}, {"0": [other.vertices]}
    return Case(*polygons, {}, {}, True, nowhere, nowhere, pieces)


def placed(points: Points, x: float, y: float, theta: float) -> shapely.Polygon:
    turned = affinity.rotate(shapely.Polygon(points), theta, origin=(0, 0), use_radians=True)
    return affinity.translate(turned, x, y)


@pytest.mark.parametrize("seed", range(3))
def test_overlap_holds_in_the_whole_box(seed: int) -> None:
    """A box that passes has no sample apart; a small box in deep overlap passes."""
    rng = random.Random(seed)
    passed = failed = 0
    for _ in range(60):
        robot, obstacle = random_convex(rng, 1, 7), random_convex(rng, 2, 9)
        case = case_of(robot, obstacle)
        level, half = rng.randrange(0, 7), 2.0 ** -rng.randrange(1, 9)
        k = rng.randrange(1 << level)
        x, y = (round(rng.uniform(-1.5, 1.5), 3) for _ in range(2))
        corners = [(units(x + a * half), units(y + b * half)) for a in (-1, 1) for b in (-1, 1)]
        at = Extent(corners, Fraction(k, 1 << level), Fraction(k + 1, 1 << level))
        try:
            check_overlap(case, "", (0, 0, 0, 0), at)
            full = True
        except CertificateRejected:
            full = False
        samples = [
            (x + a * half, y + b * half, 2 * math.pi * (k + c) / (1 << level))
            for a, b, c in product((-1, 0, 1), (-1, 0, 1), (i / 16 for i in range(17)))
        ]
        shapes = [placed(robot, *sample) for sample in samples]
        depth = min(shape.intersection(shapely.Polygon(obstacle)).area for shape in shapes)
        passed, failed = passed + full, failed + (not full)
        assert depth > 0 or not full
        if not full and half < 0.02 and level > 4:
            assert depth < 0.5
    assert min(passed, failed) > 5


@pytest.mark.parametrize("seed", range(3))
def test_separating_edges_hold_during_the_whole_motion(seed: int) -> None:
    """A motion that an edge clears has no sample overlapping; a short clear motion is cleared."""
    rng = random.Random(seed)
    cleared = 0
    for _ in range(150):
        robot, obstacle = random_convex(rng, 1, 6), random_convex(rng, 2, 8)
        case = case_of(robot, obstacle)
        stretch = 2.0 ** -rng.randrange(0, 8)
        ends = []
        start = [rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-10, 10)]
        for x, y, theta in (start, [v + stretch * rng.uniform(-1, 1) for v in start]):
            ends.append(Waypoint(units(x), units(y), theta, 0))
        first, last = (Fraction(k, 8) for k in sorted(rng.sample(range(9), 2)))
        motion = make_motion(*ends, int(first * ONE), int(last * ONE))
        mine, other = case.pieces.pair("", (0, 0, 0, 0))
        clear = any(
            all(stays_outside(edge, vertex, motion) for vertex in against.vertices)
            for own, against in ((mine, other), (other, mine))
            for edge in own.edges
        )
        (ax, ay, at, _), (bx, by, bt, _) = ends
        gap = math.inf
        for k in range(17):
            s = first + (last - first) * Fraction(k, 16)
            x, y = (
                float(Fraction(a, ONE) + s * Fraction(b - a, ONE)) for a, b in ((ax, bx), (ay, by))
            )
            shape = placed(robot, x, y, at + float(s) * (bt - at))
            area = shape.intersection(shapely.Polygon(obstacle)).area
            gap = min(gap, shape.distance(shapely.Polygon(obstacle)) - area)
            xmin, ymin, xmax, ymax = (Fraction(v, ONE) for v in swept_box(case.outline, motion))
            box = shapely.box(float(xmin), float(ymin), float(xmax), float(ymax))
            assert box.buffer(1e-9).contains(shape)
        cleared += clear
        assert gap > -1e-12 or not clear
        if gap > 0.3 and stretch < 0.02:
            assert clear
    assert cleared > 10


@pytest.mark.parametrize("seed", range(4))
def test_cover_equals_brute_force(seed: int) -> None:
    rng = random.Random(seed)
    answers = set()
    for _ in range(400):

        def rectangles(count: int) -> set[Any]:
            made = set()
            for _ in range(count):
                x, y = (sorted(rng.sample(range(9), 2)) for _ in range(2))
                made.add((x[0], y[0], x[1], y[1]))
            return made

        needs, covers = rectangles(rng.randrange(1, 3)), rectangles(rng.randrange(9))

        def cells(of: set[Any]) -> set[tuple[int, int]]:
            return {c for a, b, c_, d in of for c in product(range(a, c_), range(b, d))}

        expected = cells(needs) <= cells(covers)
        assert covered(needs, covers, (0, 0, 8, 8)) == expected
        answers.add(expected)
    assert len(answers) == 2


def test_partitions_by_an_independent_triangulation() -> None:
    """Shapely's triangles of polygons with holes pass; with one moved, doubled or lost, not."""
    rng = random.Random(5)
    for _ in range(20):
        angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(12))
        radii = [rng.uniform(2, 5) for _ in angles]
        outer = [(r * math.cos(a), r * math.sin(a)) for a, r in zip(angles, radii, strict=True)]
        hole = [(0.1, 0.1), (0.2, 0.7), (0.8, 0.3)]
        polygon = shapely.Polygon(outer, [hole])
        if not polygon.is_valid:
            continue
        triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))
        pieces = [
            [(units(x), units(y)) for x, y in shapely.get_coordinates(t)[:-1].tolist()]
            for t in triangles
        ]
        pieces = [p if cross(minus(p[1], p[0]), minus(p[2], p[1])) > 0 else p[::-1] for p in pieces]
        rings = [[(units(x), units(y)) for x, y in ring] for ring in (outer, hole)]
        check_partition("", rings, pieces)
        for wrong in (
            pieces[1:],
            [*pieces, pieces[0]],
            [[(x + 1, y) for x, y in pieces[0]], *pieces[1:]],
        ):
            with pytest.raises(CertificateRejected, match="partition"):
                check_partition("", rings, wrong)


def test_partition_with_vertices_on_sides() -> None:
    """Straight angles and T-junctions: the pieces need not have the polygon's vertices."""
    square = [(0, 0), (2, 0), (4, 0), (4, 4), (0, 4)]
    left, low, high = (
        [(0, 0), (1, 0), (1, 4), (0, 4)],
        [(1, 0), (4, 0), (4, 2), (1, 2)],
        [(1, 2), (4, 2), (4, 4), (1, 4)],
    )
    check_partition("", [square], [left, low, high])
    with pytest.raises(CertificateRejected):
        check_partition("", [square], [left, low, [(1, 2), (4, 2), (4, 4), (1, 3)]])


@pytest.mark.parametrize(
    "vertices",
    [
        [],
        [(0, 0)],
        [(0, 0), (1, 0)],
        [(0, 0), (1, 0), (2, 0)],
        [(0, 0), (0, 1), (1, 0)],
        [(0, 0), (2, 0), (1, 0), (1, 1)],
        [(0, 0), (2, 0), (2, 0), (0, 2)],
        [(0, 0), (4, 0), (1, 1), (0, 4)],
        [(0, 0), (2, 0), (0, 2), (0, 0), (2, 0), (0, 2)],
    ],
)
def test_not_convex(vertices: list[tuple[int, int]]) -> None:
    with pytest.raises(CertificateRejected, match="convex"):
        convex_piece("", vertices, of_obstacle=True)


def test_straight_angles_are_convex() -> None:
    assert len(convex_piece("", [(0, 0), (1, 0), (2, 0), (0, 2)], of_obstacle=True).edges) == 4


@pytest.mark.parametrize("name", HAND_MADE)
def test_hand_made_certificates_are_valid(name: str) -> None:
    scene, certificate = hand_made(name)
    report = verify_certificate(scene, certificate)
    assert report.verdict == certificate["verdict"]
    assert report.proof == certificate.get("claim", "path")


@pytest.mark.parametrize(
    ("theta", "side"), [(1.0, 0), (-1.0, 1), (7.0, 0), (-7.0, 1), (3.2, 1), (3.1, 0), (100.0, 1)]
)
def test_angles_of_start_and_goal_are_taken_modulo_a_turn(theta: float, side: int) -> None:
    """Only the half turn `side` is on the start's side; its faces in theta are open, of course."""
    scene, certificate = hand_made("turning_wall")
    certificate["start_side"] = [certificate["start_side"][side]]
    scene["start"] = scene["goal"] = [2, 1, theta]
    with pytest.raises(CertificateRejected, match="may hold the goal"):
        verify_certificate(scene, signed(scene, certificate))
    scene["goal"] = [8, 1, 0]
    with pytest.raises(CertificateRejected, match="neither shared nor FULL"):
        verify_certificate(scene, signed(scene, certificate))
    certificate["start_side"][0][2][1] = 1 - side
    with pytest.raises(CertificateRejected, match="does not hold the start"):
        verify_certificate(scene, signed(scene, certificate))


def test_an_angle_at_the_seam_is_on_both_sides() -> None:
    scene, certificate = hand_made("turning_wall")
    for side in (0, 1):
        scene["start"] = scene["goal"] = [2, 1, 0]
        one = {**certificate, "start_side": [certificate["start_side"][side]]}
        with pytest.raises(CertificateRejected, match="may hold the goal"):
            verify_certificate(scene, signed(scene, one))


@pytest.mark.parametrize("theta", [1e-300, -1e-300])
def test_an_angle_near_the_seam_is_on_the_side_of_its_sign(theta: float) -> None:
    scene, certificate = hand_made("turning_wall")
    scene["start"] = [2, 1, theta]
    assert verify_certificate(scene, signed(scene, certificate)).verdict == "no_path"
    other = certificate["start_side"][int(theta > 0)]  # the first box is above turn 0
    one = {**certificate, "start_side": [other]}
    with pytest.raises(CertificateRejected, match="does not hold the start"):
        verify_certificate(scene, signed(scene, one))
    scene |= {"start": [8, 1, 0], "goal": [2, 1, theta]}
    with pytest.raises(CertificateRejected, match="may hold the goal"):
        verify_certificate(scene, signed(scene, certificate))


def test_contact_tolerance_must_be_allowed() -> None:
    scene, certificate = hand_made("over_block")
    certificate["waypoints"][0][0] -= 2.0**-10
    certificate["contact_tolerance"] = 2.0**-10
    with pytest.raises(CertificateRejected, match="contact_tolerance"):
        verify_certificate(scene, certificate)
    report = verify_certificate(scene, certificate, contact_tolerance=0.5)
    assert report.contact_tolerance == 2.0**-10
    certificate["contact_tolerance"] = 2.0**-11
    with pytest.raises(CertificateRejected, match="elsewhere"):
        verify_certificate(scene, certificate, contact_tolerance=0.5)


@pytest.mark.parametrize("tolerance", [-1.0, math.nan, math.inf])
def test_a_contact_tolerance_is_a_length(tolerance: float) -> None:
    with pytest.raises(OptionsError, match="contact_tolerance must be finite"):
        verify_certificate(*hand_made("over_block"), contact_tolerance=tolerance)


def grid_certificate(scene: Json, levels: tuple[int, int, int]) -> Json | None:
    """Return a certificate from a uniform grid alone, or None if start and goal are connected.

    A box is FULL if the checker says so for one of the walls or obstacles (here convex).
    """
    problem = make_problem(load_scene(scene))
    rings = [shape["coordinates"][0] for shape in scene["obstacles"]]
    certificate: Json = {
        "format": "planar-planner/certificate",
        "version": 1,
        "made_by": "grid",
        "verdict": "no_path",
        "claim": "separation",
        "robot_pieces": {"0": scene["robot"]["coordinates"]},
        "obstacle_pieces": {str(q): [ring] for q, ring in enumerate(rings)},
        "domain": {"low": [[0, 0], [0, 0]], "size": [[1, 3], [1, 3]]},
        "full_faces": [],
    }
    content = read_certificate(signed(scene, certificate | {"start_side": [], "full": []}))
    case = make_case(problem, content)
    domain = Domain((0, 0), (units(8.0), units(8.0)), None)
    counts = [1 << level for level in levels]
    robot = scene["robot"]["coordinates"][0]
    inner = shapely.box(0, 0, 8, 8)
    claims: list[tuple[Collision, Any]] = [
        (Collision((0, 0, q, 0), None, None), shapely.Polygon(ring)) for q, ring in enumerate(rings)
    ]
    beyond = shapely.box(-9, -9, 17, 17) - inner
    claims += [(Collision(None, wall, None), beyond) for wall in case.walls]

    def full(cell: tuple[int, ...]) -> Json | None:
        box: Any = tuple(zip(levels, cell, strict=True))
        ends = ((k / n, (k + 1) / n) for k, n in zip(cell, counts, strict=True))
        shapes = [placed(robot, 8 * x, 8 * y, 2 * math.pi * a) for x, y, a in product(*ends)]
        for claim, blocked in claims:
            if not all(shape.intersection(blocked).area > 0 for shape in shapes):
                continue  # for speed alone: a box with a free corner cannot be FULL
            try:
                check_full(case, "", claim, domain.extent("", box))
            except CertificateRejected:
                continue
            return {"wall": claim.wall} if claim.pair is None else {"pair": [*claim.pair]}
        return None

    def cell_of(pose: list[float]) -> tuple[int, ...]:
        parts = (pose[0] / 8, pose[1] / 8, pose[2] / (2 * math.pi) % 1)
        return tuple(int(part * count) for part, count in zip(parts, counts, strict=True))

    start, goal = cell_of(scene["start"]), cell_of(scene["goal"])
    seen, queue, blocked = {start}, deque([start]), {}
    while queue and goal not in seen:
        cell = queue.popleft()
        for axis, step in product(range(3), (-1, 1)):
            k = cell[axis] + step
            if axis == 2:
                k %= counts[2]
            next_cell = (*cell[:axis], k, *cell[axis + 1 :])
            if not 0 <= k < counts[axis] or next_cell in seen or next_cell in blocked:
                continue
            claim = full(next_cell)
            if claim is not None:
                blocked[next_cell] = claim
            else:
                seen.add(next_cell)
                queue.append(next_cell)
    if goal in seen:
        return None
    boxes = {cell: [list(pair) for pair in zip(levels, cell, strict=True)] for cell in seen}
    certificate["start_side"] = list(boxes.values())
    certificate["full"] = [
        {"box": [list(pair) for pair in zip(levels, cell, strict=True)]} | claim
        for cell, claim in blocked.items()
    ]
    return signed(scene, certificate)


def slot_scene(gap: float) -> Json:
    """A bar of 2 by 0.5 before a slot in a wall, which it can pass end-on if at all."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 8, 8]},
        "robot": {"type": "Polygon", "coordinates": [rectangle(-1, -0.25, 1, 0.25)]},
        "obstacles": [
            {"type": "Polygon", "coordinates": [rectangle(3, 0, 5, 4 - gap / 2)]},
            {"type": "Polygon", "coordinates": [rectangle(3, 4 + gap / 2, 5, 8)]},
        ],
        "start": [1.5, 4, 1.5],
        "goal": [6.5, 4, 1.5],
    }


def test_a_grid_alone_certifies_a_blocked_slot() -> None:
    scene = slot_scene(0.2)
    certificate = grid_certificate(scene, (4, 4, 4))
    assert certificate is not None
    report = verify_certificate(scene, certificate)
    assert report.claims > 500
    wider = slot_scene(0.4)
    with pytest.raises(CertificateRejected):
        verify_certificate(wider, signed(wider, certificate))


def test_a_grid_finds_an_open_slot_open() -> None:
    assert grid_certificate(slot_scene(1.5), (4, 4, 4)) is None


def test_whole_turn_boxes_need_no_seam() -> None:
    scene, certificate = hand_made("turning_wall")
    certificate["start_side"] = [[[1, 0], [0, 0], [0, 0]]]
    assert verify_certificate(scene, certificate).verdict == "no_path"
