"""A line of running counts on a terminal, for searches longer than a second."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from typing import Any, TextIO

DELAY = 1.0
"""Seconds of search before the first line: most queries end sooner and should not flicker."""

_ERASE_LINE = "\r\x1b[K"


class Progress:
    """A listener for `planar_planner.solve` that rewrites one line; silent unless on a terminal.

    Use as a context manager: leaving it erases the line.
    """

    def __init__(self, stream: TextIO | None, *, quiet: bool = False) -> None:
        self._stream = stream if stream is not None and not quiet and stream.isatty() else None
        self._shown = False

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        if self._shown:
            self._write(_ERASE_LINE)

    def __call__(self, counts: Mapping[str, Any]) -> bool:
        """Show the counts and continue the search, unless Ctrl-C arrives in here."""
        try:
            if self._stream is not None and counts["elapsed"] >= DELAY:
                columns = shutil.get_terminal_size().columns
                self._shown = True
                self._write(_ERASE_LINE + progress_line(counts)[: columns - 1])
        except KeyboardInterrupt:
            return False
        return True

    def _write(self, text: str) -> None:
        if self._stream is None:
            return
        try:
            self._stream.write(text)
            self._stream.flush()
        except OSError:  # a terminal that has gone away must not end the search
            self._stream = None


def progress_line(counts: Mapping[str, Any]) -> str:
    """Return the running counts as one line."""
    return (
        f"{counts['elapsed']:.0f} s  {counts['cells']:,} cells: "
        f"{counts['free']:,} free, {counts['star']:,} star, {counts['full']:,} full, "
        f"{counts['mixed']:,} mixed; channel {counts['channel_length']:,}"
    )
