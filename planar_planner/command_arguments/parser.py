"""The whole command line's parser; light to import, since every start of the program pays."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from typing import Any

from planar_planner.command_arguments import (
    check,
    compare,
    convert,
    listing,
    show,
    solve,
    verify,
)

_COMMANDS = (solve, check, verify, listing, show, compare, convert)  # as help lists them

_EXAMPLES = """\
examples:
  planar-planner solve gear --plot gear.png
  planar-planner check gear-jammed
  planar-planner solve my_scene.json --start 1,2,0 --goal 8,2,1.5708 --json result.json
  planar-planner solve gear --certificate gear.cert.json
  planar-planner verify gear gear.cert.json
  planar-planner list
  planar-planner show maze --plot maze.png
  planar-planner convert map.yaml scene.json --robot robot.wkt --start 1,1,0 --goal 8,5,0
  planar-planner solve drawing.svg --flatten inwards --tolerance 0.01

exit status: 0 path, 1 no path (proven), 2 bad input or usage, 3 undecided
of verify:   0 valid, 1 rejected, 2 unreadable"""


class _Version(argparse.Action):
    """Look the version up only when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        import planar_planner

        parser.exit(message=f"planar-planner {planar_planner.__version__}\n")


def make_parser() -> argparse.ArgumentParser:
    """Return the parser; each command sets ``run``, a function of the parsed arguments."""
    parser = argparse.ArgumentParser(
        prog="planar-planner",
        description="Complete motion planning for polygonal robots in the plane: a certified path, "
        "a proof that there is none, or an honest undecided.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="show the version and exit")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in _COMMANDS:
        command.add(commands)
    return parser


def with_joined_numbers(argv: Sequence[str]) -> list[str]:
    """Write ``--start -1,2,0`` as ``--start=-1,2,0``, which argparse would take for an option."""
    joined: list[str] = []
    for argument in argv:
        if joined and joined[-1] in ("--start", "--goal") and re.match(r"-[\d.]", argument):
            joined[-1] += f"={argument}"
        else:
            joined.append(argument)
    return joined
