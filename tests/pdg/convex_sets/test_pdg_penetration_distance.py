"""d_Q(A): closed forms, a slow minimisation, PD^t, and sets that are hard on rounding."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial import ConvexHull

import pdg
from pdg import PenetrationDistance, sets

Case = tuple[str, sets.ConvexSet, sets.ConvexSet, float]


def rotation(n: int, rng: np.random.Generator) -> np.ndarray:
    return np.linalg.qr(rng.normal(size=(n, n)))[0]


def closed_forms(n: int) -> Iterator[Case]:
    rng = np.random.default_rng(n)
    r, b = rng.uniform(0.5, 2, (2, n))
    c = rng.uniform(-0.4, 0.4, n)
    v = rng.normal(size=n)
    yield "ball in box", sets.Box(r, c), sets.Ball(n), float(np.min(r - np.abs(c)))
    yield "box in box", sets.Box(r), sets.Box(b), float(np.min(r / b))
    yield "cross-polytope in cube", sets.Box(np.ones(n)), sets.CrossPolytope(np.ones(n)), 1.0
    yield "cross-polytope in box", sets.Box(r), sets.CrossPolytope(b), float(np.min(r / b))
    yield "cross-polytope in ball", sets.Ball(n), sets.CrossPolytope(b), 1 / float(b.max())
    yield (
        "ball in cross-polytope",
        sets.CrossPolytope(r),
        sets.Ball(n),
        1 / math.sqrt(np.sum(r**-2.0)),
    )
    yield "box in cross-polytope", sets.CrossPolytope(r), sets.Box(b), 1 / float(np.sum(b / r))
    yield "ray in box", sets.Box(r), sets.Segment(np.zeros(n), v), float(np.min(r / np.abs(v)))
    if n <= 6:
        m, k = rng.normal(size=(2, n, n))
        eigenvalues = np.linalg.eigvals(np.linalg.solve(k @ k.T, m @ m.T)).real
        least = math.sqrt(eigenvalues.min())
        yield "ellipsoid in ellipsoid", sets.Ellipsoid(r), sets.Ellipsoid(b), float(np.min(r / b))
        yield "turned ellipsoids", sets.Ellipsoid(m), sets.Ellipsoid(k), least
        yield (
            "ray in ellipsoid",
            sets.Ellipsoid(r),
            sets.Segment(np.zeros(n), v),
            1 / float(np.linalg.norm(v / r)),
        )
    if n <= 4:
        yield "cube in ball", sets.Ball(n), sets.Box(np.ones(n)), 1 / math.sqrt(n)
        yield "box in ball", sets.Ball(n, 2.0), sets.Box(r), 2 / float(np.linalg.norm(r))


def check(found: PenetrationDistance, truth: float, eps: float, name: object) -> None:
    """A bracket of the truth, as narrow as asked for, attained by its direction."""
    assert found.state == "inside", name
    assert found.stop_reason == "converged", name
    # The truths themselves are computed: some twenty roundings.
    assert found.lower <= truth * (1 + 4e-15), name
    assert found.upper >= truth * (1 - 4e-15), name
    assert found.upper - found.lower <= eps, name
    assert found.lower > 0, name


@pytest.mark.parametrize("n", range(2, 9))
def test_closed_forms(n: int) -> None:
    eps = 1e-3 if n > 5 else 1e-4
    for name, A, Q, truth in closed_forms(n):
        found = pdg.penetration_distance(A, Q, eps)
        check(found, truth, eps, name)
        u = found.direction
        assert np.linalg.norm(u) == pytest.approx(1, rel=1e-14)
        assert A.support(u)[0] / Q.support(u)[0] == pytest.approx(found.upper, rel=1e-12)
        assert found.point @ u == pytest.approx(A.support(u)[0], rel=1e-12)


@pytest.mark.parametrize("n", [7, 8])
def test_round_sets_in_many_dimensions(n: int) -> None:
    """Facets of a round set multiply with the dimension: a coarse bracket, but a true one."""
    rng = np.random.default_rng(n)
    for _ in range(2):
        r, b = rng.uniform(1.0, 2.0, n), rng.uniform(0.5, 1.0, n)
        found = pdg.penetration_distance(
            sets.Ellipsoid(r), sets.Ellipsoid(b), absolute_tolerance=0.3
        )
        check(found, float(np.min(r / b)), 0.3, "ellipsoid in ellipsoid")


@pytest.mark.parametrize("n", [2, 3, 5])
def test_stretched_sets_keep_their_distance(n: int) -> None:
    """d_MQ(MA) = d_Q(A), however badly M scales: 10⁻⁶ to 10⁶."""
    rng = np.random.default_rng(100 + n)
    eps = 1e-3
    for name, A, Q, truth in closed_forms(n):
        along_axes = np.exp(rng.uniform(math.log(1e-6), math.log(1e6), n))
        for m in (np.diag(along_axes), 1e-6 * np.eye(n), 1e6 * rotation(n, rng)):
            found = pdg.penetration_distance(sets.AffineImage(m, A), sets.AffineImage(m, Q), eps)
            check(found, truth, eps, (name, m))


def test_turned_and_stretched_sets_bracket_or_say_so() -> None:
    """Rounding of the turned set's coordinates may hide its thin sides."""
    rng = np.random.default_rng(5)
    reasons = set()
    for n in (2, 3, 4):
        for name, A, Q, truth in closed_forms(n):
            m = rotation(n, rng) * np.exp(rng.uniform(math.log(1e-6), math.log(1e6), n))
            found = pdg.penetration_distance(sets.AffineImage(m, A), sets.AffineImage(m, Q), 1e-3)
            # The map's own rounding changes the truth by the condition number times 10⁻¹⁶.
            slack = truth * np.linalg.cond(m) * 1e-15
            assert found.lower <= truth + slack, name
            assert found.upper >= truth - slack, name
            assert found.stop_reason == "rounding" or found.upper - found.lower <= 1e-3, name
            reasons.add(found.stop_reason)
    assert "converged" in reasons


