"""The command line: arguments → command → exit status.

Exit status as in grep: 0 a path, 1 proven that there is none, 2 bad input or usage, 3 undecided.
Modules that take long to import (numpy, shapely, matplotlib, the core) are imported by the commands
that need them.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

from planar_planner.cli.parser import parse
from planar_planner.errors import PlannerError, one_line
from planar_planner.output_files import complain, flush, use_safe_encoding

EXIT_BAD_INPUT = 2
EXIT_UNDECIDED = 3


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status; no exception leaves it.

    Under ``python -X dev`` an internal error is raised instead, to show where it comes from.
    """
    use_safe_encoding()
    interrupts: list[int] = []
    try:
        with _noted(interrupts):
            return _run(sys.argv[1:] if argv is None else argv)
    except KeyboardInterrupt:
        complain("interrupted")
        return EXIT_UNDECIDED
    except MemoryError:
        complain("undecided: out of memory")
        return EXIT_UNDECIDED
    except PlannerError as error:
        complain(one_line(str(error)))
        return EXIT_BAD_INPUT
    except Exception as error:
        if interrupts:  # on the import of a library that made another error of it
            complain("interrupted")
            return EXIT_UNDECIDED
        if sys.flags.dev_mode:
            raise
        complain(one_line(f"internal error, please report it: {type(error).__name__}: {error}"))
        return EXIT_BAD_INPUT


@contextmanager
def _noted(interrupts: list[int]) -> Iterator[None]:
    """Add to the list each Ctrl-C that arrives, and let it do what it does."""

    def note(number: int, frame: FrameType | None) -> None:
        interrupts.append(number)
        signal.default_int_handler(number, frame)

    if (
        signal.getsignal(signal.SIGINT) is not signal.default_int_handler
        or threading.current_thread() is not threading.main_thread()
    ):
        yield
        return
    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def _run(argv: Sequence[str]) -> int:
    try:
        arguments = parse(argv)
    except SystemExit as leaving:  # help, version or a usage error: argparse has said it all
        flush()
        return EXIT_BAD_INPUT if leaving.code else 0
    status: int = arguments.run(arguments)
    return status
