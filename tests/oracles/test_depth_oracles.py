"""The oracles of the benchmark of depths, against cases that are known by hand."""

from __future__ import annotations

import itertools
import math
from decimal import Decimal

import numpy as np
import pytest
import shapely

from oracles.depth_bracket import Slices, refine
from oracles.depth_methods import minkowski_depth, sampled_depth
from oracles.exact.depths import exact_displacement, placed_depth
from oracles.placing import placed

SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])


def test_exact_depths() -> None:
    assert placed_depth(SQUARE, SQUARE, (0.5, 0.0, 0.0)) == Decimal("1.5")
    turned = placed_depth(SQUARE, SQUARE, (0.0, 0.0, 0.25 * math.pi))
    assert float(turned) == pytest.approx(1 + math.sqrt(2), abs=1e-15)
    assert placed_depth(SQUARE, SQUARE, (3.0, 0.0, 0.0)) < 0


def test_other_methods_bound_or_equal_the_placed_depth() -> None:
    a, b, pose = SQUARE, placed(SQUARE, (0.0, 0.0, 0.2)), (0.25, 0.5, 0.6)
    exact = float(placed_depth(a, b, pose))
    assert minkowski_depth(a, b, pose) == pytest.approx(exact, abs=1e-15)
    rough, fine = (sampled_depth(a, b, pose, count) for count in (8, 8192))
    assert exact <= fine < rough
    assert fine == pytest.approx(exact, rel=1e-3)


def test_exact_displacement() -> None:
    assert exact_displacement(SQUARE, (0.0, 0.0, 1.0), (3.0, 4.0, 1.0)) == 5
    half_turn = exact_displacement(SQUARE, (0.0, 0.0, 0.0), (0.0, 0.0, math.pi))
    assert float(half_turn) == pytest.approx(2 * math.sqrt(2), abs=1e-15)


def test_brackets_of_convex_bodies_hold_the_translational_depth() -> None:
    square, wall = shapely.box(-1, -1, 1, 1), shapely.box(-1, -1, 1, 1)
    last = None
    for bracket in itertools.islice(refine(square, wall, (0.5, 0.0, 0.0)), 200):
        # Convex bodies: PD^g is PD^t = 1.5 ([PDG] Theorem 1).
        assert bracket.lower <= 1.5 + 1e-9
        assert bracket.upper >= 1.5 - 1e-9
        if last is not None:
            assert bracket.lower >= last.lower
            assert bracket.upper <= last.upper
        last = bracket
        if bracket.gap < 0.05:
            break
    assert last is not None
    assert last.gap < 0.05


def test_turning_can_be_nearer_than_translating() -> None:
    """A bar pokes with its slanted ends into both walls of a corridor: a turn sets it free."""
    bar = shapely.box(-2, -0.4, 2, 0.4)
    walls = shapely.union_all([shapely.box(-9, 0.5, 9, 9), shapely.box(-9, -9, 9, -0.5)])
    slices = Slices(bar, walls, (0.0, 0.0, 0.1))
    turned = slices.least(0.0, 0.0)  # back by 0.1 about the middle
    corner = math.hypot(2.0, 0.4)
    assert turned == pytest.approx(2 * math.sin(0.05) * corner, abs=1e-9)
    assert slices.least(0.1, 0.0) > 4  # by translation: out of the corridor's end
    assert slices.lower(0.0, 0.05) <= turned


def test_bounds_for_an_interval_hold_at_its_angles() -> None:
    ell = shapely.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)])
    slices = Slices(ell, ell, (0.4, 0.6, 0.7))
    for middle, half in ((0.5, 0.2), (1.0, 0.05), (2.0, 0.5)):
        bound = slices.lower(middle, half)
        for theta in np.linspace(middle - half, middle + half, 5):
            assert bound <= slices.least(float(theta), 0.0) + 1e-9
