"""Motion bounds and the C-obstacle query against samples and the published formulae."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

import pdg
from oracles.placing import placed
from worlds.bodies.random_bodies import blob, convex

METHODS = ("published", "displacement", "per-normal")
SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])


def random_cell(random: np.random.Generator) -> list[float]:
    size = math.exp(random.uniform(-4, 1))
    return [
        *random.uniform(-3, 3, 2),
        random.uniform(-7, 7),
        *(size * random.uniform(0, 1, 2)),
        math.exp(random.uniform(-6, 1)),
    ]


def sample(random: np.random.Generator, cell: list[float]) -> tuple[float, float, float]:
    """A configuration of the cell, often on its faces and corners."""
    steps = np.clip(random.uniform(-1.6, 1.6, 3), -1, 1)
    x, y, theta = np.array(cell[:3]) + steps * np.array(cell[3:])
    return x, y, theta


def test_full_never_has_a_counter_example_and_per_normal_dominates() -> None:
    random = np.random.default_rng(10)
    proved = dict.fromkeys(METHODS, 0)
    for _ in range(400):
        a, b = blob(random, 1), blob(random, 3)
        A, B = pdg.convex_pieces(a), pdg.convex_pieces(b)
        cell = random_cell(random)
        verdicts = {m: pdg.c_obstacle_query(A, B, cell, m) for m in METHODS}
        for method, verdict in verdicts.items():
            proved[method] += verdict.full
            assert verdict.full == (verdict.margin > 0)
        published, displacement, per_normal = (verdicts[m].full for m in METHODS)
        assert published <= displacement <= per_normal
        if not per_normal:
            continue
        i, j = verdicts["per-normal"].pair or (-1, -1)
        piece_a, piece_b = list(A)[i], shapely.Polygon(list(B)[j])
        for _ in range(30):
            moved = shapely.Polygon(placed(piece_a, sample(random, cell)))
            assert moved.intersection(piece_b).area > 0
    assert 10 < proved["published"] < proved["displacement"] < proved["per-normal"]


def test_published_form_is_the_published_formula() -> None:
    random = np.random.default_rng(11)
    decided = 0
    for _ in range(300):
        A, B = pdg.convex_pieces(blob(random, 2)), pdg.convex_pieces(blob(random, 3))
        cell = random_cell(random)
        radius = max(np.hypot(*p.T).max() for p in A)
        depth = pdg.generalized_depth_lower_bound(A, B, cell[:3]).lower
        margin = depth - (cell[3] + cell[4] + radius * cell[5])
        got = pdg.c_obstacle_query(A, B, cell, "published")
        if depth > 0:
            assert got.margin == pytest.approx(margin, abs=1e-11)
            assert got.margin <= margin + 1e-14 * radius  # rounded to the safe side
        decided += got.full == (margin > 0)
    assert decided == 300  # no sample within rounding of the limit


def test_strict_example_where_only_the_per_normal_form_decides() -> None:
    cell = (0, 0, 0, 1.9, 1.9, 0)
    assert [pdg.c_obstacle_query(SQUARE, SQUARE, cell, m).full for m in METHODS] == [
        False,
        False,
        True,
    ]
    # Its margin is the least depth over the cell, which the corners attain.
    margin = pdg.c_obstacle_query(SQUARE, SQUARE, cell).margin
    assert margin == pytest.approx(0.1, abs=1e-12)
    # With the corners touching, the cell is not full.
    assert not pdg.c_obstacle_query(SQUARE, SQUARE, (0, 0, 0, 2, 2, 0)).full


def test_every_orientation() -> None:
    random = np.random.default_rng(12)
    big = SQUARE * 5
    for turn in (math.pi, 4.0, 1e6):
        for method in METHODS[1:]:
            verdict = pdg.c_obstacle_query(SQUARE, big, (0, 0, 1, 0.5, 0.5, turn), method)
            assert verdict.full, (turn, method)
    long = convex(random) * (3, 0.1)
    assert not pdg.c_obstacle_query(long, SQUARE + np.array([5, 0]), (0, 0, 0, 0, 0, math.pi)).full


def test_far_from_everything_is_undecided() -> None:
    verdict = pdg.c_obstacle_query(SQUARE, SQUARE, (10, 0, 0, 1, 1, 1))
    assert (verdict.verdict, verdict.pair, verdict.margin) == ("undecided", None, -math.inf)


def test_motion_bounds() -> None:
    random = np.random.default_rng(13)
    for _ in range(300):
        hx, hy, turn = random.uniform(0, (2, 2, 5))
        r = random.uniform(0, 4)
        got = pdg.motion_bounds((hx, hy, turn), r)
        chord = 2 * r * math.sin(min(turn, math.pi) / 2)
        assert got.sum == pytest.approx(hx + hy + r * turn, rel=1e-14)
        assert got.arc == pytest.approx(math.hypot(hx, hy) + r * turn, rel=1e-14)
        assert got.displacement == pytest.approx(math.hypot(hx, hy) + chord, rel=1e-14)
        assert got.displacement <= got.arc <= got.sum


@pytest.mark.parametrize(
    ("cell", "method", "words"),
    [
        ((0, 0, 0, 1, -1, 0), "per-normal", "cell[4]: a half-extent must not be negative"),
        ((0, 0, 0, 1, 1), "per-normal", "expected 6 numbers"),
        ((0, 0, math.inf, 1, 1, 1), "per-normal", "cell[2]: must be finite"),
        ((0, 0, 0, 1, 1, 1), "guess", 'method: expected "published"'),
    ],
)
def test_bad_arguments_are_refused(cell: tuple[float, ...], method: Any, words: str) -> None:
    with pytest.raises(pdg.PdgError) as caught:
        pdg.c_obstacle_query(SQUARE, SQUARE, cell, method)
    assert words in str(caught.value)
