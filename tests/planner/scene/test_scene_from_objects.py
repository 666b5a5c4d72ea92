"""Scenes made from the objects of the field: shapely, arrays, GeoJSON, without format words."""

from __future__ import annotations

import copy
import dataclasses
import json
import pickle
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import Escape, GoalRegion, Planner, Scene, SceneError, load_scene
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import make_problem

ROBOT = shapely.box(-1, -0.25, 1, 0.25)
VERTICES = [(-1, -0.25), (1, -0.25), (1, 0.25), (-1, 0.25)]
WALLS = [shapely.box(4, 0, 5, 4), shapely.box(4, 6, 5, 10)]
ROOM = {"start": (2, 2, 0), "goal": (8, 2, 0), "workspace": (0, 0, 10, 10)}


def scene(**changed: Any) -> Scene:
    return Scene(**({"robot": ROBOT, "obstacles": WALLS, **ROOM} | changed))


def same(first: Scene, second: Scene) -> bool:
    """Whether two scenes pose the same problem, whatever the order and repetition of vertices."""

    def shapes(made: Scene) -> list[Any]:
        problem = make_problem(made)
        polygons = (problem.robot, problem.obstacles)
        return [
            [sorted(map(tuple, p.coords.tolist())), p.ring_starts.tolist()] for p in polygons
        ] + [problem.workspace_box, problem.reference_bounds, problem.start, problem.goal]

    return shapes(first) == shapes(second)


@pytest.mark.parametrize(
    "robot",
    [
        VERTICES,
        tuple(VERTICES),
        np.array(VERTICES),
        np.array(VERTICES, dtype=np.float32),
        [np.array(point) for point in VERTICES],
        ROBOT.exterior,
        shapely.geometry.mapping(ROBOT),
        {"type": "Polygon", "coordinates": np.array([VERTICES])},
        [ROBOT],
    ],
    ids=lambda robot: type(robot).__name__,
)
def test_a_robot_in_every_form(robot: Any) -> None:
    if isinstance(robot, shapely.LinearRing):
        robot = robot.coords
    assert same(scene(robot=robot), scene())


def test_a_robot_of_parts_and_with_holes() -> None:
    parts = [shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3, 1)]
    several = scene(robot=parts)
    assert len(make_problem(several).robot) == 2
    assert same(several, scene(robot=shapely.MultiPolygon(parts)))
    frame = shapely.Polygon(shapely.box(-2, -2, 2, 2).exterior, [VERTICES])
    assert len(make_problem(scene(robot=frame)).robot.ring_starts) == 3


@pytest.mark.parametrize(
    "obstacles",
    [
        WALLS,
        tuple(WALLS),
        np.array(WALLS),
        shapely.MultiPolygon(WALLS),
        shapely.GeometryCollection(WALLS),
        [np.asarray(wall.exterior.coords) for wall in WALLS],
        np.array([wall.exterior.coords for wall in WALLS]),
        {
            "type": "FeatureCollection",
            "features": [{"type": "Feature", "geometry": wall, "properties": {}} for wall in WALLS],
        },
    ],
    ids=lambda obstacles: type(obstacles).__name__,
)
def test_obstacles_in_every_form_count_one_by_one(obstacles: Any) -> None:
    made = scene(obstacles=obstacles)
    assert len(made.obstacles) == 2
    assert same(made, scene())


def test_one_obstacle_or_none() -> None:
    for single in (WALLS[0], np.array(WALLS[0].exterior.coords), [WALLS[0]]):
        assert len(make_problem(scene(obstacles=single)).obstacles) == 1
    for none in ([], (), shapely.MultiPolygon(), shapely.GeometryCollection()):
        assert len(make_problem(scene(obstacles=none)).obstacles) == 0
    assert len(make_problem(Scene(robot=ROBOT, **ROOM)).obstacles) == 0


def test_workspace_and_bounds() -> None:
    assert make_problem(scene()).workspace_box == (0, 0, 10, 10)
    for box in (np.array([0, 0, 10, 10]), {"box": [0, 0, 10, 10]}, shapely.box(0, 0, 10, 10)):
        assert same(scene(workspace=box), scene())
    room = make_problem(scene(workspace=[(0, 0), (10, 0), (9, 10), (0, 10)]))
    assert room.workspace is not None
    bounded = make_problem(scene(workspace=None, bounds=(0, 0, 10, 10)))
    assert (bounded.workspace_box, bounded.reference_bounds) == (None, (0, 0, 10, 10))


def test_goals_as_regions() -> None:
    area = shapely.box(7, 1, 9, 3)
    region = make_problem(scene(goal=GoalRegion(area, theta=(0.0, 1.0)))).goal
    assert isinstance(region, GoalSet)
    assert region.angles == (0.0, 1.0)
    any_theta = make_problem(scene(goal=GoalRegion(np.array(area.exterior.coords)))).goal
    assert isinstance(any_theta, GoalSet)
    assert any_theta.angles is None
    assert np.array_equal(any_theta.polygons.coords, region.polygons.coords)
    left = make_problem(scene(goal=Escape(shapely.box(0, 0, 5, 10)))).goal
    assert isinstance(left, GoalSet)
    assert left.left is not None
    written = {"region": area, "theta": [0.0, 1.0]}
    assert scene(goal=written) == scene(goal=GoalRegion(area, theta=np.array([0.0, 1.0])))
    wide = scene(goal="escape", bounds=(-50, -50, 50, 50), workspace=None)
    assert isinstance(make_problem(wide).goal, GoalSet)


