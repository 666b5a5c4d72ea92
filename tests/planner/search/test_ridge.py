"""Paths along the ridge of the clearance: slanted gates, where cells alone need 1/clearance."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from planar_planner import Options, load_scene, solve
from planar_planner.checker.verify import verify_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.planning.planner import Planner
from planar_planner.problem.make import make_problem
from worlds.random_scenes import random_scene

Point = tuple[float, float]
ANGLES = (0.4, 1.2, -0.3, 0.7)
CLEARANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
FINE = Options(resolution=1e-12, max_cells=20_000)


def polygon(*points: Point) -> dict[str, Any]:
    ring = [list(p) for p in points]
    return {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}


def slot(
    angle: float,
    clearance: float,
    *,
    robot: tuple[Point, ...] = ((-1.5, -0.5), (1.5, -0.5), (1.5, 0.5), (-1.5, 0.5)),
    width: float = 1.0,
    thick: float = 2.0,
    aside: float = 0.5,
) -> dict[str, Any]:
    """A gate `thick` long, turned by an angle, wider than the robot by a relative clearance."""
    c, s = math.cos(angle), math.sin(angle)

    def turned(x: float, y: float) -> Point:
        return c * x - s * y, s * x + c * y

    def block(y0: float, y1: float) -> dict[str, Any]:
        x = thick / 2
        return polygon(turned(-x, y0), turned(x, y0), turned(x, y1), turned(-x, y1))

    half = width * (1.0 + clearance) / 2
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [-10, -10, 10, 10]},
        "robot": polygon(*robot),
        "obstacles": [block(half, 14.0), block(-14.0, -half)],
        "start": [*turned(-5.0, aside), 0.3],
        "goal": [*turned(5.0, -aside), 0.1],
    }


def least_width(ring: tuple[Point, ...]) -> float:
    """Return the least width of a convex polygon, counter-clockwise."""
    widths = []
    for (x0, y0), (x1, y1) in itertools.pairwise([*ring, ring[0]]):
        dx, dy = x1 - x0, y1 - y0
        across = [dx * (y - y0) - dy * (x - x0) for x, y in ring]
        widths.append(max(across) / math.hypot(dx, dy))
    return min(widths)


@pytest.mark.parametrize("angle", ANGLES)
def test_cells_do_not_grow_with_the_inverse_of_the_clearance(angle: float) -> None:
    for clearance in CLEARANCES:
        result = solve(load_scene(slot(angle, clearance)), FINE)
        assert result.verdict == "path", clearance
        assert result.stats.decided_by == "ridge"
        assert result.stats.cells < 600, clearance


@pytest.mark.parametrize("clearance", CLEARANCES)
def test_too_narrow_is_proven_as_before(clearance: float) -> None:
    scene = load_scene(slot(0.4, -clearance))
    assert solve(scene, FINE).verdict == "no_path"


@pytest.mark.parametrize("clearance", [1e-2, 1e-6, 1e-9])
@pytest.mark.parametrize("side", [1, -1])
def test_certificates_hold(clearance: float, side: int) -> None:
    scene = load_scene(slot(0.4, side * clearance))
    result = solve(scene, FINE, certificate=True)
    assert result.certificate is not None
    finding = verify_certificate(scene.to_dict(), result.certificate)
    assert finding.verdict == ("path" if side > 0 else "no_path")


def test_is_needed_in_a_slanted_gate_and_can_be_left_out() -> None:
    problem = make_problem(load_scene(slot(0.4, 1e-6)))
    few = Options(resolution=1e-12, max_cells=5000)
    without = ask(make_core(problem, without=("ridge", "survey")), problem, few)
    assert without["verdict"] == "undecided"
    assert without["stats"].ridge_tries == 0
    assert without["stats"].ridge_evaluations == 0
    answer = ask(make_core(problem), problem, few)
    assert answer["verdict"] == "path"
    assert answer["stats"].ridge_tries > 0


def test_is_the_same_every_time() -> None:
    scene = load_scene(slot(-0.3, 1e-5))
    first, second = (solve(scene, FINE) for _ in range(2))
    assert np.array_equal(first.path, second.path)
    assert first.stats.ridge_evaluations == second.stats.ridge_evaluations


def test_ends_are_the_users_own_and_the_way_back_is_found() -> None:
    scene = slot(0.7, 1e-7)
    planner = Planner(load_scene(scene))
    for start, goal in ((scene["start"], scene["goal"]), (scene["goal"], scene["start"])):
        result = planner.solve(start, goal, options=FINE)
        assert result.verdict == "path"
        assert result.path[0].tolist() == list(start)
        assert result.path[-1][:2].tolist() == list(goal[:2])
        turns = (result.path[-1][2] - goal[2]) / math.tau
        assert turns == pytest.approx(round(turns), abs=1e-12)


def test_a_robot_that_may_not_turn() -> None:
    diamond = ((0.5, 0.0), (0.0, 0.5), (-0.5, 0.0), (0.0, -0.5))
    scene = slot(math.pi / 4, 1e-8, robot=diamond, width=math.sqrt(0.5))
    scene |= {"rotation": False}
    scene["start"][2] = scene["goal"][2] = 0.0
    result = solve(load_scene(scene), FINE)
    assert result.verdict == "path"
    assert np.ptp(result.path[:, 2]) == 0.0


@pytest.mark.parametrize("seed", range(24))
def test_convex_robots_in_random_gates(seed: int) -> None:
    """A convex body passes a gate just when its least width does (Strang 1982)."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(3, 7))
    turns = np.sort(math.tau * (np.arange(count) + rng.uniform(0.1, 0.9, count)) / count)
    flat = rng.uniform(0.4, 1.0)
    off = rng.uniform(-0.5, 0.5, 2)
    ring = tuple((float(math.cos(t) + off[0]), float(flat * math.sin(t) + off[1])) for t in turns)
    clearance = (-1.0 if seed % 3 == 0 else 1.0) * 10.0 ** rng.uniform(-8.0, -2.0)
    scene = slot(
        float(rng.uniform(-1.5, 1.5)),
        float(clearance),
        robot=ring,
        width=least_width(ring),
        thick=float(rng.choice([0.5, 1.0, 3.0])),
        aside=float(rng.uniform(-1.0, 1.0)),
    )
    result = solve(load_scene(scene), Options(resolution=1e-12, max_cells=8000))
    truth = "path" if clearance > 0 else "no_path"
    assert result.verdict in (truth, "undecided"), (clearance, result.reason)


@pytest.mark.parametrize("seed", range(400, 440))
def test_verdicts_of_random_scenes_are_the_same_without_it(seed: int) -> None:
    problem = make_problem(load_scene(random_scene(seed)))
    options = Options(max_cells=20_000)
    whole, without = (
        ask(make_core(problem, ("cheap", "probe", *left_out)), problem, options)
        for left_out in ((), ("ridge",))
    )
    if "undecided" not in (whole["verdict"], without["verdict"]):
        assert whole["verdict"] == without["verdict"]
    assert whole["verdict"] != "undecided" or without["verdict"] == "undecided"