def check_exactly(found: PenetrationDistance, truth: Fraction) -> None:
    """With rationals: no slack at all."""
    assert Fraction(found.lower) <= truth <= Fraction(found.upper)
    assert found.upper - found.lower <= 1e-11 * found.upper


def test_bounds_hold_exactly_for_boxes() -> None:
    rng = np.random.default_rng(11)
    for _ in range(150):
        n = int(rng.integers(1, 6))
        r, b = rng.uniform(0.5, 2, (2, n))
        truth = min(Fraction(x) / Fraction(y) for x, y in zip(r, b, strict=True))
        for Q in (sets.Box(b), sets.CrossPolytope(b)):
            check_exactly(pdg.penetration_distance(sets.Box(r), Q, 0), truth)


def test_bounds_hold_exactly_for_polytopes() -> None:
    """Small integers: many coplanar points; facets' planes and d_Q(A) are rational numbers."""
    rng = np.random.default_rng(12)
    compared = 0
    for _ in range(150):
        points = rng.integers(-4, 5, (12, 3))
        r = rng.integers(1, 6, 3)
        hull = ConvexHull(points)
        if not (hull.equations[:, 3] < -1e-9).all():
            continue
        balls = (
            (sets.Box(r), lambda m, r=r: int(np.abs(m) @ r)),
            (sets.CrossPolytope(r), lambda m, r=r: int((np.abs(m) * r).max())),
        )
        for Q, h_q in balls:
            truth = Fraction(10**9)
            for simplex in points[hull.simplices]:
                m = np.cross(simplex[1] - simplex[0], simplex[2] - simplex[0])
                if m.any():
                    truth = min(truth, Fraction(abs(int(m @ simplex[0])), h_q(m)))
            check_exactly(pdg.penetration_distance(sets.PointSet(points), Q, 0), truth)
            compared += 1
    assert compared > 100


def test_distances_scale() -> None:
    for factor in (1e-6, 1e6):
        found = pdg.penetration_distance(
            sets.Ellipsoid(factor * np.array([1.0, 2, 3])), sets.Ball(3), 0, relative_tolerance=1e-5
        )
        check(found, factor, 1e-5 * factor, factor)


