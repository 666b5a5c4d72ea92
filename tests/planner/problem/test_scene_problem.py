"""The gate: what it normalises, and what it takes from a query."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pytest

from planar_planner.errors import SceneError
from planar_planner.problem.make import with_query
from support.scene_gate import message, polygon, problem_of
from worlds.small import square


def test_arrays_of_a_valid_scene(scene_dict: dict[str, Any]) -> None:
    hole = square(5, 5, 0.25)
    scene_dict["obstacles"] = [
        polygon(square(5, 5), hole),
        {
            "type": "MultiPolygon",
            "coordinates": [[square(1, 8)], [square(8, 1), square(8, 1, 0.1)]],
        },
    ]
    problem = problem_of(scene_dict)
    assert problem.workspace_box == (0, 0, 10, 10)
    assert problem.workspace is None
    assert problem.reference_bounds is None
    assert (problem.start, problem.goal) == ((1, 1, 0), (9, 9, 0))
    coords, ring_starts, polygon_starts = problem.obstacles.arrays
    assert coords.dtype == np.float64
    assert ring_starts.dtype == polygon_starts.dtype == np.uint32
    assert all(a.flags.c_contiguous and not a.flags.writeable for a in problem.obstacles.arrays)
    assert ring_starts.tolist() == [0, 4, 8, 12, 16, 20]
    assert polygon_starts.tolist() == [0, 2, 3, 5]
    assert coords[4:8].tolist() == hole[:-1]
    assert problem.obstacle_indices.tolist() == [0, 1, 1]
    assert problem.obstacle_paths == (
        "obstacles[0].coordinates",
        "obstacles[1].coordinates[0]",
        "obstacles[1].coordinates[1]",
    )


def test_no_obstacles(scene_dict: dict[str, Any]) -> None:
    problem = problem_of(scene_dict | {"obstacles": []})
    assert len(problem.obstacles) == 0
    assert problem.obstacles.coords.shape == (0, 2)
    assert problem.obstacles.ring_starts.tolist() == [0]
    assert problem.obstacles.polygon_starts.tolist() == [0]


@pytest.mark.parametrize(
    "ring",
    [
        square(0, 0),
        square(0, 0)[:-1],  # open
        square(0, 0)[::-1],  # clockwise
        [square(0, 0)[0]] * 3 + square(0, 0)[1:] + [square(0, 0)[0]] * 2,  # repeated
        [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5]],
    ],
)
def test_equivalent_rings(scene_dict: dict[str, Any], ring: Any) -> None:
    robot = problem_of(scene_dict | {"robot": polygon(ring)}).robot
    assert sorted(robot.coords.tolist()) == sorted(square(0, 0)[:-1])
    assert robot.ring_starts.tolist() == [0, 4]


def test_collinear_vertices_stay(scene_dict: dict[str, Any]) -> None:
    ring = [[0, 0], [1, 0], [2, 0], [2, 1]]
    assert problem_of(scene_dict | {"robot": polygon(ring)}).robot.coords.tolist() == ring


def test_negative_zero_equals_zero(scene_dict: dict[str, Any]) -> None:
    ring = [[0.0, 0.0], [-0.0, 0.0], [1, 0], [1, 1]]
    coords = problem_of(scene_dict | {"robot": polygon(ring)}).robot.coords
    assert coords.tolist() == [[0, 0], [1, 0], [1, 1]]
    assert not np.signbit(coords).any()


def test_touching_overlapping_and_wrapped_obstacles(scene_dict: dict[str, Any]) -> None:
    a, b, c = polygon(square(2, 5)), polygon(square(3, 5)), polygon(square(3.25, 5.25))
    collection = {"type": "GeometryCollection", "geometries": [a, b]}
    feature = {"type": "Feature", "geometry": collection, "properties": {"colour": "red"}, "id": 1}
    overlap = {"type": "MultiPolygon", "coordinates": [b["coordinates"], c["coordinates"]]}
    problem = problem_of(scene_dict | {"obstacles": [a, feature, overlap]})
    assert problem.obstacle_indices.tolist() == [0, 1, 1, 2, 2]
    assert problem.obstacle_paths[2] == "obstacles[1].geometry.geometries[1].coordinates"


def test_robot_of_overlapping_parts(scene_dict: dict[str, Any]) -> None:
    robot = {"type": "MultiPolygon", "coordinates": [[square(0, 0)], [square(0.3, 0)]]}
    assert len(problem_of(scene_dict | {"robot": robot}).robot) == 2


def test_rectangle_workspace_becomes_a_box(scene_dict: dict[str, Any]) -> None:
    problem = problem_of(scene_dict | {"workspace": polygon(square(5, 5, 5))})
    assert problem.workspace_box == (0, 0, 10, 10)
    assert problem.workspace is None
    slanted = polygon([[5, 0], [10, 5], [5, 10], [0, 5]])
    problem = problem_of(scene_dict | {"workspace": slanted})
    assert problem.workspace_box is None
    assert problem.workspace is not None
    assert len(problem.workspace) == 1
    holed = polygon(square(5, 5, 5), square(5, 5, 1))
    assert problem_of(scene_dict | {"workspace": holed}).workspace is not None


def test_reference_bounds_alone_or_with_workspace(scene_dict: dict[str, Any]) -> None:
    scene_dict["reference_bounds"] = [1, 1, 9, 9]
    assert problem_of(scene_dict).reference_bounds == (1, 1, 9, 9)
    del scene_dict["workspace"]
    assert problem_of(scene_dict).workspace_box is None
    del scene_dict["reference_bounds"]
    assert "workspace: a scene needs a workspace, reference_bounds or both" in message(scene_dict)


def test_without_rotation_theta_must_agree(scene_dict: dict[str, Any]) -> None:
    scene_dict["rotation"] = False
    for turns in (0, 1, -3, 1000):
        scene_dict["start"][2] = 0.7
        scene_dict["goal"][2] = 0.7 + turns * 2 * np.pi
        problem = problem_of(scene_dict)
        assert problem.rotation is False
        assert problem.goal == (9, 9, 0.7)
    assert with_query(problem, start=(1, 1, 0.7 - 2 * np.pi)).goal[2] == 0.7 - 2 * np.pi
    with pytest.raises(SceneError, match="rotation is false"):
        with_query(problem, start=(1, 1, 0.8))
    scene_dict["goal"][2] = 0.7 + 1e-9
    assert "goal[2]: theta must equal that of start (0.7), since rotation is false" in message(
        scene_dict
    )


def test_query_overrides(scene_dict: dict[str, Any]) -> None:
    problem = problem_of(scene_dict)
    assert with_query(problem) is problem
    other = with_query(problem, start=(np.int64(2), np.float32(3), 4), goal=np.array([1, 2, 3]))
    assert (other.start, other.goal) == ((2, 3, 4), (1, 2, 3))
    assert problem.start == (1, 1, 0)
    for bad in ((1, 2), [1, 2, float("nan")], "abc", 3, [[1, 2, 3]]):
        with pytest.raises(SceneError, match="start"):
            with_query(problem, start=bad)


def test_loops_over_polygons_stay_cheap(scene_dict: dict[str, Any]) -> None:
    """Not a benchmark: a quadratic step or a slow walk per vertex would take minutes here."""
    ring = [[np.cos(a), np.sin(a)] for a in np.linspace(0, 6, 11)]
    scene_dict["obstacles"] = [polygon((np.array(ring) + k).tolist()) for k in range(20_000)]
    before = time.process_time()
    assert len(problem_of(scene_dict).obstacles) == 20_000
    assert time.process_time() - before < 20


def test_robot_with_too_many_vertices(scene_dict: dict[str, Any]) -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, 70_000, endpoint=False)
    ring = np.column_stack([np.cos(angles), np.sin(angles)]).tolist()
    content = {**scene_dict, "robot": {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}}
    assert "robot: a robot may have at most 65535 vertices (got 70000)" in message(content)
