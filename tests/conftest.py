"""Fixtures of all Python tests: a small scene, and a stand-in for the native core.

The stand-in lets the gate and the command line be tested apart from the planner. Tests named
``*_end_to_end`` use the real core.
"""

from __future__ import annotations

from typing import Any

import pytest

from support.stand_in_core import FakeCore, refuse_the_real_core
from worlds.small import small_scene


@pytest.fixture
def fake_core(monkeypatch: pytest.MonkeyPatch) -> type[FakeCore]:
    """Replace the core that planners are made with by a fresh stand-in.

    All cores are made in one place. A core that is made elsewhere raises as soon as it is asked.
    """
    core = type("Core", (FakeCore,), {"built": [], "solved": []})
    refuse_the_real_core(monkeypatch)
    monkeypatch.setattr("planar_planner.planning.engine.Core", core)
    return core


@pytest.fixture
def scene_dict() -> dict[str, Any]:
    """A valid scene as a fresh dict: a unit square, one obstacle in a box, free start and goal."""
    return small_scene()
