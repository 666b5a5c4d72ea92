"""The real planner on every shipped scene: expected verdict, and every path densely re-checked."""

import json

import numpy as np
import pytest
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
    assert np.array_equal(result.path[-1][:2], content["goal"][:2])
    turns = (result.path[-1][2] - content["goal"][2]) / (2.0 * np.pi)
    assert turns == pytest.approx(round(turns), abs=1e-12)  # theta is unwrapped
    found = check_path(content, result.path)
    assert found.within_rounding, found
    if not content.get("rotation", True):
        assert np.ptp(result.path[:, 2]) == 0.0
