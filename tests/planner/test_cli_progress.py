"""The progress line: on terminals only, after a second only, erased at the end."""

from __future__ import annotations

import io
from typing import Any

import pytest

from planar_planner.progress import Progress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


COUNTS = {
    "elapsed": 1.5,
    "cells": 12345,
    "free": 1,
    "star": 2,
    "full": 3,
    "mixed": 4,
    "channel_length": 17,
    "rounds": 9,
}


def test_line_after_a_second_and_erased(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    terminal = Terminal()
    with Progress(terminal) as progress:
        assert progress(COUNTS | {"elapsed": 0.9}) is True
        assert terminal.getvalue() == ""
        assert progress(COUNTS) is True
        assert "12,345 cells: 1 free, 2 star, 3 full, 4 mixed; channel 17" in terminal.getvalue()
    assert terminal.getvalue().endswith("\r\x1b[K")


def test_line_never_wraps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "20")
    terminal = Terminal()
    progress = Progress(terminal)
    progress(COUNTS)
    assert len(terminal.getvalue().removeprefix("\r\x1b[K")) == 19


@pytest.mark.parametrize(
    ("stream", "quiet"), [(io.StringIO(), False), (Terminal(), True), (None, False)]
)
def test_silent_when_piped_quiet_or_closed(stream: Any, quiet: bool) -> None:
    with Progress(stream, quiet=quiet) as progress:
        assert progress(COUNTS) is True
    assert stream is None or stream.getvalue() == ""


def test_interrupt_inside_the_listener_stops_the_search() -> None:
    class Interrupted(Terminal):
        def write(self, text: str) -> int:
            raise KeyboardInterrupt

    assert Progress(Interrupted())(COUNTS) is False


def test_lost_terminal_does_not_end_the_search() -> None:
    class Lost(Terminal):
        def write(self, text: str) -> int:
            raise OSError(5, "Input/output error")

    with Progress(Lost()) as progress:
        assert progress(COUNTS) is True
        assert progress(COUNTS) is True
