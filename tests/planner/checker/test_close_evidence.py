"""Paths whose room is about the bound of rounding: decided means certified, all the same."""

from __future__ import annotations

import json
import math
import random
from collections import Counter
from pathlib import Path
from typing import Any

from planar_planner import DecidedBy, Options, StopReason, load_scene, solve, verify_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"


def rectangle(x0: float, y0: float, x1: float, y1: float) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]]}


def slot(seed: int) -> dict[str, Any]:
    """Return a bar before a slot that it fits into but for 3e-14 to 1e-12."""
    draw = random.Random(seed)
    height, length, y = draw.uniform(0.05, 0.4), draw.uniform(0.5, 1.8), draw.uniform(3, 6)
    half = height + 0.5 * 10 ** draw.uniform(-13.5, -12)
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 10]},
        "robot": rectangle(-length, -height, length, height),
        "obstacles": [rectangle(4, -1, 6, y - half), rectangle(4, y + half, 6, 11)],
        "start": [2, y, draw.uniform(0, math.tau)],
        "goal": [8, y, draw.uniform(0, math.tau)],
    }


def speck(seed: int) -> dict[str, Any]:
    """Return a tiny robot beside a tiny obstacle, both far from the origin of a huge workspace."""
    draw = random.Random(seed)
    unit, far = 2.0**-26, 2.0 ** draw.randint(16, 20)

    def steps(low: int, high: int) -> float:
        return unit * draw.randint(low, high)

    x0, y0 = far + steps(0, 4), far + steps(0, 4)
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [-2 * far, -2 * far, 2 * far, 2 * far]},
        "robot": rectangle(0, -unit, steps(1, 3), steps(1, 3)),
        "obstacles": [rectangle(x0, y0, x0 + steps(1, 3), y0 + steps(1, 3))],
        "start": [far - steps(0, 4), far - steps(0, 4), 0],
        "goal": [far + steps(0, 8), far - steps(0, 4), 0],
        "reference_bounds": [far - 8 * unit, far - 8 * unit, far + 16 * unit, far + 16 * unit],
        "rotation": False,
    }


def tally(scenes: list[dict[str, Any]]) -> Counter[tuple[str, object]]:
    """Return how scenes were decided, having checked every certificate."""
    found: Counter[tuple[str, object]] = Counter()
    for content in scenes:
        scene = load_scene(content)
        result = solve(scene, Options(max_cells=20_000), certificate=True)
        assert (result.certificate is None) == (result.verdict == "undecided")
        if result.certificate is not None:
            verify_certificate(scene, result.certificate)
        found[result.verdict, result.stats.decided_by or result.stop_reason] += 1
    return found


def test_slots_with_room_of_rounding() -> None:
    found = tally([slot(seed) for seed in range(120)])
    assert found["path", DecidedBy.RIDGE] >= 30
    assert not found["undecided", StopReason.NO_EVIDENCE]


def test_specks_far_from_the_origin() -> None:
    free = []
    for seed in range(150):
        problem = make_problem(load_scene(speck(seed)))
        core = make_core(problem)
        if all(core.placement(q)["state"] != "colliding" for q in (problem.start, problem.goal)):
            free.append(speck(seed))
    found = tally(free)
    assert sum(count for (verdict, _), count in found.items() if verdict == "path") >= 30
    assert not found["undecided", StopReason.NO_EVIDENCE]


def test_close_evidence_is_marked() -> None:
    """The core asks for an exact check of evidence whose room is within the bound of rounding."""
    marked = 0
    for seed in range(400):
        problem = make_problem(load_scene(slot(seed)))
        answer = ask(make_core(problem), problem, Options(max_cells=20_000))
        marked += answer["to_be_checked"]
        assert not answer["to_be_checked"] or answer["verdict"] == "path"
    content = json.loads((FAULTS / "nocert_straight.json").read_text())
    problem = make_problem(load_scene(content))
    assert ask(make_core(problem), problem, Options())["to_be_checked"]
    assert marked < 40
