"""The search that mends its trees, against one that builds them from scratch in every round."""

from __future__ import annotations

import functools
from typing import Any

import pytest

from planar_planner import Options, load_scene
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem
from planar_planner.scene.builtin import builtin_scenes

NO_FIRST_TRY = ("probe", "cheap", "ridge")  # so that the search has something to do
FROM_SCRATCH = ("incremental", *NO_FIRST_TRY)
LIMITS = Options(max_cells=20_000)
LONG = ("maze", "maze-blocked", "gear-jammed")  # thousands of steps of the search


@functools.cache
def answer(name: str, without: tuple[str, ...]) -> dict[str, Any]:
    problem = make_problem(load_scene(name))
    return ask(make_core(problem, without), problem, LIMITS)


@pytest.mark.parametrize("name", sorted(builtin_scenes()))
def test_mended_trees_never_overlook_a_channel(name: str) -> None:
    """A channel that only the flood fill finds is counted; both searches decide alike."""
    mended, scratch = answer(name, NO_FIRST_TRY), answer(name, FROM_SCRATCH)
    assert mended["stats"].search_rebuilds == 0
    assert "undecided" in (mended["verdict"], scratch["verdict"]) or (
        mended["verdict"] == scratch["verdict"]
    )


@pytest.mark.parametrize("name", LONG)
def test_trees_are_mended_and_not_built_anew(name: str) -> None:
    """Mending takes fewer steps a round than building: the first test is not about nothing."""
    steps = []
    for without in (NO_FIRST_TRY, FROM_SCRATCH):
        stats = answer(name, without)["stats"]
        assert stats.search_rounds > 50
        steps.append(stats.search_expansions / stats.search_rounds)
    mended, scratch = steps
    assert mended < 0.5 * scratch
