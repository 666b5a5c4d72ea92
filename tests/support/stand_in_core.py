"""A stand-in for the native core: it answers what a test tells it to."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

FREE = {
    "state": "free",
    "what": "",
    "polygon": -1,
    "piece": 0,
    "depth": 0.0,
    "separation": 1.0,
}

STATS = {
    "cells": 12,
    "cells_by_label": {"free": 3, "star": 2, "full": 4, "mixed": 3},
    "cells_by_level": [0, 0, 4, 8],
    "labelled_cells": 20,
    "separation_evaluations": 340,
    "pairs_touched": 5,
    "pairs_total": 9,
    "faces_tested": 7,
    "probe_checks": 0,
    "ridge_tries": 0,
    "ridge_evaluations": 0,
    "search_rounds": 2,
    "memory_bytes": 2048,
    "seconds": {
        "preprocessing": 0.001,
        "labelling": 0.002,
        "faces": 0.0005,
        "search": 0.0001,
        "path": 0.0,
        "probe": 0.0,
        "total": 0.0036,
    },
    "path_length": 2.5,
    "waypoints": 2,
    "decided_by": "straight move",
}


class FakeCore:
    """Stands in for `planar_planner._core.Core`; tests set the class attributes."""

    built: ClassVar[list[tuple[Any, ...]]] = []
    solved: ClassVar[list[tuple[Any, ...]]] = []
    placements: Callable[[tuple[float, float, float]], dict[str, Any]] = staticmethod(
        lambda q: FREE
    )
    verdict = "path"
    reason = "straight move"
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
            "reason": self.reason,
            "path": path,
            "stats": copy.deepcopy(STATS),
        }

    def least_clearance(self) -> float:
        return float("inf")
