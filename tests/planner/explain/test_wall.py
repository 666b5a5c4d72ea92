"""The wall of a proof of absence is made of the very boxes that its certificate has."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import Cells, Planner, Scene
from planar_planner.explain.cells import FULL

DOOR = [shapely.box(4, 0, 5, 4.9), shapely.box(4, 5.1, 5, 10)]
ROOM = {"start": (2, 2, 0), "goal": (8, 2, 0), "workspace": (0, 0, 10, 10)}


def scene(robot: Any, **more: Any) -> Scene:
    return Scene(**({"robot": robot, "obstacles": DOOR} | ROOM | more))


WALLS = {
    "gear-jammed": "separation",
    "bug-trap-closed": "separation",
    "slide-blocked": "separation",
    "window-fixed": "separation",
    "disc-jammed": "disc",
    "cage": "disc",
}


def boxes_of(certificate: dict[str, Any], angle: float | None) -> tuple[Any, Any, Any]:
    """Read lower and upper corners and levels from a certificate, at one angle if that is given."""
    domain = certificate["domain"]
    low, size = (np.array([math.ldexp(m, e) for m, e in domain[key]]) for key in ("low", "size"))
    lower, upper, levels = [], [], []
    for claim in [*certificate["full"], *certificate["full_faces"]]:
        first = [k / 2**level for level, k in claim["box"]]
        last = [
            (k if axis == claim.get("axis") else k + 1) / 2**level
            for axis, (level, k) in enumerate(claim["box"])
        ]
        for corners, turns in ((lower, first), (upper, last)):
            theta = math.tau * turns[2] if angle is None else angle
            corners.append([*(low + size * turns[:2]), theta])
        levels.append([level for level, _ in claim["box"]])
    return lower, upper, levels


@pytest.mark.parametrize(("name", "claim"), WALLS.items())
def test_the_boxes_are_those_of_the_certificate(name: str, claim: str) -> None:
    planner = Planner(name)
    result = planner.solve(certificate=True)
    assert result.certificate is not None
    assert result.certificate["claim"] == claim
    wall = planner.wall()
    assert isinstance(wall, Cells)
    assert len(wall) > 0
    angle = None if planner.problem.rotation else planner.problem.start[2]
    lower, upper, levels = boxes_of(result.certificate, angle)
    assert wall.lower.tolist() == lower
    assert wall.upper.tolist() == upper
    assert wall.level.tolist() == levels
    assert set(wall.label.tolist()) == {FULL}
    assert not wall.lower.flags.writeable


def test_no_wall_without_a_separation() -> None:
    planner = Planner("gear-jammed")
    assert planner.wall() is None
    start = planner.problem.start
    assert planner.solve(goal=start).verdict == "path"
    assert planner.wall() is None
    outside = Planner(scene(shapely.box(-0.5, -0.5, 0.5, 0.5), goal=(8, 2, 0)))
    assert outside.solve().verdict == "no_path"
    assert outside.wall() is not None


def test_the_angle_is_that_of_the_last_query() -> None:
    planner = Planner(scene(shapely.box(-0.5, -0.5, 0.5, 0.5), rotation=False))
    assert planner.solve((2, 2, 7.0), (8, 2, 7.0)).verdict == "no_path"
    wall = planner.wall()
    assert wall is not None
    assert set(wall.lower[:, 2]) == set(wall.upper[:, 2]) == {7.0}
