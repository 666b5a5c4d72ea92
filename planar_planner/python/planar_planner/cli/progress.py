"""A line on a terminal that says how far long work is; it appears after a second."""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TextIO

from planar_planner.cli.terminal import is_terminal

if TYPE_CHECKING:
    from planar_planner.cli.live_line import LiveLine

DELAY = 1.0
"""Seconds of work before the line appears: most commands end sooner and should not flicker."""


class Progress:
    """A line that follows the work: silent unless on a terminal, gone when the work ends.

    Use as a context manager around the work, and print nothing to the terminal within. The line is
    drawn by a thread of its own, so that its clock goes on whatever the work does; `say` and `step`
    only note what it shows. An instance is a listener for `planar_planner.solve`.

    Parameters
    ----------
    stream : text stream or None
        Where to draw, usually standard error.
    what : str, optional
        What is being done, until `say`, `step` or the search's counts tell more.
    quiet : bool, optional
        Draw nothing.
    """

    def __init__(self, stream: TextIO | None, what: str = "", *, quiet: bool = False) -> None:
        self._stream = stream if not quiet and is_terminal(stream) else None
        self._text = what
        self._began = time.monotonic()
        self._timer: threading.Timer | None = None
        self._line: LiveLine | None = None

    def __enter__(self) -> Progress:
        if self._stream is not None:
            self._timer = threading.Timer(DELAY, self._draw)
            self._timer.daemon = True
            self._timer.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer.join()  # it may be drawing the first line just now
        if self._line is not None:
            self._line.erase()

    def __call__(self, counts: Mapping[str, Any]) -> bool:
        """Show the counts of a running search, and let it continue."""
        self._text = counts_text(counts)
        return True

    def say(self, what: str) -> None:
        """Show what is being done."""
        self._text = what

    def step(self, what: str, done: int, total: int) -> None:
        """Show what is being done, and how much of it is done."""
        self._text = f"{what}  {done:,} of {total:,}"

    def _draw(self) -> None:
        if self._stream is not None:
            from planar_planner.cli.live_line import LiveLine

            self._line = LiveLine(self._stream, self._shown)

    def _shown(self) -> str:
        return f"{time.monotonic() - self._began:.0f} s  {self._text}"


def counts_text(counts: Mapping[str, Any]) -> str:
    """Return the counts of a running search as text."""
    return (
        f"{counts['cells']:,} cells: {counts['free']:,} free, {counts['star']:,} star, "
        f"{counts['full']:,} full, {counts['mixed']:,} mixed; "
        f"channel {counts['channel_length']:,}"
    )
