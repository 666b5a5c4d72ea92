"""`planar-planner check`: decides a query and prints only the verdict."""

from __future__ import annotations

from typing import Any

from planar_planner.cli.arguments.query import add_query
from planar_planner.cli.arguments.shared import VERDICTS, add_command
from planar_planner.cli.commands.solve import run


def add(commands: Any) -> None:
    """Add the command."""
    check = add_command(
        commands,
        "check",
        "like solve, but print only the verdict",
        examples=(
            "check gear",
            "check gear-jammed --quiet",
            "check maze --timeout 1 --max-memory 512M --json verdict.json",
        ),
        status=VERDICTS,
    )
    add_query(check)
    check.set_defaults(run=run, plot=None, view=None, theta=None, verdict_only=True)
