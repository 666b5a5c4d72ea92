"""What the gate makes of a scene: a problem, or a message."""

from __future__ import annotations

from typing import Any

import pytest

from planar_planner.errors import SceneError
from planar_planner.load import load_scene
from planar_planner.problem.make import Problem, make_problem
from worlds.small import square


def problem_of(content: dict[str, Any]) -> Problem:
    return make_problem(load_scene(content))


def message(content: dict[str, Any]) -> str:
    with pytest.raises(SceneError) as caught:
        problem_of(content)
    text = str(caught.value)
    assert text.startswith("<dict>: ")
    assert "\n" not in text
    assert len(text) < 400
    return text


def polygon(*rings: Any) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": list(rings)}


VALID = {
    "format": "planar-planner/scene",
    "version": 1,
    "name": "fuzz",
    "workspace": {"box": [0, 0, 10, 10]},
    "robot": polygon(square(0, 0)),
    "obstacles": [polygon(square(5, 5))],
    "start": [1, 1, 0],
    "goal": [9, 9, 0],
    "rotation": True,
}
