"""The gate judges rings and polygons exactly: against GEOS where that does not round."""

from __future__ import annotations

import copy
import time
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from planar_planner.load import load_scene
from planar_planner.problem.make import make_problem
from planar_planner.problem.rings import Judge, judged_by_geos, judged_exactly
from support.scene_gate import VALID, message, polygon, problem_of
from worlds.small import square


@pytest.mark.parametrize("scale", [1e-40, 1e-9, 1.0, 1e11])
def test_thin_is_not_flat_and_flat_is_not_thin(scene_dict: dict[str, Any], scale: float) -> None:
    """Three points off a line by one unit in the last place are a legal triangle; on it, none."""
    thin = [[0.0, 0.0], [scale, scale], [2 * scale, float(np.nextafter(2 * scale, np.inf))]]
    assert len(problem_of(scene_dict | {"obstacles": [polygon(thin)]}).obstacles) == 1
    flat = [[0.1 * scale * k, 0.1 * scale * k] for k in (1, 3, 7, 5)]
    assert "zero area" in message(scene_dict | {"obstacles": [polygon(flat)]})


def test_flat_rings_whose_computed_area_is_not_zero(scene_dict: dict[str, Any]) -> None:
    """On y = 3x exactly, with differences that round: only exact arithmetic can tell."""
    random = np.random.default_rng(5)
    rounded = 0
    for _ in range(50):
        x = random.integers(1, 2**50, 5) * 2.0 ** random.integers(-80, -20, 5)
        ring = np.stack([x, 3 * x], axis=1)
        d = ring - ring[0]
        rounded += bool(np.any(d[1:-1, 0] * d[2:, 1] != d[1:-1, 1] * d[2:, 0]))
        assert "zero area" in message(scene_dict | {"obstacles": [polygon(ring.tolist())]})
    assert rounded > 25


@pytest.mark.parametrize("judge", [judged_exactly, judged_by_geos])
@settings(max_examples=300, deadline=None)
@given(
    ring=st.lists(
        st.lists(
            st.integers(-4, 4) | st.sampled_from([1e12, 1e-5, 0.1, 0.3]), min_size=2, max_size=2
        ),
        max_size=7,
    )
)
def test_rings_agree_with_shapely_one_by_one(judge: Judge, ring: list[list[float]]) -> None:
    """The vectorised gate accepts exactly the rings that shapely alone finds simple.

    As far as shapely can tell: its orientations have some 106 bits (see the triangle below).
    """
    import shapely

    distinct = [list(p) for p in dict.fromkeys(map(tuple, ring))]
    no_repeats = [p for i, p in enumerate(ring) if p != ring[i - 1]] if len(distinct) > 1 else []
    valid = len(distinct) >= 3 and bool(shapely.Polygon(no_repeats).is_valid)
    content = copy.deepcopy(VALID) | {"obstacles": [polygon(ring)]}
    try:
        make_problem(load_scene(content), judge)
    except SceneError:
        assert not valid
    else:
        assert valid


def test_a_triangle_too_thin_for_shapely() -> None:
    ring = [[0, 1e-50], [1e12, 1e12], [0.1, 0.1]]
    exact = [[Fraction(x), Fraction(y)] for x, y in ring]
    (ax, ay), (bx, by), (cx, cy) = exact
    assert (bx - ax) * (cy - ay) != (by - ay) * (cx - ax)
    make_problem(load_scene(copy.deepcopy(VALID) | {"obstacles": [polygon(ring)]}))


GRID_RING = st.lists(st.lists(st.integers(0, 4), min_size=2, max_size=2), min_size=3, max_size=5)


@settings(max_examples=400, deadline=None)
@given(st.lists(GRID_RING, min_size=1, max_size=3))
def test_both_judges_agree_where_nothing_is_rounded(holes: list[list[list[float]]]) -> None:
    shell = [[0, 0], [4, 0], [4, 4], [0, 4]]
    content = copy.deepcopy(VALID) | {"obstacles": [polygon(shell, *holes)]}
    messages = []
    for judge in (judged_exactly, judged_by_geos):
        try:
            make_problem(load_scene(content), judge)
        except SceneError as error:
            messages.append(error.field)
        else:
            messages.append("valid")
    assert messages[0] == messages[1]


ALMOST = {  # valid in the doubled doubles of GEOS
    "self-intersection": (
        [
            [-0.5, 0.5000000000000001],
            [3.0, 4.0],
            [-3.0, -1.0],
            [-4.0, -3.0],
        ],
        [
            [-3.9999999999999996, -2.9999999999999996],
            [0.39426472231394527, 1.3942647223139455],
            [-0.554995261881771, 0.44500473811822927],
        ],
    ),
    "hole lies outside shell": (
        [
            [-1.0, -100000.0],
            [-0.3141794525867426, -685820578831.2025],
            [-0.9999999999999997, -100000.00000000001],
            [1.0, 1.0],
            [-1e-20, -1e-50],
            [-8388608.0, 1e-20],
            [-8388607.999999999, 0.0],
            [-1e-20, -1000000000000.0],
        ],
        [[-1e-20, -1e-50], [1e-50, 1e-20], [-0.1, 0.1]],
    ),
}


@pytest.mark.parametrize("what", ALMOST)
def test_shapes_are_judged_exactly(scene_dict: dict[str, Any], what: str) -> None:
    scene_dict["obstacles"] = [polygon(*ALMOST[what])]
    assert f"obstacles[0].coordinates: polygon is not valid: {what} at (" in message(scene_dict)
    make_problem(load_scene(scene_dict), judged_by_geos)


def test_polygons_that_take_geos_for_ever(scene_dict: dict[str, Any]) -> None:
    """Not a benchmark: all pairs of these edges have overlapping boxes, 10^10 of them."""
    count = 100_000
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    radii = np.where(np.arange(count) % 2 == 0, 1.0, 2.0)
    star = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + 5.0
    nested = [square(5, 5, 1.0 + 1e-6 * k) for k in range(5_000)]
    before = time.process_time()
    scene_dict["obstacles"] = [polygon(star.tolist())]
    assert len(problem_of(scene_dict).obstacles.coords) == count
    scene_dict["obstacles"] = [polygon(square(5, 5, 3), *nested)]
    assert "holes are nested" in message(scene_dict)
    assert time.process_time() - before < 30
