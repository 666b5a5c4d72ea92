"""Replays before Chipmunk: free paths, wrong paths, touching, walls, holes, bounds, ends."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import pdg
from planar_planner import OptionsError, load_scene, solve
from planar_planner.physics import replay
from planar_planner.physics.contacts import reported, touched
from planar_planner.physics.replay import outside, problem_of
from planar_planner.physics.shapes import MOST_VERTICES, obstacle_shapes, robot_shapes
from planar_planner.physics.world import make_world
from planar_planner.planning.engine import make_core

Json = dict[str, Any]


def polygon(
    *points: tuple[float, float], holes: list[list[tuple[float, float]]] | None = None
) -> Json:
    rings = [list(points), *(holes or [])]
    return {"type": "Polygon", "coordinates": [[*map(list, ring), list(ring[0])] for ring in rings]}


def box(x0: float, y0: float, x1: float, y1: float) -> Json:
    return polygon((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def scene(**members: Any) -> Json:
    """A square of side 2 in a room of 20 × 10 with a block in the middle."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "name": "room",
        "workspace": {"box": [0, 0, 20, 10]},
        "robot": box(-1, -1, 1, 1),
        "obstacles": [box(8, 4, 12, 6)],
        "start": [2, 5, 0],
        "goal": [18, 5, 0],
    } | members


@pytest.mark.parametrize("name", ["gear", "corner", "piano", "slide", "fence", "courtyard"])
def test_paths_of_the_planner_are_witnessed(name: str) -> None:
    found = replay(name, solve(load_scene(name)).path)
    assert found.confirmed
    assert found.deepest <= found.accuracy < 1e-12
    assert found.outside == 0.0


def test_a_path_through_an_obstacle_is_found_out() -> None:
    """Robot and block are aligned all the way, which is hard for Chipmunk alone."""
    found = replay(scene(), [(2, 5, 0), (18, 5, 0)])
    assert not found.free
    assert found.joins
    assert not found.confirmed
    assert found.deepest == pytest.approx(2.0, abs=1e-6)  # straight up: (2 + 2)/2
    (contact,) = found.contacts
    assert contact.what == "obstacles[0]"
    # in contact from x = 7 to x = 13, of 16
    assert contact.count == pytest.approx(6 / 16 * len(found.configurations), abs=3)


def test_depth_agrees_with_pdg_along_a_wrong_path() -> None:
    problem = problem_of("gear")
    found = replay(problem, [problem.start, problem.goal])
    robot = [shape.vertices for shape in robot_shapes(problem, 1.0)]
    obstacles = [shape.vertices for shape in obstacle_shapes(problem, 1.0)]
    some = found.configurations[::37]
    world = make_world(problem, dynamic=False)
    for q in some.tolist():
        depth = pdg.generalized_depth_lower_bound(robot, obstacles, q).lower
        answer = max(touched(world, tuple(q))[0].values(), default=0.0)
        assert answer == pytest.approx(depth, abs=1e-8)
    assert not found.free


@pytest.mark.parametrize("name", ["gear", "piano", "courtyard", "fence", "slide"])
def test_chipmunk_and_the_planner_agree_on_what_is_free(name: str) -> None:
    problem = problem_of(name)
    core, world = make_core(problem), make_world(problem, dynamic=False)
    random = np.random.default_rng(5)
    around = np.concatenate([problem.obstacles.coords, [problem.start[:2], problem.goal[:2]]])
    states = []
    for x, y in random.uniform(around.min(axis=0), around.max(axis=0), (60, 2)).tolist():
        q = (x, y, random.uniform(-3.0, 3.0) if problem.rotation else problem.start[2])
        free = core.placement(q)["state"] in ("free", "touching")
        depth = max(touched(world, q)[0].values(), default=0.0)
        assert free == (max(depth, outside(problem.reference_bounds, np.array([q]))) <= 1e-12)
        states.append(free)
    assert {True, False} == set(states)


def test_a_thin_wall_is_not_stepped_over() -> None:
    thin = scene(obstacles=[box(10, 0, 10.001, 10)])
    assert not replay(thin, [(2, 5, 0), (18, 5, 0)]).free
    assert not replay(thin, [(2, 5, 0), (18, 5, 0)], step=3.0).free  # the robot is wider than that


def test_touching_is_no_collision() -> None:
    along = [(2, 3, 0), (10, 3, 0), (18, 3, 0)]  # slides along the block's lower edge, y = 4
    found = replay(scene(start=[2, 3, 0], goal=[18, 3, 0]), along)
    assert found.confirmed
    assert found.contacts
    assert found.deepest <= found.accuracy
    deeper = replay(
        scene(start=[2, 3 + 1e-9, 0], goal=[18, 3 + 1e-9, 0]), np.add(along, [0, 1e-9, 0])
    )
    assert not deeper.free
    assert deeper.deepest == pytest.approx(1e-9, rel=1e-3)
    assert replay(scene(), along, tolerance=1e-8).free


def test_touching_a_corner_while_turning_is_no_collision() -> None:
    """A corner of the robot slides along the block's edge, to the last bit or so, and turns on."""
    y = 4 - math.sqrt(2)
    path = [(7, y, math.pi / 4), (13, y, math.pi / 4), (13, y, math.pi / 4 + 1)]
    assert replay(scene(), path).free


