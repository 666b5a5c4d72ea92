"""`planar-planner completion`: prints a completion script for a shell."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.cli.arguments.shared import DONE, add_command
from planar_planner.cli.completion_script import completion_script
from planar_planner.output_files import emit

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
    completion.add_argument("shell", choices=SHELLS, help="name of the shell")
    completion.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the script."""
    emit(completion_script(arguments.shell, arguments.whole_parser()))
    return 0
