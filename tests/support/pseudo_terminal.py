"""Runs the command line on a real pseudo-terminal."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from support.command import COMMAND


@dataclass(frozen=True)
class Ended:
    """How a command ended; text is what the terminal got, in the order of its arrival."""

    status: int
    terminal: str
    piped: str


def on_terminal(
    *arguments: str,
    streams: tuple[str, ...] = ("stdout", "stderr"),
    columns: int = 80,
    folder: Path | None = None,
    **environment: str,
) -> Ended:
    """Run the command with the named streams on a terminal, and the other piped."""
    import fcntl
    import pty
    import struct
    import termios

    controller, terminal = pty.openpty()
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    inherited = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "COLUMNS", "LINES")}
    process = subprocess.Popen(
        [*COMMAND, *arguments],
        stdin=terminal,
        stdout=terminal if "stdout" in streams else subprocess.PIPE,
        stderr=terminal if "stderr" in streams else subprocess.PIPE,
        env=inherited | {"TERM": "xterm-256color"} | environment,
        cwd=folder,
    )
    os.close(terminal)
    shown = bytearray()
    while True:
        try:
            part = os.read(controller, 65536)
        except OSError:  # Linux: the other side is closed
            break
        if not part:
            break
        shown += part
    os.close(controller)
    out, err = process.communicate(timeout=60)
    return Ended(process.returncode, shown.decode(), ((out or b"") + (err or b"")).decode())
