"""Constant arc length: spacing, ends, and that travel bounds what the body does."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from planar_planner import load_scene
from planar_planner.planning.path_samples import (
    configurations_at,
    equal_parts,
    equal_steps,
    reach,
    travel,
)
from planar_planner.problem.make import make_problem

PATH = np.array([(1.0, 1.0, 0.0), (4.0, 1.0, 0.0), (4.0, 1.0, 2.0), (4.0, 3.5, -1.0)])
RADIUS = 0.7

paths = st.integers(1, 6).flatmap(
    lambda n: arrays(np.float64, (n, 3), elements=st.floats(-50.0, 50.0, width=32))
)


def test_travel_is_translation_plus_radius_times_turn() -> None:
    assert travel(PATH, RADIUS) == pytest.approx([0.0, 3.0, 4.4, 4.4 + 2.5 + 2.1])


@given(paths, st.floats(0.0, 10.0), st.integers(2, 40))
def test_parts_are_equal_and_end_at_the_ends(path: np.ndarray, radius: float, count: int) -> None:
    placed = equal_parts(path, radius, count)
    assert placed.shape == (count, 3)
    assert (placed[0] == path[0]).all()
    assert (placed[-1] == path[-1]).all()
    along = travel(path, radius)
    scale = max(1.0, along[-1])
    # a corner of the path may be cut between two parts, so never more than an even share
    assert np.diff(travel(placed, radius)).max() <= along[-1] / (count - 1) + 1e-9 * scale


def test_parts_of_a_straight_path_are_exactly_even() -> None:
    placed = equal_parts([(0.0, 0.0, 0.0), (3.0, 4.0, 10.0)], 0.5, 6)
    assert np.diff(travel(placed, 0.5)) == pytest.approx(np.full(5, 2.0))
    assert placed[:, 0] == pytest.approx(np.linspace(0.0, 3.0, 6))


def test_steps_are_no_longer_than_asked() -> None:
    total = travel(PATH, RADIUS)[-1]
    placed = equal_steps(PATH, RADIUS, 0.4)
    assert len(placed) == int(np.ceil(total / 0.4)) + 1
    assert np.diff(travel(placed, RADIUS)).max() <= 0.4 + 1e-12
    assert len(equal_steps(PATH, RADIUS, 1e9)) == 2


def test_configurations_lie_on_the_segments() -> None:
    placed = configurations_at(PATH, RADIUS, [-1.0, 0.0, 1.5, 3.7, 4.4, 100.0])
    assert placed == pytest.approx(
        np.array([PATH[0], PATH[0], (2.5, 1.0, 0.0), (4.0, 1.0, 1.0), PATH[2], PATH[3]])
    )


def test_waits_take_no_time() -> None:
    waiting = PATH[[0, 0, 1, 1, 1, 2, 3, 3]]
    assert (equal_parts(waiting, RADIUS, 17) == equal_parts(PATH, RADIUS, 17)).all()


def test_a_path_that_stays_where_it_is() -> None:
    here = np.array([(1.0, 2.0, 3.0)])
    assert (equal_parts(here, 1.0, 3) == np.repeat(here, 3, axis=0)).all()
    assert (equal_steps(here, 1.0, 0.1) == np.repeat(here, 2, axis=0)).all()
    # a pure turn has no length if a turn counts nothing, yet both ends are there
    turn = np.array([(0.0, 0.0, 0.0), (0.0, 0.0, 1.0)])
    assert equal_parts(turn, 0.0, 4)[[0, -1]] == pytest.approx(turn)


def test_travel_bounds_the_way_of_every_vertex() -> None:
    robot = make_problem(load_scene("gear")).robot
    radius = reach(robot)
    assert radius == pytest.approx(np.linalg.norm(robot.coords, axis=1).max())
    fine = equal_parts(PATH, radius, 4001)
    c, s = np.cos(fine[:, 2]), np.sin(fine[:, 2])
    x, y = robot.coords.T
    way = np.hypot(
        np.diff(np.outer(c, x) - np.outer(s, y) + fine[:, :1], axis=0),
        np.diff(np.outer(s, x) + np.outer(c, y) + fine[:, 1:2], axis=0),
    ).sum(axis=0)
    total = travel(PATH, radius)[-1]
    assert way.max() <= total
    assert way.max() >= 0.5 * total  # the bound is not idle


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: travel(np.empty((0, 3)), 1.0), "shape"),
        (lambda: travel([(0.0, 0.0)], 1.0), "shape"),
        (lambda: travel([(0.0, 0.0, np.nan)], 1.0), "not finite"),
        (lambda: travel(PATH, -1.0), "radius"),
        (lambda: travel(PATH, np.inf), "radius"),
        (lambda: equal_steps(PATH, 1.0, 0.0), "step"),
        (lambda: equal_steps(PATH, 1.0, np.nan), "step"),
        (lambda: equal_parts(PATH, 1.0, 1), "count"),
        (lambda: configurations_at(PATH, 1.0, [np.nan]), "not a number"),
    ],
)
def test_bad_values_are_named(call, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_the_shortest_steps_are_interpolated() -> None:
    """A turn that counts as a length near the smallest double, where slopes overflow."""
    path = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [0.0, 0.0, -2.0]]
    for radius in (2.2e-313, 5e-324):
        parts = equal_parts(path, radius, 9)
        assert np.isfinite(parts).all()
        assert parts[0].tolist() == path[0] and parts[-1].tolist() == path[-1]
        assert (np.abs(parts[:, 2]) <= 3.0).all()
