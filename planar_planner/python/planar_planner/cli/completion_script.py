"""Scripts that complete the command line in a shell; shtab makes them from the parser itself.

The placeholder of an argument determines its completions: built-in names and files for SCENE, and
files for FILE, OUT and CERT.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import shtab

from planar_planner.cli.command_parser import CommandParser
from planar_planner.scene.builtin import builtin_scenes

_FILES = ("FILE", "OUT", "CERT")
_FUNCTION = "_planar_planner_scene_or_file"  # shtab's bash escapes results of a name with _file


def completion_script(shell: str, parser: CommandParser) -> str:
    """Return the script for ``bash``, ``zsh``, ``tcsh`` or ``fish``."""
    scenes = " ".join(builtin_scenes())
    scene_or_file = {
        "bash": _FUNCTION,
        "zsh": _FUNCTION,
        "tcsh": f"`echo {scenes} *`",
        "fish": f"({_FUNCTION})",
    }
    for action in _actions(parser):
        if action.metavar == "SCENE":
            vars(action)["complete"] = scene_or_file
        elif action.metavar in _FILES:
            vars(action)["complete"] = shtab.FILE
    return shtab.complete(parser, shell, preamble=_functions(scenes).get(shell, ""))


def _functions(scenes: str) -> dict[str, str]:
    return {
        "bash": f'{_FUNCTION}() {{\n  compgen -W "{scenes}" -- "$1"\n  compgen -f -- "$1"\n}}\n',
        "zsh": f"{_FUNCTION}() {{\n"
        f"  _alternative 'scenes:built-in scene:({scenes})' 'files:file:_files'\n"
        "}\n",
        "fish": f"function {_FUNCTION}\n"
        f"  printf '%s\\n' {scenes}\n"
        "  __fish_complete_path (commandline -ct)\n"
        "end\n",
    }


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    """Yield the arguments of a parser and of its commands."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _actions(command)
        else:
            yield action
