"""Upper bounds of PD^g: free configurations, oracles by linear programmes and by a grid."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray
from scipy.optimize import linprog

import pdg
from oracles.placing import placed
from worlds.bodies.paper_models import Model, models
from worlds.bodies.random_bodies import blob, convex

Pose = tuple[float, float, float]
SAMPLES = 21
# Rounding of bodies of size 10 in plain doubles (length): brackets are rounded outwards by 3e-14.
ROUNDING = 1e-12
# Area of overlap that shapely may report of bodies of size 10 that only touch: 1e-14 of their own.
OVERLAP = 1e-12


def placed_geometry(body: Any, pose: Pose) -> shapely.Geometry:
    return shapely.transform(body, lambda points: placed(points, pose))


def assert_free(body: Any, obstacle: Any, pose: Pose) -> None:
    """By shapely, to `OVERLAP`; and by the library's lower bound, which decides exactly."""
    assert placed_geometry(body, pose).intersection(obstacle).area < OVERLAP
    assert pdg.generalized_depth_lower_bound(body, obstacle, pose).pair is None


def check(body: Any, obstacle: Any, pose: Pose, A: Any = None, B: Any = None) -> Any:
    """Return UB1 after checking everything that is promised of both bounds at one pose."""
    A = pdg.convex_pieces(body) if A is None else A
    B = pdg.convex_separators(obstacle) if B is None else B
    lower = pdg.generalized_depth_lower_bound(A, B.pieces, pose).lower
    first = pdg.generalized_depth_upper_bound(A, B, pose)
    second = pdg.generalized_depth_upper_bound(A, B, pose, method="hulls")
    best = pdg.generalized_depth_upper_bound(A, B, pose, method="best")
    assert lower <= best.upper <= first.upper <= second.upper
    assert best.distance_upper <= first.distance_upper <= second.distance_upper
    for bound in (best, first, second):
        assert bound.upper <= bound.distance_upper
        assert_free(body, obstacle, bound.placement.pose)
        assert_free(body, obstacle, bound.distance_placement.pose)
        moved = pdg.displacement(A, pose, bound.placement.pose)
        assert moved == pytest.approx(bound.upper, rel=1e-14)
        _, far = pdg.generalized_distance_bracket(A, pose, bound.distance_placement.pose)
        assert far == pytest.approx(bound.distance_upper, rel=1e-14)
    if lower == 0:
        assert (first.upper, first.placement.source) == (0, "free")
    return first


@pytest.mark.parametrize("model", models(), ids=lambda model: model.name)
def test_sweeps(model: Model) -> None:
    A, B = pdg.convex_pieces(model.moving), pdg.convex_separators(model.fixed)
    poses = model.configurations(SAMPLES)
    bounds = [check(model.moving, model.fixed, tuple(q), A, B) for q in poses]
    hulls = pdg.generalized_depth_upper_bound(A, B, poses, method="hulls").upper
    gains = hulls - [bound.upper for bound in bounds]
    assert np.median(gains / hulls) > 0.2  # the separators are of use
    for q, bound in zip(poses[::2], bounds[::2], strict=True):
        found = pdg.generalized_depth_bracket(A, B, q, relative_tolerance=0.01)
        lower = pdg.generalized_depth_lower_bound(A, B.pieces, q).lower
        assert lower - ROUNDING <= found.lower <= found.upper
        assert found.upper <= bound.upper + ROUNDING
        assert found.distance_upper <= bound.distance_upper + ROUNDING


def test_convex_pairs_give_the_translational_depth() -> None:
    random = np.random.default_rng(1)
    for _ in range(200):
        a, b = convex(random), convex(random)
        q = tuple(random.uniform(-3, 3, 3))
        bound = check(shapely.Polygon(a), shapely.Polygon(b), q)
        depth = max(0.0, pdg.translational_depth(a, b, q).depth)
        assert bound.upper == pytest.approx(depth, abs=1e-12)
        assert bound.distance_upper == pytest.approx(depth, abs=1e-12)


def test_random_bodies_with_pockets_and_holes() -> None:
    random = np.random.default_rng(2)
    sources = []
    for _ in range(120):
        body, obstacle = blob(random, 1), blob(random, 7)
        size = random.uniform(0.1, 1.5)
        body = shapely.transform(body, lambda points, size=size: size * points)
        at = shapely.get_coordinates(obstacle.centroid)[0]
        bound = check(body, obstacle, (*(at + random.normal(0, 1.5, 2)), random.uniform(-4, 4)))
        sources.append(bound.placement.source)
    assert sources.count("separator") > 30
    assert sources.count("hulls") > 5


