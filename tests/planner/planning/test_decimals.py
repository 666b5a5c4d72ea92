"""Numbers of files mean decimals: on decimal grids what is drawn touching touches."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planar_planner import (
    CertificateRejected,
    Planner,
    Scene,
    SceneError,
    load_scene,
    solve,
    verify_certificate,
)
from planar_planner.problem.decimals import decimal_places, in_small_units
from planar_planner.problem.make import make_problem

Content = dict[str, Any]
SQUARE = [[0.0, 0.0], [0.15, 0.0], [0.15, 0.15], [0.0, 0.15]]


def rectangle(x: float, y: float, width: float, height: float) -> Content:
    ring = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
    return {"type": "Polygon", "coordinates": [ring]}


def puzzle(seed: int) -> Content:
    """Return a random scene of small integers for a robot that may not turn."""
    draw = random.Random(seed)
    n = draw.randint(4, 7)
    size = [(1, 1), (2, 1), (1, 2)][draw.randrange(3)]
    obstacles = [
        rectangle(draw.randint(0, n), draw.randint(0, n), draw.randint(1, 2), draw.randint(1, 2))
        for _ in range(draw.randint(3, n * n // 4 + 2))
    ]
    start, goal = ([draw.randint(0, n - size[0]), draw.randint(0, n - size[1]), 0] for _ in "ab")
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "robot": rectangle(0, 0, *size),
        "obstacles": obstacles,
        "workspace": {"box": [0, 0, n, n]},
        "start": start,
        "goal": goal,
        "rotation": False,
    }


def scaled(value: Any, places: int, shift: int) -> Any:
    """Return numbers of a scene as decimals of so many places, moved by an integer."""
    if isinstance(value, list):
        return [scaled(each, places, shift) for each in value]
    return float(Fraction(value + shift) / 10**places)


def on_decimal_grid(content: Content, places: int, shift: int) -> Content:
    """Return the scene in a unit 10^places larger, moved off the origin."""
    moved = json.loads(json.dumps(content))
    moved["robot"]["coordinates"] = scaled(content["robot"]["coordinates"], places, 0)
    for obstacle in moved["obstacles"]:
        obstacle["coordinates"] = scaled(obstacle["coordinates"], places, shift)
    moved["workspace"]["box"] = scaled(content["workspace"]["box"], places, shift)
    for end in ("start", "goal"):
        moved[end] = [*scaled(content[end][:2], places, shift), 0]
    return moved


def verdict_of(content: Content) -> str:
    try:
        return solve(content).verdict
    except SceneError as error:
        assert "collides" in str(error) or "outside the workspace" in str(error)
        return "collides"


def test_decimal_grids_give_the_meant_answer() -> None:
    meant: list[str] = []
    for seed in range(300):
        content = puzzle(seed)
        places, shift = 1 + seed % 3, (seed * 37) % 1000
        moved = on_decimal_grid(content, places, shift)
        meant.append(verdict_of(content))
        assert verdict_of(moved) == meant[-1], seed
        if meant[-1] in ("path", "no_path") and seed % 5 == 0:
            result = solve(moved, certificate=True)
            assert result.certificate is not None
            assert verify_certificate(moved, result.certificate).verdict == meant[-1]
    assert min(meant.count(verdict) for verdict in ("path", "no_path", "collides")) >= 10
    assert "undecided" not in meant


def test_waypoints_are_decimals() -> None:
    content = on_decimal_grid(corridor(), 1, 0)
    result = solve(content, certificate=True)
    assert result.decimal_places == 1
    assert result.to_json()["decimal_places"] == 1
    assert result.path[:, :2].tolist() == [[0.0, 0.3], [0.9, 0.3]]
    assert result.path_length == pytest.approx(0.9)
    assert result.certificate is not None
    assert result.certificate["waypoints"] == [[0, 3, 0, 0], [9, 3, 0, 0]]


def corridor() -> Content:
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "robot": rectangle(0, 0, 1, 1),
        "obstacles": [rectangle(2, 0, 6, 3), rectangle(2, 4, 6, 5)],
        "workspace": {"box": [0, 0, 10, 9]},
        "start": [0, 3, 0],
        "goal": [9, 3, 0],
    }


def test_doubles_are_doubles_if_the_scene_says_so() -> None:
    content = {**on_decimal_grid(corridor(), 1, 0), "rotation": False}
    assert solve(content).verdict == "path"
    with pytest.raises(SceneError, match="may be the rounding of decimals to doubles"):
        solve({**content, "numbers": "doubles"})  # 0.9 + 0.1 reaches beyond 1
    with pytest.raises(SceneError, match=r'numbers: must be "decimals" or "doubles" \(got 3\)'):
        solve({**content, "numbers": 3})


def test_files_mean_decimals_and_python_means_doubles(tmp_path: Path) -> None:
    content = {**on_decimal_grid(corridor(), 1, 0), "rotation": False}
    file = tmp_path / "corridor.json"
    file.write_text(json.dumps(content))
    assert solve(file).verdict == "path"
    made = Scene(
        robot=np.array(content["robot"]["coordinates"][0]),
        obstacles=content["obstacles"],
        workspace=content["workspace"]["box"],
        start=content["start"],
        goal=content["goal"],
        rotation=False,
    )
    with pytest.raises(SceneError, match="rounding of decimals"):
        solve(made)
    assert solve(replace(made, numbers="decimals")).verdict == "path"
    assert load_scene(made.to_dict()).numbers == "doubles"
    assert load_scene(load_scene(file).to_dict()).numbers == "decimals"


def test_a_certificate_in_decimals_needs_a_scene_in_decimals() -> None:
    content = on_decimal_grid(corridor(), 1, 0)
    certificate = solve(content, certificate=True).certificate
    assert certificate is not None
    assert verify_certificate(content, certificate).decimal_places == 1
    with pytest.raises(CertificateRejected, match="mean doubles"):
        verify_certificate({**content, "numbers": "doubles"}, certificate)


def test_a_planner_answers_in_the_users_unit() -> None:
    """Cells, wall and path of a query that is answered in decimals, and of the next one."""
    content = on_decimal_grid(corridor(), 1, 0)
    content["robot"] = {"type": "Polygon", "coordinates": [SQUARE]}  # too large for the corridor
    content["goal"] = [0.85, 0.3, 0]
    planner = Planner(load_scene(content))
    assert planner.solve().verdict == "no_path"
    cells, wall = planner.cells(), planner.wall()
    assert wall is not None and len(wall)
    for found in (cells, wall):
        assert (found.lower[:, :2] >= -0.2).all() and (found.upper[:, :2] <= 1.2).all()
    near = planner.solve([0.01, 0.31, 0.0], [0.02, 0.6, 0.0])
    assert near.verdict == "path" and near.decimal_places is None


def test_places() -> None:
    content = corridor()
    assert decimal_places(make_problem(load_scene(content))) is None, "integers are exact"
    content["start"][0] = 0.5
    assert decimal_places(make_problem(load_scene(content))) is None, "so are halves"
    content["start"][0] = 0.125001
    assert decimal_places(make_problem(load_scene(content))) == 6
    content["start"][0] = 0.1 + 0.2
    assert decimal_places(make_problem(load_scene(content))) is None, "17 digits"
    content["start"][0] = 0.1
    content["obstacles"][0] = rectangle(0, 5, 1e12, 1)
    assert decimal_places(make_problem(load_scene(content))) is None, "13 digits"


def test_small_units_are_integers() -> None:
    for seed in range(20):
        content = on_decimal_grid(puzzle(seed), 3, 12_345)
        problem = make_problem(load_scene(content))
        places = decimal_places(problem)
        assert places is not None
        small = in_small_units(problem, places)
        for lengths in (small.robot.coords, small.obstacles.coords, np.array(small.start[:2])):
            assert (lengths == np.rint(lengths)).all()
        back = small.obstacles.coords / 10.0**places
        assert (back == problem.obstacles.coords).all()