def random_set(n: int, rng: np.random.Generator) -> sets.ConvexSet:
    """Several kinds added up or joined, about the origin."""
    parts: list[sets.ConvexSet] = [
        sets.Ellipsoid(rng.normal(size=(n, rng.integers(1, n + 1))), 0.3 * rng.normal(size=n)),
        sets.PointSet(rng.normal(size=(2 * n, n))),
        sets.Scaled(-0.5, sets.CrossPolytope(rng.uniform(0.2, 2, n))),
        sets.Box(rng.uniform(0.1, 1, n), 0.1 * rng.normal(size=n)),
    ]
    chosen = [parts[i] for i in rng.choice(4, 2, replace=False)]
    if rng.random() < 0.5:
        return sets.MinkowskiSum(chosen)
    return sets.UnionHull([*chosen, sets.Ball(n, 0.3)])


def slow_minimum(A: sets.ConvexSet, Q: sets.ConvexSet, rng: np.random.Generator) -> float:
    """Min h_A / h_Q: many directions, the best of them improved by Nelder and Mead's method."""

    def ratio(u: np.ndarray) -> np.ndarray:
        h_q = Q.supports(u)[0]
        return np.where(h_q > 1e-9, A.supports(u)[0] / np.where(h_q > 1e-9, h_q, 1), np.inf)

    directions = rng.normal(size=(20000, A.dimension))
    best = directions[np.argsort(ratio(directions))[:6]]
    options = {"xatol": 1e-9, "fatol": 1e-10, "maxiter": 800, "adaptive": True}
    found = [
        minimize(lambda u: float(ratio(u[None])[0]), u, method="Nelder-Mead", options=options)
        for u in best / np.linalg.norm(best, axis=1, keepdims=True)
    ]
    return float(min(f.fun for f in found))


@pytest.mark.parametrize("n", [2, 3, 4])
def test_slow_minimisation_finds_nothing_below(n: int) -> None:
    rng = np.random.default_rng(40 + n)
    compared = 0
    for _ in range(5):
        A, Q = random_set(n, rng), random_set(n, rng)
        Q = sets.UnionHull([Q, sets.PointSet(np.zeros((1, n)))])
        found = pdg.penetration_distance(A, Q, 1e-5)
        slow = slow_minimum(A, Q, rng)
        if slow < 0:
            assert found.state == "outside"
            continue
        assert found.stop_reason == "converged"
        assert found.lower <= slow * (1 + 1e-12)
        # The slow way may stop above the minimum, by little.
        assert slow <= found.upper + 1e-4
        compared += 1
    assert compared >= 3


def convex_polygon(rng: np.random.Generator) -> np.ndarray:
    points = rng.normal(size=(8, 2))
    return points[ConvexHull(points).vertices]


def difference(a: np.ndarray, b: np.ndarray) -> sets.ConvexSet:
    return sets.MinkowskiSum([sets.PointSet(b), sets.Scaled(-1, sets.PointSet(a))])


def test_translational_depth_in_the_plane_is_a_special_case() -> None:
    rng = np.random.default_rng(3)
    states = set()
    for _ in range(60):
        a, b = convex_polygon(rng), convex_polygon(rng) + rng.normal(size=2)
        depth = pdg.translational_depth(a, b)
        found = pdg.penetration_distance(difference(a, b), sets.Ball(2), 1e-10)
        states.add(depth.state)
        if depth.state == "apart":
            assert found.state == "outside"
            assert found.upper == -math.inf
            continue
        assert found.state == "inside"
        assert found.lower <= depth.depth + 1e-13
        assert abs(found.upper - depth.depth) <= 1e-9
        assert abs(found.lower - depth.depth) <= 1e-9
    assert states == {"apart", "overlap"}


def test_translational_depth_in_space_is_a_special_case() -> None:
    rng = np.random.default_rng(4)
    inside = 0
    for _ in range(25):
        a, b = rng.normal(size=(2, 12, 3))
        b = b + 0.5 * rng.normal(size=3)
        differences = (b[:, None] - a[None]).reshape(-1, 3)
        depth = float(np.min(-ConvexHull(differences).equations[:, 3]))
        found = pdg.penetration_distance(difference(a, b), sets.Ball(3), 1e-10)
        if depth < 0:
            assert found.state == "outside"
            continue
        inside += 1
        assert abs(found.upper - depth) <= 1e-9
        assert abs(found.lower - depth) <= 1e-9
    assert inside >= 10


