"""`planar-planner completion`: what the scripts complete, asked in the shells themselves."""

from __future__ import annotations

import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

from planar_planner.cli.commands.completion import SHELLS
from planar_planner.cli.main import main
from planar_planner.cli.parser import make_parser
from planar_planner.scene.builtin import manifest

COMMANDS = {"solve", "check", "verify", "list", "show", "compare", "convert", "completion"}
FILES = {"gear-scan.json", "map.yaml", "pictures"}

BASH = """
source {script}
COMP_WORDS=({words})
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_shtab_planar_planner
printf '%s\\n' "${{COMPREPLY[@]}}"
"""


@pytest.fixture
def folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    for shell in SHELLS:
        assert main(["completion", shell]) == 0
        (tmp_path / f"script.{shell}").write_text(capsys.readouterr().out, encoding="utf-8")
    work = tmp_path / "work"
    (work / "pictures").mkdir(parents=True)
    for name in FILES - {"pictures"}:
        (work / name).touch()
    return work


def completed(shell: str, folder: Path, *words: str) -> set[str]:
    """Return what the shell offers for the last word."""
    if shutil.which(shell) is None:
        pytest.skip(f"needs {shell}")
    script = folder.parent / f"script.{shell}"
    if shell == "bash":
        code = BASH.format(script=script, words=shlex.join(["planar-planner", *words]))
        command = ["bash", "--norc", "-c", code]
    else:
        typed = " ".join(["planar-planner", *words])
        command = [
            "fish",
            "--no-config",
            "-c",
            f"source {script}; complete -C {shlex.quote(typed)}",
        ]
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=60, check=True
    )
    assert done.stderr == ""
    return {line.partition("\t")[0].rstrip("/") for line in done.stdout.splitlines() if line}


both = pytest.mark.parametrize("shell", ["bash", "fish"])


@both
def test_commands(shell: str, folder: Path) -> None:
    assert completed(shell, folder, "") >= COMMANDS
    assert completed(shell, folder, "co") == {"compare", "convert", "completion"}


@both
def test_scenes_and_files(shell: str, folder: Path) -> None:
    assert completed(shell, folder, "solve", "") >= FILES | set(manifest())
    offered = completed(shell, folder, "check", "--quiet", "gear-")
    assert offered == {name for name in [*manifest(), "gear-scan.json"] if name.startswith("gear-")}
    assert completed(shell, folder, "verify", "gear", "") == FILES
    assert completed(shell, folder, "compare", "gear", "slot-j") == {"slot-jammed"}


@both
def test_options_and_their_values(shell: str, folder: Path) -> None:
    assert completed(shell, folder, "solve", "--max-") == {"--max-cells", "--max-memory"}
    assert "--plot" not in completed(shell, folder, "check", "--")
    assert completed(shell, folder, "solve", "gear", "--flatten", "") == {"outwards", "inwards"}
    assert completed(shell, folder, "solve", "gear", "--plot", "") == FILES
    assert completed(shell, folder, "solve", "gear", "--plot", "pic") == {"pictures"}
    assert completed(shell, folder, "completion", "") == set(SHELLS)


@pytest.mark.parametrize("shell", ["zsh", "tcsh"])
def test_other_shells_read_their_script(shell: str, folder: Path) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"needs {shell}")
    script = folder.parent / f"script.{shell}"
    code = f"source {script}"
    if shell == "zsh":
        code = f'autoload -U compinit && compinit -D && eval "$(cat {script})"'
    done = subprocess.run(
        [shell, "-f", "-c", code],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_what_is_completed_does_not_reach_the_parser_itself() -> None:
    """Scene names are offered, not demanded: files are scenes too."""
    assert make_parser().parse_args(["solve", "some.json"]).scene == "some.json"
