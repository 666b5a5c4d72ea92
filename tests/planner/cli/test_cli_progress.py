"""The progress line: on terminals only, after a second only, erased at the end."""

from __future__ import annotations

import io
import json
import os
import re
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from planar_planner.cli import progress as module
from planar_planner.cli.progress import Progress, counts_text
from support.pseudo_terminal import on_terminal
from worlds.endless import ENDLESS, long_search


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


class Lost(Terminal):
    def write(self, text: str) -> int:
        raise OSError(5, "Input/output error")


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


@pytest.fixture(autouse=True)
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "DELAY", 0.05)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "200")


def waited_for(terminal: io.StringIO, text: str) -> bool:
    deadline = time.monotonic() + 10
    while text not in terminal.getvalue():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.01)
    return True


def test_line_follows_the_work_and_is_erased() -> None:
    terminal = Terminal()
    with Progress(terminal, "checking") as progress:
        assert waited_for(terminal, "0 s  checking")
        assert progress(COUNTS) is True
        assert waited_for(terminal, counts_text(COUNTS))
        progress.step("runs", 1200, 3000)
        assert waited_for(terminal, "runs  1,200 of 3,000")
        progress.say("drawing")
        assert waited_for(terminal, "drawing")
    assert terminal.getvalue().endswith("\x1b[2K")
    written = terminal.getvalue()
    time.sleep(0.3)
    assert terminal.getvalue() == written


def test_counts_are_named() -> None:
    assert counts_text(COUNTS) == ("12,345 cells: 1 free, 2 star, 3 full, 4 mixed; channel 17")


def test_short_work_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "DELAY", 60.0)
    terminal = Terminal()
    before = threading.active_count()
    with Progress(terminal, "checking") as progress:
        assert progress(COUNTS) is True
    assert terminal.getvalue() == ""
    assert threading.active_count() == before


@pytest.mark.parametrize(
    ("stream", "quiet"), [(io.StringIO(), False), (Terminal(), True), (None, False)]
)
def test_silent_when_piped_quiet_or_closed(stream: Any, quiet: bool) -> None:
    with Progress(stream, "checking", quiet=quiet) as progress:
        assert progress(COUNTS) is True
        time.sleep(0.2)
    assert stream is None or stream.getvalue() == ""


def test_silent_on_a_dumb_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "dumb")
    terminal = Terminal()
    with Progress(terminal, "checking"):
        time.sleep(0.2)
    assert terminal.getvalue() == ""


def test_lost_terminal_does_not_end_the_work(capsys: pytest.CaptureFixture[str]) -> None:
    with Progress(Lost(), "checking") as progress:
        time.sleep(0.3)
        assert progress(COUNTS) is True
    assert capsys.readouterr().err == ""


def test_a_failure_of_the_work_erases_the_line() -> None:
    terminal = Terminal()
    with pytest.raises(ValueError, match="wrong"), Progress(terminal, "checking"):
        assert waited_for(terminal, "checking")
        raise ValueError("wrong")
    assert terminal.getvalue().endswith("\x1b[2K")


@pytest.mark.skipif(os.name != "posix", reason="opens a pseudo-terminal")
@pytest.mark.parametrize("columns", [30, 120])
def test_search_on_a_terminal(tmp_path: Path, columns: int) -> None:
    file = long_search(tmp_path)
    output = tmp_path / "result.json"
    ended = on_terminal(
        "check", file, *ENDLESS, "--timeout", "2", "--json", str(output), columns=columns
    )
    assert ended.status == 3
    line, _, rest = ended.terminal.rpartition("\x1b[2K")
    assert re.search(r"1 s  [\d,]+ cells", line)
    assert ("channel" in line) == (columns == 120)
    assert re.sub(r"\x1b\[[\d;]*m", "", rest).startswith("scene: undecided (time limit reached")
    assert json.loads(output.read_text())["verdict"] == "undecided"


@pytest.mark.skipif(os.name != "posix", reason="opens a pseudo-terminal")
def test_no_progress_when_standard_error_is_piped(tmp_path: Path) -> None:
    ended = on_terminal(
        "check", long_search(tmp_path), *ENDLESS, "--timeout", "1.5", streams=("stdout",)
    )
    assert ended.piped == ""
    assert "cells:" not in ended.terminal
