"""Arguments of `planar-planner animate`."""

from __future__ import annotations

import argparse
import re
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.limits import add_limits
from planar_planner.command_arguments.shared import (
    FILM_SUFFIXES,
    VERDICTS,
    add_command,
    add_json,
    add_scene,
    file_of,
    real_number,
)

ANIMATION_SUFFIXES = (*FILM_SUFFIXES, ".html")


def add(commands: Any) -> None:
    """Add the command."""
    animate = add_command(
        commands,
        "animate",
        "solve a scene and write the robot's motion as a film or as a page",
        examples=(
            "animate gear gear.html",
            "animate gear gear.gif --seconds 2 --fps 8 --size 320x320",
            "animate slot slot.mp4 --speed 5 --fps 10",
            "animate gear-jammed wall.html",
        ),
        status=VERDICTS,
    )
    add_scene(animate)
    animate.add_argument(
        "out",
        metavar="OUT",
        type=file_of(ANIMATION_SUFFIXES),
        help=f"file to write: {', '.join(ANIMATION_SUFFIXES)}",
    )
    add_importing(animate)
    add_json(animate, "the result")
    pace = animate.add_argument_group("pace and size")
    how_long = pace.add_mutually_exclusive_group()
    how_long.add_argument(
        "--speed",
        type=real_number,
        metavar="LENGTH",
        help="travel a second, in scene units; of a sweep through angles, radians a second",
    )
    how_long.add_argument(
        "--seconds", type=real_number, metavar="SECONDS", help="from start to goal (default: 10)"
    )
    pace.add_argument(
        "--fps",
        type=real_number,
        metavar="N",
        default=25.0,
        help="frames a second of a film; a page draws as often as the screen (default: 25)",
    )
    pace.add_argument(
        "--hold",
        type=real_number,
        metavar="SECONDS",
        default=1.0,
        help="how long a film stands still at start and goal (default: 1)",
    )
    pace.add_argument(
        "--size",
        type=_size,
        metavar="WIDTHxHEIGHT",
        help="pixels of a film (default: 800x600); the most that a page's views take of its window",
    )
    animate.add_argument(
        "--quiet", action="store_true", help="no statistics and no progress, only the verdict"
    )
    add_limits(animate)
    animate.set_defaults(run=_run)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,6})[x×](\d{1,6})", text.strip(), re.IGNORECASE | re.ASCII)
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 800x600")
    return int(match[1]), int(match[2])


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.animate import run

    return run(arguments)
