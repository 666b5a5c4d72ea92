"""Ctrl-C before the command line is there to answer it; imported before everything else."""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # `signal` takes longer to import than to need
import os
from types import FrameType

EXIT_INTERRUPTED = 3
MESSAGE = "interrupted"


def leave(_number: int, _frame: FrameType | None) -> None:
    """End the process: nothing has been done yet, and there is nothing to clear away."""
    os.write(2, f"planar-planner: {MESSAGE}\n".encode())
    os._exit(EXIT_INTERRUPTED)


def answer_interrupts() -> None:
    """Let Ctrl-C end the process in one line, unless a caller answers or ignores it."""
    if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, leave)


def ignore_interrupts() -> None:
    """Ignore Ctrl-C from now on: all is done."""
    if _signal.getsignal(_signal.SIGINT) is leave:
        _signal.signal(_signal.SIGINT, _signal.SIG_IGN)
