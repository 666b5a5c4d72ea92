"""`planar-planner margin`: computes how far the robot can grow, or must shrink."""

from __future__ import annotations

import argparse
import sys
from typing import Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.limits import add_limits, options_of
from planar_planner.cli.arguments.shared import (
    add_command,
    add_json,
    add_plot,
    add_scene,
    real_number,
)
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.cli.terminal import VERDICT_STYLES, styled
from planar_planner.margins.text import margin_details, margin_headline
from planar_planner.output_files import check_writable, complain, emit, written_aside

_STATUS = (
    "0 a path exists for the robot as it is, 1 only for a smaller one,\n"
    "  2 bad input or usage, 3 a limit was reached first"
)

EXIT_STATUS = {"path": 0, "no_path": 1}
LIMIT_REACHED = 3


def add(commands: Any) -> None:
    """Add the command."""
    margin = add_command(
        commands,
        "margin",
        "compute how far the robot can grow, or must shrink, and where it is narrowest",
        examples=(
            "margin slot",
            "margin corner-too-long --width 1e-4 --plot narrow.png",
            "margin corner --by scale --about centroid --json margin.json",
        ),
        status=_STATUS,
    )
    add_scene(margin)
    add_importing(margin)
    margin.add_argument(
        "--by",
        choices=("offset", "scale"),
        default="offset",
        help="grow the robot by a distance on all sides, or scale it (default: offset)",
    )
    margin.add_argument(
        "--about",
        choices=("reference", "centroid"),
        default="reference",
        help="fixed point of the scaling (default: reference)",
    )
    margin.add_argument(
        "--width",
        type=real_number,
        metavar="LENGTH",
        help="greatest width of the answer's bracket: a length in the scene's unit, or a factor "
        "(default: 1/1000 of half the robot's diagonal, or 1/1000)",
    )
    add_json(margin, "the margin")
    add_plot(margin, "draw the scene and its narrow place")
    margin.add_argument("--quiet", action="store_true", help="print one line and no progress")
    add_limits(margin)
    margin.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Bracket the margin, then report it as text, JSON and picture."""
    options = options_of(arguments)
    output = json_output(arguments.json)
    if arguments.plot is not None:
        check_writable(arguments.plot)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    from planar_planner.margins.find import margin  # only now: a misspelt name is answered at once

    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        found = margin(
            scene,
            options,
            by=arguments.by,
            about=arguments.about,
            width=arguments.width,
            listener=progress,
        )
    status = EXIT_STATUS[found.verdict] if found.decided else LIMIT_REACHED
    arguments.stated.status = status
    if not output.to_stdout:
        style = VERDICT_STYLES[found.verdict]
        emit(margin_headline(found, lambda verdict: styled(verdict, style, sys.stdout)))
        if not arguments.quiet:
            emit(margin_details(found))
    output.write(found.to_json())
    if found.imported.holds_for:
        side = "lower" if found.imported.holds_for == "path" else "upper"
        complain(
            f"curves were flattened to one side: only the {side} number is also proven for the "
            "curves of the drawing"
        )
    if arguments.plot is not None:
        from planar_planner.pictures.margin import draw_margin
        from planar_planner.pictures.style import save_picture

        figure = draw_margin(scene, found)
        with written_aside(arguments.plot) as aside:
            save_picture(figure, aside, arguments.plot.suffix)
    return status
