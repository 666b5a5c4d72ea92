"""Fits of growth against laws that are known exactly."""

from __future__ import annotations

import math
import random

import pytest


def test_power_law_is_found_exactly() -> None:
    from oracles.fits import exponent

    xs = [10.0, 30.0, 100.0, 1000.0]
    fit = exponent(xs, [7.0 * x**1.5 for x in xs])
    assert fit is not None
    assert (fit.slope, fit.lower, fit.upper) == pytest.approx((1.5, 1.5, 1.5))
    assert fit.points == 4


def test_growth_per_decade_of_a_logarithm() -> None:
    from oracles.fits import exponent, per_decade

    xs = [10.0**k for k in range(1, 10)]
    ys = [50.0 + 31.0 * math.log10(x) for x in xs]
    fit = per_decade(xs, ys)
    assert fit is not None
    assert fit.slope == pytest.approx(31.0)
    power = exponent(xs, ys)
    assert power is not None
    assert power.slope < 0.15  # a logarithm is no power law


def test_one_bad_reading_hardly_moves_the_slope() -> None:
    from oracles.fits import exponent

    rng = random.Random(1)
    xs = [2.0**k for k in range(1, 12)]
    ys = [x**2 * math.exp(rng.uniform(-0.1, 0.1)) for x in xs]
    ys[5] *= 100.0
    fit = exponent(xs, ys)
    assert fit is not None
    assert fit.slope == pytest.approx(2.0, abs=0.1)


def test_a_bend_shows_in_the_spread() -> None:
    from oracles.fits import exponent

    xs = [10.0**k for k in range(7)]
    fit = exponent(xs, [1.0 + x**2 / 1e6 for x in xs])
    assert fit is not None
    assert fit.upper - fit.lower > 0.5


@pytest.mark.parametrize(("xs", "ys"), [([1, 2], [1, 2]), ([1, 2, 3], [1, 0, 2]), ([], [])])
def test_too_few_points_give_no_fit(xs: list[float], ys: list[float]) -> None:
    from oracles.fits import exponent, per_decade

    assert exponent(xs, ys) is None
    assert per_decade(xs, ys) is None


def test_lengths_must_agree() -> None:
    from oracles.fits import exponent

    with pytest.raises(ValueError, match="2 x and 1 y"):
        exponent([1.0, 2.0], [1.0])
