"""Files that cannot be written: one line says so, and whatever was there before is still there."""

from __future__ import annotations

import os
import shutil
import stat
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from attacks.stress_parts.common import Row, Settings, fail
from attacks.stress_parts.fault_processes import PATIENCE

PART = "faults"
SCENE = "corner"
OLD = "what was here before\n"
OUTPUTS = {"--json": "out.json", "--certificate": "out.cert.gz", "--plot": "out.png"}
BLOCK = 100  # bytes: the largest file a process may write, where it is limited


@dataclass(frozen=True)
class Fault:
    """A way for a write to fail.

    `prepare` gets the folder and the file to be written and returns the command's prefix;
    `message` must stand in what the command prints; `keeps` says whether the old file can be
    looked at afterwards.
    """

    name: str
    prepare: Callable[[Path, Path, ExitStack], list[str]]
    message: str
    keeps: bool = True


def run(settings: Settings) -> list[Row]:
    """Try every fault with every kind of output."""
    if os.name != "posix":
        return []
    rows = []
    for fault in _faults():
        row = Row(PART, f"output: {fault.name}")
        began = time.perf_counter()
        for option in OUTPUTS:
            if settings.quick and option == "--plot":
                continue
            with ExitStack() as cleanup:
                _try(settings, row, fault, option, cleanup)
        row.seconds = time.perf_counter() - began
        rows.append(row)
    return rows


def _try(settings: Settings, row: Row, fault: Fault, option: str, cleanup: ExitStack) -> None:
    folder = Path(cleanup.enter_context(tempfile.TemporaryDirectory()))
    file = folder / OUTPUTS[option]
    file.write_text(OLD)
    prefix = fault.prepare(folder, file, cleanup)
    before = sorted(folder.iterdir()) if folder.exists() else []
    command = [*prefix, sys.executable, "-P", "-m", "planar_planner", "solve", SCENE, "--quiet"]
    done = subprocess.run(
        [*command, option, str(file)],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    row.tried += 1
    place = f"{fault.name}, {option}"
    if done.returncode != 2 or done.stderr.count("\n") != 1 or fault.message not in done.stderr:
        fail(settings, row, None, f"{place}: exit status {done.returncode}, {done.stderr!r}")
    if not fault.keeps:
        return
    if file.is_file() and stat.S_ISREG(file.stat().st_mode) and file.read_bytes() != OLD.encode():
        fail(settings, row, None, f"{place}: the old file is lost")
    after = sorted(folder.iterdir())
    if after != before:
        fail(settings, row, None, f"{place}: files {after}, were {before}")


def _faults() -> list[Fault]:
    faults = [
        Fault("file size limit", _limited, "File too large"),
        Fault("a directory of that name", _directory, "is a directory", keeps=False),
        Fault("no such directory", _no_directory, "no directory", keeps=False),
    ]
    if Path("/dev/full").exists():
        faults.append(Fault("full device", _full_device, "No space left", keeps=False))
    if os.geteuid() != 0:
        faults += [
            Fault("read-only file", _read_only_file, "ermission denied"),
            Fault("read-only directory", _read_only_folder, "ermission denied"),
        ]
    elif shutil.which("setpriv") is not None:
        faults += [
            Fault("read-only file", _as_nobody(_read_only_file), "ermission denied"),
            Fault("read-only directory", _as_nobody(_read_only_folder), "ermission denied"),
        ]
    if os.geteuid() == 0 and shutil.which("mount") is not None and _can_mount():
        faults.append(Fault("full disk", _full_disk, "No space left"))
    return faults


def _limited(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    code = (
        "import os, resource, sys\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({BLOCK}, {BLOCK}))\n"
        "os.environ['PYTHONDONTWRITEBYTECODE'] = '1'\n"
        "os.execv(sys.argv[1], sys.argv[1:])\n"
    )
    return [sys.executable, "-c", code]


def _directory(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    file.unlink()
    file.mkdir()
    return []


def _no_directory(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    shutil.rmtree(folder)
    cleanup.callback(folder.mkdir)  # what the caller removes at the end
    return []


def _full_device(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    file.unlink()
    file.symlink_to("/dev/full")
    return []


def _read_only_file(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    file.chmod(0o444)
    return []


def _read_only_folder(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    folder.chmod(0o555)
    cleanup.callback(folder.chmod, 0o755)
    return []


def _as_nobody(
    prepare: Callable[[Path, Path, ExitStack], list[str]],
) -> Callable[[Path, Path, ExitStack], list[str]]:
    """Give up root's right to write anything anywhere, for the command alone."""

    def prepared(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
        capabilities = "--bounding-set=-dac_override,-dac_read_search,-fowner"
        drop = ["setpriv", "--inh-caps=-all", capabilities]
        return [*prepare(folder, file, cleanup), *drop]

    return prepared


def _can_mount() -> bool:
    with tempfile.TemporaryDirectory() as folder:
        if subprocess.run(_mount(folder), capture_output=True, check=False).returncode != 0:
            return False
        subprocess.run(["umount", folder], check=True)
        return True


def _mount(folder: str) -> list[str]:
    return ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", folder]


def _full_disk(folder: Path, file: Path, cleanup: ExitStack) -> list[str]:
    """Put a disk of 64 KiB over the folder and fill it up but for the old file."""
    subprocess.run(_mount(str(folder)), check=True)
    cleanup.callback(subprocess.run, ["umount", str(folder)], check=True)
    file.write_text(OLD)
    filler = folder / "filler"
    with filler.open("wb", buffering=0) as out:
        try:
            while True:
                out.write(bytes(1024))
        except OSError:
            return []
