"""`planar-planner solve` and `planar-planner check`: decide a query and report."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from planar_planner.command_arguments.limits import options_of
from planar_planner.commands.scene_input import scene_of
from planar_planner.output import OutputError, check_writable, complain, emit, written_aside
from planar_planner.progress import Progress
from planar_planner.report import headline, statistics

if TYPE_CHECKING:
    from planar_planner.result import Result

EXIT_STATUS = {"path": 0, "no_path": 1, "undecided": 3}
_STDOUT = "-"


def run(arguments: argparse.Namespace) -> int:
    """Solve, then report: text, JSON, picture. The exit status is the verdict."""
    options = options_of(arguments)
    json_file = None if arguments.json in (None, _STDOUT) else Path(arguments.json)
    for file in (json_file, arguments.certificate, arguments.plot):
        if file is not None:
            check_writable(file)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    from planar_planner.planner import solve  # only now: a misspelt name is answered at once

    with Progress(sys.stderr, quiet=arguments.quiet) as progress:
        result = solve(
            scene, options, listener=progress, certificate=arguments.certificate is not None
        )
    if arguments.json == _STDOUT:
        _print_json(result)
    else:
        _print_text(result, brief=arguments.quiet or arguments.verdict_only)
    if scene.holds_for and result.verdict not in (scene.holds_for, "undecided"):
        complain(one_sided(scene.holds_for))
    if json_file is not None:
        with written_aside(json_file) as aside:
            aside.write_text(as_json(result) + "\n", encoding="utf-8")
    if arguments.certificate is not None:
        _write_certificate(result, arguments.certificate)
    if arguments.plot is not None:
        from planar_planner.plot import draw_scene, save_picture

        figure = draw_scene(scene, result)
        with written_aside(arguments.plot) as aside:
            save_picture(figure, aside, arguments.plot.suffix)
    return EXIT_STATUS[result.verdict]


def _write_certificate(result: Result, file: Path) -> None:
    if result.certificate is None:
        complain(f"{file} is not written: an undecided answer has no certificate")
        return
    from planar_planner.certificate import write_certificate

    with written_aside(file) as aside:
        write_certificate(result.certificate, aside, file.name)


def one_sided(holds_for: str) -> str:
    """Return why the other verdict than this one says nothing of a file's curves."""
    if holds_for == "path":
        return "curves were flattened outwards: this proof is about outlines; try --flatten inwards"
    return "curves were flattened inwards: this path is among outlines; try --flatten outwards"


def as_json(result: Result) -> str:
    """Return the result as JSON text; a value that JSON cannot hold would be a defect, so raise."""
    return json.dumps(result.to_json(), indent=1, allow_nan=False)


def _print_json(result: Result) -> None:
    """Print the result and nothing else to standard output, which must be there."""
    if sys.stdout is None:
        raise OutputError("cannot write standard output: it is closed")
    emit(as_json(result))


def _print_text(result: Result, *, brief: bool) -> None:
    emit(headline(result) if brief else f"{headline(result)}\n{statistics(result)}")
