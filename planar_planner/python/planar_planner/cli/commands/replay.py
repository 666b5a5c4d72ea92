"""`planar-planner replay`: checks a path in a physics engine, or pushes a robot where none is."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.limits import add_limits, options_of
from planar_planner.cli.arguments.shared import (
    FILM_SUFFIXES,
    add_command,
    add_json,
    add_scene,
    file_of,
    real_number,
    whole_number,
)
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.errors import OptionsError
from planar_planner.output_files import check_writable, emit, written_aside
from planar_planner.planning.result_text import headline

if TYPE_CHECKING:
    from planar_planner.physics import Push
    from planar_planner.planning.result import Result
    from planar_planner.scene.model import Scene

PUSHES: Mapping[str, float] = {"seconds": 20.0, "tries": 4, "seed": 0}
"""Defaults of the options that need --push."""

CONFIRMED, CONTRADICTED, UNDECIDED = 0, 1, 3


def add(commands: Any) -> None:
    """Add the command."""
    replay = add_command(
        commands,
        "replay",
        "replay a path in the physics engine Chipmunk, or push a robot where no path is",
        examples=(
            "replay gear",
            "solve gear --json result.json",
            "replay gear --path result.json",
            "replay gear-jammed --push --seconds 2 --seed 1 --save push.gif",
        ),
        status="0 confirmed, 1 contradicted, 2 bad input or usage, 3 undecided",
    )
    add_scene(replay)
    add_importing(replay)
    replay.add_argument(
        "--path", metavar="FILE", type=Path, help="replay the path in a file from solve --json"
    )
    replay.add_argument(
        "--step",
        metavar="LENGTH",
        type=real_number,
        help="greatest travel between two checks (default: 1/256 of the robot's reach)",
    )
    replay.add_argument(
        "--save",
        metavar="FILE",
        type=file_of(FILM_SUFFIXES),
        help=f"write a film: {', '.join(FILM_SUFFIXES)}",
    )
    add_json(replay, "the finding")
    replay.add_argument("--quiet", action="store_true", help="print only the finding, no numbers")
    pushing = replay.add_argument_group("pushing")
    pushing.add_argument(
        "--push", action="store_true", help="drive the robot by random forces, without a path"
    )
    for name, metavar, kind, what in (
        ("seconds", "SECONDS", real_number, "simulated time of a try"),
        ("tries", "N", whole_number, "number of robots, one after the other"),
        ("seed", "N", whole_number, "seed of the pushes"),
    ):
        pushing.add_argument(
            f"--{name}",
            metavar=metavar,
            type=kind,
            help=f"{what} (default: {PUSHES[name]})",
        )
    add_limits(replay)
    replay.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Replay a path or push a robot, then report."""
    output = json_output(arguments.json)
    if arguments.save is not None:
        check_writable(arguments.save)
    if arguments.push and arguments.path is not None:
        raise OptionsError("--path and --push exclude each other: --push needs no path")
    for name, default in PUSHES.items():
        if getattr(arguments, name) is None:
            setattr(arguments, name, default)
        elif not arguments.push:
            raise OptionsError(f"--{name} needs --push")
    _check_extras(arguments)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    status, text, content = (_push if arguments.push else _replay)(arguments, scene)
    arguments.stated.status = status
    if not output.to_stdout:
        emit(text.partition("\n")[0] if arguments.quiet else text)
    output.write(content | scene.imported.to_json())
    return status


def _check_extras(arguments: argparse.Namespace) -> None:
    """Check before the search that what the command needs is installed."""
    from planar_planner.physics.world import engine

    engine()
    if arguments.save is not None:
        from planar_planner.films.physics import check_save

        check_save(arguments.save.suffix)


def _replay(arguments: argparse.Namespace, scene: Scene) -> tuple[int, str, dict[str, Any]]:
    """Return exit status, text and JSON of a replay, or of the search if it is undecided.

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
            raise OptionsError(
                f"{headline(result)}: there is no path to replay; --push drives a robot instead"
            )
        if result.verdict == "undecided":
            return UNDECIDED, headline(result), result.to_json()
        path = result.path
    from planar_planner.physics import replay
    from planar_planner.physics.text import replay_text
    from planar_planner.problem.make import make_problem

    with Progress(sys.stderr, "replaying", quiet=arguments.quiet):
        problem = make_problem(scene)
        tolerance = arguments.contact_tolerance
        found = replay(problem, path, step=arguments.step, tolerance=tolerance)
        if arguments.save is not None:
            from planar_planner.films.physics import save_replay

            with written_aside(arguments.save) as aside:
                save_replay(problem, found, aside, arguments.save.suffix)
    return CONFIRMED if found.confirmed else CONTRADICTED, replay_text(found), found.to_json()


def _push(arguments: argparse.Namespace, scene: Scene) -> tuple[int, str, dict[str, Any]]:
    """Return exit status, text and JSON of a push."""
    from planar_planner.physics import push
    from planar_planner.physics.text import push_text
    from planar_planner.problem.make import make_problem

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
            from planar_planner.films.physics import save_push

            progress.say("drawing")
            with written_aside(arguments.save) as aside:
                save_push(problem, found, aside, arguments.save.suffix)
    first, _, rest = push_text(found).partition("\n")
    text = f"{first}\n  {headline(result)}\n{rest}"
    return _status(result, found), text, {"verdict": result.verdict} | found.to_json()


def _status(result: Result, found: Push) -> int:
    """Return the exit status, which says whether the push agrees with the verdict."""
    if result.verdict == "undecided" or found.may_have_tunnelled:
        return UNDECIDED
    if result.verdict == "path" or not found.reached:
        return CONFIRMED
    return CONTRADICTED if found.reached_free else UNDECIDED


def _solved(arguments: argparse.Namespace, scene: Scene) -> Result:
    from planar_planner.planning.planner import solve

    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        return solve(scene, options_of(arguments), listener=progress)
