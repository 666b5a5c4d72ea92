"""The native program of the culling ratios; it is built only where a build folder is named."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

# Building takes a minute: not in every run of the tests, but in every one of .ci/run.
needs_build = pytest.mark.skipif(
    "PLANNER_BENCH_BUILD" not in os.environ, reason="PLANNER_BENCH_BUILD names no build folder"
)


def test_scenes_are_handed_over_exactly() -> None:
    from lib.native import as_numbers
    from planar_planner import load_scene
    from planar_planner.problem.make import make_problem

    problem = make_problem(load_scene("field"))
    words = as_numbers(problem).split()
    numbers = [float(word) for word in words]
    assert words[0] == "1"
    assert tuple(numbers[2:6]) == problem.workspace_box
    robot = numbers[8 : 8 + 1 + 2 * len(problem.robot.coords)]
    assert robot[1:] == problem.robot.coords.ravel().tolist()
    assert tuple(numbers[-6:]) == (*problem.start, *problem.goal)


@pytest.fixture(scope="module")
def program() -> Path:
    from lib import native as native_bench

    return native_bench.build("culling")


def census(found: dict[str, Any]) -> dict[str, Any]:
    total: dict[str, Any] = found["total"]
    return total


@needs_build
@pytest.mark.parametrize("scene", ["gear", "slot-jammed", "window-fixed"])
@pytest.mark.parametrize("walk", [("--search",), ("--driver", "published", "--cells", "3000")])
def test_a_stronger_query_culls_no_less(program: Path, scene: str, walk: tuple[str, ...]) -> None:
    from lib.native import run

    total = census(run(program, scene, *walk, "--repeats", "1", "--misses", "0"))
    culled = total["culled"]
    names = ["published", "displacement", "per_normal_alone"]
    inherited = ["per_normal", "per_normal_single", "per_normal_joint"]
    for chain in (names, inherited):
        counts = [culled[name] for name in chain]
        assert counts == sorted(counts)
    assert culled["per_normal_joint"] <= total["obstacle"] <= total["cells"]
    assert total["undecided"] <= 0.1 * total["cells"]
