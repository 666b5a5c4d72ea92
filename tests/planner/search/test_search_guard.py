"""The mended search against the flood fill that guards every proof of non-existence."""

from __future__ import annotations

import pytest

from planar_planner import load_scene, solve
from planar_planner.scene.builtin import builtin_scenes


@pytest.mark.parametrize("name", sorted(builtin_scenes()))
def test_mended_trees_never_overlook_a_channel(name: str) -> None:
    assert solve(load_scene(name)).stats["search_rebuilds"] == 0
