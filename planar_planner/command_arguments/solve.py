"""Arguments of `planar-planner solve`."""

from __future__ import annotations

from typing import Any

from planar_planner.command_arguments.query import add_query, run
from planar_planner.command_arguments.shared import VERDICTS, add_command, add_plot
from planar_planner.command_arguments.view import add_view


def add(commands: Any) -> None:
    """Add the command."""
    solve = add_command(
        commands,
        "solve",
        "find a path, or prove that there is none",
        examples=(
            "solve gear --plot gear.png",
            "solve gear --plot slices.svg --view slices --theta 0,30deg,60deg",
            "solve bug-trap-closed --plot why.png --view wall",
            "solve corner --start 2.5,0.5,0 --goal 0.5,2.5,-1.5708 --json result.json",
            "solve gear-jammed --certificate jammed.json.gz",
            "solve corner --json - --quiet",
        ),
        status=VERDICTS,
    )
    add_query(solve)
    add_plot(solve, "draw the scene and the result")
    add_view(solve)
    solve.set_defaults(run=run, verdict_only=False)
