"""All that the command line writes: standard streams, and files written aside then renamed."""

from __future__ import annotations

import contextlib
import os
import stat
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TextIO

from planar_planner.errors import OutputError, one_line


def emit(text: str) -> None:
    """Print to standard output.

    A reader that has left (``| head``) changes nothing about the verdict, so it is no error; a full
    disk is one.
    """
    _write(sys.stdout, text + "\n", "standard output")


def flush() -> None:
    """Bring what argparse has printed to standard output, or say why that is impossible."""
    _write(sys.stdout, "", "standard output")


def complain(text: str) -> None:
    """Print one line to standard error; if even that fails, nobody is left to tell."""
    with contextlib.suppress(OutputError):
        _write(sys.stderr, f"planar-planner: {one_line(text)}\n", "standard error")


def _write(stream: TextIO | None, text: str, name: str) -> None:
    if stream is None:  # closed by the caller (>&-)
        return
    try:
        stream.write(text)
        stream.flush()
    except BrokenPipeError:
        _abandon(stream)
    except OSError as error:
        _abandon(stream)
        raise OutputError(f"cannot write {name}: {error.strerror}") from None


def _abandon(stream: TextIO) -> None:
    """Point the stream at nothing, so that the interpreter's last flush cannot fail again."""
    with contextlib.suppress(OSError, ValueError):
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, stream.fileno())
        os.close(nothing)


def use_safe_encoding() -> None:
    """Let characters that the terminal cannot show appear escaped instead of raising."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="backslashreplace")


def check_writable(file: Path) -> None:
    """Find out before the work, not after it, that a file cannot be written.

    Raises
    ------
    OutputError
        If the file is a directory, or its directory is missing or not writable.
    """
    try:
        if file.is_dir():
            raise OutputError(f"cannot write {file}: is a directory")
        parent = file.resolve().parent
        if not parent.is_dir():
            raise OutputError(f"cannot write {file}: no directory {parent}")
        replaced = file.is_file() or not file.exists()  # anything else is written in place
        if (replaced and not os.access(parent, os.W_OK)) or not (
            not file.exists() or os.access(file, os.W_OK)
        ):
            raise OutputError(f"cannot write {file}: permission denied")
    except (OSError, ValueError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise OutputError(f"cannot write {file}: {reason}") from None


def check_distinct(inputs: Mapping[str, Path], outputs: Mapping[str, Path]) -> None:
    """Refuse to write one file twice, or onto what is read; devices and pipes may repeat.

    Parameters
    ----------
    inputs, outputs : mapping of str to Path
        The files, by what a message calls them.

    Raises
    ------
    OutputError
        If two of the files are the same.
    """
    seen = {_identity(file): name for name, file in inputs.items()}
    for name, file in outputs.items():
        with contextlib.suppress(OSError, ValueError, RuntimeError):
            if file.exists() and not file.is_file():
                continue
        other = seen.setdefault(_identity(file), name)
        if other != name:
            raise OutputError(f"cannot write {file}: {other} and {name} are the same file")


def _identity(file: Path) -> object:
    """Return what two names of one file share."""
    try:
        if file.exists():
            status = file.stat()
            return status.st_dev, status.st_ino
        return file.resolve()
    except (OSError, ValueError, RuntimeError):
        return file


@contextlib.contextmanager
def written_aside(file: Path) -> Iterator[Path]:
    """Give a path to write to; rename it to `file` at the end, remove it on any error.

    Until the rename an existing file stays as it was. What is not a regular file (a device, a pipe)
    is written in place, and a link is followed.

    Raises
    ------
    OutputError
        If writing or renaming fails.
    """
    aside: Path | None = None
    try:
        mode = file.stat().st_mode if file.exists() else None
        if mode is not None and not stat.S_ISREG(mode):
            yield file  # as it is called: /dev/stdout leads to a pipe, which has no path
            return
        target = file.resolve()
        aside = target.with_name(f".planar-planner-{os.getpid()}{target.suffix}")
        yield aside
        if mode is not None:
            aside.chmod(stat.S_IMODE(mode))
        aside.replace(target)
        aside = None
    except OSError as error:
        raise OutputError(f"cannot write {file}: {error.strerror or error}") from None
    except MemoryError:
        raise OutputError(f"cannot write {file}: out of memory") from None
    finally:
        if aside is not None:
            with contextlib.suppress(OSError):
                aside.unlink()
