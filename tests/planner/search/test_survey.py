"""Channels that are surveyed: long narrow ways whose one tight place is elsewhere."""

from __future__ import annotations

import math
from typing import Any

import pytest
import shapely
from shapely.geometry.base import BaseGeometry

from planar_planner import Options, load_scene, solve, verify_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem

FINE = Options(resolution=1e-13, max_cells=20_000)
HALF = 9.0  # half the side of the room

T_ROBOT = [(-1.1, 0.0), (1.1, 0.0), (1.1, 0.22), (0.11, 0.22), (0.11, 0.83), (-0.11, 0.83),
           (-0.11, 0.22), (-1.1, 0.22)]  # fmt: skip
L_ROBOT = [(0.0, 0.0), (2.0, 0.0), (2.0, 0.4), (0.4, 0.4), (0.4, 1.1), (0.0, 1.1)]


def polygon(shape: BaseGeometry) -> dict[str, Any]:
    return {
        "type": "Polygon",
        "coordinates": [[list(p) for p in shape.exterior.coords]],
    }


def bent_slot(
    width: float,
    *,
    bend: float = 0.27,
    length: float = 2.8,
    turn: float = 0.9,
    robot: list[tuple[float, float]] | None = None,
) -> dict[str, Any]:
    """A wall with a slot of two arms that meet at an angle; a wider slot holds a narrower one."""
    rise = math.tan(bend) * length
    middle = [(-length - 1.0, rise * (length + 1.0) / length), (0.0, 0.0)]
    middle.append((length + 1.0, middle[0][1]))
    slot = shapely.LineString(middle).buffer(
        width / 2, cap_style="flat", join_style="mitre", mitre_limit=20
    )
    wall = shapely.box(-length, -12.0, length, 12.0).difference(slot)
    turned = [shapely.affinity.rotate(g, turn, (0, 0), use_radians=True) for g in wall.geoms]
    c, s = math.cos(turn), math.sin(turn)
    end = length + 3.0
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [-HALF, -HALF, HALF, HALF]},
        "robot": polygon(shapely.Polygon(robot or T_ROBOT)),
        "obstacles": [polygon(g) for g in turned],
        "start": [-c * end, -s * end, 0.4],
        "goal": [c * end, s * end, -0.7],
    }


def critical(**slot: Any) -> tuple[float, float]:
    """Return the widest slot shown too narrow and the narrowest shown wide enough."""
    low, high = 0.1, 3.0
    while high - low > 1e-9 * high:
        width = 0.5 * (low + high)
        verdict = solve(bent_slot(width, **slot), FINE).verdict
        if verdict == "undecided":
            break
        low, high = (low, width) if verdict == "path" else (width, high)
    return low, high


@pytest.mark.parametrize("turn", [0.0, 0.3, 0.9, 2.2])
@pytest.mark.parametrize("robot", [T_ROBOT, L_ROBOT], ids=["T", "L"])
@pytest.mark.parametrize("bend", [0.15, 0.27, 0.8])
def test_bent_slots_are_decided_to_the_last(
    robot: list[tuple[float, float]], bend: float, turn: float
) -> None:
    low, high = critical(robot=robot, bend=bend, turn=turn)
    assert high - low <= 1e-9 * high


@pytest.mark.parametrize("side", [1, -1])
def test_certificates_hold(side: int) -> None:
    low, high = critical()
    width = high * (1 + 1e-8) if side > 0 else low * (1 - 1e-8)
    scene = bent_slot(width)
    result = solve(scene, FINE, certificate=True)
    assert result.certificate is not None
    assert verify_certificate(scene, result.certificate).verdict == (
        "path" if side > 0 else "no_path"
    )


def test_is_needed_and_can_be_left_out() -> None:
    problem = make_problem(load_scene(bent_slot(critical()[1] * (1 + 1e-5))))
    assert ask(make_core(problem), problem, FINE)["verdict"] == "path"
    assert ask(make_core(problem, ["survey"]), problem, FINE)["verdict"] == "undecided"


def test_is_the_same_every_time() -> None:
    scene = bent_slot(critical()[1])
    first, second = (solve(scene, FINE) for _ in range(2))
    assert first == second
    assert first.stats.labelled_cells == second.stats.labelled_cells
