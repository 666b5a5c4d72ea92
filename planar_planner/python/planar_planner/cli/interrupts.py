"""Ctrl-C at any moment: one line and a documented exit status, never a traceback. Light to import.

Before a command runs, Ctrl-C ends the process at once (`planar_planner.cli.leave`). While it runs,
Ctrl-C raises KeyboardInterrupt, but not within an import: libraries turn it into other errors
there, or crash.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from planar_planner.cli.leave import leave
from planar_planner.tolerances import INTERRUPT_AGAIN


@contextmanager
def noted(interrupts: list[int]) -> Iterator[None]:
    """Add each Ctrl-C that arrives to the list, and then raise KeyboardInterrupt.

    Nothing happens where a caller has a handler of its own, or outside the main thread.
    """

    def note(number: int, frame: FrameType | None) -> None:
        interrupts.append(number)
        if _within_import(frame):
            threading.Thread(target=_interrupt_again, daemon=True).start()
        else:
            signal.default_int_handler(number, frame)

    before = signal.getsignal(signal.SIGINT)
    ours = before in (signal.default_int_handler, leave)
    if not ours or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _within_import(frame: FrameType | None) -> bool:
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _interrupt_again() -> None:
    time.sleep(INTERRUPT_AGAIN)
    signal.raise_signal(signal.SIGINT)
