"""`planar-planner --version`: the version in the first line, then what the build is made of."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import planar_planner
from planar_planner._core import build_info
from planar_planner.cli.main import main

NATIVE = Path(__file__).parents[3] / "planar_planner" / "native" / "bindings"


def test_version_with_build_details(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    first, *rest = capsys.readouterr().out.splitlines()
    assert first == f"planar-planner {planar_planner.__version__}"
    found = {line.split()[0]: line.split(maxsplit=1)[1] for line in rest}
    assert list(found) == [
        "commit",
        "core",
        "compiler",
        "ABI",
        "Python",
        "platform",
        "libraries",
        "installed",
    ]
    commit = r"[0-9a-f]{7,12}(-dirty)?|unknown: not built in a git checkout"
    assert re.fullmatch(commit, found["commit"])
    assert re.fullmatch(r"\w+ [\d.]+", found["compiler"])
    assert found["Python"].endswith(platform.python_version())
    assert f"numpy {np.__version__}" in found["libraries"]
    assert Path(found["installed"]) == Path(planar_planner.__file__).parent


def test_core_tells_what_it_was_compiled_for() -> None:
    facts = build_info()
    assert facts["build_type"]
    assert re.fullmatch(r"\d+\.\d+\.\d+", facts["nanobind"])
    assert re.match(r"(abi3, )?CPython 3\.\d+", facts["abi"])
    if not facts["abi"].startswith("abi3"):
        assert facts["abi"] == f"CPython {sys.version_info.major}.{sys.version_info.minor}"


def test_a_core_that_cannot_be_imported_is_told_of(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "planar_planner._core", None)
    assert main(["--version"]) == 0
    assert re.search(r"core +cannot be imported: ", capsys.readouterr().out)


@pytest.mark.skipif(shutil.which("cmake") is None, reason="runs the build's own CMake script")
@pytest.mark.parametrize("given", ["", "-DCOMMIT=0123abc"])
def test_commit_of_a_surrounding_repository_is_not_ours(tmp_path: Path, given: str) -> None:
    """As when a source distribution is unpacked inside somebody's project."""
    if shutil.which("git") is not None:
        subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    source = tmp_path / "unpacked"
    source.mkdir()
    header = tmp_path / "build_facts.hpp"
    command = [
        "cmake",
        f"-DSOURCE={source}",
        f"-DTEMPLATE={NATIVE / 'build_facts.hpp.in'}",
        f"-DHEADER={header}",
        '-DFLAGS= -DX="a b" ',
        *([given] if given else []),
        "-P",
        str(NATIVE / "build_facts.cmake"),
    ]
    subprocess.run(command, check=True)
    written = header.read_text()
    assert f'kCommit = "{given.removeprefix("-DCOMMIT=")}"' in written
    assert r'kFlags = "-DX=\"a b\""' in written
