"""OMPL's planners on our scenes, and ours as one of OMPL's. Skipped without the extra ``ompl``.

Each test body that imports OMPL runs in a process of its own: its seed is set once a process, and
nanobind prints a report of leaks at exit.
"""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from planar_planner import load_scene
from planar_planner.cli.main import main
from planar_planner.ompl.compare import Settings, compare
from planar_planner.ompl.samplers import INSTALL_HINT

needs_ompl = pytest.mark.skipif(importlib.util.find_spec("ompl") is None, reason=INSTALL_HINT)

PREAMBLE = """
import json, math, sys, time
from planar_planner.ompl import CompletePlanner, make_sampler, set_up, waypoints_of
from planar_planner.ompl.setup import base
from planar_planner.ompl.samplers import SAMPLERS, import_ompl
import_ompl("util").setLogLevel(import_ompl("util").LogLevel.LOG_NONE)

def ask(scene, limit=20.0, definition=None, **options):
    setup = set_up(scene)
    planner = CompletePlanner(setup.information, scene, **options)
    definition = definition(setup) if definition else setup.problem_definition()
    planner.setProblemDefinition(definition)
    planner.setup()
    status = planner.solve(limit).getStatus().name
    return setup, planner, definition, status
"""


def in_a_process(body: str) -> str:
    done = subprocess.run(
        [sys.executable, "-P", "-c", PREAMBLE + textwrap.dedent(body)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


@needs_ompl
@pytest.mark.parametrize("scene", ["bug-trap", "slide", "open"])
def test_a_path_is_handed_over_exact_and_sound(scene: str) -> None:
    """`slide` does not turn (a plane of states), `open` is one segment that turns."""
    in_a_process(
        f"""
        setup, planner, definition, status = ask({scene!r})
        assert status == "EXACT_SOLUTION", status
        assert definition.hasExactSolution() and not definition.hasApproximateSolution()
        path = definition.getSolutionPath()
        assert path.check()
        q = waypoints_of(path, setup.problem.start[2], turning=setup.problem.rotation)
        assert setup.judge.path(q) == "sound"
        assert tuple(q[0, :2]) == setup.problem.start[:2]
        assert tuple(q[-1, :2]) == setup.problem.goal[:2]
        assert definition.getGoal().isSatisfied(path.getState(path.getStateCount() - 1))
        assert planner.certificate["verdict"] == "path"
        """
    )


@needs_ompl
@pytest.mark.parametrize("scene", ["bug-trap-closed", "slide-blocked"])
def test_absence_is_infeasible_with_its_certificate(scene: str) -> None:
    in_a_process(
        f"""
        setup, planner, definition, status = ask({scene!r})
        assert status == "INFEASIBLE", status
        assert not definition.hasSolution()
        assert planner.certificate["verdict"] == "no_path"
        assert planner.certificates == [planner.certificate]
        planner.clear()
        assert planner.certificate is None and planner.results == []
        """
    )


@needs_ompl
def test_limits_are_heeded() -> None:
    in_a_process(
        """
        for limit in (0.02, base.timedPlannerTerminationCondition(0.02), lambda: True):
            began = time.monotonic()
            setup, planner, definition, status = ask("maze-blocked", limit)
            assert status == "TIMEOUT", (status, limit)
            assert time.monotonic() - began < 5
            assert not definition.hasSolution() and planner.certificate is None
        """
    )


@needs_ompl
def test_several_starts_and_goals_and_invalid_ones() -> None:
    in_a_process(
        """
        def several(setup):
            goals = base.GoalStates(setup.information)
            goals.addState(setup.state(setup.problem.goal))
            goals.addState(setup.state(setup.problem.start))
            definition = base.ProblemDefinition(setup.information)
            definition.setGoal(goals)
            definition.addStartState(setup.state(setup.problem.start))
            return definition
        _, planner, _, status = ask("bug-trap-closed", definition=several)
        assert status == "EXACT_SOLUTION", status
        assert [result.verdict for result in planner.results] == ["no_path", "path"]

        def wide(setup):
            definition = setup.problem_definition()
            definition.getGoal().setThreshold(0.5)
            return definition
        assert ask("bug-trap-closed", definition=wide)[3] == "UNKNOWN"

        def nowhere(end):
            def make(setup):
                box = setup.judge.check.bounds
                ends = {"start": setup.problem.start, "goal": setup.problem.goal}
                ends[end] = (box[0] - 10.0, box[1] - 10.0, 0.0)
                definition = base.ProblemDefinition(setup.information)
                states = []
                for q in ends.values():
                    state = setup.information.getStateSpace().allocState()
                    state.setXY(q[0], q[1]); state.setYaw(q[2])
                    states.append(state)
                definition.setStartAndGoalStates(*states)
                return definition
            return make
        assert ask("open", definition=nowhere("start"))[3] == "INVALID_START"
        assert ask("open", definition=nowhere("goal"))[3] == "INVALID_GOAL"

        def region(setup):
            definition = setup.problem_definition()
            definition.setGoal(base.GoalSpace(setup.information))
            return definition
        assert ask("open", definition=region)[3] == "UNRECOGNIZED_GOAL_TYPE"
        """
    )


@needs_ompl
def test_narrow_bounds_of_the_space_hold_and_other_spaces_are_refused() -> None:
    in_a_process(
        """
        setup = set_up("bug-trap")
        x, y = setup.problem.start[:2]
        space = base.SE2StateSpace()
        bounds = base.RealVectorBounds(2)
        for k, value in ((0, x), (1, y)):
            bounds.setLow(k, value - 1e-3)
            bounds.setHigh(k, value + 1e-3)
        space.setBounds(bounds)
        information = base.SpaceInformation(space)
        information.setStateValidityChecker(lambda state: True)
        information.setup()
        planner = CompletePlanner(information, "bug-trap")
        assert planner._planner.problem.reference_bounds == (x - 1e-3, y - 1e-3, x + 1e-3, y + 1e-3)
        dubins = base.SpaceInformation(base.DubinsStateSpace())
        try:
            CompletePlanner(dubins, "bug-trap")
        except TypeError as error:
            assert "SE2StateSpace" in str(error)
        else:
            raise AssertionError("a car is not refused")
        """
    )


@needs_ompl
def test_ours_works_inside_simple_setup() -> None:
    in_a_process(
        """
        geometric = import_ompl("geometric")
        setup = set_up("bug-trap")
        simple = geometric.SimpleSetup(setup.information)
        simple.setStartAndGoalStates(
            setup.state(setup.problem.start), setup.state(setup.problem.goal)
        )
        simple.setPlanner(CompletePlanner(setup.information, "bug-trap"))
        assert simple.solve(20.0).getStatus().name == "EXACT_SOLUTION"
        assert simple.haveExactSolutionPath()
        """
    )


@needs_ompl
def test_every_known_planner_is_bound() -> None:
    in_a_process(
        """
        import os
        setup = set_up("open")
        made = [make_sampler(name.lower(), setup.information) for name in SAMPLERS]
        assert [type(planner).__name__ for planner in made] == list(SAMPLERS)
        os._exit(0)  # OMPL's AORRTC crashes when it is destroyed before it had a problem
        """
    )


@needs_ompl
def test_the_same_seed_repeats_a_run() -> None:
    settings = Settings(planners=("RRTConnect",), runs=2, timeout=5.0)
    first, second = compare("window", settings), compare("window", settings)
    runs = [first.samplers["RRTConnect"], second.samplers["RRTConnect"]]
    assert [run.checks for run in runs[0]] == [run.checks for run in runs[1]]
    assert runs[0][0].checks != runs[0][1].checks
    for run in runs[0]:
        assert run.exact
        assert run.error == ""
        assert run.soundness in ("sound", "collides")
        assert run.length > 0
        assert run.seconds > 0
        assert run.prepare_seconds > 0
        assert run.check_ns > run.native_check_ns > 0


@needs_ompl
def test_command_prints_table_and_writes_json_and_picture(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    json_file, picture = tmp_path / "runs.json", tmp_path / "times.png"
    common = ("--planners", "RRTConnect", "--runs", "2", "--timeout", "0.3")
    files = ("--json", str(json_file), "--plot", str(picture))
    assert main(["compare", "open", "slide-blocked", *common, *files]) == 0
    text = capsys.readouterr().out
    assert "the samplers ran to the limit without an answer" in text
    content = json.loads(json_file.read_text(encoding="utf-8"))
    assert [each["scene"] for each in content["scenes"]] == ["open", "slide-blocked"]
    assert picture.stat().st_size > 10_000


@needs_ompl
def test_a_scene_that_is_wrong_is_refused_before_any_run(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    content = load_scene("open").to_dict()
    content["start"] = [1e6, 0.0, 0.0]
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    assert main(["compare", "open", str(file)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "start" in captured.err
