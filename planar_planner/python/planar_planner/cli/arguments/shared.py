"""Arguments that several commands share; light to import."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from planar_planner.cli.command_parser import CommandParser
from planar_planner.scene.fields import radians_of

PLOT_SUFFIXES = (".png", ".svg", ".pdf")
FILM_SUFFIXES = (".gif", ".mp4")

DONE = "0 done, 2 bad input or usage"
VERDICTS = "0 path, 1 no path (proven), 2 bad input or usage, 3 undecided"

_UNITS = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}


def add_command(
    commands: Any, name: str, summary: str, *, examples: Sequence[str], status: str
) -> CommandParser:
    """Add a command and return its parser.

    Parameters
    ----------
    commands : what `argparse.ArgumentParser.add_subparsers` returns
    name : str
        As the user types it.
    summary : str
        One line: what the command does.
    examples : sequence of str
        Command lines without the program's name, shown in the command's help; see `CommandParser`.
    status : str
        What the exit statuses mean.
    """
    command: CommandParser = commands.add_parser(
        name, help=summary, description=summary, examples=examples, status=status
    )
    return command


def add_scene(command: argparse.ArgumentParser) -> None:
    """Add the scene: a built-in name or a file."""
    command.add_argument(
        "scene",
        metavar="SCENE",
        help="a built-in name (see list) or a file, a scene or any other known format; - for "
        "standard input",
    )


def add_plot(command: argparse.ArgumentParser, what: str) -> None:
    """Add a picture to write; `what` says what the option does."""
    command.add_argument(
        "--plot",
        metavar="FILE",
        type=file_of(PLOT_SUFFIXES),
        help=f"{what} into this file: {', '.join(PLOT_SUFFIXES)}",
    )


def add_json(command: argparse.ArgumentParser, what: str) -> None:
    """Add JSON to write; `what` says what it contains."""
    command.add_argument(
        "--json", metavar="FILE", help=f"write {what} as JSON; - for standard output"
    )


def whole_number(text: str) -> int:
    """Return the integer that a text states."""
    if re.fullmatch(r"[+-]?[0-9]{1,4000}", text.strip()) is None:  # int also takes 1_000 and ٣
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number")
    return int(text)


def real_number(text: str) -> float:
    """Return the number that a text states; the caller decides about ``inf`` and ``nan``."""
    try:
        value = float(text)
    except ValueError:
        value = None
    if value is None or "_" in text or not text.isascii():  # float also takes 1_000 and ٣
        raise argparse.ArgumentTypeError(f"{text!r} is not a number")
    return value


def angle(text: str) -> float:
    """Return an angle in radians: a plain number, or one with a unit such as ``90deg``."""
    written = radians_of(text)
    return real_number(text) if written is None else written


def byte_count(text: str) -> int:
    """Return the bytes that a text such as ``512M`` states."""
    match = re.fullmatch(
        r"(\d{1,18}(?:\.\d{1,9})?)\s*([KMGT]?)(?:i?B)?", text.strip(), re.IGNORECASE | re.ASCII
    )
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of bytes such as 512M or 4G")
    return int(float(match[1]) * _UNITS[match[2].upper()])


def output_file(text: str) -> Path:
    """Return a file to write; only --json can write to standard output."""
    if text in ("", "-"):
        raise argparse.ArgumentTypeError(f"{text!r} is not a file to write")
    return Path(text)


def file_of(suffixes: Sequence[str]) -> Callable[[str], Path]:
    """Return a converter for the name of a file to write, which must have one of the suffixes."""

    def file(text: str) -> Path:
        path = Path(text)
        if path.suffix.lower() not in suffixes:
            raise argparse.ArgumentTypeError(
                f"cannot tell the format of {text!r}; it must end in {', '.join(suffixes)}"
            )
        return path

    return file
