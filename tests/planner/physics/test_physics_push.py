"""Robots that forces drive: they stay where they belong, can reach a goal, and repeat."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest

from planar_planner import OptionsError, solve
from planar_planner.physics import push, replay
from planar_planner.physics.contacts import find_contacts
from planar_planner.physics.driver import Driver
from planar_planner.physics.goals import nearest_goal
from planar_planner.physics.replay import problem_of
from planar_planner.physics.world import make_world
from planar_planner.tolerances import ASIDE


def box(x0: float, y0: float, x1: float, y1: float) -> dict[str, Any]:
    ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]
    return {"type": "Polygon", "coordinates": [ring]}


@pytest.mark.parametrize("name", ["gear-jammed", "slide-blocked", "bug-trap-closed"])
def test_robots_stay_in_their_part(name: str) -> None:
    found = push(name, seconds=3.0, tries=2, seed=1)
    assert not found.reached
    assert not found.may_have_tunnelled
    assert found.deepest < 2.0 * found.step  # simulated contact gives way by a step
    assert min(run.length for run in found.tries) > 0.5  # they did try


@pytest.mark.parametrize("name", ["open", "gear-wide", "fence"])
def test_robots_can_reach_a_goal(name: str) -> None:
    found = push(name, seconds=20.0, tries=2)
    assert found.reached
    (first, *_) = [run for run in found.tries if run.reached]
    assert first.nearest < found.distance
    assert first.outside < found.step
    seen = replay(name, first.configurations)
    assert seen.start_gap == 0.0
    assert seen.deepest <= first.deepest + seen.step + 0.05  # straight between recorded ones


def test_recorded_depth_is_what_is_found_there() -> None:
    """The depth that the simulation tells, against that of a fresh question, at each step."""
    problem = problem_of("gear-jammed")
    probe = make_world(problem, dynamic=False)
    driver = Driver(problem, make_world(problem, dynamic=True), random.Random("0/2"))
    deepest = 0.0
    for _ in range(4300):
        driver.advance(1.0 / 1024.0)
        depth = driver.depth()
        if depth > 1e-4:
            fresh = find_contacts(probe, np.array([driver.configuration()])).deepest
            assert depth == pytest.approx(fresh, abs=1e-9)
            deepest = max(deepest, depth)
    assert 1e-4 < deepest < 0.01


def test_a_robot_that_was_thrown_is_taken_back() -> None:
    problem = problem_of("open")
    world = make_world(problem, dynamic=True)
    driver = Driver(problem, world, random.Random(0))
    driver.advance(1.0 / 1024.0)
    before = driver.configuration()
    world.robot.velocity = (500.0, 0.0)
    driver.advance(1.0 / 1024.0)
    assert driver.undone == 1
    assert math.dist(before[:2], driver.configuration()[:2]) <= 2.0 * ASIDE / world.scale
    driver.advance(1.0 / 1024.0)
    assert driver.undone == 1


def test_the_same_seed_repeats_to_the_last_bit_and_another_does_not() -> None:
    one, two, other = (push("piano-jammed", seconds=2.0, tries=2, seed=s) for s in (7, 7, 8))
    for a, b in zip(one.tries, two.tries, strict=True):
        assert a.configurations.tobytes() == b.configurations.tobytes()
        assert (a.deepest, a.length) == (b.deepest, b.length)
    assert not np.array_equal(one.tries[0].configurations, one.tries[1].configurations)
    assert not np.array_equal(one.tries[0].configurations, other.tries[0].configurations)


def test_a_robot_that_may_not_turn_does_not() -> None:
    found = push("slide-blocked", seconds=2.0, tries=1)
    trace = found.tries[0].configurations
    assert (trace[:, 2] == trace[0, 2]).all()


def test_no_point_moves_farther_in_a_step_than_promised() -> None:
    problem = problem_of("open")
    driver = Driver(problem, make_world(problem, dynamic=True), random.Random(3))
    found = push("open", seconds=0.01, tries=1)
    corners = problem.robot.coords
    last = None
    for _ in range(3000):
        driver.advance(found.time_step)
        x, y, theta = driver.configuration()
        turn = np.array([[math.cos(theta), -math.sin(theta)], [math.sin(theta), math.cos(theta)]])
        now = corners @ turn.T + (x, y)
        if last is not None:
            assert np.hypot(*(now - last).T).max() <= found.step * 1.25  # pushed out of overlaps
        last = now


def test_bad_numbers() -> None:
    with pytest.raises(OptionsError, match="seconds"):
        push("open", seconds=0.0)
    with pytest.raises(OptionsError, match="tries"):
        push("open", tries=0)
    with pytest.raises(OptionsError, match="at most 1e"):
        push("open", seconds=1e9)


def test_goals_that_are_regions() -> None:
    """A room with a block: into its right end at half a turn or so, and out of its left end."""
    room = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 20, 10]},
        "robot": box(-1, -1, 1, 1),
        "obstacles": [box(8, 4, 12, 6)],
        "start": [2, 5, 0],
        "goal": {"region": box(15, 2, 19, 8), "theta": [3, 4]},
    }
    problem = problem_of(room)
    assert nearest_goal(problem, (2.0, 5.0, 0.0)) == pytest.approx((15.0, 5.0, 4.0 - math.tau))
    assert nearest_goal(problem, (16.0, 9.0, 3.5)) == pytest.approx((16.0, 8.0, 3.5))
    inside = (16.0, 5.0, 3.25 + 2 * math.tau)
    assert nearest_goal(problem, inside) == inside
    path = solve(room).path
    assert replay(room, path).witnessed
    assert not replay(room, path[path[:, 0] < 15.0]).joins
    escape = room | {"goal": {"escape": box(-30, -30, 5, 40)}}
    found = push(escape, seconds=20.0, tries=2)
    assert found.distance == pytest.approx(3.0)
    assert found.reached
