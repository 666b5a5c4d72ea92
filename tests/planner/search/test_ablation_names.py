"""Parts and queries that an experiment names are those that there are."""

from __future__ import annotations

import pytest

from planar_planner import load_scene
from planar_planner.planning.engine import make_core
from planar_planner.problem.make import make_problem


def test_unknown_parts_and_queries_are_refused_with_those_that_there_are() -> None:
    problem = make_problem(load_scene("corner"))
    with pytest.raises(ValueError, match=r"no part stars; known are star joint .* shift$"):
        make_core(problem, without=["joint", "stars"])
    with pytest.raises(ValueError, match=r"no query Per-normal; known are none .* per-normal$"):
        make_core(problem, query="Per-normal")