def region(sides: NDArray[np.float64], reach: float) -> shapely.Polygon:
    """Return what half-planes leave of a square of half-side `reach`."""
    left = shapely.box(-reach, -reach, reach, reach)
    for x, y, c in sides:
        n, t = np.array((x, y)), np.array((-y, x))
        corners = [(c * n) + 4 * reach * v for v in (-t, t)]
        left = left.difference(
            shapely.Polygon([*corners, *(p + 4 * reach * n for p in corners[::-1])])
        )
    return left


def test_containers_hold_nothing_of_the_body() -> None:
    random = np.random.default_rng(3)
    bodies = [*(model.fixed for model in models()), *(blob(random, 7) for _ in range(30))]
    for body in bodies:
        for sides in pdg.convex_separators(body):
            assert len(sides) >= 2
            assert np.hypot(sides[:, 0], sides[:, 1]) == pytest.approx(1, abs=1e-14)
            container = region(sides, 30.0)
            assert container.area > 0
            assert container.intersection(body).area < 1e-9  # of the clipping: 30^2 * 1e-12


def test_every_pocket_and_hole_has_a_container() -> None:
    comb = shapely.box(0, 0, 9, 4)
    for x in (1, 3, 5, 7):
        comb = comb.difference(shapely.box(x, 1, x + 1, 5))
    comb = comb.difference(shapely.Polygon([(8.2, 1), (8.8, 1), (8.5, 2)]))  # a hole
    containers = [region(sides, 20.0) for sides in pdg.convex_separators(comb)]
    for inside in [(1.5, 1.5), (3.5, 1.5), (5.5, 1.5), (7.5, 1.5), (8.5, 1.3)]:
        assert any(container.contains(shapely.Point(inside)) for container in containers)
    hole = min(containers, key=lambda container: container.area)
    assert hole.area == pytest.approx(0.3)


def least_in_container(
    hull: NDArray[np.float64], q: Pose, sides: NDArray[np.float64], theta: float, corners: int
) -> float:
    """Return the least DISP at an angle by HiGHS, lengths measured by a regular polygon's gauge.

    The gauge is at most the length, and at least cos(pi / corners) times it.
    """
    at_q, turned = placed(hull, q), placed(hull, (0.0, 0.0, theta))
    angles = 2 * np.pi * np.arange(corners) / corners
    u = np.column_stack([np.cos(angles), np.sin(angles)])
    # u . (turned + t - at_q) <= z for all vertices; only the farthest one matters for each u.
    farthest = ((turned - at_q) @ u.T).max(axis=0)
    support = (turned @ sides[:, :2].T).max(axis=0)
    rows = np.vstack(
        [np.column_stack([u, -np.ones(corners)]), np.pad(sides[:, :2], ((0, 0), (0, 1)))]
    )
    bounds = np.concatenate([-farthest, sides[:, 2] - support])
    solved = linprog([0, 0, 1], A_ub=rows, b_ub=bounds, bounds=[(None, None)] * 3, method="highs")
    return float(solved.fun) if solved.success else math.inf


def container_cases(count: int) -> list[tuple[NDArray[np.float64], shapely.Polygon, Pose]]:
    """Return bodies, and thick blocks with one convex hole that holds them, not far from q."""
    random = np.random.default_rng(4)
    cases = []
    while len(cases) < count:
        hole, hull = convex(random, 3.0), convex(random, 1.2)
        block = shapely.box(-60, -60, 60, 60).difference(shapely.Polygon(hole))
        q = (*random.uniform(-2.5, 2.5, 2), random.uniform(-3, 3))
        bound = pdg.generalized_depth_upper_bound(hull, block, q)
        if bound.placement.source == "separator":
            cases.append((hull, block, q))
    return cases


def test_placements_in_a_container_are_the_least_over_all_angles() -> None:
    corners = 64
    for hull, block, q in container_cases(5):
        separators = pdg.convex_separators(block)
        assert len(separators) == 1
        (sides,) = separators
        bound = pdg.generalized_depth_upper_bound(hull, separators, q)
        at_angle = least_in_container(hull, q, sides, bound.placement.pose[2], corners)
        assert at_angle <= bound.upper * (1 + 1e-9)
        assert bound.upper * math.cos(math.pi / corners) <= at_angle + 1e-9
        for theta in q[2] + np.linspace(-np.pi, np.pi, 181):
            least = least_in_container(hull, q, sides, theta, corners)
            assert bound.upper * math.cos(math.pi / corners) <= least * (1 + 1.1e-3)


