"""Arguments of `planar-planner verify`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_planner.command_arguments.importing import add_importing
from planar_planner.command_arguments.limits import add_contact_tolerance
from planar_planner.command_arguments.shared import add_command, add_json, add_scene


def add(commands: Any) -> None:
    """Add the command."""
    verify = add_command(
        commands,
        "verify",
        "check a certificate with independent, exact code",
        examples=(
            "solve gear-jammed --certificate jammed.json.gz",
            "verify gear-jammed jammed.json.gz",
        ),
        status="0 valid, 1 rejected, 2 unreadable, or bad input or usage",
    )
    add_scene(verify)
    verify.add_argument("certificate", metavar="CERT", help="what solve --certificate has written")
    add_importing(verify)
    add_json(verify, "the finding")
    add_contact_tolerance(verify, "the ends of a path may have been moved")
    verify.set_defaults(run=_run)


def _run(arguments: argparse.Namespace) -> int:
    from planar_planner.commands.verify import run

    return run(arguments)
