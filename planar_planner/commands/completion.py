"""`planar-planner completion`: a script for the shell."""

from __future__ import annotations

import argparse

from planar_planner.completion_script import completion_script
from planar_planner.output import emit


def run(arguments: argparse.Namespace) -> int:
    """Print the script."""
    emit(completion_script(arguments.shell))
    return 0
