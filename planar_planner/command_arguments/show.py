"""Arguments of `planar-planner show`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.shared import DONE, add_command, add_json, add_plot, add_scene


def add(commands: Any) -> None:
    """Add the command."""
    show = add_command(
        commands,
        "show",
        "describe a scene, and draw it, without solving it",
        examples=("show gear", "show maze --plot maze.png", "show gear --json -"),
        status=DONE,
    )
    add_scene(show)
    add_importing(show)
    add_json(show, "the description")
    add_plot(show, "draw the scene")
    show.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.show import run

    return run(arguments)
