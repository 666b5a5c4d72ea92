"""The command line: arguments → command → exit status.

The exit status follows grep: 0 for a path, 1 for a proof that there is none, 2 for bad input or
usage, 3 for undecided. The commands themselves import the modules that take long to import (numpy,
shapely, matplotlib, the core).
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass

from planar_planner.cli.interrupts import noted
from planar_planner.cli.leave import EXIT_INTERRUPTED, MESSAGE
from planar_planner.cli.parser import parse
from planar_planner.errors import PlannerError, one_line
from planar_planner.output_files import complain, flush, use_safe_encoding

EXIT_BAD_INPUT = 2
EXIT_UNDECIDED = 3


@dataclass
class Stated:
    """The exit status that a command's printed verdict states; None before the verdict.

    Whatever stops a command after its verdict leaves the status as it is.
    """

    status: int | None = None


@dataclass(frozen=True)
class Outcome:
    """The exit status of a command, and whether Ctrl-C has ended it."""

    status: int
    interrupted: bool


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status; no exception leaves it.

    Under ``python -X dev`` an internal error is raised instead, so that its origin is visible.
    """
    return outcome(argv).status


def outcome(argv: Sequence[str] | None = None) -> Outcome:
    """Run the command line; see `main`."""
    use_safe_encoding()
    interrupts: list[int] = []
    stated = Stated()
    try:
        with noted(interrupts):
            status = _run(sys.argv[1:] if argv is None else argv, stated)
        return Outcome(status, interrupted=bool(interrupts))
    except KeyboardInterrupt:
        return _interrupted(stated)
    except MemoryError:
        complain("undecided: out of memory")
        return Outcome(EXIT_UNDECIDED, interrupted=False)
    except PlannerError as error:
        complain(one_line(str(error)))
        return Outcome(EXIT_BAD_INPUT, interrupted=False)
    except Exception as error:
        if interrupts:  # a library turned it into another error
            return _interrupted(stated)
        if sys.flags.dev_mode:
            raise
        complain(one_line(f"internal error, please report it: {type(error).__name__}: {error}"))
        return Outcome(EXIT_BAD_INPUT, interrupted=False)


def _interrupted(stated: Stated) -> Outcome:
    if stated.status is None:
        complain(MESSAGE)
        return Outcome(EXIT_INTERRUPTED, interrupted=True)
    complain(f"{MESSAGE} after the verdict; files that were still to be written are missing")
    return Outcome(stated.status, interrupted=True)


def _run(argv: Sequence[str], stated: Stated) -> int:
    try:
        arguments = parse(argv)
    except SystemExit as leaving:  # help, version or a usage error, which argparse has printed
        flush()
        return EXIT_BAD_INPUT if leaving.code else 0
    arguments.stated = stated
    status: int = arguments.run(arguments)
    return status
