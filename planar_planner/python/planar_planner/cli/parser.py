"""The parser of the whole command line; light to import, since every start imports it."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from planar_planner.cli.arguments.shared import VERDICTS
from planar_planner.cli.build_details import build_details
from planar_planner.cli.command_parser import CommandParser
from planar_planner.output_files import emit

COMMANDS = {  # name → module here, in the order of the help
    "solve": "solve",
    "check": "check",
    "margin": "margin",
    "verify": "verify",
    "replay": "replay",
    "list": "listing",
    "show": "show",
    "animate": "animate",
    "compare": "compare",
    "convert": "convert",
    "completion": "completion",
}

_EXAMPLES = (
    "list",
    "solve gear --plot gear.png",
    "check gear-jammed",
    "solve corner --start 2.5,0.5,0 --goal 0.5,2.5,-1.5708 --json result.json",
    "solve gear --certificate gear.cert.json",
    "verify gear gear.cert.json",
    "margin slot",
    "show maze --plot maze.png",
    "animate slot slot.gif --seconds 2 --fps 10",
    "convert corner corner.svg",
    "solve corner.svg --flatten inwards --tolerance 0.01",
)


class _Version(argparse.Action):
    """Collects the build details only when they are requested."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        emit(build_details())
        parser.exit()


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """Return the arguments; their member ``run`` is the function that executes the command.

    Raises `SystemExit` after a mistake, which it reports in one line, and after help or version.
    """
    named = argv[0] if argv and argv[0] in COMMANDS else None
    arguments: argparse.Namespace = make_parser(named).parse_args(_with_joined_numbers(argv))
    return arguments


def make_parser(command: str | None = None) -> CommandParser:
    """Return the parser of all commands, or of one command alone, which takes less time to make."""
    parser = CommandParser(
        prog="planar-planner",
        description="Complete motion planning for polygonal robots in the plane:\n"
        "a certified path, a proof that there is none, or undecided.",
        examples=_EXAMPLES,
        status=f"{VERDICTS};\n  each command's --help states its own",
    )
    parser.add_argument(
        "--version", action=_Version, nargs=0, help="show the version and build details and exit"
    )
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    parser.set_defaults(whole_parser=make_parser)
    for name in [command] if command else COMMANDS:
        import_module(f"planar_planner.cli.commands.{COMMANDS[name]}").add(commands)
    return parser


_NUMBERS = ("--start", "--goal", "--theta")  # options whose values may begin with a minus


def _with_joined_numbers(argv: Sequence[str]) -> list[str]:
    """Write ``--start -1,2,0`` as ``--start=-1,2,0``; argparse would take -1,2,0 for an option."""
    joined: list[str] = []
    for argument in argv:
        if joined and joined[-1] in _NUMBERS and re.match(r"-[\d.]", argument):
            joined[-1] += f"={argument}"
        else:
            joined.append(argument)
    return joined
