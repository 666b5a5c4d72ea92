"""Goals in scene files: what is legal, what the message says, who refuses regions."""

from __future__ import annotations

import json
import math
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import GoalRegion, Planner, SceneError, load_scene
from planar_planner.checker.verify import verify_certificate
from planar_planner.cli.main import main
from planar_planner.pictures import draw_scene
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem
from support.scene_gate import message, problem_of
from worlds.goal_worlds import cage, rectangle, shape, slot

BEYOND = rectangle(7, 2, 9, 8)


def region_of(goal: Any, **more: Any) -> GoalSet:
    found = problem_of(slot(0.6, goal, **more)).goal
    assert isinstance(found, GoalSet)
    return found


@pytest.mark.parametrize("theta", ["any", [0, 7], [-math.pi, math.pi]])
def test_any_angle(theta: Any) -> None:
    assert region_of({"region": BEYOND, "theta": theta}).angles is None
    assert region_of({"region": BEYOND}).angles is None


def test_an_interval_is_kept_as_written() -> None:
    assert region_of({"region": BEYOND, "theta": [3, 4]}).angles == (3.0, 4.0)
    assert region_of({"region": BEYOND, "theta": [1, 1]}).angles == (1.0, 1.0)


def test_every_kind_of_geometry_is_a_region() -> None:
    two = {"type": "MultiPolygon", "coordinates": [BEYOND["coordinates"]] * 2}
    assert len(region_of({"region": two}).polygons) == 2
    feature = {"type": "Feature", "geometry": BEYOND, "properties": {}}
    assert len(region_of({"region": feature}).polygons) == 1


def test_an_escape_is_the_plane_outside() -> None:
    goal = region_of({"escape": rectangle(1, 1, 4, 9)})
    assert goal.left is not None
    assert goal.left.coords.tolist() == [[1, 1], [4, 1], [4, 9], [1, 9]]
    frame = goal.polygons.coords[:4]
    assert (frame.min(axis=0) < -2).all()
    assert (frame.max(axis=0) > 12).all()
    assert goal.polygons.polygon_starts.tolist() == [0, 2]


def test_a_plain_escape_leaves_the_obstacles_and_the_robots_reach() -> None:
    goal = problem_of(cage(1.5, "escape")).goal
    assert isinstance(goal, GoalSet)
    assert goal.left is not None
    low, high = goal.left.coords.min(axis=0), goal.left.coords.max(axis=0)
    assert (low < -1).all()
    assert (high > 9).all()
    np.testing.assert_allclose([low, high], [[-1, -1], [9, 9]], rtol=1e-15, atol=1e-14)


@pytest.mark.parametrize(("low", "high"), [(1 + 2**-51, 3), (-3, -1 - 2**-51)])
def test_an_escape_whose_box_ends_next_to_zero(low: float, high: float) -> None:
    """The obstacle begins, or ends, where the robot reaches, rounded up by two units."""
    robot = shape([[-0.5, -0.25], [0.5, -0.25], [1, 0], [0.5, 0.25], [-0.5, 0.25]])
    obstacles = [rectangle(low, low, high, high)]
    scene = cage(1.5, "escape") | {"robot": robot, "obstacles": obstacles, "start": [5, 5, 0]}
    result = Planner(scene).solve(certificate=True)
    assert result.certificate is not None
    assert verify_certificate(scene, result.certificate).verdict == "path"


