"""Batches are the single results, row by row, and leave the interpreter to other threads."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import pytest

import pdg
from worlds.bodies.random_bodies import blob, convex

SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
HUGE = 1.2e150 * SQUARE
METHODS = ("published", "displacement", "per-normal")


def poses(random: np.random.Generator, count: int) -> np.ndarray:
    return random.uniform((-6, -6, -4), (6, 6, 4), (count, 3))


def cells(random: np.random.Generator, count: int) -> np.ndarray:
    return np.column_stack([poses(random, count), random.uniform(0, 0.2, (count, 3))])


def test_translational_depths_are_the_single_ones() -> None:
    random = np.random.default_rng(20)
    for _ in range(20):
        A, B = pdg.convex_pieces(convex(random)), pdg.convex_pieces(convex(random))
        rows = poses(random, 40)
        many = pdg.translational_depth(A, B, rows)
        assert isinstance(many, pdg.TranslationalDepths)
        assert list(many) == [pdg.translational_depth(A, B, tuple(q)) for q in rows]
        assert [d.depth for d in many] == many.depth.tolist()
        assert [d.state for d in many] == many.state.tolist()
        assert many[-1] == many[len(many) - 1]


def test_lower_bounds_are_the_single_ones() -> None:
    random = np.random.default_rng(21)
    none = 0
    for _ in range(10):
        A, B = pdg.convex_pieces(blob(random, 2)), pdg.convex_pieces(blob(random, 4))
        rows = poses(random, 40)
        many = pdg.generalized_depth_lower_bound(A, B, rows)
        assert list(many) == [pdg.generalized_depth_lower_bound(A, B, tuple(q)) for q in rows]
        none += (many.pair[:, 0] < 0).sum()
        assert (many.lower[many.pair[:, 0] < 0] == 0).all()
    assert 10 < none < 390


@pytest.mark.parametrize("method", METHODS)
def test_verdicts_are_the_single_ones(method: pdg.QueryMethod) -> None:
    random = np.random.default_rng(22)
    full = 0
    for _ in range(10):
        A, B = pdg.convex_pieces(blob(random, 1)), pdg.convex_pieces(blob(random, 3))
        rows = cells(random, 40)
        many = pdg.c_obstacle_query(A, B, rows, method)
        assert list(many) == [pdg.c_obstacle_query(A, B, tuple(c), method) for c in rows]
        full += many.full.sum()
    assert 10 < full < 390


@pytest.mark.parametrize("prepared", [False, True])
def test_brackets_are_the_single_ones(prepared: bool) -> None:
    random = np.random.default_rng(25)
    ends = set()
    apart = 0
    for _ in range(5):
        A, B = pdg.convex_pieces(blob(random, 1)), pdg.convex_pieces(blob(random, 3))
        fixed = pdg.convex_separators(B) if prepared else B
        rows = 0.5 * poses(random, 8)
        for tolerance, most in ((1e-2, None), (1e-9, 20)):
            many = pdg.generalized_depth_bracket(A, fixed, rows, tolerance, max_nodes=most)
            assert isinstance(many, pdg.DepthBrackets)
            assert list(many) == [
                pdg.generalized_depth_bracket(A, fixed, tuple(q), tolerance, max_nodes=most)
                for q in rows
            ]
            assert [b.pose for b in many] == [tuple(q) for q in many.pose.tolist()]
            ends |= {b.stop_reason for b in many}
            apart += (many.upper == 0).sum()
    assert ends >= {"converged", "max_nodes"}
    assert 2 < apart < 78


def test_a_timeout_is_for_each_bracket() -> None:
    notch = [(-6, -6), (6, -6), (6, 2), (1.6, 2), (1.6, -3), (-1.6, -3), (-1.6, 2), (-6, 2)]
    many = pdg.generalized_depth_bracket(
        SQUARE, notch, np.tile((0.9, -1.0, 0.3), (3, 1)), 0.0, timeout=0.0
    )
    assert many.stop_reason.tolist() == ["timeout"] * 3
    assert (many.lower <= many.upper).all()


def test_displacements_are_the_single_ones() -> None:
    random = np.random.default_rng(23)
    body = pdg.convex_pieces(blob(random, 3))
    starts, ends = poses(random, 50), poses(random, 50)
    both = pdg.displacement(body, starts, ends)
    one = pdg.displacement(body, starts[0], ends)
    for row in range(50):
        assert both[row] == pdg.displacement(body, starts[row], ends[row])
        assert one[row] == pdg.displacement(body, starts[0], ends[row])
    assert pdg.displacement(body, ends, starts[0]) == pytest.approx(one, abs=1e-12)


@pytest.mark.parametrize("empty", [[], np.zeros((0, 3))])
def test_empty_batches(empty: object) -> None:
    assert list(pdg.translational_depth(SQUARE, SQUARE, empty)) == []
    assert list(pdg.generalized_depth_lower_bound(SQUARE, SQUARE, empty)) == []
    assert list(pdg.generalized_depth_bracket(SQUARE, SQUARE, empty)) == []
    assert pdg.displacement(SQUARE, empty, (0, 0, 0)).shape == (0,)
    verdicts = pdg.c_obstacle_query(SQUARE, SQUARE, np.zeros((0, 6)))
    assert len(verdicts) == 0
    assert verdicts.pair.shape == (0, 2)


GOOD = [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("call", "name", "index", "value", "words"),
    [
        (
            lambda: pdg.translational_depth(SQUARE, SQUARE, [GOOD, [0, np.nan, 0]]),
            "pose",
            1,
            [0.0, pytest.approx(np.nan, nan_ok=True), 0.0],
            "finite",
        ),
        (
            lambda: pdg.translational_depth(SQUARE * 3e150, SQUARE, [GOOD, [0, 3e150, 0]]),
            "pose",
            1,
            [0.0, 3e150, 0.0],
            "outside the range",
        ),
        (
            lambda: pdg.generalized_depth_bracket(
                HUGE, HUGE, [[0, 3e150, 0], [0, 2.2e150, 0]], max_nodes=0
            ),
            "pose",
            1,
            [0.0, 2.2e150, 0.0],
            "outside the range",
        ),
        (
            lambda: pdg.generalized_depth_lower_bound(SQUARE, SQUARE, np.full((2, 3), np.inf)),
            "pose",
            0,
            [np.inf] * 3,
            "finite",
        ),
        (
            lambda: pdg.translational_depth(SQUARE, SQUARE, np.zeros((4, 2))),
            "pose",
            None,
            (4, 2),
            "rows of 3",
        ),
        (
            lambda: pdg.translational_depth(SQUARE, SQUARE, np.zeros((1, 4, 3))),
            "pose",
            None,
            (1, 4, 3),
            "3 numbers",
        ),
        (lambda: pdg.displacement(SQUARE, [GOOD] * 2, [GOOD] * 3), "q1", None, 3, "2 rows"),
        (
            lambda: pdg.c_obstacle_query(SQUARE, SQUARE, [[0] * 6, [0, 0, 0, 1, -1, 0]]),
            "cell",
            1,
            [0.0, 0.0, 0.0, 1.0, -1.0, 0.0],
            "negative",
        ),
        (
            lambda: pdg.c_obstacle_query(SQUARE, SQUARE, np.zeros((2, 5))),
            "cell",
            None,
            (2, 5),
            "rows of 6",
        ),
    ],
)
def test_bad_rows_are_named(
    call: Callable[[], object], name: str, index: int | None, value: object, words: str
) -> None:
    with pytest.raises(pdg.PdgError, match=words) as caught:
        call()
    assert (caught.value.name, caught.value.index) == (name, index)
    assert caught.value.value == value


@contextmanager
def counting_thread() -> Iterator[Callable[[], int]]:
    """Count in another thread, which gets the lock only when this one lets go of it."""
    count = 0
    done = threading.Event()

    def work() -> None:
        nonlocal count
        while not done.is_set():
            count += 1
            time.sleep(1e-4)

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e3)
    thread = threading.Thread(target=work)
    thread.start()
    try:
        yield lambda: count
    finally:
        done.set()
        sys.setswitchinterval(interval)
        thread.join()


@pytest.mark.parametrize("what", ["depths", "bounds", "queries", "displacements", "brackets"])
def test_another_thread_runs_during_a_batch(what: str) -> None:
    random = np.random.default_rng(24)
    a, b = pdg.convex_pieces(convex(random))._native, pdg.convex_pieces(convex(random))._native
    rows, boxes = poses(random, 4000), cells(random, 4000)
    core = pdg._core
    batch: Callable[[], object] = {
        "depths": lambda: core.translational_depths(a, b, rows),
        "bounds": lambda: core.generalized_depth_lower_bounds(a, b, rows),
        "queries": lambda: core.c_obstacle_queries(a, b, boxes, 2),
        "displacements": lambda: core.displacements(a, rows, rows),
        "brackets": lambda: core.bracket_depths(a, b, None, rows[:200], 1e-2, 1.0, 100),
    }[what]
    with counting_thread() as count:
        while count() == 0:
            time.sleep(1e-3)
        # Fewer rows than between two looks at signals: only a released lock lets the other in.
        advanced = 0
        for _ in range(1000):
            before = count()
            batch()
            advanced += count() > before
            if advanced >= 3:
                break
    assert advanced >= 3
