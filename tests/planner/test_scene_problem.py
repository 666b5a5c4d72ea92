"""The gate: what it normalises, and what it rejects with field, index and value."""

from __future__ import annotations

import copy
import time
from typing import Any

import numpy as np
import pytest
from conftest import square
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from planar_planner.problem import Problem, make_problem, with_query
from planar_planner.scene import load_scene
from planar_planner.validity import Judge, judged_by_geos, judged_exactly


def problem_of(content: dict[str, Any]) -> Problem:
    return make_problem(load_scene(content))


def message(content: dict[str, Any]) -> str:
    with pytest.raises(SceneError) as caught:
        problem_of(content)
    text = str(caught.value)
    assert text.startswith("<dict>: ")
    assert "\n" not in text
    assert len(text) < 400
    return text


def polygon(*rings: Any) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": list(rings)}


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


BAD_VALUES: list[tuple[tuple[Any, ...], Any, str]] = [
    (("workspace",), 3, "workspace: must be a JSON object (got 3)"),
    (("workspace",), {}, "workspace: must be {"),
    (("workspace", "box"), [0, 0, 1], "workspace.box: must be [xmin, ymin, xmax, ymax]"),
    (("workspace", "box"), [5, 0, 1, 9], "workspace.box: xmin must be less than xmax"),
    (("workspace", "box"), [5, 0, 5, 9], "workspace.box: xmin must be less than xmax"),
    (("workspace", "box"), [0, 9, 1, 8], "workspace.box: ymin must be less than ymax"),
    (("workspace", "box"), [0, 9, 1, 9], "workspace.box: ymin must be less than ymax"),
    (("workspace", "box", 2), "1", "workspace.box[2]: must be a number (got '1')"),
    (("workspace",), {"box": [0, 0, 1, 1], "boxx": 1}, "workspace.boxx: unknown field"),
    (("workspace",), {"bx": [0, 0, 1, 1]}, "workspace.bx: unknown field; did you mean 'box'?"),
    (
        ("workspace",),
        {"type": "MultiPolygon", "coordinates": [[square(0, 0)], [square(5, 5)]]},
        "workspace: must be one polygon (got 2 polygons)",
    ),
    (("reference_bounds",), [0, 0, -1, 1], "reference_bounds: xmin must be less than xmax"),
    (("reference_bounds",), [0, 0, float("nan"), 1], "reference_bounds[2]: must be a finite"),
    (("start",), [1, 2], "start: must be [x, y, theta] (got [1, 2])"),
    (("start", 2), None, "start[2]: must be a number (got None)"),
    (("start", 0), True, "start[0]: must be a number (got True)"),
    (("goal", 2), float("inf"), "goal[2]: must be a finite number (got inf)"),
    (("goal", 2), 1e7, "goal[2]: angle must not exceed 1e+06 rad"),
    (("goal", 1), 1e308, "goal[1]: magnitude must not exceed 1e+12 (got 1e+308)"),
    (("goal", 1), 10**400, "goal[1]: is too large for a double (got 1000"),
    (("goal", 1), 5e-324, "goal[1]: must be 0 or at least 1e-50 in magnitude"),
    (("rotation",), 0, "rotation: must be true or false (got 0)"),
    (("robot",), None, "robot: must be a JSON object (got None)"),
    (("robot",), {"type": "MultiPolygon", "coordinates": []}, "robot.coordinates: must not be e"),
    (("robot",), {"type": "Polygon", "coordinates": []}, "robot.coordinates: must not be empty"),
    (("robot",), {"type": "Polygon"}, "robot.coordinates: must be a list (got None)"),
    (("robot",), {"type": "Poligon", "coordinates": []}, "did you mean 'Polygon'"),
    (("robot",), {"type": "Point", "coordinates": [0, 0]}, "robot.type: unknown type of geometry"),
    (("robot",), {"type": ["Polygon"]}, "robot.type: unknown type of geometry"),
    (("robot", "color"), "red", "robot.color: unknown field"),
    (("obstacles",), {}, "obstacles: must be a list of geometries (got {})"),
    (("obstacles", 0), [], "obstacles[0]: must be a JSON object"),
    (("obstacles", 0, "coordinates"), "no", "obstacles[0].coordinates: must be a list"),
    (("obstacles", 0, "coordinates", 0), 7, "obstacles[0].coordinates[0]: a ring must be"),
    (("obstacles", 0, "coordinates", 0, 2), 7, "coordinates[0][2]: a position must be [x, y]"),
    (("obstacles", 0, "coordinates", 0, 2), [1, 2, 3], "coordinates[0][2]: a position must be"),
    (("obstacles", 0, "coordinates", 0, 2), {"x": 1}, "coordinates[0][2]: a position must be"),
    (("obstacles", 0, "coordinates", 0, 2, 1), "6", "[0][2][1]: must be a number (got '6')"),
    (("obstacles", 0, "coordinates", 0, 2, 1), False, "[0][2][1]: must be a number (got False)"),
    (("obstacles", 0, "coordinates", 0, 2, 0), float("nan"), "[0][2][0]: must be a finite number"),
    (("obstacles", 0, "coordinates", 0, 3, 0), -float("inf"), "[0][3][0]: must be a finite"),
    (("obstacles", 0, "coordinates", 0, 3, 0), -1e308, "[0][3][0]: magnitude must not exceed"),
    (("obstacles", 0, "coordinates", 0, 3, 0), 10**400, "[0][3][0]: is too large for a double"),
    (("obstacles", 0, "coordinates", 0, 3, 0), 1e-320, "[0][3][0]: must be 0 or at least 1e-50"),
    (("obstacles", 0, "coordinates", 0), [], "[0]: ring must have at least three distinct points"),
    (("obstacles", 0, "coordinates", 0), [[1, 1]], "not 1 distinct point"),
    (("obstacles", 0, "coordinates", 0), [[1, 1], [1, 1], [1, 1], [1, 1]], "not 1 distinct point"),
    (("obstacles", 0, "coordinates", 0), [[1, 1], [2, 1], [1, 1]], "not 2 distinct points"),
    (("obstacles", 0, "coordinates", 0), [[0, 0], [1, 1]] * 4, "not 2 distinct points"),
    (("obstacles", 0, "coordinates", 0), [[0, 0], [1, 1], [3, 3]], "[0]: ring has zero area"),
    (
        ("obstacles", 0, "coordinates", 0),
        [[0, 0], [2, 2], [2, 0], [0, 2]],
        "obstacles[0].coordinates: polygon is not valid: self-intersection at (1, 1)",
    ),
    (
        ("obstacles", 0, "coordinates", 0),
        [[0, 0], [2, 0], [2, 2], [1, 0], [0, 2]],
        "ring self-intersection at (1, 0)",
    ),
    (
        ("obstacles", 0, "coordinates", 0),
        [[0, 0], [2, 0], [2, 2], [2, 0], [0, 0]],
        "obstacles[0].coordinates",
    ),
    (("obstacles", 0, "coordinates"), [square(5, 5), square(9, 9, 0.1)], "hole lies outside"),
    (
        ("obstacles", 0, "coordinates"),
        [square(5, 5, 2), square(5, 5), square(5, 5, 0.1)],
        "nested",
    ),
    (
        ("obstacles", 0),
        {"type": "GeometryCollection", "geometries": [{"type": "GeometryCollection"}]},
        "obstacles[0].geometries[0].type",
    ),
    (("obstacles", 0), {"type": "Feature", "geometry": None}, "obstacles[0].geometry: must be a"),
    (
        ("obstacles", 0),
        {"type": "Feature", "geometry": {"type": "Feature"}},
        "obstacles[0].geometry.type",
    ),
]


