"""`planar-planner animate`: solves a scene and writes the motion as a film or a page."""

from __future__ import annotations

import argparse
import re
import sys
from typing import Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.limits import add_limits, options_of
from planar_planner.cli.arguments.shared import (
    FILM_SUFFIXES,
    VERDICTS,
    add_command,
    add_json,
    add_scene,
    file_of,
    real_number,
)
from planar_planner.cli.commands.solve import EXIT_STATUS, print_verdict, say_one_sided
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.errors import one_line
from planar_planner.films.pace import Pace
from planar_planner.output_files import check_writable, emit, written_aside

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
        help="travel per second, in scene units; for a sweep through angles, radians per second",
    )
    how_long.add_argument(
        "--seconds",
        type=real_number,
        metavar="SECONDS",
        help="time from start to goal (default: 10)",
    )
    pace.add_argument(
        "--fps",
        type=real_number,
        metavar="N",
        default=25.0,
        help="frames per second of a film; a page draws as often as the screen (default: 25)",
    )
    pace.add_argument(
        "--hold",
        type=real_number,
        metavar="SECONDS",
        default=1.0,
        help="time for which a film stands still at start and goal (default: 1)",
    )
    pace.add_argument(
        "--size",
        type=_size,
        metavar="WIDTHxHEIGHT",
        help="pixels of a film (default: 800x600), or the largest size of a page's views",
    )
    animate.add_argument(
        "--quiet", action="store_true", help="print only the verdict, no statistics or progress"
    )
    add_limits(animate)
    animate.set_defaults(run=run)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,6})[x×](\d{1,6})", text.strip(), re.IGNORECASE | re.ASCII)
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 800x600")
    return int(match[1]), int(match[2])


def run(arguments: argparse.Namespace) -> int:
    """Solve and animate. The exit status states the verdict."""
    options = options_of(arguments)
    file = arguments.out
    suffix = file.suffix.lower()
    check_writable(file)
    output = json_output(arguments.json)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    # These imports are slow, so they come after the check of the scene's name.
    from planar_planner.films.canvas import check_size
    from planar_planner.films.film import DEFAULT_SIZE, check_film, write_film
    from planar_planner.films.material import gather
    from planar_planner.films.page import PAGE_SUFFIX, write_page
    from planar_planner.planning.planner import Planner

    pace = Pace(arguments.speed, arguments.seconds, arguments.fps, arguments.hold)
    page = suffix == PAGE_SUFFIX
    size = arguments.size or DEFAULT_SIZE
    if page:
        check_size(size)
    else:
        check_film(suffix, pace, size)
    planner = Planner(scene)
    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        result = planner.solve(options=options, listener=progress)
    arguments.stated.status = EXIT_STATUS[result.verdict]
    if not output.to_stdout:
        print_verdict(result, brief=arguments.quiet)
    say_one_sided(result)
    with Progress(sys.stderr, "drawing", quiet=arguments.quiet):
        material = gather(planner, result, options, cells_needed=page or not len(result.path))
        with written_aside(file) as aside:
            if page:
                write_page(material, aside, pace, arguments.size)
            else:
                write_film(material, aside, suffix=suffix, pace=pace, size=size)
    output.write(result.to_json())
    if not (arguments.quiet or output.to_stdout):
        emit(one_line(f"{file}: {file.stat().st_size:,} bytes"))
    return EXIT_STATUS[result.verdict]
