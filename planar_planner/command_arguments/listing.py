"""Arguments of `planar-planner list`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.shared import DONE, add_command, add_json


def add(commands: Any) -> None:
    """Add the command."""
    listing = add_command(
        commands,
        "list",
        "list the built-in scenes with size, expected verdict and origin",
        examples=("list", "list --json scenes.json"),
        status=DONE,
    )
    add_json(listing, "the list")
    listing.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.listing import run

    return run(arguments)
