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
    options = options_of(arguments)
    file = arguments.out
    suffix = file.suffix.lower()
    check_writable(file)
    output = json_output(arguments.json)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    # Heavy, so only now: a misspelt name is answered at once.
    from planar_planner.animation.canvas import check_size
    from planar_planner.animation.film import DEFAULT_SIZE, check_film, write_film
    from planar_planner.animation.material import gather
    from planar_planner.animation.pace import Pace
    from planar_planner.animation.page import PAGE_SUFFIX, write_page
    from planar_planner.planner import Planner

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
    if not output.to_stdout:
        print_verdict(result, brief=arguments.quiet)
    if scene.holds_for and result.verdict not in (scene.holds_for, "undecided"):
        complain(one_sided(scene.holds_for))
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
