"""A stand-in for the native core: it answers what a test tells it to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
import pytest

from planar_planner import _core

FREE = {
    "state": "free",
    "exact": False,
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

    def tolerated_error(self) -> float:
        return float("inf")

    def solve(self, start: Any, goal: Any, *limits: Any) -> dict[str, Any]:
        type(self).solved.append((start, goal, *limits))
        type(self).during_solve(limits[-1])
        path = np.array([start, goal]) if self.verdict == "path" else np.empty((0, 3))
        return {
            "verdict": self.verdict,
            "stop_reason": _core.StopReason.MAX_CELLS if self.verdict == "undecided" else None,
            "ends_moved": False,
            "to_be_checked": False,
            "exact_legs": False,
            "path": path,
            "stats": STATS.replace(decided_by=DECIDED_BY[self.verdict]),
        }

    def least_clearance(self) -> float:
        return float("inf")


def refuse_the_real_core(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the real core raise when it is asked: the stand-in then was not in its place."""

    def asked(*_arguments: object, **_limits: object) -> None:
        raise AssertionError("the real core was asked while a stand-in was planted")

    for question in ("placement", "solve"):
        monkeypatch.setattr(_core.Core, question, asked)
