"""The programs in ``examples/`` print what their docstrings say."""

from __future__ import annotations

import ast
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "examples"
PROGRAMS = sorted(FOLDER.glob("*.py"))
EXTRAS = {"beside_ompl": "ompl"}  # program → the module that its extra brings
WITHOUT = "import runpy, sys; sys.modules[sys.argv[1]] = None; runpy.run_path(sys.argv[2])"


def run(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        cwd=folder,
        check=False,
        timeout=120,
    )


def stated(program: Path) -> list[str]:
    """Return the lines that the docstring shows after ``::``, which ends it."""
    text = ast.get_docstring(ast.parse(program.read_text(encoding="utf-8")))
    assert text is not None
    lines = text.partition("It prints::")[2].splitlines()
    return [line.strip() for line in lines if line.strip()]


def test_there_are_programs() -> None:
    assert len(PROGRAMS) >= 6
    assert EXTRAS.keys() <= {program.stem for program in PROGRAMS}


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_programs_print_what_they_say(program: Path, tmp_path: Path) -> None:
    needed = EXTRAS.get(program.stem)
    if needed is not None and find_spec(needed) is None:
        pytest.skip(f"needs {needed}")
    done = run(tmp_path, str(program))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == stated(program)
    assert stated(program) != []
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", EXTRAS)
def test_programs_say_in_one_line_what_is_missing(name: str, tmp_path: Path) -> None:
    done = run(tmp_path, "-c", WITHOUT, EXTRAS[name], str(FOLDER / f"{name}.py"))
    assert done.returncode == 1
    assert done.stdout == ""
    (line,) = done.stderr.splitlines()
    assert f"planar-planner[{EXTRAS[name]}]" in line
