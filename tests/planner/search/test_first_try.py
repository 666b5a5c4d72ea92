"""The first try by trees: where it answers, and that it changes no verdict."""

import math
from typing import Any

import numpy as np
import pytest

from planar_planner import Options, load_scene, solve
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.decimals import decimal_places, in_small_units
from planar_planner.problem.make import make_problem
from planar_planner.scene.builtin import manifest

BY_TREES = "RRT-Connect"
CHECKS = 1000  # that a first try asks for at least where it finds nothing, and
MOST_CHECKS = 6000  # at most in a scene of few vertices
SCENES = manifest()
ROOMY = ("gear-wide", "window", "slide", "courtyard", "fence")


@pytest.mark.parametrize("name", sorted(SCENES))
def test_verdict_is_the_same_without_it(name: str) -> None:
    problem = make_problem(load_scene(name))
    places = decimal_places(problem) if name == "peg" else None
    if places is not None:
        problem = in_small_units(problem, places)
    answer = ask(make_core(problem, without=("probe",)), problem, Options())
    assert answer["verdict"] == SCENES[name]["expected"]
    assert answer["stats"].probe_checks == 0
    assert answer["stats"].decided_by != BY_TREES


@pytest.mark.parametrize("name", ROOMY)
def test_answers_where_there_is_room(name: str) -> None:
    scene = load_scene(name)
    result = solve(scene, certificate=True)
    assert result.stats.decided_by == BY_TREES
    assert result.stats.cells == 0
    assert result.stats.probe_checks > 0
    assert result.stats.least_clearance > 0.0
    assert result.path[0].tolist() == list(scene.start)
    assert result.path[-1][:2].tolist() == list(scene.goal[:2])
    assert result.certificate is not None


def test_is_short_where_there_is_none() -> None:
    scene = load_scene("corner-too-long")
    result = solve(scene)
    assert result.verdict == "no_path"
    assert 0 < result.stats.probe_checks <= MOST_CHECKS


@pytest.mark.parametrize("name", ["gear-jammed", "snowflake-jammed", "maze-blocked"])
def test_goes_on_beside_the_cells_for_a_small_part_of_their_work(name: str) -> None:
    scene = load_scene(name)
    alone = solve(scene, Options(max_cells=1)).stats
    beside = solve(scene).stats
    more = beside.probe_checks - alone.probe_checks
    assert more > 0
    # In the unit of native/search/tuning.hpp, about a nanosecond; a check takes at least 60.
    cells = (
        1300 * beside.labelled_cells
        + 160 * beside.search_expansions
        + 70 * beside.separation_evaluations
    )
    assert 60 * more <= cells / 16


def test_is_the_same_every_time() -> None:
    first, second = (solve(load_scene("fence")) for _ in range(2))
    assert np.array_equal(first.path, second.path)
    assert first.stats.probe_checks == second.stats.probe_checks


def dodecagon_before_a_slot(width: float) -> dict[str, Any]:
    turns = [k / 12 * math.tau for k in range(12)]
    ring = [[math.cos(turn), math.sin(turn)] for turn in turns]
    walls = [(-5.0, -width / 2), (width / 2, 5.0)]
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [-6, -5, 6, 5]},
        "robot": {"type": "Polygon", "coordinates": [[*ring, ring[0]]]},
        "obstacles": [
            {"type": "Polygon", "coordinates": [[[-1, a], [1, a], [1, b], [-1, b], [-1, a]]]}
            for a, b in walls
        ],
        "start": [-4, 0.3, 0],
        "goal": [4, 0, 0],
    }


def test_counts_what_the_discs_asked_too() -> None:
    # Wider than the disc inside the robot, narrower than the one around it: neither disc decides.
    result = solve(dodecagon_before_a_slot(1.94))
    assert result.verdict == "path"
    assert result.stats.decided_by in ("channel", "ridge")
    assert result.stats.probe_checks > CHECKS
