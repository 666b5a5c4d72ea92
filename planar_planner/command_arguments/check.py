"""Arguments of `planar-planner check`."""

from __future__ import annotations

from typing import Any

from planar_planner.command_arguments.query import add_query, run
from planar_planner.command_arguments.shared import add_command


def add(commands: Any) -> None:
    """Add the command."""
    check = add_command(commands, "check", "like solve, but print only the verdict")
    add_query(check)
    check.set_defaults(run=run, plot=None, verdict_only=True)