def test_chipmunk_misjudges_what_touches_to_the_last_bit_and_is_asked_again() -> None:
    """Both cases are answers of Chipmunk 2.0.1; they guard the reason to ask again."""
    robot = [(-1, 4), (-3, -3), (2, -1), (4, 2)]
    obstacle = [(-1, -2), (3, 4), (0, 1)]
    bounds = {"workspace": None, "reference_bounds": [-50, -50, 50, 50]}
    world = make_world(
        problem_of(scene(robot=polygon(*robot), obstacles=[polygon(*obstacle)], **bounds)),
        dynamic=False,
    )
    q = (-4.0, -1.0, 0.0)
    assert pdg.translational_depth(robot, obstacle, q).depth == 0.0
    assert reported(world, q)["obstacles[0]"] > 1.0
    depths, doubted = touched(world, q)
    assert doubted
    assert depths["obstacles[0]"] <= 1e-12


def test_room_with_a_polygonal_workspace_and_holes() -> None:
    room = polygon((0, 0), (20, 0), (20, 10), (0, 10.5), holes=[[(9, 4), (11, 4), (11, 6), (9, 6)]])
    walled = scene(workspace=room, obstacles=[])
    assert replay(walled, [(2, 2, 0), (18, 2, 0)]).free
    through = replay(walled, [(2, 5, 0), (18, 5, 0)])
    assert [contact.what for contact in through.contacts] == ["workspace"]
    assert through.deepest == pytest.approx(2.0, abs=through.step)
    over = replay(walled, [(2, 5, 0), (2, 12, 0)])
    assert over.deepest == pytest.approx(2.6, abs=0.1)
    assert over.contacts[0].what == "workspace"


@pytest.mark.parametrize("end", [(2, -3, 0), (2, 14, 0), (-3, 5, 0), (24, 5, 0)])
def test_leaving_the_box_is_a_penetration_of_its_walls(end: tuple[float, float, float]) -> None:
    found = replay(scene(), [(2, 5, 0) if end[0] < 10 else (18, 5, 0), end])
    assert found.contacts[0].what == "workspace"
    assert found.deepest >= 2.0


def test_a_robot_in_the_hole_of_an_obstacle_is_free_and_out_of_it_is_not() -> None:
    ring = polygon((5, 0), (15, 0), (15, 10), (5, 10), holes=[[(7, 2), (13, 2), (13, 8), (7, 8)]])
    held = scene(obstacles=[ring], start=[8, 5, 0], goal=[12, 5, 0])
    assert replay(held, [(8, 5, 0), (12, 5, 0)]).confirmed
    assert replay(held, [(8, 5, 0), (14, 5, 0)]).deepest == pytest.approx(2.0, abs=1e-6)


def test_reference_bounds_hold_the_point_and_not_the_body() -> None:
    bounded = scene(workspace=None, reference_bounds=[1, 1, 19, 9], obstacles=[])
    assert replay(bounded, [(2, 5, 0), (1, 1, 0), (18, 5, 0)]).confirmed
    found = replay(bounded, [(2, 5, 0), (0.5, 9.25, 0), (18, 5, 0)])
    assert (found.outside, found.deepest, found.free) == (0.5, 0.0, False)


def test_ends_other_than_start_and_goal_are_told() -> None:
    found = replay(scene(), [(2, 5, math.tau), (2, 2, 0), (18, 2, 0)])
    assert found.free
    assert not found.joins
    assert found.start_gap == pytest.approx(0.0, abs=1e-12)  # a whole turn is none
    assert found.goal_gap == 3.0
    assert not found.confirmed


@pytest.mark.parametrize("factor", [2.0**-60, 1e-9, 1e6, 2.0**30])
def test_the_finding_does_not_depend_on_the_unit(factor: float) -> None:
    scaled = scene(
        workspace={"box": [0, 0, 20 * factor, 10 * factor]},
        robot=box(-factor, -factor, factor, factor),
        obstacles=[box(8 * factor, 4 * factor, 12 * factor, 6 * factor)],
    )
    path = np.array([(2, 5, 0), (18, 5, 0)]) * [factor, factor, 1]
    scaled |= {"start": path[0].tolist(), "goal": path[1].tolist()}
    assert replay(scaled, path).deepest == pytest.approx(2.0 * factor, rel=1e-6)
    detour = np.array([(2, 5, 0), (2, 2, 0), (18, 2, 0), (18, 5, 0)]) * [factor, factor, 1]
    assert replay(scaled, detour).confirmed


def test_a_robot_that_is_round_is_cut_into_shapes_that_chipmunk_can_number() -> None:
    angles = np.linspace(0, math.tau, 400, endpoint=False)
    disc = polygon(*np.column_stack([np.cos(angles), np.sin(angles)]).tolist())
    problem = problem_of(scene(robot=disc))
    shapes = robot_shapes(problem, 1.0)
    assert max(len(shape.vertices) for shape in shapes) <= MOST_VERTICES
    areas = [pdg.convex_pieces(shape.vertices) for shape in shapes]
    assert len(areas) == len(shapes) > 3
    found = replay(problem, [(2, 5, 0), (18, 5, 0)])
    assert found.deepest > 0.9


def test_bad_numbers() -> None:
    path = [(2, 5, 0), (2, 2, 0)]
    for step in (0.0, -1.0, math.nan, math.inf, 1e-12):
        with pytest.raises(OptionsError, match="step"):
            replay(scene(), path, step=step)
    with pytest.raises(OptionsError, match="tolerance"):
        replay(scene(), path, tolerance=-1.0)
    with pytest.raises(ValueError, match="finite"):
        replay(scene(), [(2, 5, math.nan)])
