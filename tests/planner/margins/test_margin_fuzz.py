"""Brackets of random scenes, judged from outside: GEOS's distances, and scenes solved afresh."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import Margin, Options, load_scene, margin, solve
from planar_planner.margins.surroundings import Surroundings, placed, shape_of
from planar_planner.planning.path_samples import equal_steps
from planar_planner.problem.make import make_problem
from worlds.random_scenes import random_scene

LIMITS = Options(timeout=20.0, max_cells=60_000)
SLACK = 1e-9  # of GEOS's doubles
SEEDS = range(1000, 1016)


def _buffered(robot: Any, distance: float) -> shapely.Geometry:
    """Return GEOS's offset of the robot; its arcs are inside the true ones, by up to a per cent."""
    return shapely.geometry.shape(robot).buffer(distance, quad_segs=24)


def _apart(distance: float) -> float:
    """Return more than the error of `_buffered`."""
    return 0.01 + 0.02 * abs(distance)


def _verdict(scene: dict[str, Any], robot: shapely.Geometry) -> str:
    try:
        return solve({**scene, "robot": shapely.geometry.mapping(robot)}, LIMITS).verdict
    except ValueError:  # an end collides
        return "no_path"


@pytest.fixture(scope="module", params=SEEDS)
def case(request: pytest.FixtureRequest) -> tuple[dict[str, Any], Margin]:
    scene = random_scene(request.param)
    return scene, margin(scene, LIMITS, width=0.02)


def test_most_are_decided_and_all_are_brackets(case: tuple[dict[str, Any], Margin]) -> None:
    _, found = case
    assert found.lower <= found.upper
    assert found.reason or found.upper - found.lower <= 0.02 or found.binding == "none"


def test_the_path_keeps_the_lower_end_away(case: tuple[dict[str, Any], Margin]) -> None:
    scene, found = case
    if len(found.path) < 2 or found.lower < 0.0 or found.binding == "none":
        pytest.skip("no path of a grown robot")
    problem = make_problem(load_scene(scene))
    around, shape = Surroundings(problem), shape_of(problem.robot)
    places = equal_steps(found.path, 1.0, 0.02)
    assert min(around.clearance(placed(shape, q)) for q in places) >= found.lower - SLACK
    assert np.allclose(found.path[0], problem.start)
    assert np.allclose(found.path[-1][:2], problem.goal[:2])


def test_a_larger_robot_has_no_path_and_a_smaller_one_has(
    case: tuple[dict[str, Any], Margin],
) -> None:
    scene, found = case
    if found.binding == "none":
        pytest.skip("nothing in the way")
    larger = _buffered(scene["robot"], found.upper + _apart(found.upper))
    assert larger.is_empty or _verdict(scene, larger) != "path"
    smaller = _buffered(scene["robot"], found.lower - _apart(found.lower))
    assert smaller.is_empty or _verdict(scene, smaller) != "no_path"


def test_the_bottleneck_has_the_clearance_of_the_margin(
    case: tuple[dict[str, Any], Margin],
) -> None:
    _, found = case
    place = found.narrow_place
    if place is None or found.lower < 0.0 or not found.decided:
        pytest.skip("no bottleneck of a grown robot")
    assert place.clearance >= found.lower - SLACK
    assert place.contacts
    assert place.contacts[0].distance == pytest.approx(place.clearance)
