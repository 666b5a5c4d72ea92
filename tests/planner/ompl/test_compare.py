"""The comparison's own parts, without OMPL: names, settings, spreads, table, JSON, judging."""

from __future__ import annotations

import json
import math
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from planar_planner import load_scene
from planar_planner.cli.main import main
from planar_planner.errors import OptionsError
from planar_planner.ompl import compare
from planar_planner.ompl.compare import (
    OurRun,
    SamplerRun,
    SceneComparison,
    Settings,
    path_length,
    path_turning,
    run_ours,
    sampler_run,
)
from planar_planner.ompl.comparison import spread, table, to_json
from planar_planner.ompl.samplers import INSTALL_HINT, SAMPLERS, check_samplers
from planar_planner.pictures.comparison import draw_comparison
from planar_planner.planning.path_judge import Judge, unwrapped
from planar_planner.problem.make import make_problem


def judge_of(scene: dict[str, Any]) -> Judge:
    return Judge(make_problem(load_scene(scene)))


def our_run(**changes: Any) -> OurRun:
    values: dict[str, Any] = {
        "verdict": "path",
        "reason": "certified",
        "seconds": 0.002,
        "core_seconds": 0.001,
        "certificate_seconds": 0.0005,
        "cells": 10,
        "length": 3.0,
        "turning": 0.0,
        "soundness": "sound",
    }
    return OurRun(**(values | changes))


def a_sampler_run(**changes: Any) -> SamplerRun:
    values: dict[str, Any] = {
        "planner": "RRTConnect",
        "seed": 1,
        "exact": True,
        "prepare_seconds": 0.25,
        "seconds": 0.5,
        "checks": 1000,
        "length": 4.0,
        "turning": 1.0,
        "soundness": "sound",
        "check_ns": 400.0,
        "native_check_ns": 100.0,
    }
    return SamplerRun(**(values | changes))


UNSOLVED = {"exact": False, "seconds": math.inf, "soundness": "", "length": 0.0, "checks": 7}


def comparison(ours: OurRun, *runs: SamplerRun) -> SceneComparison:
    return SceneComparison("small", 0.001, (ours,), {"RRTConnect": runs})


# Paths between other ends


def test_a_path_between_other_ends_is_not_sound(scene_dict: dict[str, Any]) -> None:
    judge = judge_of({**scene_dict, "obstacles": []})
    start, goal = scene_dict["start"], scene_dict["goal"]
    whole = {"exact": True, "seconds": 0.1, "prepare_seconds": 0.1, "path": [start, goal]}
    assert sampler_run("RRT", 1, whole, judge).soundness == "sound"
    turned = [start, [goal[0], goal[1], goal[2] + math.tau]]
    assert judge.joins(np.array(turned))
    for path in ([goal], [goal, goal], [goal, start], [start, [goal[0], goal[1], goal[2] + 1e-3]]):
        assert not judge.joins(np.array(path, dtype=float))
        assert sampler_run("RRT", 1, whole | {"path": path}, judge).soundness == "unknown"


# Names and settings


def test_names_are_found_whatever_their_case_and_once() -> None:
    assert check_samplers(["rrtconnect", "PRM", "RRTConnect"]) == ("RRTConnect", "PRM")
    assert check_samplers(SAMPLERS) == SAMPLERS


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["RRTConect"], "did you mean 'RRTConnect'"),
        (["EST"], "unknown planner 'EST'"),
        ([], "no planner"),
    ],
)
def test_unknown_names_are_refused(names: list[str], message: str) -> None:
    with pytest.raises(OptionsError, match=message):
        check_samplers(names)


@pytest.mark.parametrize(
    "changes",
    [
        {"runs": 0},
        {"timeout": 0.0},
        {"timeout": math.inf},
        {"timeout": math.nan},
        {"resolution": 0.0},
        {"resolution": 1.5},
        {"seed": -1},
        {"planners": ()},
    ],
)
def test_settings_refuse_what_makes_no_sense(changes: dict[str, Any]) -> None:
    with pytest.raises(OptionsError):
        Settings(**changes)


# Figures


