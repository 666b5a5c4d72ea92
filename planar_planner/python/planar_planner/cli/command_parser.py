"""A parser that answers a mistake with one line and the likely spelling; light to import."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterable, Sequence
from typing import Any

from planar_planner.cli.terminal import has_colours
from planar_planner.errors import cut, one_line
from planar_planner.scene.builtin import builtin_scenes

EXIT_USAGE = 2

_OPTION = re.compile(r"-{1,2}[A-Za-z]")  # -1 and -.5 are numbers, - is standard output


class CommandParser(argparse.ArgumentParser):
    """An `argparse.ArgumentParser` with one-line errors, suggestions and a short usage line.

    Attributes
    ----------
    examples : tuple of str
        Command lines without the program's name, shown below the help. They run as they stand, one
        after another in an empty folder (tests/planner/cli/test_help.py).
    """

    def __init__(self, *, examples: Sequence[str] = (), status: str = "", **settings: Any) -> None:
        lines = "\n".join(f"  planar-planner {example}" for example in examples)
        super().__init__(
            epilog=f"examples:\n{lines}\n\nexit status: {status}".replace("%", "%%"),
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
            **settings,
        )
        self.examples = tuple(examples)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Parse, but leave nothing over: each command names what it does not know itself."""
        if args is not None:
            self._refuse_unknown_options(args)  # first, for argparse asks for what is missing first
        found, rest = super().parse_known_args(args, namespace)
        if rest:
            self.error(f"unexpected argument {_shown(rest[0])}")
        return found, rest

    def error(self, message: str) -> Any:
        """Print one line and leave with status 2."""
        self.exit(EXIT_USAGE, f"{self.prog}: {one_line(message)} (see {self.prog} --help)\n")

    def format_help(self) -> str:
        """Return the help, with one line of usage: the options follow below it."""
        if self.usage is None:
            self.usage = self._short_usage()
        return super().format_help()

    def print_help(self, file: Any = None) -> None:
        """Print the help, in colours where the stream has them."""
        stream = sys.stdout if file is None else file
        text = self.format_help()
        if has_colours(stream):
            from planar_planner.cli.styled_help import styled_help

            text = styled_help(text)
        self._print_message(text, stream)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Suggest a spelling where argparse would list all choices."""
        if action.choices is None or value in action.choices:
            return
        choices = [str(choice) for choice in action.choices]
        if isinstance(action, argparse._SubParsersAction):
            message = f"unknown command {_shown(value)}"
            self.error(message + (_did_you_mean(str(value), choices) or _scene_hint(str(value))))
        hint = _did_you_mean(str(value), choices) or f"; expected one of {', '.join(choices)}"
        raise argparse.ArgumentError(action, f"unknown value {_shown(value)}{hint}")

    def _refuse_unknown_options(self, arguments: Sequence[str]) -> None:
        commands = any(isinstance(a, argparse._SubParsersAction) for a in self._actions)
        for argument in arguments:
            if argument == "--" or (commands and not argument.startswith("-")):
                return  # what follows a command is the command's
            name = argument.partition("=")[0]
            if _OPTION.match(argument) and name not in self._option_string_actions:
                hint = _did_you_mean(name, self._option_string_actions)
                self.error(f"unknown option {cut(name)}{hint}")

    def _short_usage(self) -> str:
        words = [self.prog]
        for action in self._get_positional_actions():
            words.append(str(action.metavar or action.dest))
            if action.nargs in ("+", "*") or isinstance(action, argparse._SubParsersAction):
                words.append("…")
        return " ".join([*words, "[options]"]).replace("%", "%%")


def _shown(value: object) -> str:
    return repr(cut(str(value)))


def _did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return ``; did you mean x?`` for the closest known names, else nothing."""
    import difflib

    bare = {other.lstrip("-"): other for other in known}  # dashes would make any two options alike
    near = difflib.get_close_matches(cut(name).lstrip("-"), bare, n=3)
    close = [bare[other] for other in near]
    return "; did you mean " + " or ".join(close) + "?" if close else ""


def _scene_hint(name: str) -> str:
    """Return what to type if a scene stands where a command belongs."""
    return f"; it is a scene: planar-planner solve {name}" if name in builtin_scenes() else ""
