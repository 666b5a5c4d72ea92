"""`planar-planner solve` and `planar-planner check`: decide a query and report."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from planar_planner.arguments import options_of
from planar_planner.output import OutputError, check_writable, emit, written_aside
from planar_planner.planner import Planner
from planar_planner.progress import Progress
from planar_planner.report import headline, statistics
from planar_planner.result import Result

_EXIT_STATUS = {"path": 0, "no_path": 1, "undecided": 3}


def run(arguments: argparse.Namespace) -> int:
    """Solve, then report: text, JSON, picture. The exit status is the verdict."""
    options = options_of(arguments)
    to_stdout = arguments.json == "-"
    json_file = Path(arguments.json) if arguments.json is not None and not to_stdout else None
    for file in (json_file, arguments.plot):
        if file is not None:
            check_writable(file)
    planner = Planner(arguments.scene)
    with Progress(sys.stderr, quiet=arguments.quiet) as progress:
        result = planner.solve(arguments.start, arguments.goal, options, listener=progress)
    if to_stdout:
        emit_json(result)
    else:
        brief = arguments.quiet or arguments.verdict_only
        emit(headline(result) if brief else f"{headline(result)}\n{statistics(result)}")
    if json_file is not None:
        with written_aside(json_file) as aside:
            aside.write_text(as_json(result) + "\n", encoding="utf-8")
    if arguments.plot is not None:
        from planar_planner.plot import draw_scene

        with written_aside(arguments.plot) as aside:
            draw_scene(planner.scene, result, aside)
    return _EXIT_STATUS[result.verdict]


def as_json(result: Result) -> str:
    """Return the result as JSON text; a value that JSON cannot hold would be a defect, so raise."""
    return json.dumps(result.to_json(), indent=1, allow_nan=False)


def emit_json(result: Result) -> None:
    """Print the result and nothing else to standard output, which must be there."""
    if sys.stdout is None:
        raise OutputError("cannot write standard output: it is closed")
    emit(as_json(result))
