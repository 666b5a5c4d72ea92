"""The benchmark of run time against error: its critical values, curves and fits."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from lib.timing import Spread
from parts.error_time import curves, truths
from parts.error_time.sampling import ranks
from parts.error_time.sweep import Effort, Point, WrongVerdictError, measure
from worlds.critical import SIDES, Family, Side

TRUTHS = [*truths.with_formula(), *truths.harder()]


@pytest.mark.parametrize("truth", TRUTHS, ids=lambda truth: truth.name)
def test_parameters_are_on_their_side_down_to_the_finest(truth: Family) -> None:
    for distance in (0.1, 1e-6, truth.finest):
        path, no_path = (truth.parameter(side, distance) for side in SIDES)
        assert (path > no_path) == (truth.passing > 0)
        assert abs(Fraction(path) / truth.path_at - 1) == pytest.approx(distance, rel=0.01)
    with pytest.raises(ValueError, match="rounding"):
        truth.parameter("path", 1e-18)


@pytest.mark.parametrize("truth", TRUTHS, ids=lambda truth: truth.name)
def test_critical_values_agree_with_their_theorems_to_50_places(truth: Family) -> None:
    """The theorem as a rational test changes its answer within 10^-50 of the value."""
    assert truth.path_at == truth.no_path_at
    off = truth.path_at * Fraction(1, 10**50) * truth.passing
    assert truth.has_path(truth.path_at + off)
    assert not truth.has_path(truth.path_at - off)


def test_the_corner_against_its_formula() -> None:
    (corner,) = (t for t in TRUTHS if t.name == "corner")
    width = Fraction(0.1)
    # (l / 2 + w)^2 = 2 at the critical length
    assert abs((corner.path_at / 2 + width) ** 2 - 2) < Fraction(1, 10**50)


def test_scenes_are_decided_rightly_and_a_wrong_truth_is_noticed() -> None:
    (corridor,) = (t for t in TRUTHS if t.name == "triangle, corridor")
    effort = Effort(limit=5.0, budget=0.0, fewest=1)
    for side in SIDES:
        assert measure(corridor, "ours", side, 1e-3, effort).decided == 1.0
    wrong = Family(
        "wrong", corridor.make, corridor.path_at * 2, corridor.path_at * 2, 1, lambda _: False
    )
    with pytest.raises(WrongVerdictError, match="wrong at"):
        measure(wrong, "ours", "no_path", 1e-3, effort)


def point(side: Side, distance: float, seconds: float, count: float = 1.0) -> Point:
    spread = Spread(seconds, seconds, seconds, 1)
    decided = float(math.isfinite(seconds))
    return Point("f", "p", side, 1.0, distance, decided, spread, spread, count)


def test_error_counts_only_distances_above_which_all_is_decided() -> None:
    points = [
        point("path", 1e-1, 1.0),
        point("path", 1e-2, math.inf),
        point("path", 1e-3, 1.0),  # beyond a gap: not within the band's complement
        point("no_path", 1e-1, 3.0),
        point("no_path", 1e-2, 2.0),
    ]
    curve = curves.error_curve(points)
    assert [(step.seconds, step.error) for step in curve] == [
        (3.0, pytest.approx(0.5 * (1e-1 + 1e-2)))
    ]
    assert curves.error_at(curve, 2.9) == math.inf


def test_a_sampler_is_judged_on_the_side_it_can_answer() -> None:
    curve = curves.error_curve([point("path", 1e-1, 1.0), point("path", 1e-2, 4.0)])
    assert [(s.seconds, s.error) for s in curve] == [(1.0, 1e-1), (4.0, 1e-2)]


def test_laws() -> None:
    distances = [10.0**-k for k in range(1, 8)]
    logarithmic = [point("path", d, 1.0, 7 - 5 * math.log10(d)) for d in distances]
    law = curves.logarithmic_law(logarithmic, 1.0)
    assert law is not None
    assert (law.slope, law.r_squared, law.count) == (pytest.approx(5), pytest.approx(1), 7)
    power = curves.power_law([point("path", d, 3 * d**-0.5) for d in distances], 1.0, "seconds")
    assert power is not None
    assert (power.slope, power.r_squared) == (pytest.approx(0.5), pytest.approx(1))
    assert curves.logarithmic_law(logarithmic[:2], 1.0) is None


def test_ranks_are_values_that_occurred() -> None:
    assert ranks([3.0, 1.0, 2.0], 5) == Spread(3.0, 2.0, math.inf, 5)
    assert ranks([], 3) == Spread(math.inf, math.inf, math.inf, 3)
