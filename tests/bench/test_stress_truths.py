"""The truths that stress tests compare with, against other ways to find them."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest


@pytest.mark.parametrize("seed", range(20))
def test_sine_and_cosine(seed: int) -> None:
    from stress_parts.exact import PLACES, sine_cosine

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
    from stress_parts import exact
    from stress_parts.worlds import star

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
    from stress_parts.exact import polygon, squared_width

    assert squared_width(polygon([(0, 0), (3, 0), (3, 1), (0, 1)])) == 1
    assert squared_width(polygon([(0, 0), (4, 0), (0, 3)])) == Fraction(144, 25)
    ring = [(math.cos(math.tau * k / 12), math.sin(math.tau * k / 12)) for k in range(12)]
    assert float(squared_width(polygon(ring))) == pytest.approx(4 * math.cos(math.pi / 12) ** 2)


def test_longest_round_corner() -> None:
    from stress_parts.exact import longest_round_corner

    even = longest_round_corner(Fraction(1), Fraction(1), Fraction(1, 8))
    # 2 (√2 − 1/8): its half plus 1/8 squared is 2
    assert abs((even / 2 + Fraction(1, 8)) ** 2 - 2) < Fraction(1, 10**45)
    ladder = longest_round_corner(Fraction(1), Fraction(8), Fraction(0))
    assert abs(ladder**2 - 125) < Fraction(1, 10**45)  # (1^(2/3) + 8^(2/3))^(3/2) = 5^(3/2)


def test_families_have_both_sides() -> None:
    from stress_parts.families import families

    for family in families():
        near = [family.parameter(distance) for distance in (-1e-9, 1e-9)]
        assert {family.has_path(parameter) for parameter in near} == {True, False}, family.name
