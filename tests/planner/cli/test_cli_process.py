"""The command line as a process, without the core: start-up, broken pipes, full disks."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from support.command import COMMAND


def run(*arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*COMMAND, *arguments],
        capture_output="stdout" not in options,
        text=True,
        timeout=120,
        check=False,
        **options,
    )


@pytest.mark.parametrize(
    "arguments", [["--help"], ["list"], ["solve", "--help"], ["solve", "geer"]]
)
def test_light_commands_import_nothing_heavy(arguments: list[str]) -> None:
    code = (
        "import sys\n"
        "from planar_planner.cli.main import main\n"
        f"main({arguments!r})\n"
        "heavy = {'numpy', 'shapely', 'matplotlib', 'scipy', 'planar_planner._core'}\n"
        "sys.exit(len(heavy & set(sys.modules)))\n"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], capture_output=True, timeout=60, check=False
    )
    assert done.returncode == 0


def test_show_imports_no_pictures() -> None:
    code = (
        "import sys\n"
        "from planar_planner.cli.main import main\n"
        "assert main(['show', 'gear']) == 0\n"
        "sys.exit(len({'matplotlib', 'scipy'} & set(sys.modules)))\n"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], capture_output=True, timeout=60, check=False
    )
    assert done.returncode == 0


@pytest.mark.parametrize("arguments", [["list"], ["--help"], ["show", "gear"]])
def test_reader_that_leaves_is_no_error(arguments: list[str]) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    try:
        done = run(*arguments, stdout=writing, stderr=subprocess.PIPE)
    finally:
        os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("arguments", [["list"], ["--help"], ["show", "gear"]])
def test_full_disk_is_one_line(arguments: list[str]) -> None:
    with Path("/dev/full").open("w") as full:
        done = run(*arguments, stdout=full, stderr=subprocess.PIPE)
    assert done.returncode == 2
    assert done.stderr == "planar-planner: cannot write standard output: No space left on device\n"


def test_closed_streams() -> None:
    script = f'"{sys.executable}" -P -m planar_planner list >&- 2>&-'
    done = subprocess.run(["sh", "-c", script], timeout=60, check=False)
    assert done.returncode == 0


def test_ascii_terminal() -> None:
    environment = os.environ | {"PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    done = run("solve", "gär\udcff", env=environment)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "Traceback" not in done.stderr


def test_endless_device_is_no_scene() -> None:
    if not Path("/dev/zero").exists():
        pytest.skip("no endless device")
    done = run("solve", "/dev/zero")
    assert done.returncode == 2
    assert "/dev/zero: is larger than" in done.stderr
