"""Ctrl-C at every moment of a command's life: one line, no traceback, a status that is true."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs signals between processes")

# Says when it is there: what the interpreter itself does before cannot be answered by a program.
START = (
    "import os, sys\nfrom planar_planner.__main__ import answer_interrupts, run\n"
    "answer_interrupts()\nos.write(1, b'!')\nsys.exit(run())\n"
)
COMMANDS = {
    "list": (["list"], "scene", None),
    "check": (["check", "gear-jammed"], "no path, proven", 1),
    "picture": (["solve", "gear", "--plot", "p.png", "--json", "r.json"], "path found", 0),
    "film": (["animate", "slot", "s.gif", "--seconds", "1", "--fps", "10"], "path found", 0),
    "margin": (["margin", "slot", "--plot", "m.svg"], "a path exists", 0),
    "convert": (["convert", "corner", "c.svg"], "vertices", None),
}
DELAYS = [0.0, 0.005, 0.01, 0.02, 0.03, 0.045, 0.06, 0.08, 0.1, 0.13, 0.16, 0.2, 0.25, 0.3, 0.5]


@pytest.mark.parametrize("name", COMMANDS)
def test_an_interrupt_at_any_moment(name: str, tmp_path: Path) -> None:
    arguments, verdict, stated = COMMANDS[name]
    for delay in DELAYS:
        status, out, err = interrupted(arguments, tmp_path, delay)
        where = f"{name} after {delay}: {status}, {out!r}, {err!r}"
        assert err.count("\n") <= 1 and "Traceback" not in err, where
        assert status in (0, 1, 3), where
        if stated is not None and verdict in out:
            assert status == stated, where
        if status == 3:
            assert err == "planar-planner: interrupted\n" or "undecided (interrupted)" in out, where
        elif err:
            assert err.startswith("planar-planner: interrupted after the verdict"), where
        left = [f.name for f in tmp_path.iterdir() if f.name.startswith(".planar-planner")]
        assert left == [], where


def interrupted(arguments: list[str], folder: Path, delay: float) -> tuple[int, str, str]:
    process = subprocess.Popen(
        [sys.executable, "-P", "-c", START, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=folder,
        bufsize=0,
    )
    assert process.stdout is not None and process.stdout.read(1) == b"!"
    time.sleep(delay)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    return process.returncode, out.decode(), err.decode()


def test_an_ignored_interrupt_stays_ignored() -> None:
    """As under nohup: what the caller ignores is not answered."""
    code = f"import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n{START}"
    process = subprocess.Popen(
        [sys.executable, "-P", "-c", code, "check", "gear"], stdout=subprocess.PIPE, bufsize=0
    )
    assert process.stdout is not None and process.stdout.read(1) == b"!"
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=60)
    assert process.returncode == 0 and b"path found" in out
