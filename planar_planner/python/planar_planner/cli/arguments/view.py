"""Arguments that choose the content of a picture; light to import."""

from __future__ import annotations

import argparse
import math

from planar_planner.cli.arguments.shared import angle
from planar_planner.errors import OptionsError

VIEWS = ("path", "filmstrip", "slices", "space", "wall")


def add_view(command: argparse.ArgumentParser) -> None:
    """Add the view of a picture, and the angles of slices."""
    command.add_argument(
        "--view",
        choices=VIEWS,
        help="content of the picture: the path or its filmstrip, the cells as slices at --theta or "
        "in 3-D space, or the separating wall (default: wall or path, by the verdict)",
    )
    command.add_argument(
        "--theta",
        metavar="A,B,…",
        type=angles,
        help="angles of the slices, in radians or like 45deg (default: some of the path's)",
    )


def angles(text: str) -> list[float]:
    """Return the angles, in radians, that a text such as ``0,0.5,90deg`` states."""
    found = []
    for part in text.split(","):
        try:
            value = angle(part)
        except argparse.ArgumentTypeError:
            raise argparse.ArgumentTypeError(f"{part!r} is not an angle") from None
        if not math.isfinite(value):
            raise argparse.ArgumentTypeError(f"{part!r} is not finite")
        found.append(value)
    return found


def view_of(arguments: argparse.Namespace) -> str | None:
    """Return the requested view, or None to choose by the verdict.

    Raises
    ------
    OptionsError
        If a view is requested without a picture, or angles with another view than slices.
    """
    view: str | None = arguments.view
    if arguments.plot is None and (view is not None or arguments.theta is not None):
        raise OptionsError("--view and --theta need a picture: --plot FILE is missing")
    if arguments.theta is None:
        return view
    if view not in (None, "slices"):
        raise OptionsError(f"--theta gives the angles of --view slices, not of {view}")
    return "slices"
