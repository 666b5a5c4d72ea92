"""The real planner on every shipped scene: expected verdict, and every path densely re-checked."""

import json
from typing import Any

import numpy as np
import pytest
import shapely
from shapely import affinity

from oracles.decisive import FOLDER, listed
from oracles.dense_path import check_path
from planar_planner import load_scene, solve


@pytest.mark.parametrize("name", sorted(listed()))
def test_planner_gives_the_expected_verdict(name: str) -> None:
    content = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    result = solve(load_scene(content))
    assert result.verdict == listed()[name]["expected"], result.reason
    if result.verdict != "path":
        assert len(result.path) == 0
        return
    assert np.array_equal(result.path[0], content["start"])
    check_arrival(content, result.path[-1].tolist())
    found = check_path(content, result.path)
    assert found.within_rounding, found
    if not content.get("rotation", True):
        assert np.ptp(result.path[:, 2]) == 0.0


def check_arrival(content: dict[str, Any], end: list[float]) -> None:
    goal = content["goal"]
    if isinstance(goal, list):
        assert end[:2] == goal[:2]
        turns = (end[2] - goal[2]) / (2.0 * np.pi)
        assert turns == pytest.approx(round(turns), abs=1e-12)  # theta is unwrapped
    elif "region" in goal:
        assert shapely.geometry.shape(goal["region"]).contains(shapely.Point(end[:2]))
        assert goal["theta"][0] <= end[2] % (2.0 * np.pi) <= goal["theta"][1]
    else:  # the whole body is out of the way
        robot = shapely.geometry.shape(content["robot"])
        placed = affinity.rotate(robot, end[2], origin=(0, 0), use_radians=True)
        placed = affinity.translate(placed, *end[:2])
        obstacles = shapely.union_all([shapely.geometry.shape(o) for o in content["obstacles"]])
        if goal == "escape":
            assert not placed.intersects(shapely.box(*obstacles.bounds))
        else:
            assert not shapely.geometry.shape(goal["escape"]).contains(shapely.Point(end[:2]))