@pytest.mark.parametrize("n", [2, 3, 5])
def test_origin_outside_is_proved(n: int) -> None:
    rng = np.random.default_rng(n)
    for _ in range(20):
        centre = rng.normal(size=n)
        centre *= (1 + 10 ** rng.uniform(-9, 1)) / np.linalg.norm(centre)
        A = sets.Ball(n, 1.0, centre)
        found = pdg.penetration_distance(A, sets.Ball(n))
        assert found.state == "outside"
        assert found.lower == found.upper == -math.inf
        assert A.support(found.direction)[0] < 0


def test_origin_on_the_boundary() -> None:
    for A in (
        sets.Ball(3, 1.0, [1.0, 0, 0]),
        sets.Box([1.0, 2, 3], [1.0, 0, 3]),
        sets.CrossPolytope([1.0, 2, 3], [1.0, 0, 0]),
        sets.PointSet(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])),
    ):
        found = pdg.penetration_distance(A, sets.Ball(3), 1e-6)
        assert found.state == "boundary", A
        assert found.lower == 0, A
        assert 0 <= found.upper <= 1e-6, A


def test_ray_from_the_boundary_says_that_it_cannot_be_proved() -> None:
    found = pdg.penetration_distance(
        sets.Box([1.0, 1], [1.0, 0]), sets.Segment([0.0, 0], [1.0, 0]), 1e-6
    )
    assert (found.state, found.stop_reason) == ("boundary", "rounding")
    assert found.lower == 0
    assert found.upper == pytest.approx(2, abs=1e-6)


def test_flat_sets() -> None:
    rng = np.random.default_rng(8)
    for n, k in ((2, 1), (3, 1), (3, 2), (6, 3), (6, 5)):
        axes = rotation(n, rng)[:, :k] * rng.uniform(0.5, 2, k)
        A = sets.Ellipsoid(axes)
        # Q leaves A's subspace.
        found = pdg.penetration_distance(A, sets.Ball(n))
        assert (found.state, found.lower) == ("flat", 0)
        assert found.upper < 1e-12
        assert np.abs(axes.T @ found.direction).max() < 1e-12
        # Q spans the same subspace: the answer is the one there.
        other = rng.normal(size=(k, k))
        found = pdg.penetration_distance(A, sets.Ellipsoid(axes @ other), 1e-6)
        truth = 1 / np.linalg.norm(other, 2)
        assert (found.state, found.stop_reason, found.dimension) == ("inside", "converged", k)
        assert found.lower <= truth * (1 + 1e-12)
        assert found.upper >= truth * (1 - 1e-12)
        assert found.upper - found.lower <= 1e-6
        # The subspace misses the origin.
        normal = np.linalg.svd(axes.T)[2][-1]
        found = pdg.penetration_distance(sets.Ellipsoid(axes, normal), sets.Ball(n))
        assert (found.state, found.lower) == ("outside", -math.inf)
    found = pdg.penetration_distance(sets.PointSet([[0.0, 0]]), sets.Ball(2))
    assert (found.state, found.lower, found.upper) == ("flat", 0, pytest.approx(0, abs=1e-15))


def test_flat_q_and_q_with_the_origin_on_its_boundary() -> None:
    A = sets.Box([1.0, 2, 3])
    disc = sets.Ellipsoid(np.eye(3)[:, 1:])
    check(pdg.penetration_distance(A, disc, 1e-6), 2, 1e-6, "disc")
    tangent = sets.Ball(3, 1.0, [0, 0, 1.0])
    check(pdg.penetration_distance(A, tangent, 1e-6), 1, 1e-6, "ball tangent to a plane")
    corner = sets.Box([0.5, 0.5, 0.5], [0.5, 0.5, 0.5])
    check(pdg.penetration_distance(A, corner, 1e-6), 1, 1e-6, "cube with a corner there")