@pytest.mark.parametrize(("place", "value", "expected"), BAD_VALUES)
def test_bad_value(
    scene_dict: dict[str, Any], place: tuple[Any, ...], value: Any, expected: str
) -> None:
    problem_of(scene_dict)  # the only fault is the one put in next
    target: Any = scene_dict
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    assert expected in message(scene_dict)


def test_index_of_the_bad_polygon(scene_dict: dict[str, Any]) -> None:
    scene_dict["obstacles"] *= 5
    scene_dict["obstacles"].append(
        {"type": "MultiPolygon", "coordinates": [[square(1, 1)], [square(3, 3, 1), [[3, 3]]]]}
    )
    assert "obstacles[5].coordinates[1][1]: ring must have" in message(scene_dict)
    scene_dict["obstacles"][5]["coordinates"][1][1] = [[3, 3], [3, 3.5], [3.5, "a"]]
    assert "obstacles[5].coordinates[1][1][2][1]: must be a number (got 'a')" in message(scene_dict)


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


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(["type", "coordinates", "geometry", "geometries", "box", "x"]), inner
        )
    ),
    max_leaves=10,
)
PLACES = [
    ("workspace",),
    ("workspace", "box"),
    ("robot",),
    ("robot", "type"),
    ("robot", "coordinates"),
    ("robot", "coordinates", 0),
    ("robot", "coordinates", 0, 1),
    ("robot", "coordinates", 0, 1, 0),
    ("obstacles",),
    ("obstacles", 0),
    ("obstacles", 0, "coordinates", 0),
    ("start",),
    ("goal", 2),
    ("rotation",),
    ("name",),
    ("version",),
]
VALID = {
    "format": "planar-planner/scene",
    "version": 1,
    "name": "fuzz",
    "workspace": {"box": [0, 0, 10, 10]},
    "robot": polygon(square(0, 0)),
    "obstacles": [polygon(square(5, 5))],
    "start": [1, 1, 0],
    "goal": [9, 9, 0],
    "rotation": True,
}


@settings(max_examples=400, deadline=None)
@given(place=st.sampled_from(PLACES), value=JSON_VALUES)
def test_any_value_anywhere_is_accepted_or_a_scene_error(place: Any, value: Any) -> None:
    content: Any = copy.deepcopy(VALID)
    target = content
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    try:
        problem = problem_of(content)
    except SceneError as error:
        assert error.source == "<dict>"
        assert "\n" not in str(error)
    else:
        assert np.isfinite(problem.robot.coords).all()
        assert np.diff(problem.robot.ring_starts).min() >= 3


@pytest.mark.parametrize("judge", [judged_exactly, judged_by_geos])
@settings(max_examples=300, deadline=None)
@given(
    ring=st.lists(
        st.lists(
            st.integers(-4, 4) | st.sampled_from([1e12, 1e-50, 0.1, 0.3]), min_size=2, max_size=2
        ),
        max_size=7,
    )
)
def test_rings_agree_with_shapely_one_by_one(judge: Judge, ring: list[list[float]]) -> None:
    """The vectorised gate accepts exactly the rings that shapely alone finds simple."""
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


def test_robot_with_too_many_vertices(scene_dict: dict[str, Any]) -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, 70_000, endpoint=False)
    ring = np.column_stack([np.cos(angles), np.sin(angles)]).tolist()
    content = {**scene_dict, "robot": {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}}
    assert "robot: a robot may have at most 65535 vertices (got 70000)" in message(content)
