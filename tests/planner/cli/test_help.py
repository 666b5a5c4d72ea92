"""Help: every example that a command shows runs; mistakes are answered with the likely spelling."""

from __future__ import annotations

import importlib.util
import shlex
from pathlib import Path

import pytest

from planar_planner.cli.main import main
from planar_planner.cli.parser import make_parser
from support.command import parsers

EXTRAS = {"compare": "ompl"}  # command → the module that its extra brings


@pytest.mark.parametrize("command", parsers())
def test_examples_of_the_help_run(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    needed = EXTRAS.get(command)
    if needed is not None and importlib.util.find_spec(needed) is None:
        pytest.skip(f"needs {needed}")
    examples = parsers()[command].examples
    assert examples
    assert any(shlex.split(example)[0] == command for example in examples) or not command
    monkeypatch.chdir(tmp_path)
    for example in examples:
        assert main(shlex.split(example)) in (0, 1), example
        assert f"  planar-planner {example}\n" in parsers()[command].format_help()
    complaints = [line for line in capsys.readouterr().err.splitlines() if ": undecided" in line]
    assert complaints == []


@pytest.mark.parametrize("command", parsers())
def test_help_fits_and_names_the_exit_status(
    command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*command.split(), "--help"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith(f"usage: planar-planner {command}".rstrip())
    assert "\nexit status: 0 " in shown
    examples = shown.partition("\nexamples:")[2]
    assert all(len(line) < 80 for line in shown.removesuffix(examples).splitlines())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ("slove gear", "unknown command 'slove'; did you mean solve?"),
        ("gear", "unknown command 'gear'; it is a scene: planar-planner solve gear"),
        ("--vesion", "unknown option --vesion; did you mean --version?"),
        ("solve gear --plto x.png", "unknown option --plto; did you mean --plot?"),
        ("solve --plto=x.png", "unknown option --plto; did you mean --plot?"),
        ("check gear --max-cell 3", "unknown option --max-cell; did you mean --max-cells? ("),
        ("check gear --view wall", "unknown option --view (see"),  # --quiet is not near
        ("solve gear --flatten inward", "unknown value 'inward'; did you mean inwards?"),
        ("solve gear --flatten x", "unknown value 'x'; expected one of outwards, inwards"),
        ("solve gear corner", "unexpected argument 'corner'"),
        ("solve geear", "did you mean 'gear'"),
        ("", "required: COMMAND"),
    ],
)
def test_likely_spellings(arguments: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments.split()) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err
    assert captured.err.startswith("planar-planner")
    assert captured.err.count("\n") == 1


def test_values_that_begin_with_a_minus_are_no_options(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert (
        main(["solve", "--contact-tolerance", "-0", "--goal", "-1,2,0", "--json", "-", "geear"])
        == 2
    )
    assert "did you mean 'gear'" in capsys.readouterr().err


def test_one_command_is_parsed_as_among_all() -> None:
    """Only the command that is asked for is imported, and it looks the same."""
    for command, parser in parsers().items():
        if command:
            (commands,) = (a for a in make_parser(command)._actions if isinstance(a.choices, dict))
            assert list(commands.choices) == [command]
            assert commands.choices[command].format_help() == parser.format_help()