@pytest.mark.parametrize(
    ("goal", "reason"),
    [
        ("flee", 'goal: must be [x, y, theta], {"region": Polygon, "theta": [lo, hi]}'),
        ({}, "goal: must be [x, y, theta]"),
        ({"region": BEYOND, "escape": BEYOND}, "goal: must be [x, y, theta]"),
        ({"region": BEYOND, "angle": 1}, "goal.angle: unknown field"),
        ({"escape": BEYOND, "theta": [1, 2]}, "goal.theta: unknown field"),
        ({"region": [1, 2, 3]}, "goal.region: must be a JSON object"),
        ({"region": {"type": "Point"}}, "goal.region.type: unknown type of geometry"),
        (
            {"region": {"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [1, 0], [0, 1]]]}},
            "goal.region.coordinates: polygon is not valid: self-intersection",
        ),
        ({"region": BEYOND, "theta": 1.5}, 'goal.theta: must be [lo, hi] or "any"'),
        ({"region": BEYOND, "theta": [2, 1]}, "goal.theta: lo must not exceed hi"),
        ({"region": BEYOND, "theta": [1, math.inf]}, "goal.theta[1]: must be a finite number"),
        ({"region": BEYOND, "theta": [1, 2e6]}, "goal.theta[1]: angle must not exceed"),
        (
            {"escape": {"type": "MultiPolygon", "coordinates": [BEYOND["coordinates"]] * 2}},
            "goal.escape: must be one polygon without holes",
        ),
        (None, "goal: must be [x, y, theta]"),
    ],
)
def test_what_is_no_goal(goal: Any, reason: str) -> None:
    text = message(slot(0.6, goal))
    assert reason in text.replace("(got", "")


def test_an_escape_within_bounds_that_end_too_soon() -> None:
    corners = [rectangle(0, 0, 1, 1), rectangle(9, 9, 10, 10)]
    text = message(slot(0.6, "escape", obstacles=corners))
    assert 'goal: "escape" leads out of the box of the obstacles, grown' in text


def test_an_escape_from_nothing() -> None:
    assert "needs obstacles to escape from" in message(slot(0.6, "escape", obstacles=[]))


def test_a_query_takes_any_form_of_goal() -> None:
    planner = Planner(slot(0.6, [8, 5, 0]))
    for goal in ({"region": shapely.box(7, 2, 9, 8), "theta": np.array([1, 2])},):
        assert planner.solve(goal=goal).verdict == "path"
    with pytest.raises(SceneError, match=r"goal\.theta: lo must not exceed hi"):
        planner.solve(goal={"region": BEYOND, "theta": [2, 1]})
    found = planner.problem.goal
    assert found == (8, 5, 0)
    assert planner.solve(goal=GoalRegion(BEYOND)).verdict == "path"
    again = region_of({"region": BEYOND})  # a valid set is taken as it is
    assert planner.solve(goal=again).verdict == "path"


def test_without_rotation_an_interval_counts_up_to_whole_turns() -> None:
    start = [2, 5, 4 * math.pi]
    goal = {"region": BEYOND, "theta": [0.0, 0.0]}
    assert region_of(goal, rotation=False, start=start).angles == (0.0, 0.0)
    far = {"region": BEYOND, "theta": [1e-9, 0.1]}
    assert "must hold theta of start" in message(slot(0.6, far, rotation=False, start=start))


def file_of(tmp_path: Path, goal: Any) -> str:
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(slot(0.6, goal)), encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("goal", [{"region": BEYOND, "theta": [1, 2]}, {"escape": BEYOND}])
@pytest.mark.parametrize(
    ("command", "who"),
    [
        pytest.param(
            ["compare"],
            "a comparison with samplers needs a configuration",
            marks=pytest.mark.skipif(find_spec("ompl") is None, reason="needs OMPL"),
        ),
        (["convert", "{out}.svg"], "only scene files hold those"),
    ],
)
def test_who_needs_a_configuration_says_so(
    goal: Any, command: list[str], who: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [word.format(out=tmp_path / "out") for word in command]
    assert main([words[0], file_of(tmp_path, goal), *words[1:]]) == 2
    error = capsys.readouterr().err
    assert "goal: is a region" in error
    assert who in error
    assert error.count("\n") == 1


def test_a_scene_file_is_converted_and_shown(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = file_of(tmp_path, {"region": BEYOND, "theta": [1, 2]}), tmp_path / "out.json"
    assert main(["convert", path, str(out)]) == 0
    assert load_scene(out).goal["theta"] == [1, 2]
    assert main(["show", path]) == 0
    assert "goal: a region of 1 polygon(s), theta in [1, 2]" in capsys.readouterr().out


@pytest.mark.parametrize("goal", [{"region": BEYOND, "theta": [1, 2]}, {"escape": BEYOND}])
@pytest.mark.parametrize("solved", [True, False])
def test_a_picture_shows_the_region(goal: Any, solved: bool) -> None:
    scene = load_scene(slot(0.6, goal))
    figure = draw_scene(scene, Planner(scene).solve() if solved else None)
    texts = [text.get_text() for text in figure.legends[0].get_texts()]
    assert any(text.startswith("goal: reference point") for text in texts)
    assert ("goal" in texts) == solved


def test_problems_stay_comparable(scene_dict: dict[str, Any]) -> None:
    """A point goal is what it was: three numbers."""
    problem: Problem = problem_of(scene_dict)
    assert isinstance(problem.goal, tuple)
