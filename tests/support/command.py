"""The command line: how to run it in a process of its own, and its parsers."""

from __future__ import annotations

import sys

from planar_planner.cli.command_parser import CommandParser
from planar_planner.cli.parser import make_parser

COMMAND = [sys.executable, "-P", "-m", "planar_planner"]


def parsers() -> dict[str, CommandParser]:
    """Return the parser of every command, and that of the program under the empty name."""
    parser = make_parser()
    (commands,) = (a.choices for a in parser._actions if isinstance(a.choices, dict))
    return {"": parser, **commands}
