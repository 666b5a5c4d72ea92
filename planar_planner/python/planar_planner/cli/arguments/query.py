"""Arguments of the commands that decide a query: solve and check; light to import."""

from __future__ import annotations

import argparse

from planar_planner.cli.arguments.importing import add_importing
from planar_planner.cli.arguments.limits import add_limits
from planar_planner.cli.arguments.shared import add_json, add_scene, output_file


def add_query(command: argparse.ArgumentParser) -> None:
    """Add what a query is, its limits, and what to write of its answer."""
    add_scene(command)
    add_importing(command)
    add_json(command, "the result")
    command.add_argument(
        "--certificate",
        metavar="FILE",
        type=output_file,
        help="write the evidence for the answer, compressed if the name ends in .gz; see verify",
    )
    command.add_argument(
        "--quiet", action="store_true", help="no statistics and no progress, only the verdict"
    )
    add_limits(command)
