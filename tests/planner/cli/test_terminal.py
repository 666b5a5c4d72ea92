"""Colours and tables: on a terminal only, and never against the user's wish."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest

from planar_planner.scene.builtin import manifest
from support.pseudo_terminal import on_terminal

pytestmark = pytest.mark.skipif(os.name != "posix", reason="opens a pseudo-terminal")

ESCAPE = "\x1b"


def plain(text: str) -> str:
    return re.sub(r"\x1b\[[\d;]*m", "", text).replace("\r\n", "\n")


@pytest.mark.parametrize(
    ("scene", "words", "status"),
    [("corner", "path found", 0), ("slot-jammed", "no path, proven", 1)],
)
def test_verdict_is_coloured(scene: str, words: str, status: int) -> None:
    ended = on_terminal("check", scene)
    assert ended.status == status
    assert f"{ESCAPE}[1;3" in ended.terminal
    assert f"m{words}{ESCAPE}[0m" in ended.terminal
    assert plain(ended.terminal).startswith(f"{scene}: {words} (")
    assert ended.terminal.count(ESCAPE) == 2  # nothing else: no progress, no leftovers


@pytest.mark.parametrize("environment", [{"NO_COLOR": "1"}, {"TERM": "dumb"}])
@pytest.mark.parametrize("arguments", ["check corner", "list", "solve --help"])
def test_no_colours_when_unwanted(arguments: str, environment: dict[str, str]) -> None:
    ended = on_terminal(*arguments.split(), **environment)
    assert ended.status == 0
    assert ended.terminal
    assert ESCAPE not in ended.terminal


def test_help_is_coloured_and_says_the_same() -> None:
    ended = on_terminal("solve", "--help", columns=100, COLUMNS="100")
    assert f"{ESCAPE}[1mexamples:{ESCAPE}[0m" in ended.terminal
    assert f"{ESCAPE}[36m--certificate{ESCAPE}[0m FILE" in ended.terminal
    piped = on_terminal("solve", "--help", streams=(), COLUMNS="100").piped
    assert plain(ended.terminal) == piped


def test_empty_no_color_is_no_wish() -> None:
    assert ESCAPE in on_terminal("check", "corner", NO_COLOR="").terminal


@pytest.mark.parametrize("arguments", ["check corner", "list", "show gear", "--help"])
def test_no_colours_in_a_pipe_of_a_terminal(arguments: str) -> None:
    """Even if the environment has the wish that rich would follow."""
    ended = on_terminal(*arguments.split(), streams=("stderr",), FORCE_COLOR="1")
    assert ended.status == 0
    assert ended.terminal == ""
    assert ended.piped
    assert ESCAPE not in ended.piped


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_list_has_one_line_a_scene_at_any_width(columns: int) -> None:
    ended = on_terminal("list", columns=columns)
    lines = plain(ended.terminal).rstrip("\n").split("\n")
    assert len(lines) == len(manifest()) + 2
    assert all(len(line) <= columns for line in lines)
    if columns >= 80:
        assert [line.split()[0] for line in lines[2:]] == list(manifest())


def test_verify_is_coloured(tmp_path: Path) -> None:
    file = tmp_path / "c.json"
    on_terminal("check", "corner", "--certificate", str(file))
    valid = on_terminal("verify", "corner", str(file))
    assert f"valid{ESCAPE}[0m: path" in valid.terminal
    content = json.loads(file.read_text())
    content["segments"] = content["segments"][:-1]
    file.write_text(json.dumps(content))
    rejected = on_terminal("verify", "corner", str(file))
    assert rejected.status == 1
    assert f"rejected{ESCAPE}[0m: segments" in rejected.terminal


def test_errors_are_plain_single_lines() -> None:
    ended = on_terminal("solve", "geear")
    assert ended.status == 2
    expected = "geear: no built-in scene and no file of this name; did you mean 'gear'?"
    assert ended.terminal == f"planar-planner: {expected}\r\n"
