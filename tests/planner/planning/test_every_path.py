"""Results of every shipped scene, as a user gets them: verdicts, paths and statistics."""

import json
import math
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from oracles.decisive import FOLDER, listed
from oracles.dense_path import check_path, interpolate
from oracles.scene_shapes import shapes
from planar_planner import Planner

NAMES = sorted(set(listed()) - {"field"})


@pytest.mark.parametrize("name", NAMES)
def test_both_ways_and_again(name: str) -> None:
    """There, back on the same cells, and the statistics of the way there."""
    content = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    planner = Planner(content)
    expected = listed()[name]["expected"]
    there = planner.solve()
    assert there.verdict == expected, there.reason
    reversible = isinstance(content["goal"], list) or expected == "path"
    if reversible:
        goal = content["goal"] if isinstance(content["goal"], list) else there.path[-1]
        back = planner.solve(goal, content["start"])
        assert back.verdict == expected, back.reason
    labels = there.stats.cells_by_label
    assert sum(labels.values()) == there.stats.cells == sum(there.stats.cells_by_level)
    assert there.stats.pairs_touched <= there.stats.pairs_total
    if expected == "no_path":
        return
    for path in (there.path, back.path):
        found = check_path(content, path)
        assert found.within_rounding, found
    steps = np.diff(there.path, axis=0)
    length = float(np.hypot(steps[:, 0], steps[:, 1]).sum())
    assert there.stats.path_length == pytest.approx(length, rel=1e-12)
    assert there.stats.waypoints == len(there.path)
    assert (there.stats.least_clearance > 0.0) == (name not in TOUCHING)


TOUCHING = {"exact-maze", "peg", "sliding-block", "unlocked"}
"""Scenes whose paths touch; the sampled clearance of decimals may be less than 0 by rounding."""


def sampled_clearance(content: dict[str, Any], path: NDArray[np.float64]) -> float:
    """Least distance of the robot from obstacles and box at samples along the path."""
    scene = shapes(content)
    least = math.inf
    tree = shapely.STRtree(scene.obstacles)
    for x, y, theta in interpolate(path, scene.radius, 2e-3 * scene.size):
        c, s = math.cos(theta), math.sin(theta)
        placed = shapely.affinity.affine_transform(scene.robot, [c, -s, s, c, x, y])
        if scene.obstacles:
            _, distance = tree.query_nearest(placed, return_distance=True, all_matches=False)
            least = min(least, float(distance[0]))
        if scene.box is not None:
            low, high = np.array(placed.bounds[:2]), np.array(placed.bounds[2:])
            least = min(least, *(low - scene.box[:2]), *(scene.box[2:] - high))
    return least


@pytest.mark.parametrize("name", [n for n in NAMES if listed()[n]["expected"] == "path"])
def test_least_clearance_is_a_bound(name: str) -> None:
    content = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    result = Planner(content).solve()
    assert result.verdict == "path"
    reported = result.stats.least_clearance
    assert (reported > 0.0) == (name not in TOUCHING)
    rounding = 1e-14 if name in TOUCHING else 0.0
    assert reported <= sampled_clearance(content, result.path) * (1.0 + 1e-9) + rounding
