"""Arguments of `planar-planner convert`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.shared import DONE, add_command, add_json, add_scene


def add(commands: Any) -> None:
    """Add the command."""
    convert = add_command(
        commands,
        "convert",
        "turn a file in an outside format into a scene file, or back",
        examples=(
            "convert corner corner.svg",
            "convert corner.svg corner.json --flatten inwards --tolerance 0.01",
            "convert gear gear.dxf",
        ),
        status=DONE,
    )
    add_scene(convert)
    convert.add_argument(
        "out",
        metavar="OUT",
        type=Path,
        help="file to write: .json for a scene; .geojson, .wkt, .svg, .dxf, .csv, .txt (with .rob)",
    )
    add_importing(convert)
    add_json(convert, "what was written and repaired")
    convert.add_argument("--quiet", action="store_true", help="do not tell what was repaired")
    convert.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.convert import run

    return run(arguments)
