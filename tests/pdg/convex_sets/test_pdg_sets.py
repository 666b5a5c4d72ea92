"""Convex sets: support functions against points of the sets, formulas and each other."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, cast

import numpy as np
import pytest

import pdg
from pdg import sets
from pdg.sets import as_convex_set

RNG = np.random.default_rng(7)


def examples(n: int) -> dict[str, tuple[sets.ConvexSet, np.ndarray]]:
    """Sets of dimension n, each with many of its points."""
    rng = np.random.default_rng(n)
    c = rng.normal(size=n)
    r = rng.uniform(0.1, 3, n)
    ball = rng.normal(size=(400, n))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    cube = rng.choice([-1.0, 1.0], size=(400, n))
    tips = np.concatenate([np.eye(n), -np.eye(n)])
    m = rng.normal(size=(n, n))
    disc = rng.normal(size=(n, 2))
    circle = rng.normal(size=(400, 2))
    circle /= np.linalg.norm(circle, axis=1, keepdims=True)
    points = rng.normal(size=(9, n))
    some = sets.Ellipsoid(r, c)
    return {
        "ball": (sets.Ball(n, 2.0, c), c + 2 * ball),
        "axis ellipsoid": (some, c + r * ball),
        "ellipsoid": (sets.Ellipsoid(m, c), c + ball @ m.T),
        "cone's base": (sets.Ellipsoid(disc, c), c + circle @ disc.T),
        "box": (sets.Box(r, c), c + r * cube),
        "cross-polytope": (sets.CrossPolytope(r, c), c + r * tips),
        "points": (sets.PointSet(points), points),
        "segment": (sets.Segment(points[0], points[1]), points[:2]),
        "sum": (
            sets.MinkowskiSum([some, sets.PointSet(points)]),
            (c + r * ball)[:, None] + points,
        ),
        "hull": (
            sets.UnionHull([some, sets.PointSet(points)]),
            np.concatenate([c + r * ball, points]),
        ),
        "image": (sets.AffineImage(m, some, -c), (c + r * ball) @ m.T - c),
        "scaled": (sets.Scaled(-1.5, some), -1.5 * (c + r * ball)),
    }


@pytest.mark.parametrize("n", [1, 2, 3, 6, 20])
def test_support_is_the_greatest_of_the_points(n: int) -> None:
    for name, (body, samples) in examples(n).items():
        assert body.dimension == n
        points = samples.reshape(-1, n)
        u = RNG.normal(size=(50, n))
        values, at = body.supports(u)
        scale = np.abs(points).max()
        best = (points @ u.T).max(axis=0)
        norm = np.linalg.norm(u, axis=1)
        assert (best <= values + 1e-13 * norm * scale).all(), name
        # The support point attains the value, and is met by asking in its direction alone.
        np.testing.assert_allclose(np.sum(u * at, axis=1), values, rtol=0, atol=1e-12 * scale * n)
        value, point = body.support(u[0])
        assert value == values[0]
        assert (point == at[0]).all()


@pytest.mark.parametrize("n", [2, 5])
def test_support_points_of_polytopes_are_their_vertices(n: int) -> None:
    for name in ("box", "cross-polytope", "points", "segment"):
        body, points = examples(n)[name]
        if name == "box":
            r, c = body.supports(np.concatenate([np.eye(n), -np.eye(n)]))[0].reshape(2, n)
            low, high = -c, r
            _, at = body.supports(RNG.normal(size=(20, n)))
            assert (np.isclose(at, low) | np.isclose(at, high)).all()
        else:
            _, at = body.supports(RNG.normal(size=(20, n)))
            assert all(np.isclose(points, p).all(axis=1).any() for p in at)


def test_support_points_of_round_sets_lie_on_them() -> None:
    for n in (2, 4):
        r = np.arange(1.0, n + 1)
        m = RNG.normal(size=(n, n))
        u = RNG.normal(size=(30, n))
        _, at = sets.Ellipsoid(r).supports(u)
        np.testing.assert_allclose(np.sum((at / r) ** 2, axis=1), 1, atol=1e-13)
        _, at = sets.Ellipsoid(m, np.ones(n)).supports(u)
        preimage = np.linalg.solve(m, (at - 1).T)
        np.testing.assert_allclose(np.linalg.norm(preimage, axis=0), 1, atol=1e-10)


def test_zero_direction_gives_a_point_of_the_set() -> None:
    for body, _ in examples(3).values():
        value, point = body.support([0.0, 0.0, 0.0])
        assert value == 0
        assert np.isfinite(point).all()


class Cushion:
    """{|x|^4 + |y|^4 <= 1}."""

    dimension = 2

    def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
        value = float(np.sum(np.abs(u) ** (4 / 3)) ** (3 / 4))
        point = np.cbrt(u) * (1 / value if value else 0) ** (1 / 3)
        return value, point


def test_a_python_object_serves_as_a_set() -> None:
    body = as_convex_set(Cushion(), "A")
    u = RNG.normal(size=(10, 2))
    values, points = body.supports(u)
    np.testing.assert_allclose(np.sum(points**4, axis=1), 1, atol=1e-12)
    np.testing.assert_allclose(np.sum(points * u, axis=1), values, atol=1e-12)
    total = sets.MinkowskiSum([Cushion(), sets.Ball(2)])
    np.testing.assert_allclose(total.supports(u)[0], values + np.linalg.norm(u, axis=1), atol=1e-12)


class Liar(Cushion):
    def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
        value, point = super().support(u)
        return value + 1e-6 * (u[0] > 0.5), point


class Breaks(Cushion):
    def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
        if abs(u[0]) > 1.5:
            raise ZeroDivisionError
        return super().support(u)


def test_a_python_object_that_lies_or_breaks_is_reported() -> None:
    body = as_convex_set(Liar(), "A")
    with pytest.raises(pdg.PdgError, match=r"A\.support\(u\): .* differs"):
        body.support([0.8, 0.6])
    with pytest.raises(ZeroDivisionError):
        as_convex_set(Breaks(), "A").support([2.0, 0.0])
    with pytest.raises(pdg.PdgError, match="expected a convex set"):
        as_convex_set([1, 2], "Q")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: sets.Ball(0), "dimension: expected an integer"),
        (lambda: sets.Ball(2, -1.0), r"radius\[0\]: must not be negative"),
        (lambda: sets.Box([1, np.nan]), r"half_extents\[1\]: must be finite"),
        (lambda: sets.Box([1, 2], [0]), "centre: expected 2 numbers"),
        (lambda: sets.Ellipsoid(3.0), "axes: expected a matrix"),
        (lambda: sets.PointSet([1, 2]), "points: expected a matrix"),
        (lambda: sets.PointSet(np.zeros((0, 2))), "points: expected a matrix"),
        (lambda: sets.MinkowskiSum([]), "sets: at least one"),
        (lambda: sets.UnionHull([sets.Ball(2), sets.Ball(3)]), r"sets\[1\]: expected dimension 2"),
        (lambda: sets.AffineImage(np.eye(3), sets.Ball(2)), "matrix: expected 2 columns"),
        (lambda: sets.Ball(2).support([1, 2, 3]), "u: expected 2 numbers"),
        (lambda: sets.Scaled(np.inf, sets.Ball(2)), "factor"),
    ],
)
def test_wrong_arguments_are_named(make: object, message: str) -> None:
    with pytest.raises(pdg.PdgError, match=message):
        make()


def test_a_sum_within_a_sum_rounds_at_its_own_magnitude() -> None:
    """Small summands do not vanish one by one beside a large one; one rounding is left to the sum.

    2e-17 is a fifth of a rounding of 1, so each of 200 would leave it as it is.
    """
    small = sets.MinkowskiSum([sets.PointSet([(2e-17, 0)])] * 200)
    whole = sets.MinkowskiSum([sets.PointSet([(1, 0)]), small])
    _, point = whole.support((1.0, 0.0))
    assert abs(Fraction(point[0]) - 1 - 200 * Fraction(2e-17)) < Fraction(1, 2**52)


def test_odd_arguments_give_the_library_s_error() -> None:
    loop: list[object] = []
    loop.append(loop)
    odd: Any = loop
    for call in (
        lambda: sets.Ellipsoid(odd),
        lambda: sets.Ball(10**400),
        lambda: sets.MinkowskiSum(cast(Any, 3)),
        lambda: sets.UnionHull(cast(Any, np.array(1.0))),
        lambda: pdg.penetration_distance(sets.Ball(2), sets.Ball(2), history=cast(Any, 1)),
        lambda: pdg.penetration_distance(sets.Ball(2), sets.Ball(2), timeout=cast(Any, [])),
        lambda: pdg.penetration_distance(sets.Ball(2), sets.Ball(2), max_facets=True),
    ):
        with pytest.raises(pdg.PdgError) as caught:
            call()
        assert caught.value.name
        assert caught.value.value is not None
    huge = pdg.penetration_distance(sets.Ball(2), sets.Ball(2), max_iterations=10**30)
    assert huge.stop_reason == "converged"
