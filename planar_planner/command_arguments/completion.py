"""Arguments of `planar-planner completion`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.shared import DONE, add_command

SHELLS = ("bash", "zsh", "tcsh", "fish")


def add(commands: Any) -> None:
    """Add the command."""
    completion = add_command(
        commands,
        "completion",
        "print a script that completes commands, options, scenes and files in a shell",
        examples=("completion bash", "completion zsh"),
        status=DONE,
    )
    completion.add_argument("shell", choices=SHELLS, help="see docs/command-line.md")
    completion.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.completion import run

    return run(arguments)
