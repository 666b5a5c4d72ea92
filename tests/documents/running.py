"""Runs the blocks of a page in order, in one folder: a page reads as one session.

python    Executed; names carry over from block to block. A comment that begins a line right below
          an expression or a call of print is what that gives.
sh        Each line is run, in bash if it has more than a command. It exits with 0, or with what
          its comment says ("exits 1"), or with 1 where it says that there is no path.
console   The same for lines after "$ "; the lines below are what is printed, "…" stands for any.
others    Not run; a mark has them written to a file before all.
"""

from __future__ import annotations

import ast
import contextlib
import doctest
import io
import os
import re
import shlex
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from documents.fenced import Block
from planar_planner.cli.main import main

COMMANDS = ("planar-planner ",)
NOT_RUN = {"", "bibtex", "cpp", "json", "text", "toml", "yaml"}
_CHECKER = doctest.OutputChecker()
_LENIENT = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
_BEYOND_ONE_COMMAND = re.compile(r"[|&;<>$*~`]")


def run_page(blocks: list[Block], folder: Path) -> None:
    """Run all blocks of a page in `folder`, the current directory."""
    names: dict[str, Any] = {"__name__": "__main__"}
    for block in blocks:
        if "file" in block.marks:
            (folder / block.marks["file"]).write_text(block.text, encoding="utf-8")
    for block in blocks:
        if {"ci", "not run"} & block.marks.keys() or block.language.startswith("{"):
            continue
        if "needs" in block.marks and find_spec(block.marks["needs"]) is None:
            continue
        if block.language == "python":
            run_python(block, names)
        elif block.language == "sh":
            run_shell(block, folder)
        elif block.language == "console":
            run_console(block, folder)
        else:
            assert block.language in NOT_RUN, f"{block.place}: language {block.language!r}"
            assert not block.text.startswith(COMMANDS), f"{block.place}: mark it as sh"


def run_python(block: Block, names: dict[str, Any]) -> None:
    """Execute statement by statement, and compare what is shown with what comes."""
    lines = block.text.splitlines()
    for statement in ast.parse(block.text).body:
        file = f"{block.place} and on"
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            if isinstance(statement, ast.Expr):
                value = eval(compile(ast.Expression(statement.value), file, "eval"), names)
                if value is not None:
                    print(repr(value))
            else:
                exec(compile(ast.Module([statement], []), file, "exec"), names)
        if isinstance(statement, ast.Expr):
            shown = _comment_below(lines, statement.end_lineno or 0)
            if shown:
                _compare(f"{block.place}: line {statement.lineno}", shown, printed.getvalue())


def _comment_below(lines: list[str], after: int) -> str:
    """Return the comment in the lines right below line `after`, counted from 1."""
    shown = []
    for line in lines[after:]:
        if not line.startswith("#"):
            break
        shown.append(line.removeprefix("#").removeprefix(" ") + "\n")
    return "".join(shown)


def run_shell(block: Block, folder: Path) -> None:
    """Run each line, continued lines joined."""
    for line in re.sub(r"\\\n\s*", "", block.text).splitlines():
        if line.strip() and not line.startswith("#"):
            run_line(block, line, folder)


def run_console(block: Block, folder: Path) -> None:
    """Run the lines after "$ " and compare what they print."""
    sessions = re.split(r"^\$ ", re.sub(r"\\\n\s*", "", block.text), flags=re.MULTILINE)
    assert not sessions[0], f"{block.place}: begins without a command"
    for session in sessions[1:]:
        line, _, shown = session.partition("\n")
        printed = run_line(block, line, folder)
        if shown:
            _compare(f"{block.place}: {line}", shown, printed)


def run_line(block: Block, line: str, folder: Path) -> str:
    """Run a line, hold its exit status against the expected one, return what it printed."""
    words = shlex.split(line, comments=True)
    place = f"{block.place}: {line}"
    assert line.startswith(COMMANDS), f"{place}\nmark the block <!-- not run: why -->"
    command, _, comment = line.partition(" #")
    if _BEYOND_ONE_COMMAND.search(re.sub(r"'[^']*'", "", command)):
        status, printed = _in_bash(command, folder)
    else:
        status, printed = _in_process(words[1:])
    stated = re.search(r"\bexits (?:with )?(\d)", comment)
    if stated:
        assert status == int(stated[1]), f"{place}\nexits {status}\n{printed}"
    else:
        assert status == 0 or (status == 1 and "no path" in printed.lower()), (
            f"{place}\nexits {status}\n{printed}"
        )
    return printed


def _in_process(arguments: list[str]) -> tuple[int, str]:
    """Call the command line's main: it saves the start of an interpreter."""
    stream = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True)
    with contextlib.redirect_stdout(stream), contextlib.redirect_stderr(stream):
        status = main(arguments)
    stream.seek(0)
    return status, stream.read()


def _in_bash(command: str, folder: Path) -> tuple[int, str]:
    """Run in bash, with this interpreter's planar-planner for the command of that name."""
    function = 'planar-planner() { "$PYTHON" -P -m planar_planner "$@"; }\n'
    done = subprocess.run(
        ["bash", "-c", f"set -o pipefail\n{function}{command}"],
        env={**os.environ, "PYTHON": sys.executable},
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=60,
        check=False,
    )
    return done.returncode, done.stdout


def _compare(place: str, shown: str, printed: str) -> None:
    want = shown.replace("…", "...")
    assert _CHECKER.check_output(want, printed, _LENIENT), (
        f"{place}\nshown:\n{shown}\nprinted:\n{printed}"
    )
