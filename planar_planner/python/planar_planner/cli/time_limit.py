"""A limit of time for work that has no listener of its own."""

from __future__ import annotations

import math
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from planar_planner.errors import OptionsError
from planar_planner.tolerances import TIMER_TICK


class OutOfTimeError(Exception):
    """The time has run out. No TimeoutError, which readers of files take for a defect of a file."""


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise OutOfTimeError in the body after some seconds; infinity is no limit.

    The body is Python code in the main thread, on a system with interval timers (not Windows);
    elsewhere there is no limit. A single call of compiled code ends first.

    Raises
    ------
    OptionsError
        If the time is not positive.
    """
    if not seconds > 0.0:
        raise OptionsError(f"timeout must be positive, not {seconds!r}")
    timed = hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()
    if not timed or math.isinf(seconds):
        yield
        return

    def expire(_signal: int, _frame: FrameType | None) -> None:
        raise OutOfTimeError

    before = signal.signal(signal.SIGALRM, expire)
    signal.setitimer(signal.ITIMER_REAL, max(seconds, TIMER_TICK))
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
