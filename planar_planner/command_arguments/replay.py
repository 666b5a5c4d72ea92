"""Arguments of `planar-planner replay`."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.limits import add_limits
from planar_planner.command_arguments.shared import (
    FILM_SUFFIXES,
    add_command,
    add_json,
    add_scene,
    file_of,
    real_number,
    whole_number,
)

PUSHES: Mapping[str, float] = {"seconds": 20.0, "tries": 4, "seed": 0}
"""Defaults of the options that only pushing has."""


def add(commands: Any) -> None:
    """Add the command."""
    replay = add_command(
        commands,
        "replay",
        "let the Chipmunk physics engine witness a path, or try where there is none",
        examples=(
            "replay gear",
            "solve gear --json result.json",
            "replay gear --path result.json",
            "replay gear-jammed --push --seconds 2 --seed 1 --save push.gif",
        ),
        status="0 witnessed, 1 contradicted, 2 bad input or usage, 3 undecided",
    )
    add_scene(replay)
    add_importing(replay)
    replay.add_argument(
        "--path", metavar="FILE", type=Path, help="replay this, as solve --json writes it"
    )
    replay.add_argument(
        "--step",
        metavar="LENGTH",
        type=real_number,
        help="most travel between two looks (default: 1/256 of the robot's reach)",
    )
    replay.add_argument(
        "--save",
        metavar="FILE",
        type=file_of(FILM_SUFFIXES),
        help=f"write a film: {', '.join(FILM_SUFFIXES)}",
    )
    add_json(replay, "the finding")
    replay.add_argument("--quiet", action="store_true", help="no numbers, only the finding")
    pushing = replay.add_argument_group("pushing")
    pushing.add_argument(
        "--push", action="store_true", help="no path: let random forces drive the robot"
    )
    for name, metavar, kind, what in (
        ("seconds", "SECONDS", real_number, "simulated time of a try"),
        ("tries", "N", whole_number, "robots, one after the other"),
        ("seed", "N", whole_number, "of the pushes"),
    ):
        pushing.add_argument(
            f"--{name}",
            metavar=metavar,
            type=kind,
            help=f"{what} (default: {PUSHES[name]})",
        )
    add_limits(replay)
    replay.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.replay import run

    return run(arguments)
