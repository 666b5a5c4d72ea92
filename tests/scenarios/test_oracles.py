"""The oracles themselves: on cases whose answer is known by hand."""

import math
from typing import Any, Literal

import numpy as np
import pytest
import shapely

from oracles.dense_path import check_path, interpolate
from oracles.grid import (
    convex_pieces,
    flood,
    free_cells,
    make_grid,
    translational_obstacle,
    triangles,
)
from oracles.scene_shapes import shapes
from scenarios.model import box, polygon, scene


def wall_scene(**changes: Any) -> dict[str, Any]:
    """Unit square left of a wall x in [2, 3] in a box."""
    made = scene(
        "wall",
        "A wall.",
        workspace=(-5.0, -5.0, 5.0, 5.0),
        robot=box(-0.5, -0.5, 0.5, 0.5),
        obstacles=[box(2.0, -1.0, 3.0, 1.0)],
        start=(0.0, 0.0, 0.0),
        goal=(4.0, 0.0, 0.0),
    )
    return {**made, **changes}


def test_dense_check_accepts_contact() -> None:
    found = check_path(wall_scene(), [(0.0, 0.0, 0.0), (1.5, 0.0, 0.0), (1.5, 4.5, 0.0)])
    assert found.within_rounding


def test_dense_check_measures_penetration() -> None:
    found = check_path(wall_scene(), [(0.0, 0.0, 0.0), (1.75, 0.0, 0.0), (0.0, 0.0, 0.0)])
    assert found.depth == pytest.approx(0.25, abs=1e-12)
    assert found.area == pytest.approx(0.25, abs=1e-12)
    assert found.where[0] == pytest.approx(1.75)


def test_dense_check_sees_a_turn_between_free_ends() -> None:
    """Free at 0 and 90 degrees, 0.5 sqrt(2) - 0.6 deep at 45."""
    path = [(1.4, 0.0, 0.0), (1.4, 0.0, 0.5 * math.pi)]
    found = check_path(wall_scene(), path)
    assert found.depth == pytest.approx(0.5 * math.sqrt(2.0) - 0.6, abs=1e-3)
    assert not found.within_rounding


def test_dense_check_sees_leaving_the_boxes() -> None:
    out_of_box = check_path(wall_scene(), [(0.0, 0.0, 0.0), (-4.7, 0.0, 0.0)])
    assert out_of_box.outside == pytest.approx(0.2)
    bounded = wall_scene(reference_bounds=[-1.0, -1.0, 5.0, 1.0])
    out_of_bounds = check_path(bounded, [(0.0, 0.0, 0.0), (-1.25, 0.0, 0.0)])
    assert out_of_bounds.outside == pytest.approx(0.25)


def test_interpolation_keeps_waypoints_and_step() -> None:
    path = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 2.0), (1.0, 0.3, 2.0)])
    samples = interpolate(path, 1.5, 0.01)
    for waypoint in path:
        assert (np.abs(samples - waypoint).max(axis=1) == 0.0).any()
    move = np.diff(samples, axis=0)
    step = np.hypot(move[:, 0], move[:, 1]) + 1.5 * np.abs(move[:, 2])
    assert step.max() <= 0.01 * (1.0 + 1e-12)


@pytest.mark.parametrize(
    ("shape", "count"),
    [
        (shapely.box(0.0, 0.0, 3.0, 1.0), 1),
        (shapely.box(0.0, 0.0, 3.0, 1.0).buffer(0.2, quad_segs=3), 1),
        (shapely.Polygon([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]), 2),
        (shapely.box(0, 0, 3, 3).difference(shapely.box(1, 1, 2, 2)), 4),
        (shapely.Polygon([(0, 0), (2, 0), (2, 1), (1, 1 - 1e-9), (0, 1)]), 2),  # a shallow dent
    ],
)
def test_convex_pieces_cover_just_the_shape(shape: shapely.Polygon, count: int) -> None:
    pieces = convex_pieces(shape)
    assert count <= len(pieces) <= count + 2
    assert len(pieces) == 1 or count > 1
    for piece in pieces:
        assert piece.equals(piece.convex_hull)
    assert shapely.union_all(pieces).symmetric_difference(shape).area <= 1e-12


def test_translational_obstacle_of_two_squares() -> None:
    unit, wall = shapely.box(-0.5, -0.5, 0.5, 0.5), shapely.box(2.0, -1.0, 3.0, 1.0)
    upright = translational_obstacle(triangles(unit), triangles(wall), 0.0)
    assert upright.equals(shapely.box(1.5, -1.5, 3.5, 1.5))
    turned = translational_obstacle(triangles(unit), triangles(wall), 0.25 * math.pi)
    r = math.sqrt(0.5)
    assert turned.bounds == pytest.approx((2.0 - r, -1.0 - r, 3.0 + r, 1.0 + r))
    assert turned.area == pytest.approx(2.0 + 1.0 + 2.0 * r * (1.0 + 2.0))  # mixed areas


@pytest.mark.parametrize("side", ["subset", "superset"])
def test_grid_labels_hold_in_the_whole_cell(side: Literal["subset", "superset"]) -> None:
    """Random configurations against shapely: subset cells free, cells outside the superset not."""
    ring = [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.0), (0.0, 0.0), (0.0, 0.9), (-0.9, 0.9)]
    content = wall_scene(robot=polygon(ring))
    made = shapes(content)
    grid = make_grid(made, 0.2)
    free = free_cells(made, grid, side=side)
    rng = np.random.default_rng(5)
    low, high = made.reference_domain[:2], made.reference_domain[2:]
    decided = 0
    for _ in range(3000):
        q = [*rng.uniform(low, high), rng.uniform(0.0, 2.0 * math.pi)]
        found = check_path(content, [q, q])
        legal = found.area == 0.0 and found.outside == 0.0
        label = bool(free[grid.index(q)])
        if side == "subset" and label:
            assert legal, q
            decided += 1
        if side == "superset" and not label:
            assert not legal, q
            decided += 1
    assert decided > 500


def test_flood_wraps_in_theta_only() -> None:
    free = np.zeros((4, 3, 3), dtype=bool)
    free[0, 0, 0] = free[3, 0, 0] = free[3, 0, 2] = free[2, 1, 1] = True
    straight = flood(free, (0, 0, 0), diagonal=False)
    assert straight[3, 0, 0]
    assert straight.sum() == 2
    diagonal = flood(free, (0, 0, 0), diagonal=True)
    assert diagonal.sum() == 4
