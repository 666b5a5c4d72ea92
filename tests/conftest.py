"""Fixtures of all Python tests: a small scene, and a stand-in for the native core.

The stand-in lets the gate and the command line be tested apart from the planner. Tests named
``*_end_to_end`` use the real core.
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

import pytest

from support.stand_in_core import FakeCore
from worlds.small import small_scene


@pytest.fixture
def fake_core(monkeypatch: pytest.MonkeyPatch) -> type[FakeCore]:
    """Replace the core of the planner by a fresh stand-in."""
    core = type("Core", (FakeCore,), {"built": [], "solved": []})
    module = ModuleType("planar_planner._core")
    vars(module)["Core"] = core
    monkeypatch.setitem(sys.modules, "planar_planner._core", module)
    # modules that took the real class by name are imported anew, with the stand-in
    for name in (
        "planning.engine",
        "planning.placement",
        "planning.planner",
        "cli.commands.solve",
        "cli.commands.check",
    ):
        monkeypatch.delitem(sys.modules, f"planar_planner.{name}", raising=False)
    import planar_planner

    for name in ("solve", "Planner"):
        monkeypatch.delitem(vars(planar_planner), name, raising=False)
    return core


@pytest.fixture
def scene_dict() -> dict[str, Any]:
    """A valid scene as a fresh dict: a unit square, one obstacle in a box, free start and goal."""
    return small_scene()
