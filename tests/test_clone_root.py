"""In the clone's root Python finds the installed packages, not the folders of the same names."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pdg
import planar_planner
from documents.fenced import fenced_blocks

ROOT = Path(__file__).parents[1]
FILES = "import pdg, planar_planner; print(pdg.__file__); print(planar_planner.__file__)"


def run(folder: Path, *arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        cwd=folder,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_tests_run_against_what_is_installed(tmp_path: Path) -> None:
    installed = run(tmp_path, "-P", "-c", FILES).splitlines()
    assert [pdg.__file__, planar_planner.__file__] == installed


def test_python_in_the_root_finds_what_is_installed(tmp_path: Path) -> None:
    assert run(ROOT, "-c", FILES) == run(tmp_path, "-P", "-c", FILES)


def test_the_readme_runs_in_the_root() -> None:
    programs = [b.text for b in fenced_blocks(ROOT / "README.md") if b.language == "python"]
    assert programs
    for program in programs:
        assert run(ROOT, "-c", program).startswith("path\n")


def test_pytest_in_the_root_tests_what_is_installed() -> None:
    """As ``python -m pytest``, which puts the root before everything else."""
    this = Path(__file__).relative_to(ROOT)
    name = test_tests_run_against_what_is_installed.__name__
    shown = run(ROOT, "-m", "pytest", "-p", "no:cacheprovider", "-v", "-k", name, str(this))
    assert "1 passed" in shown
