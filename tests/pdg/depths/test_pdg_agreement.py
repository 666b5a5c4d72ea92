"""PD^t of random and degenerate convex pairs against exact integers, shapely, SciPy and pymunk."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pdg
from oracles.exact.depths import exact_depth
from oracles.placing import placed
from support.depth_agreement import failures, measure
from worlds.bodies.convex_pairs import FAMILIES

SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])


def moved(x: float, y: float) -> np.ndarray:
    return SQUARE + np.array([x, y])


def test_the_oracle_knows_cases_done_by_hand() -> None:
    assert exact_depth(SQUARE, SQUARE) == ("overlap", 2.0)
    assert exact_depth(moved(2, 0), SQUARE) == ("touching", 0.0)
    assert exact_depth(moved(5, 6), SQUARE) == ("apart", -5.0)
    assert exact_depth(moved(1.5, 0.25), SQUARE) == ("overlap", 0.5)
    turned = placed(SQUARE, np.array([0, 0, math.pi / 4]))
    assert exact_depth(turned, SQUARE).depth == pytest.approx(1 + math.sqrt(2), rel=1e-15)
    segment = np.array([(-3.0, 0.0), (3.0, 0.0), (1.0, 0.0)])
    assert exact_depth(segment, SQUARE) == ("overlap", 1.0)
    assert exact_depth(np.full((3, 2), 0.25), SQUARE) == ("overlap", 0.75)


@pytest.mark.parametrize("family", FAMILIES)
def test_pairs_agree_with_the_oracles(family: str) -> None:
    row = measure(family, 1, 300, every=3)
    assert not failures(row), row
    assert row.exact < 2e-15  # sixteen roundings of the depth itself
    assert row.overlap > 20


@pytest.mark.parametrize("shift", [2.0**-70, -(2.0**-70)])
def test_depths_far_below_the_rounding_of_coordinates(shift: float) -> None:
    """A corner 2^-70 off the diagonal of a unit square: plain doubles see neither gap nor depth."""
    a = np.array([(-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    b = np.array([(shift, 0.0), (1.0, 0.0), (1.0, 0.5)])
    got = pdg.translational_depth(a, b)
    assert got.state == ("apart" if shift > 0 else "overlap")
    assert got.depth == pytest.approx(-shift / math.sqrt(2), rel=1e-15)
    assert got.direction == pytest.approx((-math.sqrt(0.5), math.sqrt(0.5)), rel=1e-15)


def test_what_rounding_leaves_of_a_sliver_still_has_a_depth() -> None:
    sliver = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1e-30)])
    speck = sliver * 1e-40
    for body, depth in ((sliver, 0.75), (speck, 0.75)):
        got = pdg.translational_depth(body, SQUARE, (-0.25, 0.25, 0.0))
        left = placed(body, np.array([-0.25, 0.25, 0.0]))
        assert (got.state, got.depth) == exact_depth(left, SQUARE) == ("overlap", depth)
        assert pdg.translational_depth(body, SQUARE, (0.0, 1.0, 0.0)).state == "touching"
        assert pdg.translational_depth(body, SQUARE, (0.0, 1.5, 0.0)).depth == -0.5