def test_spread_interpolates_and_keeps_infinite_times_infinite() -> None:
    found = spread([4.0, 1.0, 3.0, 2.0])
    assert (found.lower, found.median, found.upper) == (1.75, 2.5, 3.25)
    found = spread([1.0, 2.0, math.inf])
    assert (found.lower, found.median, found.upper) == (1.5, 2.0, math.inf)
    assert spread([1.0, math.inf]).median == math.inf
    assert spread([math.inf] * 3).lower == math.inf


def test_length_and_turning() -> None:
    path = [[0.0, 0.0, 0.0], [3.0, 4.0, 1.0], [3.0, 5.0, -1.0]]
    assert path_length(path) == 6.0
    assert path_turning(path) == 3.0
    assert path_length([]) == 0.0


def test_theta_is_unwrapped_the_shorter_way() -> None:
    path = unwrapped(np.array([[0, 0, 3.0], [0, 0, -3.0], [0, 0, 3.0], [0, 0, 0.0]]))
    assert path[:, 2] == pytest.approx([3.0, math.tau - 3.0, 3.0, 0.0])


# Table, JSON, picture


def test_table_shows_success_soundness_and_call_overhead() -> None:
    text = table(
        comparison(
            our_run(), a_sampler_run(), a_sampler_run(soundness="collides"), a_sampler_run()
        ),
        Settings(runs=3),
    )
    row = next(line for line in text.splitlines() if "RRTConnect" in line)
    assert row.split()[:3] == ["RRTConnect", "3/3", "750"]
    assert "preparation (state check, space, query) 250 ms" in text
    assert "not in it, exporting the certificate 0.5 ms" in text
    assert row.split()[-3:] == ["2/3", "33", "%"]
    assert "one validity check: 100 ns" in text
    assert "overhead 300 ns" in text


def test_table_says_that_absence_was_proven() -> None:
    ours = our_run(verdict="no_path", length=0.0, soundness="")
    text = table(comparison(ours, a_sampler_run(**UNSOLVED)), Settings(timeout=10.0))
    assert "ours has proven that there is no path; the samplers ran to the limit" in text
    assert "> 10000" in text
    text = table(comparison(ours, a_sampler_run(soundness="collides")), Settings())
    assert "1 sampler runs claim one, and every such path is wrong" in text


def test_undecided_counts_as_no_success_of_ours() -> None:
    text = table(comparison(our_run(verdict="undecided"), a_sampler_run()), Settings())
    assert next(line for line in text.splitlines() if "ours" in line).split()[1] == "0/1"


def test_a_process_that_failed_is_told_of() -> None:
    run = a_sampler_run(**UNSOLVED, error="ended with status -11")
    assert "failed: RRTConnect: ended with status -11" in table(
        comparison(our_run(), run), Settings()
    )


def test_json_holds_every_run_in_finite_values() -> None:
    content = to_json(
        [comparison(our_run(), a_sampler_run(**UNSOLVED))], Settings(), {"ompl": "2.0"}
    )
    again = json.loads(json.dumps(content, allow_nan=False))
    assert again["format"] == "planar-planner/comparison"
    (run,) = again["scenes"][0]["samplers"]["RRTConnect"]
    assert run["seconds"] is None
    assert run["prepare_seconds"] == 0.25
    assert run["checks"] == 7
    assert again["settings"]["planners"] == list(Settings().planners)


def test_picture_is_drawn_with_runs_beyond_the_limit(tmp_path: Path) -> None:
    settings = Settings(planners=("RRTConnect",), runs=2)
    each = replace(
        comparison(our_run(), a_sampler_run(), a_sampler_run(**UNSOLVED)), scene="$\\foo$"
    )
    both = [each, comparison(our_run(), a_sampler_run(**UNSOLVED))]
    files = tmp_path / "picture.svg", tmp_path / "again.svg"
    for file in files:
        draw_comparison(both, settings, file, ".svg")
    first, again = (file.read_text(encoding="utf-8") for file in files)
    assert "<svg" in first
    assert first == again


# Judging what others found