def test_symmetric_sums_of_segments() -> None:
    """Zonotopes have many coplanar support points; off-the-shelf incremental hulls abort."""
    for n in (3, 4, 5):
        directions = [d for d in itertools.product([0.0, 1.0], repeat=n) if any(d)]
        A = sets.MinkowskiSum([sets.Segment(-np.array(d), np.array(d)) for d in directions])
        found = pdg.penetration_distance(A, sets.Ball(n), 1e-9)
        generators = np.array(directions)
        # Facets of a zonotope are normal to n - 1 independent generators.
        truth = math.inf
        for chosen in itertools.combinations(generators, n - 1):
            _, sigma, vt = np.linalg.svd(np.array(chosen))
            if sigma[-1] > 1e-9:
                truth = min(truth, float(np.abs(generators @ vt[-1]).sum()))
        check(found, truth, 1e-9, n)


class Cushion:
    """{|x|^4 + |y|^4 <= 1}."""

    dimension = 2

    def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
        value = float(np.sum(np.abs(u) ** (4 / 3)) ** (3 / 4))
        return value, np.cbrt(u) * (1 / value if value else 0) ** (1 / 3)


def test_python_sets() -> None:
    assert pdg.penetration_distance(Cushion(), sets.Ball(2), 1e-8).upper == pytest.approx(1)
    found = pdg.penetration_distance(sets.Ball(2), Cushion(), 1e-8)
    check(found, 2**-0.25, 1e-8, "cushion")

    class Breaks(Cushion):
        def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
            if 0 < abs(u[0]) < abs(u[1]):
                raise KeyError("u")
            return super().support(u)

    with pytest.raises(KeyError):
        pdg.penetration_distance(Breaks(), sets.Ball(2))


def test_limits_and_history() -> None:
    A, Q = sets.Ellipsoid([1.0, 1.1, 1.2, 1.3, 1.4]), sets.Ball(5)
    few = pdg.penetration_distance(A, Q, 1e-9, max_iterations=20, history=True)
    assert (few.stop_reason, few.iterations) == ("max_iterations", 20)
    assert 0 < few.lower < 1 < few.upper
    assert len(few.history) == 21
    lowers, uppers, facets = zip(*few.history, strict=True)
    assert list(uppers) == sorted(uppers, reverse=True)
    assert facets[-1] == few.facets
    assert lowers[-1] == pytest.approx(few.lower)
    assert pdg.penetration_distance(A, Q, 1e-9, max_facets=100).stop_reason == "max_facets"
    assert pdg.penetration_distance(A, Q, 1e-9, timeout=0.01).stop_reason == "timeout"
    assert pdg.penetration_distance(sets.Box([1.0, 1]), sets.Ball(2), 0).stop_reason == "rounding"


def test_same_answer_every_time() -> None:
    A = sets.Ellipsoid(np.random.default_rng(1).normal(size=(4, 4)))
    first, second = (pdg.penetration_distance(A, sets.Ball(4)) for _ in range(2))
    assert (first.lower, first.upper, first.facets) == (second.lower, second.upper, second.facets)


def test_example_of_the_documentation(capsys: pytest.CaptureFixture[str]) -> None:
    page = Path(__file__).parents[3] / "docs" / "penetration-distance.md"
    (example,) = re.findall(r"^```python\n(.*?)^```", page.read_text("utf-8"), re.M | re.S)
    exec(example, {})
    assert capsys.readouterr().out.strip() == example.splitlines()[-1].removeprefix("# ")


BALL = sets.Ball


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda f: f(BALL(2), BALL(3)), "Q: expected dimension 2"),
        (lambda f: f(BALL(2), BALL(2, 1.0, [3.0, 0])), "Q: must hold the origin"),
        (lambda f: f(BALL(2), sets.PointSet([[0.0, 0]])), "Q: is the origin alone"),
        (lambda f: f(BALL(2), "ball"), "Q: expected a convex set"),
        (lambda f: f(BALL(2), BALL(2), -1.0), "absolute_tolerance: must not be negative"),
        (lambda f: f(BALL(2), BALL(2), max_iterations=1.5), "max_iterations: expected"),
        (lambda f: f(BALL(2), BALL(2), timeout=math.nan), "timeout"),
        (lambda f: f(sets.Scaled(1e59, BALL(2, 1e59)), BALL(2)), "A: must extend to"),
    ],
)
def test_wrong_arguments_are_named(call: Callable[..., object], message: str) -> None:
    with pytest.raises(pdg.PdgError, match=message):
        call(pdg.penetration_distance)
