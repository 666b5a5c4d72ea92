"""Shared by all Python tests: small scenes, and a stand-in for the native core.

The stand-in answers what a test tells it to, so that the gate and the command line are tested
apart from the planner. Tests named ``*_end_to_end`` use the real core.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

import numpy as np
import pytest

from planar_planner import _core

# Makes benchmarks and generators importable from a checkout, after anything that is installed.
ROOT = Path(__file__).parents[1]
for folder in (ROOT / "bench", ROOT):
    if str(folder) not in sys.path:
        sys.path.append(str(folder))

FREE = {
    "state": "free",
    "what": "",
    "polygon": -1,
    "piece": 0,
    "depth": 0.0,
    "separation": 1.0,
}

STATS = _core.Statistics(
    cells=12,
    cells_by_label={"free": 3, "star": 2, "full": 4, "mixed": 3},
    cells_by_level=[0, 0, 4, 8],
    labelled_cells=20,
    separation_evaluations=340,
    pairs_touched=5,
    pairs_total=9,
    faces_tested=7,
    search_rounds=2,
    memory_bytes=2048,
    seconds=_core.Seconds(
        preprocessing=0.001, labelling=0.002, faces=0.0005, search=0.0001, total=0.0036
    ),
    path_length=2.5,
    waypoints=2,
)

DECIDED_BY = {
    "path": _core.DecidedBy.STRAIGHT_MOVE,
    "no_path": _core.DecidedBy.SEPARATION,
    "undecided": None,
}


class FakeCore:
    """Stands in for `planar_planner._core.Core`; tests set the class attributes."""

    built: ClassVar[list[tuple[Any, ...]]] = []
    solved: ClassVar[list[tuple[Any, ...]]] = []
    placements: Callable[[tuple[float, float, float]], dict[str, Any]] = staticmethod(
        lambda q: FREE
    )
    verdict = "path"
    during_solve: Callable[[Any], None] = staticmethod(lambda listener: None)

    def __init__(self, *arguments: Any, **parts: Any) -> None:
        type(self).built.append(arguments)

    def placement(self, q: tuple[float, float, float]) -> dict[str, Any]:
        return type(self).placements(q)

    def solve(self, start: Any, goal: Any, *limits: Any) -> dict[str, Any]:
        type(self).solved.append((start, goal, *limits))
        type(self).during_solve(limits[-1])
        path = np.array([start, goal]) if self.verdict == "path" else np.empty((0, 3))
        return {
            "verdict": self.verdict,
            "stop_reason": _core.StopReason.CELLS if self.verdict == "undecided" else None,
            "ends_moved": False,
            "path": path,
            "stats": STATS.replace(decided_by=DECIDED_BY[self.verdict]),
        }

    def least_clearance(self) -> float:
        return float("inf")


@pytest.fixture
def fake_core(monkeypatch: pytest.MonkeyPatch) -> type[FakeCore]:
    """Replace the core of the planner by a fresh stand-in."""
    core = type("Core", (FakeCore,), {"built": [], "solved": []})
    module = ModuleType("planar_planner._core")
    vars(module).update(vars(_core) | {"Core": core})
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


def square(x: float, y: float, half: float = 0.5) -> list[list[float]]:
    """Return the closed ring of an axis-parallel square."""
    return [
        [x - half, y - half],
        [x + half, y - half],
        [x + half, y + half],
        [x - half, y + half],
        [x - half, y - half],
    ]


@pytest.fixture
def scene_dict() -> dict[str, Any]:
    """A valid scene as a fresh dict: a unit square, one obstacle in a box, free start and goal."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "name": "small",
        "description": "one obstacle",
        "workspace": {"box": [0.0, 0.0, 10.0, 10.0]},
        "robot": {"type": "Polygon", "coordinates": [square(0, 0)]},
        "obstacles": [{"type": "Polygon", "coordinates": [square(5, 5, 1.0)]}],
        "start": [1.0, 1.0, 0.0],
        "goal": [9.0, 9.0, 0.0],
    }