def test_judge_tells_sound_from_colliding_and_touching(scene_dict: dict[str, Any]) -> None:
    judge = judge_of(scene_dict)
    around = [[1.0, 1.0, 0.0], [1.0, 9.0, 0.0], [9.0, 9.0, 0.0]]
    through = [[1.0, 1.0, 0.0], [9.0, 9.0, 0.0]]
    sliding = [[1.0, 1.0, 0.0], [3.5, 1.0, 0.0], [3.5, 9.0, 0.0], [9.0, 9.0, 0.0]]
    outside = [[1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
    assert judge.path(np.array(around)) == "sound"
    assert judge.path(np.array(through)) == "collides"
    assert judge.path(np.array(sliding)) == "unknown"
    assert judge.path(np.array(outside)) == "collides"


def test_a_narrow_collision_between_checked_states_is_found(scene_dict: dict[str, Any]) -> None:
    """What a motion validator of resolution 0.01 steps over: a needle, 1e-3 of the extent wide."""
    scene_dict["robot"]["coordinates"] = [[[-0.01, -0.01], [0.01, -0.01], [0.0, 0.01]]]
    needle = [[5.0, 0.5], [5.001, 0.5], [5.001, 9.5], [5.0, 9.5], [5.0, 0.5]]
    scene_dict["obstacles"] = [{"type": "Polygon", "coordinates": [needle]}]
    judge = judge_of(scene_dict)
    path = np.array([[1.0, 1.0, 0.0], [4.95, 1.0, 0.0], [5.05, 1.0, 0.0], [9.0, 1.0, 0.0]])
    assert all(judge.check.is_free(*q) for q in path.tolist())
    assert judge.path(path) == "collides"


def test_answers_of_a_process_are_judged(scene_dict: dict[str, Any]) -> None:
    judge = judge_of(scene_dict)
    path = [[1, 1, 0], [9, 9, 0]]
    answer = {"exact": True, "prepare_seconds": 0.5, "seconds": 0.25, "checks": 5, "path": path}
    run = sampler_run("PRM", 3, answer, judge)
    assert (run.soundness, run.seconds, run.checks) == ("collides", 0.25, 5)
    assert run.total_seconds == 0.75
    assert run.length == pytest.approx(8 * math.sqrt(2))
    run = sampler_run("PRM", 3, {"exact": False, "seconds": 10.0}, judge)
    assert (run.soundness, run.seconds, run.total_seconds) == ("", math.inf, math.inf)
    assert sampler_run("PRM", 3, {"error": "crashed"}, judge).error == "crashed"


def test_ours_is_timed_from_the_core_to_the_answer_and_the_certificate_apart(
    scene_dict: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each stage takes a known time on a clock of the test's own, which nothing else moves."""
    judge = judge_of(scene_dict)
    now = 0.0

    def lasting(seconds: float, name: str) -> None:
        stage = getattr(compare, name)

        def slow(*arguments: Any) -> Any:
            nonlocal now
            now += seconds
            return stage(*arguments)

        monkeypatch.setattr(compare, name, slow)

    lasting(1.0, "make_core")
    lasting(2.0, "ask")
    lasting(4.0, "make_certificate")
    lasting(8.0, "make_result")
    monkeypatch.setattr(compare, "time", SimpleNamespace(perf_counter=lambda: now))
    run = run_ours(judge.problem, judge, 10.0)
    assert (run.verdict, run.soundness) == ("path", "sound")
    assert (run.seconds, run.certificate_seconds) == (3.0, 4.0)
    assert run.core_seconds > 0


# State check


def test_state_check_counts_bounds_and_arrays(scene_dict: dict[str, Any]) -> None:
    check = judge_of(scene_dict).check
    places = np.array([[1.0, 1.0, 0.0], [5.0, 5.0, 0.0], [3.5, 5.0, 0.0], [np.nan, 1.0, 0.0]])
    assert check.are_free(places).tolist() == [True, False, False, False]
    assert [check.is_free(*q) for q in places.tolist()] == [True, False, False, False]
    assert check.checks == 8
    assert check.bounds == pytest.approx([0.5, 0.5, 9.5, 9.5])
    assert check.robot_radius == pytest.approx(math.sqrt(0.5))


# Command line


def refusal(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["compare", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert "internal error" not in captured.err
    return captured.err


def test_command_refuses_in_one_line(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert "did you mean 'PRM'" in refusal(capsys, "open", "--planners", "PRN")
    assert "runs must be" in refusal(capsys, "open", "--runs", "0")
    assert "cannot write" in refusal(capsys, "open", "--json", str(tmp_path / "no" / "file.json"))


def test_command_says_how_to_get_ompl(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ompl", None)
    assert INSTALL_HINT in refusal(capsys, "open")
