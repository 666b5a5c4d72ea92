"""The truths that stress tests compare with, against other ways to find them."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest


@pytest.mark.parametrize("seed", range(20))
def test_sine_and_cosine(seed: int) -> None:
    from oracles.exact.numbers import PLACES, sine_cosine

    angle = random.Random(seed).uniform(-10.0, 10.0)
    sine, cosine = sine_cosine(angle)
    assert float(sine) == pytest.approx(math.sin(angle), abs=1e-15)
    assert float(cosine) == pytest.approx(math.cos(angle), abs=1e-15)
    assert abs(sine**2 + cosine**2 - 1) < Fraction(1, 10 ** (PLACES - 1))
    double_sine, double_cosine = sine_cosine(2.0 * angle)  # doubling is exact
    tolerance = Fraction(1, 10 ** (PLACES - 1))
    if abs(angle) <= 5.0:
        assert abs(double_sine - 2 * sine * cosine) < tolerance
        assert abs(double_cosine - (cosine**2 - sine**2)) < tolerance


@pytest.mark.parametrize("seed", range(40))
def test_drops(seed: int) -> None:
    """A robot that fell touches: a little higher it is clear, a little lower it overlaps."""
    import shapely

    from oracles.exact import polygons as exact
    from worlds.random_kinds import star

    rng = random.Random(seed)
    ring, rock = star(rng, 1.0), star(rng, 1.5, (rng.uniform(-0.3, 0.3), -3.0))
    body = exact.turned(exact.polygon(ring), rng.choice((0.0, rng.uniform(-4.0, 4.0))))
    fall = exact.drop(body, exact.polygon(rock))
    assert fall is not None
    solid = shapely.Polygon(rock)
    for off, overlaps in ((1e-7, False), (-1e-7, True)):
        moved = shapely.Polygon([(float(x), float(y - fall) + off) for x, y in body])
        assert (moved.intersection(solid).area > 1e-18) == overlaps


def test_squared_width() -> None:
    from oracles.exact.polygons import polygon, squared_width

    assert squared_width(polygon([(0, 0), (3, 0), (3, 1), (0, 1)])) == 1
    assert squared_width(polygon([(0, 0), (4, 0), (0, 3)])) == Fraction(144, 25)
    ring = [(math.cos(math.tau * k / 12), math.sin(math.tau * k / 12)) for k in range(12)]
    assert float(squared_width(polygon(ring))) == pytest.approx(4 * math.cos(math.pi / 12) ** 2)


def test_longest_round_corner() -> None:
    from oracles.exact.corner import longest_round_corner

    even = longest_round_corner(Fraction(1), Fraction(1), Fraction(1, 8))
    # 2 (√2 − 1/8): its half plus 1/8 squared is 2
    assert abs((even / 2 + Fraction(1, 8)) ** 2 - 2) < Fraction(1, 10**45)
    ladder = longest_round_corner(Fraction(1), Fraction(8), Fraction(0))
    assert abs(ladder**2 - 125) < Fraction(1, 10**45)  # (1^(2/3) + 8^(2/3))^(3/2) = 5^(3/2)


@pytest.mark.parametrize("seed", range(30))
def test_lattices_against_shapely(seed: int) -> None:
    """Placements that shapely calls free by a margin, or overlapping by area, are so."""
    import shapely

    from worlds.lattice import SIDE, STEP, free_cells

    rng = random.Random(seed)
    robot = [(0, 0, 2, 1), (0, 1, 1, 2)]
    places = [(rng.randrange(8), rng.randrange(8)) for _ in range(3)]
    obstacles = [(x, y, x + 2, y + 1) for x, y in places]
    free = free_cells(robot, obstacles)
    world = shapely.box(0.0, 0.0, SIDE * STEP, SIDE * STEP)
    solid = shapely.union_all([shapely.box(*(STEP * v for v in box)) for box in obstacles])
    body = shapely.union_all([shapely.box(*(STEP * v for v in box)) for box in robot])
    for x in range(-4, 2 * SIDE + 4):
        for y in range(-4, 2 * SIDE + 4):
            placed = shapely.affinity.translate(body, 0.5 * STEP * x, 0.5 * STEP * y)
            overlap = placed.intersection(solid).area + placed.difference(world).area
            assert ((x, y) in free) == (overlap == 0.0), (x, y)


def test_lattices_connect_through_contact() -> None:
    """A unit box passes gates and passages of just its size, and no corner that closes them."""
    from worlds.lattice import free_cells, reached

    for obstacles, passes in (
        ([(0, 4, 3, 5), (4, 4, 8, 5)], True),  # a gate of just its width
        ([(0, 4, 4, 5), (4, 3, 8, 4)], False),  # corner to corner
        ([(0, 4, 4, 5), (4, 2, 8, 3)], True),  # a passage of just its height
    ):
        free = free_cells([(0, 0, 1, 1)], obstacles)
        assert ((0, 14) in reached((0, 0), free)) == passes


def test_families_have_both_sides() -> None:
    from worlds.critical import families

    for family in families():
        near = [family.near(distance) for distance in (-1e-9, 1e-9)]
        assert {family.has_path(parameter) for parameter in near} == {True, False}, family.name