def two_levels(hull: NDArray[np.float64], q0: Pose, sides: NDArray[np.float64]) -> float:
    """Return [PDG] section 5 to the letter, by HiGHS: DISP of the containment, infinite if none.

    Eqs. 10 and 11 find a containment from q0 by small turns; Eqs. 12 to 14 then lessen
    |x| + |y| + R |theta| from q0 (R about the origin of the body's frame).
    """
    radius = float(np.hypot(*hull.T).max())
    q = np.array(q0)

    def rows() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Eq. 10: c . dt + (c x-turned vertex) dtheta <= b - c . p, for all sides and vertices."""
        p = placed(hull, tuple(q))
        arm = p - q[:2]
        turned = np.column_stack([-arm[:, 1], arm[:, 0]])
        n, b = sides[:, :2], sides[:, 2]
        spin = (n @ turned.T).ravel()
        return np.column_stack([np.repeat(n, len(p), axis=0), spin]), (b[:, None] - n @ p.T).ravel()

    step = np.array([1.0, 1.0, 0.3])
    for _ in range(60):
        g, room = rows()
        if room.min() >= -1e-10:
            break
        count = len(room)
        solved = linprog(
            np.concatenate([np.zeros(3), np.ones(count)]),
            A_ub=np.hstack([g, -np.eye(count)]),
            b_ub=room,
            bounds=[*((-s, s) for s in step), *([(0, None)] * count)],
        )
        q = q + solved.x[:3]
    else:
        return math.inf
    best = pdg.displacement(hull, q0, q)
    for _ in range(40):
        g, room = rows()
        weights = np.array([1.0, 1.0, radius])
        away = q - q0
        solved = linprog(
            np.concatenate([np.zeros(3), weights]),
            A_ub=np.vstack(
                [
                    np.hstack([g, np.zeros((len(g), 3))]),
                    np.hstack([np.eye(3), -np.eye(3)]),
                    np.hstack([-np.eye(3), -np.eye(3)]),
                ]
            ),
            b_ub=np.concatenate([np.maximum(room, 0), -away, away]),
            bounds=[*((-s, s) for s in step), *([(0, None)] * 3)],
        )
        if not solved.success:
            break
        q = q + solved.x[:3]
        step = 0.7 * step
        if rows()[1].min() >= -1e-10:
            best = min(best, pdg.displacement(hull, q0, q))
    return best


def test_never_worse_than_the_papers_two_levels_of_linear_programmes() -> None:
    found = 0
    for hull, block, q in container_cases(12):
        separators = pdg.convex_separators(block)
        (sides,) = separators
        bound = pdg.generalized_depth_upper_bound(hull, separators, q).upper
        published = two_levels(hull, q, sides)
        assert bound <= published * (1 + 1.1e-3)
        found += math.isfinite(published)
    assert found > 6


def test_a_dense_grid_finds_nothing_much_better_in_a_hole() -> None:
    """UB1 is an upper bound: no free configuration of a grid may be below PD^g, nor UB1 below."""
    block = shapely.box(-6, -6, 6, 6).difference(shapely.box(-1, -1.5, 1, 1.5))
    body = shapely.box(-0.8, -1.0, 0.8, 1.0)
    q0 = (0.5, -0.9, 0.5)
    bound = check(body, block, q0)
    step = 0.05
    turn = 0.02
    poses = np.stack(
        np.meshgrid(
            np.arange(-0.4, 0.6, step), np.arange(-1.1, 0.6, step), np.arange(-0.4, 0.8, turn)
        ),
        axis=-1,
    ).reshape(-1, 3)
    free = pdg.generalized_depth_lower_bound(body, block, poses).pair[:, 0] < 0
    least = pdg.displacement(body, q0, poses[free]).min()
    radius = math.hypot(0.8, 1.0)
    cell = math.hypot(step / 2, step / 2) + radius * turn / 2
    assert least - 2 * cell <= bound.upper <= least * (1 + 1.1e-3)


def test_a_batch_is_its_rows() -> None:
    model = models()[3]
    A, B = pdg.convex_pieces(model.moving), pdg.convex_separators(model.fixed)
    poses = model.configurations(7)
    for method in ("separators", "hulls", "best"):
        many = pdg.generalized_depth_upper_bound(A, B, poses, method=method)
        assert len(many) == 7
        for row, one in zip(poses, many, strict=True):
            assert one == pdg.generalized_depth_upper_bound(A, B, tuple(row), method=method)
    assert len(pdg.generalized_depth_upper_bound(A, B, [])) == 0


def test_drawing_back_is_of_use_where_hulls_say_little() -> None:
    model = models()[2]  # a spoon outside a cup
    poses = model.configurations(20)[:5]
    A, B = pdg.convex_pieces(model.moving), pdg.convex_separators(model.fixed)
    first = pdg.generalized_depth_upper_bound(A, B, poses)
    best = pdg.generalized_depth_upper_bound(A, B, poses, method="best")
    assert best.placement.drawn_back.all()
    assert best.distance_placement.drawn_back.all()
    assert (best.upper < 0.95 * first.upper).all()


def test_polygons_of_one_body_may_overlap() -> None:
    obstacle = [shapely.box(-3, -3, 3, -1), shapely.box(-3, -3, -1, 3), shapely.box(1, -3, 3, 3)]
    union = shapely.union_all(obstacle)
    body = shapely.box(-0.8, -0.8, 0.8, 0.8)
    bound = pdg.generalized_depth_upper_bound(body, obstacle, (0.0, -0.5, 0.0))
    assert_free(body, union, bound.placement.pose)
    assert bound.upper >= 0.3 - 1e-12


def test_far_from_the_origin() -> None:
    """What is confirmed free is free for the placed doubles, however coarse they are."""
    model = models()[1]
    for shift in (1e3, 1e6, 1e9):
        moved = shapely.transform(model.fixed, lambda points, s=shift: points + s)
        for q in model.configurations(5):
            pose = (q[0] + shift, q[1] + shift, q[2])
            bound = pdg.generalized_depth_upper_bound(model.moving, moved, pose)
            near = pdg.generalized_depth_upper_bound(model.moving, model.fixed, tuple(q))
            free = pdg.generalized_depth_lower_bound(model.moving, moved, bound.placement.pose)
            assert free.pair is None
            assert bound.upper == pytest.approx(near.upper, abs=2e-3 + 1e-13 * shift)


def test_bad_arguments_are_refused() -> None:
    square = shapely.box(-1, -1, 1, 1)
    with pytest.raises(pdg.PdgError, match="method: expected") as caught:
        pdg.generalized_depth_upper_bound(square, square, method="hull")
    assert (caught.value.name, caught.value.value) == ("method", "hull")
    with pytest.raises(pdg.PdgError, match=r"pose\[1\]: must be finite"):
        pdg.generalized_depth_upper_bound(square, square, (0, math.inf, 0))
    with pytest.raises(pdg.PdgError, match="pose"):
        pdg.generalized_depth_upper_bound(square, square, [(0, 0, 0), (0, 0, math.nan)])
    with pytest.raises(pdg.PdgError, match="B: "):
        pdg.convex_separators([(0, 0), (1, 1)])
    with pytest.raises(pdg.PdgError, match="A: "):
        pdg.generalized_depth_upper_bound([(0, 0), (1, 1)], square)


def test_bodies_of_a_few_roundings_end_and_are_free() -> None:
    """Turns that move less than rounding are not told apart without end."""
    a = [
        (1.0000000000000009, 1.0000000000000007),
        (1.000000000000001, 1.0000000000000007),
        (1.000000000000001, 1.0000000000000009),
    ]
    b = pdg.convex_pieces(
        [
            [
                (0.5026874276137621, -1.8933381480464364),
                (0.4825942655894805, -1.0961219834712197),
                (1.395897678528014, -0.3966679062634869),
                (-1.094302511892504, 0.8342518934408706),
            ],
            [
                (0.6289849077154187, 1.1975431871568207),
                (0.6289849077154189, 1.1975431871568205),
                (0.6289849077154192, 1.1975431871568207),
                (0.6289849077154192, 1.1975431871568205),
                (0.6289849077154194, 1.197543187156821),
                (0.6289849077154194, 1.1975431871568214),
                (0.6289849077154192, 1.1975431871568214),
                (0.6289849077154185, 1.1975431871568216),
            ],
            [
                (-0.9953790552976154, -1.9213606798516574),
                (1.3043119753027657, -2.774015755812215),
                (0.5204566933880068, -0.5775555619474746),
                (-0.10358522333782774, -0.5383194488629955),
                (-0.22732714115803948, -1.0107314049013958),
                (-0.545704770268232, -0.40661641626684103),
                (-1.2130966132677767, -0.56587928620026),
            ],
        ]
    )
    pose = (-0.37101509228458196, 0.1975431871568205, 0.0)
    for method in ("separators", "best"):
        got = pdg.generalized_depth_upper_bound(a, b, pose, method=method)
        assert got.upper < 1e-12
        assert pdg.translational_depth(a, b, got.placement.pose).state != "overlap"
