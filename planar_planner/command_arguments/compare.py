"""Arguments of `planar-planner compare`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.shared import (
    DONE,
    add_command,
    add_json,
    add_plot,
    real_number,
    whole_number,
)
from planar_planner.samplers import DEFAULT_SAMPLERS


def add(commands: Any) -> None:
    """Add the command."""
    compare = add_command(
        commands,
        "compare",
        "compare with OMPL's planners in one run; needs the extra [ompl]",
        examples=(
            "compare slot --runs 3 --limit 2",
            "compare corner slot --planners RRTConnect,PRM --runs 3 --limit 2 --plot times.svg",
        ),
        status=DONE,
    )
    compare.add_argument(
        "scenes",
        metavar="SCENE",
        nargs="+",
        help="built-in names (see list) or files: scenes or outside formats",
    )
    compare.add_argument(
        "--planners",
        metavar="A,B,…",
        default=",".join(DEFAULT_SAMPLERS),
        help="OMPL's planners by name (default: %(default)s)",
    )
    for name, metavar, kind, default, what in (
        ("runs", "N", whole_number, 11, "runs of each planner"),
        ("limit", "SECONDS", real_number, 10.0, "time of a run"),
        ("resolution", "FRACTION", real_number, 0.002, "of OMPL's motion validation"),
        ("seed", "N", whole_number, 0, "run i (from 0) of a planner has the seed N + i + 1"),
    ):
        compare.add_argument(
            f"--{name}",
            metavar=metavar,
            type=kind,
            default=default,
            help=f"{what} (default: %(default)s)",
        )
    add_json(compare, "all runs")
    add_importing(compare)
    add_plot(compare, "draw times to the first solution")
    compare.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.compare import run

    return run(arguments)
