"""Ends in contact: what the contact tolerance allows to be concluded."""

from __future__ import annotations

import math
from typing import Any

import pytest

from planar_planner import Options, SceneError, load_scene, solve, verify_certificate
from planar_planner.planning.certificate import make_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem


def rectangle(x0: float, y0: float, x1: float, y1: float) -> dict[str, Any]:
    ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]
    return {"type": "Polygon", "coordinates": [ring]}


TILT = 0.25


def room(door: float, tilt: float = TILT, turn: float = 0.0) -> dict[str, Any]:
    """Return a room whose square robot rests on a floor; the wall may leave a door.

    It rests on a corner if it is tilted: up to rounding, so that no exact translation is known to
    be free. The goal is turned on by an angle.
    """
    height = 0.25 + 0.5 * (math.sin(tilt) + math.cos(tilt))
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 4]},
        "robot": rectangle(-0.5, -0.5, 0.5, 0.5),
        "obstacles": [rectangle(5, 0, 6, 4 - door), rectangle(0, -1, 10, 0.25)],
        "start": [2, height, tilt],
        "goal": [8, 2, tilt + turn],
    }


def test_without_a_tolerance_no_path_is_certified_but_its_absence_is() -> None:
    scene = load_scene(room(0.0))
    assert solve(room(1.5)).verdict == "undecided"
    walled_in = solve(scene, certificate=True)
    assert walled_in.verdict == "no_path"
    assert walled_in.certificate is not None
    verify_certificate(scene, walled_in.certificate)


@pytest.mark.parametrize("rotation", [True, False])
def test_a_resting_robot_that_need_not_turn_gets_away_exactly(rotation: bool) -> None:
    scene = load_scene({**room(1.5, tilt=0.0), "rotation": rotation})
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert result.certificate is not None
    verify_certificate(scene, result.certificate)


@pytest.mark.parametrize("end", ["start", "goal"])
@pytest.mark.parametrize("turn", [0.5, 2.0, 3.0, 6.0])
def test_a_resting_robot_that_has_to_turn_leaves_the_floor_exactly(end: str, turn: float) -> None:
    content = room(1.5, tilt=0.0, turn=turn)
    if end == "goal":
        content["start"], content["goal"] = content["goal"], content["start"]
    scene = load_scene(content)
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert result.certificate is not None
    assert result.certificate["contact_tolerance"] == 0.0
    verify_certificate(scene, result.certificate)


def test_a_bar_leaves_its_rest_turns_and_rests_again() -> None:
    """Both legs are exact; between them the bar turns by half a turn."""
    content = room(1.5, tilt=0.0)
    content["robot"] = rectangle(-0.25, -0.5, 1.25, 0.5)
    content["goal"] = [8, 0.75, 0.0]
    content["obstacles"] = [rectangle(0, -1, 10, 0.25), rectangle(4, 2.75, 5, 4)]
    content["obstacles"].append(rectangle(4, 0, 5, 1.0))
    scene = load_scene(content)
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert result.certificate is not None
    verify_certificate(scene, result.certificate)


@pytest.mark.parametrize("tolerance", [1e-7, 1e-5, 1e-3])
def test_a_resting_robot_gets_away(tolerance: float) -> None:
    scene = load_scene(room(1.5))
    result = solve(scene, Options(contact_tolerance=tolerance), certificate=True)
    assert result.verdict == "path"
    lift = result.path[1] - result.path[0]
    assert 0 < (lift[0] ** 2 + lift[1] ** 2) ** 0.5 <= tolerance
    assert result.certificate is not None
    assert result.certificate["contact_tolerance"] == tolerance
    verify_certificate(scene, result.certificate, contact_tolerance=tolerance)


@pytest.mark.parametrize("tolerance", [1e-7, 1e-5, 1e-3])
def test_a_resting_robot_is_proven_walled_in(tolerance: float) -> None:
    """The cells that separate the lifted start separate the start itself, so the proof is of it."""
    scene = load_scene(room(0.0))
    result = solve(scene, Options(contact_tolerance=tolerance), certificate=True)
    assert result.verdict == "no_path"
    assert result.certificate is not None
    verify_certificate(scene, result.certificate)


@pytest.mark.parametrize("exponent", [-52, -50, -48, -46])
@pytest.mark.parametrize("end", ["start", "goal"])
def test_an_end_that_overlaps_by_less_than_rounding_has_no_path(end: str, exponent: int) -> None:
    """Sunk into the workspace's floor, and a robot that has to turn: found by the stress run."""
    content = room(1.5, tilt=0.0, turn=1.0)
    content["obstacles"].pop()
    content["start"] = [2, 0.5 - 2.0**exponent, 0.0]
    if end == "goal":
        content["start"], content["goal"] = content["goal"], content["start"]
    scene = load_scene(content)
    with pytest.raises(SceneError, match=f"outside the workspace by {2.0**exponent:.6g}"):
        solve(scene)
    problem = make_problem(scene)
    core = make_core(problem)
    answer = ask(core, problem, Options())
    assert (answer["verdict"], answer["stats"].decided_by.lower()) == ("no_path", end)
    certificate = make_certificate(problem, core.evidence(), 0.0)
    assert certificate is not None
    assert verify_certificate(scene, certificate).proof == "end"
