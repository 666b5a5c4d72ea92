"""One line of a terminal that rich redraws; imported only if there is a terminal."""

from __future__ import annotations

from collections.abc import Callable
from typing import IO, TextIO, cast

from rich.console import Console
from rich.live import Live
from rich.spinner import Spinner
from rich.table import Table
from rich.text import Text

REDRAWS_PER_SECOND = 8.0


class LiveLine:
    """Draws a line until `erase` is called.

    Parameters
    ----------
    stream : text stream
        A terminal.
    text : function without arguments
        Returns the text to show now; the line is cut at the terminal's width.
    """

    def __init__(self, stream: TextIO, text: Callable[[], str]) -> None:
        tolerant = cast("IO[str]", _Tolerant(stream))
        console = _Console(file=tolerant, force_terminal=True, highlight=False)
        moving = Spinner("dots" if console.encoding.startswith("utf") else "line")

        def line() -> Table:
            grid = Table.grid(padding=(0, 1))
            grid.add_row(moving, Text(text(), no_wrap=True, overflow="ellipsis"))
            return grid

        self._live = Live(
            get_renderable=line,
            console=console,
            refresh_per_second=REDRAWS_PER_SECOND,
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        self._live.start(refresh=True)

    def erase(self) -> None:
        """Erase the line and stop drawing."""
        self._live.stop()


class _Console(Console):
    def show_cursor(self, show: bool = True) -> bool:
        """Leave the cursor visible, because a killed process could not restore it."""
        return False


class _Tolerant:
    """A terminal that ignores errors, so that closing the terminal does not end the work."""

    def __init__(self, stream: TextIO) -> None:
        self._stream: TextIO | None = stream
        self.encoding = stream.encoding or "ascii"

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        try:
            if self._stream is not None:
                self._stream.write(text)
        except (OSError, ValueError):
            self._stream = None
        return len(text)

    def flush(self) -> None:
        try:
            if self._stream is not None:
                self._stream.flush()
        except (OSError, ValueError):
            self._stream = None
