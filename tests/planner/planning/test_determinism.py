"""The same question gets the same answer, bit for bit, and cells of old queries serve new ones."""

import numpy as np
import pytest

from oracles.decisive import FOLDER, listed
from planar_planner import Options, Planner, load_scene, solve
from planar_planner.planning.result import Result
from worlds.random_scenes import random_scene

OPTIONS = Options(max_cells=50_000)
COUNTS = (
    "cells",
    "cells_by_label",
    "cells_by_level",
    "labelled_cells",
    "separation_evaluations",
    "pairs_touched",
    "faces_tested",
    "search_rounds",
)


def same(a: Result, b: Result) -> bool:
    counts = all(a.stats[key] == b.stats[key] for key in COUNTS)
    return counts and a.verdict == b.verdict and np.array_equal(a.path, b.path)


@pytest.mark.parametrize("name", sorted(set(listed()) - {"field"}))
def test_shipped_scene_twice(name: str) -> None:
    scene = load_scene(FOLDER / f"{name}.json")
    assert same(solve(scene), solve(scene))


@pytest.mark.parametrize("seed", range(500, 540))
def test_second_query_agrees_with_a_fresh_planner(seed: int) -> None:
    """Whatever was asked before: other ends, the other way round, a limit that stopped it."""
    scene, other = random_scene(seed), random_scene(seed)
    start, goal = scene["start"], scene["goal"]
    fresh = Planner(scene).solve(options=OPTIONS)
    assert same(fresh, solve(other, OPTIONS))
    planner = Planner(scene)
    planner.solve(options=Options(max_cells=30))
    planner.solve(options=Options(resolution=0.05))
    assert planner.solve(goal, start, options=OPTIONS).verdict == fresh.verdict
    again = planner.solve(start, goal, options=OPTIONS)
    assert again.verdict == fresh.verdict
    assert again.stats["labelled_cells"] <= fresh.stats["labelled_cells"]
    repeated = planner.solve(start, goal, options=OPTIONS)
    assert repeated.verdict == fresh.verdict
    assert repeated.stats["labelled_cells"] == 0


def test_second_query_at_another_fixed_angle() -> None:
    """With rotation off the cells belong to one angle only."""
    scene = load_scene(FOLDER / "window-fixed.json")
    planner = Planner(scene)
    for theta in (0.0, 0.5 * np.pi, 0.0):
        start = [*planner.problem.start[:2], theta]
        goal = [*planner.problem.goal[:2], theta]
        fresh = Planner(scene)
        assert (
            planner.solve(start, goal, options=OPTIONS).verdict
            == fresh.solve(start, goal, options=OPTIONS).verdict
        )
