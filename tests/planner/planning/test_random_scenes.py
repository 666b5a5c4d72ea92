"""Verdicts of random small scenes against a sound flood fill, where the grid is decisive."""

from typing import Literal

import pytest

from oracles.dense_path import check_path
from oracles.grid import decide
from planar_planner import Options, solve
from worlds.random_scenes import random_scene

STEP = 0.2
OPTIONS = Options(max_cells=50_000)
# Seeds that the grid decides in about a second each; between them every kind of scene.
PATH = (24, 29, 33, 35, 39, 41, 42, 44, 47, 49, 58, 61, 65, 67, 70, 73, 78, 83)
NO_PATH = (27, 71, 95, 100, 119)


@pytest.mark.parametrize(
    ("seed", "expected"), [*((s, "path") for s in PATH), *((s, "no_path") for s in NO_PATH)]
)
def test_verdict_is_the_grids(seed: int, expected: Literal["path", "no_path"]) -> None:
    scene = random_scene(seed)
    assert decide(scene, STEP, claim=expected)
    result = solve(scene, OPTIONS)
    assert result.verdict == expected, result.reason


@pytest.mark.parametrize("seed", range(200, 260))
def test_paths_stay_free(seed: int) -> None:
    scene = random_scene(seed)
    result = solve(scene, OPTIONS)
    assert result.verdict != "undecided", result.reason
    if result.verdict == "path":
        found = check_path(scene, result.path)
        assert found.within_rounding, found