def test_a_query_takes_the_same_goals() -> None:
    planner = Planner(scene())
    reached = planner.solve(goal=GoalRegion(shapely.box(7, 7, 9, 9), theta=(1.0, 1.5)))
    assert reached.verdict == "path"
    x, y, theta = reached.path[-1]
    assert 7 <= x <= 9
    assert 7 <= y <= 9
    assert 1.0 <= theta % (2 * np.pi) <= 1.5
    assert planner.solve(goal=Escape(shapely.box(1, 1, 3, 3))).verdict == "path"
    assert planner.solve(start=np.array([2.0, 2.0, 0.0]), goal=[8, 8, 0]).verdict == "path"


def test_it_is_the_scene_of_the_file() -> None:
    made = scene(name="walls", description="two walls")
    content = json.loads(json.dumps(made.to_dict()))
    assert content["format"] == "planar-planner/scene"
    read = load_scene(content)
    assert read == made
    assert hash(read) == hash(made)
    assert load_scene(made) is made
    assert read != scene(name="walls", description="two walls", start=(2, 2, 0.5))
    assert fingerprint(make_problem(made)) == fingerprint(make_problem(read))


def test_nothing_is_shared_with_what_was_given() -> None:
    vertices = np.array(VERTICES)
    content: dict[str, Any] = {"type": "Polygon", "coordinates": [[[4, 0], [5, 0], [5, 4]]]}
    made = scene(robot=vertices, obstacles=[content])
    vertices[0, 0] = content["coordinates"][0][0][0] = -9
    assert made == scene(
        robot=VERTICES, obstacles=[{"type": "Polygon", "coordinates": [[[4, 0], [5, 0], [5, 4]]]}]
    )


def test_scenes_are_copied_changed_and_pickled() -> None:
    made = scene(name="walls")
    assert pickle.loads(pickle.dumps(made)) == made
    assert copy.deepcopy(made) == made
    turned = dataclasses.replace(made, rotation=False)
    assert turned.rotation is False
    assert turned.robot == made.robot
    with pytest.raises(dataclasses.FrozenInstanceError):
        made.rotation = False  # type: ignore[misc]


def test_repr_is_one_short_line() -> None:
    assert repr(scene(name="walls")) == (
        "Scene(name='walls', 2 obstacles, start=[2, 2, 0], goal=[8, 2, 0])"
    )
    hostile = repr(scene(name="<b>\n" * 1000, obstacles=WALLS * 500))
    assert "\n" not in hostile
    assert len(hostile) < 200


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"robot": None}, "scene: robot: must be a polygon (shapely or GeoJSON) or an array of"),
        ({"robot": 3}, "robot: must be a polygon (shapely or GeoJSON) or an array of vertices"),
        ({"robot": []}, "robot: must be a polygon"),
        ({"robot": "gear"}, "robot: must be a polygon (shapely or GeoJSON) or an array of"),
        ({"robot": object}, "robot: a type has no JSON form"),
        ({"robot": [ROBOT, 7]}, "robot[1]: must be a polygon (shapely or GeoJSON) or an array"),
        ({"robot": shapely.Point(0, 0)}, "robot.type: unknown type of geometry"),
        ({"robot": shapely.Polygon()}, "robot.coordinates: must not be empty"),
        ({"robot": np.zeros((4, 3))}, "robot.coordinates[0][0]: a position must be [x, y]"),
        ({"robot": [(0, 0), (1, 0), (1, "1")]}, "robot.coordinates[0][2][1]: must be a number"),
        ({"robot": [(0, 0), (1, 0), (1, np.nan)]}, "[0][2][1]: must be a finite number (got nan)"),
        ({"obstacles": 3}, "obstacles: must be a sequence, each a polygon"),
        ({"obstacles": [WALLS[0], None]}, "obstacles[1]: must be a polygon"),
        ({"obstacles": [WALLS[0], {1}]}, "obstacles[1]: a set has no JSON form (got {1})"),
        ({"obstacles": [WALLS[0], [(0, 0), (1, 1), (1, 0), (0, 1)]]}, "obstacles[1].coordinates"),
        ({"workspace": (0, 0, 10)}, "workspace: must be (xmin, ymin, xmax, ymax), a polygon"),
        ({"workspace": (0, 0, -1, 10)}, "workspace.box: xmin must be less than xmax"),
        ({"workspace": (0, 0, "1", 10)}, "workspace.box[2]: must be a number (got '1')"),
        ({"workspace": None}, "a scene needs a workspace, reference_bounds or both"),
        ({"bounds": (0, 0, 1)}, "reference_bounds: must be [xmin, ymin, xmax, ymax]"),
        ({"start": (1, 2)}, "start: must be [x, y, theta] (got [1, 2])"),
        ({"start": None}, "start: must be [x, y, theta] (got None)"),
        ({"start": shapely.Point(1, 2)}, "start: must be [x, y, theta]"),
        ({"goal": (1, 2, "0")}, "goal[2]: must be a number of radians, or text"),
        ({"goal": {"region": 3}}, "goal.region: must be a polygon"),
        ({"goal": {"escape": shapely.MultiPolygon(WALLS)}}, "goal.escape: must be one polygon"),
        ({"rotation": 1}, "rotation: must be true or false (got 1)"),
        ({"name": 3}, "name: must be a string (got 3)"),
        ({"name": "walls", "start": ()}, "walls: start: must be [x, y, theta] (got [])"),
    ],
    ids=lambda value: str(value)[:30] if isinstance(value, str) else "",
)
def test_wrong_values_are_named_with_their_place(changed: Any, message: str) -> None:
    with pytest.raises(SceneError) as caught:
        make_problem(scene(**changed))
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_wrong_regions_are_errors_where_they_are_made() -> None:
    with pytest.raises(SceneError, match=r"goal.region: must be a polygon"):
        GoalRegion(3)  # type: ignore[arg-type]
    with pytest.raises(SceneError, match=r"goal.escape: must be a polygon"):
        Escape(None)  # type: ignore[arg-type]
