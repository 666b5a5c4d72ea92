"""Arguments of `planar-planner margin`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.limits import add_limits
from planar_planner.command_arguments.shared import (
    add_command,
    add_json,
    add_plot,
    add_scene,
    real_number,
)

_STATUS = (
    "0 a path remains for the robot as it is, 1 only for a smaller one,\n"
    "  2 bad input or usage, 3 a limit was reached first"
)


def add(commands: Any) -> None:
    """Add the command."""
    margin = add_command(
        commands,
        "margin",
        "find out how far the robot can grow, or must shrink, and where it is narrowest",
        examples=(
            "margin slot",
            "margin corner-too-long --within 1e-4 --plot bottleneck.png",
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
        help="grow the robot by a distance all round, or scale it (default: offset)",
    )
    margin.add_argument(
        "--about",
        choices=("reference", "centroid"),
        default="reference",
        help="the point that scaling leaves in place (default: reference)",
    )
    margin.add_argument(
        "--within",
        type=real_number,
        metavar="LENGTH",
        help="how wide the answer's bracket may be: a length in the scene's unit, or a factor "
        "(default: 1/1000 of half the robot's diagonal, or 1/1000)",
    )
    add_json(margin, "the margin")
    add_plot(margin, "draw the scene and its bottleneck")
    margin.add_argument("--quiet", action="store_true", help="one line, and no progress")
    add_limits(margin)
    margin.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.margin import run

    return run(arguments)
