"""`planar-planner animate`: solve, then write the motion as a film or a page."""

from __future__ import annotations

import argparse
import sys

from planar_planner.command_arguments.limits import options_of
from planar_planner.commands.scene_input import scene_of
from planar_planner.commands.solve import EXIT_STATUS, one_sided, print_verdict
from planar_planner.errors import one_line
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, complain, emit, written_aside
from planar_planner.progress import Progress


def run(arguments: argparse.Namespace) -> int:
    """Solve and animate. The exit status is the verdict."""
    from planar_planner.animation.pace import Pace

    options = options_of(arguments)
    pace = Pace(arguments.speed, arguments.seconds, arguments.fps, arguments.hold)
    file = arguments.out
    suffix = file.suffix.lower()
    check_writable(file)
    output = json_output(arguments.json)
    from planar_planner.animation.film import DEFAULT_SIZE, check_film

    size = arguments.size or DEFAULT_SIZE
    check_film(suffix, pace, size)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    from planar_planner.planner import Planner

    planner = Planner(scene)
    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        result = planner.solve(options=options, listener=progress)
    if not output.to_stdout:
        print_verdict(result, brief=arguments.quiet)
    if scene.holds_for and result.verdict not in (scene.holds_for, "undecided"):
        complain(one_sided(scene.holds_for))
    from planar_planner.animation.film import write_film
    from planar_planner.animation.material import gather

    with Progress(sys.stderr, "drawing", quiet=arguments.quiet):
        material = gather(planner, result, options, cells_needed=not len(result.path))
        with written_aside(file) as aside:
            write_film(material, aside, suffix=suffix, pace=pace, size=size)
    output.write(result.to_json())
    if not (arguments.quiet or output.to_stdout):
        emit(one_line(f"{file}: {file.stat().st_size:,} bytes"))
    return EXIT_STATUS[result.verdict]
