"""`solve` and `Planner` with a stand-in for the core: what is asked of it, and how often."""

from __future__ import annotations

import inspect
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import planar_planner
from planar_planner import Planner, _core
from support.stand_in_core import FREE, FakeCore


def test_public_names_resolve() -> None:
    for name in planar_planner.__all__:
        assert getattr(planar_planner, name) is not None
        assert name in dir(planar_planner)
    with pytest.raises(AttributeError, match="nonsense"):
        assert planar_planner.nonsense


def test_import_is_light() -> None:
    code = (
        "import sys, planar_planner\n"
        "from planar_planner import load_scene\n"
        "sys.exit(len({'numpy', 'shapely', 'matplotlib', 'scipy'} & set(sys.modules)))"
    )
    assert (
        subprocess.run([sys.executable, "-P", "-c", code], timeout=60, check=False).returncode == 0
    )


@pytest.mark.parametrize("verdict", ["path", "no_path", "undecided"])
def test_solve_takes_dict_or_scene(
    fake_core: type[FakeCore], scene_dict: dict[str, Any], verdict: str
) -> None:
    fake_core.verdict = verdict
    for scene in (scene_dict, planar_planner.load_scene(scene_dict)):
        result = planar_planner.solve(scene)
        assert result.verdict == verdict
        assert result.scene == "small"
        assert result.stats.cells == 12


def test_second_query_uses_the_same_core(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    planner.solve()
    planner.solve(start=(2, 2, 0.5))
    planner.solve(goal=np.array([3.0, 1.0, 0.25]), options=planar_planner.Options(max_cells=3))
    planner.solve()
    assert len(fake_core.built) == 1
    assert [(start, goal) for start, goal, *_ in fake_core.solved] == [
        ((1, 1, 0), (9, 9, 0)),
        ((2, 2, 0.5), (9, 9, 0)),
        ((1, 1, 0), (3, 1, 0.25)),
        ((1, 1, 0), (9, 9, 0)),
    ]
    assert fake_core.solved[2][3] == 3


def test_every_query_is_checked(fake_core: type[FakeCore], scene_dict: dict[str, Any]) -> None:
    hit = {"state": "colliding", "exact": False, "what": "obstacle", "polygon": 0, "depth": 0.125}
    fake_core.placements = staticmethod(lambda q: FREE | hit if q[:2] == (5, 5) else FREE)
    planner = planar_planner.Planner(scene_dict)
    planner.solve()
    with pytest.raises(planar_planner.SceneError, match="goal: robot collides with obstacles"):
        planner.solve(goal=(5, 5, 0))
    with pytest.raises(planar_planner.SceneError, match="start: must be"):
        planner.solve(start=(5, 5))
    assert len(fake_core.solved) == 1


def test_listener_is_passed_on(fake_core: type[FakeCore], scene_dict: dict[str, Any]) -> None:
    heard: list[Any] = []
    fake_core.during_solve = staticmethod(lambda listener: listener({"cells": 1}))

    def listener(counts: Any) -> bool:
        heard.append(counts)
        return True

    planar_planner.solve(scene_dict, listener=listener)
    assert heard == [{"cells": 1}]


def test_public_functions_say_what_they_take() -> None:
    from planar_planner.load import load_scene

    for part in ("Parameters", "Returns", "Raises"):
        assert part in (inspect.getdoc(load_scene) or "")


def test_a_real_core_is_noticed_where_a_stand_in_is_planted(
    fake_core: type[FakeCore], scene_dict: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("planar_planner.planning.engine.Core", _core.Core)
    with pytest.raises(AssertionError, match="the real core was asked"):
        Planner(scene_dict).solve()
    assert fake_core.built == []
