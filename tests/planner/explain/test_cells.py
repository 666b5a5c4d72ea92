"""The cells of the subdivision as arrays."""

import itertools
import math
from typing import Any

import numpy as np
import pytest
import shapely

import planar_planner
from planar_planner import Cells, Planner, cells_on_path, load_scene, theta_slice
from planar_planner.explain.cells import FREE, FULL, LABELS
from planar_planner.pictures import placed, polygon_paths
from support.stand_in_core import FakeCore


def bodies(planner: Planner, q: np.ndarray) -> tuple[shapely.Geometry, shapely.Geometry]:
    """Robot at q and obstacles, both without holes, as the scenes used here are."""
    robot = placed(polygon_paths(planner.problem.robot), q)
    parts = [shapely.Polygon(np.asarray(path.vertices)[:-1]) for path in robot]
    walls = polygon_paths(planner.problem.obstacles)
    return (
        shapely.union_all(parts),
        shapely.union_all([shapely.Polygon(np.asarray(path.vertices)[:-1]) for path in walls]),
    )


@pytest.fixture(scope="module")
def corner() -> Planner:
    planner = Planner("corner-too-long")
    assert planner.solve().verdict == "no_path"
    return planner


def test_cells_tile_the_space(corner: Planner) -> None:
    cells = corner.cells()
    low, high = cells.lower.min(axis=0), cells.upper.max(axis=0)
    assert low[2] == 0.0
    assert high[2] == math.tau
    volumes = np.prod(cells.upper - cells.lower, axis=1)
    assert volumes.sum() == pytest.approx(np.prod(high - low), rel=1e-12)
    assert np.allclose(volumes, np.prod(high - low) / 2.0 ** cells.level.sum(axis=1))


def test_counts_are_those_of_the_statistics(corner: Planner) -> None:
    by_label = corner.solve().stats["cells_by_label"]
    counts = np.bincount(corner.cells().label, minlength=4)
    assert dict(zip(LABELS, counts.tolist(), strict=True)) == {
        name.upper(): count for name, count in by_label.items()
    }


def test_labels_hold_at_random_configurations(corner: Planner) -> None:
    """FREE and FULL of the cells' boxes in the world's frame, asked of shapely."""
    cells = corner.cells()
    random = np.random.default_rng(0)
    looked_at = 0
    for label in (FREE, FULL):
        chosen = cells[cells.label == label]
        for i in np.repeat(np.arange(len(chosen)), 10):
            q = random.uniform(chosen.lower[i], chosen.upper[i])
            robot, walls = bodies(corner, q)
            xmin, ymin, xmax, ymax = corner.problem.workspace_box or (0.0, 0.0, 0.0, 0.0)
            outside = robot.difference(shapely.box(xmin, ymin, xmax, ymax)).area
            overlap = robot.intersection(walls).area + outside
            assert (overlap > 0.0) == (label == FULL)
            looked_at += 1
    assert looked_at > 200


@pytest.mark.parametrize("theta", [0.0, 1.0, -1e-300, -0.3, 2 * math.pi, 100.0])
def test_a_slice_tiles_the_plane_once(corner: Planner, theta: float) -> None:
    cells = corner.cells()
    flat = theta_slice(cells, theta)
    extent = cells.upper.max(axis=0) - cells.lower.min(axis=0)
    areas = np.prod((flat.upper - flat.lower)[:, :2], axis=1)
    assert areas.sum() == pytest.approx(extent[0] * extent[1], rel=1e-12)
    same = theta_slice(cells, theta + 4 * math.pi)
    if abs(theta) > 1e-6:  # below, adding a turn rounds theta away
        assert np.array_equal(same.lower, flat.lower)


def test_a_slice_needs_a_finite_angle(corner: Planner) -> None:
    with pytest.raises(ValueError, match="finite"):
        theta_slice(corner.cells(), math.inf)


def test_a_robot_that_may_not_turn_has_one_slice() -> None:
    planner = Planner("slide-blocked")
    assert planner.solve().verdict == "no_path"
    cells, theta = planner.cells(), planner.problem.start[2]
    assert len(theta_slice(cells, theta)) == len(cells) > 0
    assert len(theta_slice(cells, theta + 1.0)) == 0
    if theta == 0.0:
        assert len(theta_slice(cells, -2 * math.pi)) == len(cells)


def test_an_easy_answer_has_no_cells_unless_asked_for() -> None:
    easy = Planner("open")
    assert easy.solve().verdict == "path"
    assert len(easy.cells()) == 0
    planner = Planner("open", cells_only=True)
    assert planner.solve().verdict == "path"
    assert len(planner.cells()) > 0
    assert len(Planner("open").cells()) == 0


def test_a_path_runs_through_open_cells() -> None:
    planner = Planner("window", cells_only=True)
    path = planner.solve().path
    cells = planner.cells()
    on_path = cells_on_path(cells, path)
    points = np.concatenate([np.linspace(a, b, 50) for a, b in itertools.pairwise(path)])
    points[:, 2] %= math.tau
    for q in points:
        holds = np.all((cells.lower <= q) & (q <= cells.upper), axis=1)
        assert np.any(holds & on_path)
        assert not np.any(cells.label[holds & ~on_path] == FULL)
    assert on_path.sum() < len(cells)


def test_a_path_across_the_seam_meets_cells_on_both_sides() -> None:
    lower = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, math.pi]])
    upper = np.array([[1.0, 1.0, math.pi], [1.0, 1.0, math.tau]])
    cells = Cells(lower, upper, np.zeros((2, 3), np.uint8), np.zeros(2, np.uint8))
    assert cells_on_path(cells, [[0.5, 0.5, -0.1], [0.5, 0.5, 0.1]]).tolist() == [True, True]
    assert cells_on_path(cells, [[0.5, 0.5, 7.0], [0.5, 0.5, 8.0]]).tolist() == [True, False]
    assert cells_on_path(cells, [[0.5, 0.5, -1.0], [0.5, 0.5, -2.0]]).tolist() == [False, True]
    assert cells_on_path(cells, [[1.5, 0.5, 1.0], [2.5, 0.5, 2.0]]).tolist() == [False, False]


def test_cells_cannot_be_asked_for_during_a_query(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    fake_core.during_solve = staticmethod(lambda listener: listener({}))
    with pytest.raises(RuntimeError, match="one query at a time"):
        planner.solve(listener=lambda _: bool(planner.cells()))


def test_cells_are_read_only(corner: Planner) -> None:
    with pytest.raises(ValueError, match="read-only"):
        corner.cells().label[0] = FREE


def test_scene_of_cells_is_the_scene_given() -> None:
    assert Planner(load_scene("open"), cells_only=True).scene.name == "open"
