"""Arguments that several commands share; light to import."""

from __future__ import annotations

import argparse
import re
from pathlib import Path
from typing import Any

PLOT_SUFFIXES = (".png", ".svg", ".pdf")

_UNITS = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}


def add_command(commands: Any, name: str, summary: str) -> argparse.ArgumentParser:
    """Add a command and return its parser."""
    command: argparse.ArgumentParser = commands.add_parser(
        name, help=summary, description=summary, allow_abbrev=False
    )
    return command


def add_scene(command: argparse.ArgumentParser) -> None:
    """Add the scene, a built-in name or a file."""
    command.add_argument(
        "scene",
        metavar="SCENE",
        help="a built-in name (see list) or a file: scene or outside format",
    )


def add_plot(command: argparse.ArgumentParser, what: str) -> None:
    """Add a picture to write; `what` says what it shows."""
    command.add_argument(
        "--plot", metavar="FILE", type=picture, help=f"{what}: {', '.join(PLOT_SUFFIXES)}"
    )


def add_json(command: argparse.ArgumentParser, what: str) -> None:
    """Add JSON to write; `what` says what it holds."""
    command.add_argument(
        "--json", metavar="FILE", help=f"write {what} as JSON; - for standard output"
    )


def byte_count(text: str) -> int:
    """Return the bytes that a text such as ``512M`` states."""
    match = re.fullmatch(
        r"(\d{1,18}(?:\.\d{1,9})?)\s*([KMGT]?)(?:i?B)?", text.strip(), re.IGNORECASE
    )
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of bytes such as 512M or 4G")
    return int(float(match[1]) * _UNITS[match[2].upper()])


def picture(text: str) -> Path:
    """Return the file of a picture, whose suffix states a format that matplotlib can write."""
    file = Path(text)
    if file.suffix.lower() not in PLOT_SUFFIXES:
        raise argparse.ArgumentTypeError(
            f"cannot tell the format of {text!r}; it must end in {', '.join(PLOT_SUFFIXES)}"
        )
    return file
