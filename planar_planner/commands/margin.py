"""`planar-planner margin`: how far the robot can grow, or must shrink."""

from __future__ import annotations

import argparse
import sys

from planar_planner.command_arguments.limits import options_of
from planar_planner.commands.scene_input import scene_of
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, complain, emit, written_aside
from planar_planner.progress import Progress
from planar_planner.terminal import VERDICT_STYLES, styled

EXIT_STATUS = {"path": 0, "no_path": 1}
LIMIT_REACHED = 3


def run(arguments: argparse.Namespace) -> int:
    """Bracket the margin, then report: text, JSON, picture."""
    options = options_of(arguments)
    output = json_output(arguments.json)
    if arguments.plot is not None:
        check_writable(arguments.plot)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    from planar_planner.margins.find import margin  # only now: a misspelt name is answered at once
    from planar_planner.margins.text import margin_details, margin_headline

    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        found = margin(
            scene,
            options,
            by=arguments.by,
            about=arguments.about,
            tolerance=arguments.within,
            listener=progress,
        )
    if not output.to_stdout:
        style = VERDICT_STYLES[found.verdict]
        emit(margin_headline(found, lambda verdict: styled(verdict, style, sys.stdout)))
        if not arguments.quiet:
            emit(margin_details(found))
    output.write(found.to_json())
    if scene.holds_for:
        side = "lower" if scene.holds_for == "path" else "upper"
        complain(f"curves were flattened one way: only the {side} end holds for the drawing itself")
    if arguments.plot is not None:
        from planar_planner.margins.picture import draw_margin
        from planar_planner.plot import save_picture

        figure = draw_margin(scene, found)
        with written_aside(arguments.plot) as aside:
            save_picture(figure, aside, arguments.plot.suffix)
    return EXIT_STATUS[found.verdict] if found.decided else LIMIT_REACHED
