"""Arguments for the limits of a query and for the contact tolerance; light to import."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.cli.arguments.shared import byte_count, real_number, whole_number
from planar_planner.planning.options import Options

_DEFAULTS = Options()


def add_contact_tolerance(command: Any, what: str) -> None:
    """Add the contact tolerance to a parser or group; `what` is the subject of its help."""
    command.add_argument(
        "--contact-tolerance",
        type=real_number,
        metavar="LENGTH",
        default=_DEFAULTS.contact_tolerance,
        help=f"greatest distance by which {what} out of contact (default: %(default)g)",
    )


def add_limits(command: argparse.ArgumentParser) -> None:
    """Add the limits of one query."""
    limits = command.add_argument_group("limits", "a limit that is reached gives undecided")
    limits.add_argument(
        "--resolution",
        type=real_number,
        metavar="FRACTION",
        default=_DEFAULTS.resolution,
        help="size of the smallest cell, relative to the scene (default: %(default)g)",
    )
    limits.add_argument(
        "--max-cells",
        type=whole_number,
        metavar="N",
        default=_DEFAULTS.max_cells,
        help="number of cells (default: %(default)s)",
    )
    limits.add_argument(
        "--timeout",
        type=real_number,
        metavar="SECONDS",
        default=_DEFAULTS.timeout,
        help="time of the search, or inf (default: %(default)g)",
    )
    limits.add_argument(
        "--max-memory",
        type=byte_count,
        metavar="BYTES",
        default=_DEFAULTS.max_memory,
        help="memory of the cells, with unit K, M, G or T "
        f"(default: {_DEFAULTS.max_memory / 2**30:g}G)",
    )
    add_contact_tolerance(limits, "a touching start or goal may be moved")


def options_of(arguments: argparse.Namespace) -> Options:
    """Return the limits that the arguments state."""
    return Options(
        resolution=arguments.resolution,
        max_cells=arguments.max_cells,
        timeout=arguments.timeout,
        max_memory=arguments.max_memory,
        contact_tolerance=arguments.contact_tolerance,
    )
