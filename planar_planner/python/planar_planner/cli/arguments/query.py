"""Arguments of solve and check, the commands that decide a query; light to import."""

from __future__ import annotations

import argparse

from planar_planner.cli.arguments.importing import add_importing
from planar_planner.cli.arguments.limits import add_limits
from planar_planner.cli.arguments.shared import add_json, add_scene, output_file


def add_query(command: argparse.ArgumentParser) -> None:
    """Add the query, its limits, and the files to write."""
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
        "--quiet", action="store_true", help="print only the verdict, no statistics or progress"
    )
    add_limits(command)
