"""Arguments of `planar-planner solve`."""

from __future__ import annotations

from typing import Any

from planar_planner.command_arguments.query import add_query, run
from planar_planner.command_arguments.shared import VERDICTS, add_command, add_plot


def add(commands: Any) -> None:
    """Add the command."""
    solve = add_command(
        commands,
        "solve",
        "find a path, or prove that there is none",
        examples=(
            "solve gear --plot gear.png",
            "solve corner --start 2.5,0.5,0 --goal 0.5,2.5,-1.5708 --json result.json",
            "solve gear-jammed --certificate jammed.json.gz",
            "solve corner --json - --quiet",
        ),
        status=VERDICTS,
    )
    add_query(solve)
    add_plot(solve, "draw the scene and the result")
    solve.set_defaults(run=run, verdict_only=False)
