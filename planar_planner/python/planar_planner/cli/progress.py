"""A line on a terminal that shows the progress of long work; it appears after a second."""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TextIO

from planar_planner.cli.terminal import is_terminal

if TYPE_CHECKING:
    from planar_planner.cli.live_line import LiveLine

DELAY = 1.0
"""Seconds of work before the line appears; most commands end sooner and must not flicker."""


class Progress:
    """A line that shows progress on a terminal only, and that disappears when the work ends.

    Use it as a context manager around the work, and print nothing to the terminal within. A thread
    of its own draws the line, so that its clock advances whatever the work does; `say` and `step`
    only set its text. An instance is a listener for `planar_planner.solve`.

    Parameters
    ----------
    stream : text stream or None
        Stream for the line, usually standard error.
    what : str, optional
        The first text, until `say`, `step` or the search's counts replace it.
    quiet : bool, optional
        Whether to draw nothing.
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
            self._timer.join()  # it may be drawing the first line at this moment
        if self._line is not None:
            self._line.erase()

    def __call__(self, counts: Mapping[str, Any]) -> bool:
        """Show the counts of a running search, and let it continue."""
        self._text = counts_text(counts)
        return True

    def say(self, what: str) -> None:
        """Show a text that says which work is being done."""
        self._text = what

    def step(self, what: str, done: int, total: int) -> None:
        """Show which work is being done, and how many of its parts are done."""
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
