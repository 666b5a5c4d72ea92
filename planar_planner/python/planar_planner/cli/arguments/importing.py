"""Arguments for start, goal and files in other formats, and the scene that they name."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path

from planar_planner.cli.arguments.shared import angle, real_number
from planar_planner.cli.progress import Progress
from planar_planner.errors import SceneError, one_line
from planar_planner.formats.parts import INWARDS, OUTWARDS, ImportOptions
from planar_planner.formats.roles import ROLES
from planar_planner.load import load_scene, scene_of_bytes
from planar_planner.output_files import check_distinct, complain
from planar_planner.scene.input_limits import MAX_FILE_BYTES
from planar_planner.scene.model import Scene

STDIN = "-"
_OUTPUTS = {
    "out": "the output",
    "json": "--json",
    "certificate": "the certificate",
    "plot": "--plot",
    "save": "--save",
}
"""Arguments that name files to write, or a certificate to read, and what messages call them."""


def add_importing(command: argparse.ArgumentParser) -> None:
    """Add start and goal, and options for what files in other formats may leave open."""
    for name in ("start", "goal"):
        command.add_argument(
            f"--{name}",
            metavar="X,Y,THETA",
            type=_configuration,
            help=f"use this {name} instead of the scene's; theta in radians or as in 90deg",
        )
    group = command.add_argument_group(
        "other file formats", "for files that are not scene files; see docs/formats.md"
    )
    group.add_argument(
        "--robot", metavar="FILE", type=Path, help="take the robot from this file, of any format"
    )
    group.add_argument(
        "--footprint", metavar="'[[X,Y],…]'", help="the robot's outline, as Nav2 writes it"
    )
    group.add_argument(
        "--padding",
        metavar="LENGTH",
        type=_length,
        help="Nav2's footprint_padding, for --footprint or a footprint in the file (default: 0)",
    )
    group.add_argument(
        "--unknown", action="store_true", help="treat unknown cells of a map as obstacles"
    )
    group.add_argument(
        "--allow-empty", action="store_true", help="take a file in which nothing is an obstacle"
    )
    group.add_argument(
        "--flatten",
        choices=(OUTWARDS, INWARDS),
        default=OUTWARDS,
        help="side on which curves become edges; with outwards a path also holds for the curves, "
        "with inwards a proof of no path does (default: %(default)s)",
    )
    group.add_argument(
        "--tolerance",
        metavar="LENGTH",
        type=_length,
        help="greatest distance of an edge from its curve (default: a thousandth of the drawing)",
    )
    group.add_argument(
        "--join",
        metavar="LENGTH",
        type=_length,
        help="join ends of a drawing's lines that are this far apart (default: a millionth of it)",
    )
    group.add_argument(
        "--role",
        metavar="PATTERN=ROLE",
        type=_role,
        action="append",
        default=[],
        help="role of a drawing's layers, ids, classes or labels, for example 'wall*=obstacle'; "
        f"roles: {', '.join(ROLES)}",
    )


def import_options(arguments: argparse.Namespace) -> ImportOptions:
    """Return the import options that the arguments state."""
    return ImportOptions(
        start=arguments.start,
        goal=arguments.goal,
        robot=arguments.robot,
        footprint=arguments.footprint,
        padding=arguments.padding,
        unknown=arguments.unknown,
        allow_empty=arguments.allow_empty,
        flatten=arguments.flatten,
        tolerance=arguments.tolerance,
        join=arguments.join,
        roles=tuple(arguments.role),
    )


def _configuration(text: str) -> list[float]:
    *place, theta = text.split(",")
    try:
        values = [*map(real_number, place), angle(theta)]
    except argparse.ArgumentTypeError:
        values = []
    if len(values) != 3:
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,THETA, three numbers")
    return values


def _length(text: str) -> float:
    try:
        value = real_number(text)
    except argparse.ArgumentTypeError:
        value = math.nan
    if not (0 < value < math.inf):
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive length")
    return value


def _role(text: str) -> tuple[str, str]:
    pattern, _, role = text.rpartition("=")
    if not pattern or role not in ROLES:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not PATTERN=ROLE with a role of {', '.join(ROLES)}"
        )
    return pattern, role


def scene_of(arguments: argparse.Namespace, name: str, *, quiet: bool = False) -> Scene:
    """Load a scene with the start, goal, robot and import options that the arguments state."""
    _check_files(arguments, name)
    with Progress(sys.stderr, f"reading {one_line(name)}", quiet=quiet):
        options = import_options(arguments)
        scene = _of_stdin(options) if name == STDIN else load_scene(name, options)
    if not quiet:
        for note in scene.notes:
            complain(f"{name}: {note}")
    return scene


def _of_stdin(options: ImportOptions) -> Scene:
    """Read a scene, of any format that its content tells, from standard input."""
    if sys.stdin is None:
        raise SceneError("cannot read the scene: standard input is closed", source=STDIN)
    data = sys.stdin.buffer.read(MAX_FILE_BYTES + 1)
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(f"is larger than {MAX_FILE_BYTES} bytes", source="standard input")
    return scene_of_bytes(data, Path("standard input"), options)


def _check_files(arguments: argparse.Namespace, name: str) -> None:
    """Find out before the work that an output would overwrite an input or another output."""
    given = vars(arguments)
    inputs = {"the scene": Path(name)}
    inputs |= {f"--{key}": given[key] for key in ("robot", "path") if given.get(key) is not None}
    outputs = {
        label: Path(given[key])
        for key, label in _OUTPUTS.items()
        if given.get(key) not in (None, STDIN)
    }
    check_distinct(inputs, outputs)
