"""`planar-planner replay`: an outside witness for a path, or a robot that tries where none is."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

from planar_planner.command_arguments.limits import options_of
from planar_planner.command_arguments.replay import PUSHES
from planar_planner.commands.scene_input import scene_of
from planar_planner.errors import OptionsError
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, emit, written_aside
from planar_planner.progress import Progress
from planar_planner.report import headline

if TYPE_CHECKING:
    from planar_planner.physics import Push
    from planar_planner.result import Result
    from planar_planner.scene import Scene

WITNESSED, CONTRADICTED, UNDECIDED = 0, 1, 3


def run(arguments: argparse.Namespace) -> int:
    """Replay a path or push a robot, then report."""
    output = json_output(arguments.json)
    if arguments.save is not None:
        check_writable(arguments.save)
    if arguments.push and arguments.path is not None:
        raise OptionsError("--path is for a replay, --push drives without one")
    for name, default in PUSHES.items():
        if getattr(arguments, name) is None:
            setattr(arguments, name, default)
        elif not arguments.push:
            raise OptionsError(f"--{name} is for --push")
    _check_extras(arguments)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    status, text, content = (_push if arguments.push else _replay)(arguments, scene)
    if not output.to_stdout:
        emit(text.partition("\n")[0] if arguments.quiet else text)
    output.write(content)
    return status


def _check_extras(arguments: argparse.Namespace) -> None:
    """Find out before the search what is not installed."""
    from planar_planner.physics.world import engine

    engine()
    if arguments.save is not None:
        from planar_planner.physics.film import check_save

        check_save(arguments.save.suffix)


def _replay(arguments: argparse.Namespace, scene: Scene) -> tuple[int, str, dict[str, Any]]:
    """Return exit status, text and JSON of a replay; of the search, if that is undecided.

    Raises
    ------
    OptionsError
        If there is no path to replay.
    """
    if arguments.path is not None:
        from planar_planner.physics.path_file import read_path

        path = read_path(arguments.path)
    else:
        result = _solved(arguments, scene)
        if result.verdict == "no_path":
            raise OptionsError(f"{headline(result)}: nothing to replay; --push lets a robot try")
        if result.verdict == "undecided":
            return UNDECIDED, headline(result), result.to_json()
        path = result.path
    from planar_planner.physics import replay
    from planar_planner.physics.text import replay_text
    from planar_planner.problem import make_problem

    with Progress(sys.stderr, "replaying", quiet=arguments.quiet):
        problem = make_problem(scene)
        tolerance = arguments.contact_tolerance
        found = replay(problem, path, step=arguments.step, tolerance=tolerance)
        if arguments.save is not None:
            from planar_planner.physics.film import save_replay

            with written_aside(arguments.save) as aside:
                save_replay(problem, found, aside, arguments.save.suffix)
    return WITNESSED if found.witnessed else CONTRADICTED, replay_text(found), found.to_json()


def _push(arguments: argparse.Namespace, scene: Scene) -> tuple[int, str, dict[str, Any]]:
    """Return exit status, text and JSON of a push."""
    from planar_planner.physics import push
    from planar_planner.physics.text import push_text
    from planar_planner.problem import make_problem

    result = _solved(arguments, scene)
    with Progress(sys.stderr, "pushing", quiet=arguments.quiet) as progress:

        def listen(number: int, seconds: float) -> None:
            progress.say(f"try {number}: {seconds:.0f} of {arguments.seconds:g} simulated seconds")

        problem = make_problem(scene)
        found = push(
            problem,
            seconds=arguments.seconds,
            tries=arguments.tries,
            seed=arguments.seed,
            listener=listen,
        )
        if arguments.save is not None:
            from planar_planner.physics.film import save_push

            progress.say("drawing")
            with written_aside(arguments.save) as aside:
                save_push(problem, found, aside, arguments.save.suffix)
    first, _, rest = push_text(found).partition("\n")
    text = f"{first}\n  {headline(result)}\n{rest}"
    return _status(result, found), text, {"verdict": result.verdict} | found.to_json()


def _status(result: Result, found: Push) -> int:
    """Return whether the push agrees with the verdict."""
    if result.verdict == "undecided" or found.may_have_tunnelled:
        return UNDECIDED
    if result.verdict == "path" or not found.reached:
        return WITNESSED
    return CONTRADICTED if found.reached_free else UNDECIDED


def _solved(arguments: argparse.Namespace, scene: Scene) -> Result:
    from planar_planner.planner import solve

    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        return solve(scene, options_of(arguments), listener=progress)
