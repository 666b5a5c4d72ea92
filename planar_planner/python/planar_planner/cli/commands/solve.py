"""`planar-planner solve`, and the work of `check`: decides a query and reports the result."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_planner.cli.arguments.importing import scene_of
from planar_planner.cli.arguments.limits import options_of
from planar_planner.cli.arguments.query import add_query
from planar_planner.cli.arguments.shared import VERDICTS, add_command, add_plot
from planar_planner.cli.arguments.view import add_view, view_of
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.cli.report import setup_line, statistics
from planar_planner.cli.terminal import VERDICT_STYLES, styled
from planar_planner.output_files import check_writable, complain, emit, written_aside
from planar_planner.planning.result_text import headline

if TYPE_CHECKING:
    from planar_planner.planning.options import Options
    from planar_planner.planning.planner import Planner
    from planar_planner.planning.result import Result

EXIT_STATUS = {"path": 0, "no_path": 1, "undecided": 3}


def add(commands: Any) -> None:
    """Add the command."""
    solve = add_command(
        commands,
        "solve",
        "find a path, or prove that there is none",
        examples=(
            "solve gear --plot gear.png",
            "solve gear --plot slices.svg --view slices --theta 0,30deg,60deg",
            "solve bug-trap-closed --plot why.png --view wall",
            "solve corner --start 2.5,0.5,0 --goal 0.5,2.5,-1.5708 --json result.json",
            "solve gear-jammed --certificate jammed.json.gz",
            "solve corner --json - --quiet",
        ),
        status=VERDICTS,
    )
    add_query(solve)
    add_plot(solve, "draw the scene and the result")
    add_view(solve)
    solve.set_defaults(run=run, verdict_only=False)


def run(arguments: argparse.Namespace) -> int:
    """Solve, then report as text, JSON and picture. The exit status states the verdict."""
    options = options_of(arguments)
    view = view_of(arguments)
    output = json_output(arguments.json)
    for file in (arguments.certificate, arguments.plot):
        if file is not None:
            check_writable(file)
    began = time.perf_counter()
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    reading = time.perf_counter() - began
    from planar_planner.planning.planner import (
        Planner,  # only now: a misspelt name is answered at once
    )

    with Progress(sys.stderr, "checking the scene", quiet=arguments.quiet) as progress:
        planner = Planner(scene)
        result = planner.solve(
            options=options, listener=progress, certificate=arguments.certificate is not None
        )
    arguments.stated.status = EXIT_STATUS[result.verdict]
    if not output.to_stdout:
        brief = arguments.quiet or arguments.verdict_only
        print_verdict(result, brief=brief, contact_tolerance=options.contact_tolerance)
        if not brief:
            emit(setup_line(reading, planner.setup_seconds))
    output.write(result.to_json())
    say_one_sided(result)
    if arguments.certificate is not None:
        _write_certificate(result, arguments.certificate)
    if arguments.plot is not None:
        _draw(planner, result, view, arguments, options)
    return EXIT_STATUS[result.verdict]


def _draw(
    planner: Planner,
    result: Result,
    view: str | None,
    arguments: argparse.Namespace,
    options: Options,
) -> None:
    from planar_planner.pictures.style import save_picture
    from planar_planner.pictures.views import ViewError, draw_view

    try:
        figure = draw_view(planner, result, view, arguments.theta, options)
    except ViewError as error:
        complain(f"{arguments.plot} is not written: {error}")
        return
    with written_aside(arguments.plot) as aside:
        save_picture(figure, aside, arguments.plot.suffix)


def _write_certificate(result: Result, file: Path) -> None:
    if result.certificate is None:
        complain(f"{file} is not written: an undecided answer has no certificate")
        return
    from planar_planner.planning.certificate import write_certificate

    with written_aside(file) as aside:
        write_certificate(result.certificate, aside, file.name)


def say_one_sided(result: Result) -> None:
    """Say on standard error if the verdict does not hold for the curves of the scene's file."""
    holds_for = result.imported.holds_for
    if not holds_for or result.verdict in (holds_for, "undecided"):
        return
    complain(
        "curves were flattened outwards: this proof holds for the flattened outlines only; "
        "try --flatten inwards"
        if holds_for == "path"
        else "curves were flattened inwards: this path holds for the flattened outlines only; "
        "try --flatten outwards"
    )


def print_verdict(result: Result, *, brief: bool, contact_tolerance: float = 0.0) -> None:
    """Print the verdict, coloured on a terminal, and the statistics unless `brief`."""
    style = VERDICT_STYLES[result.verdict]
    first = headline(result, lambda verdict: styled(verdict, style, sys.stdout))
    more = "" if brief else f"\n{statistics(result, contact_tolerance=contact_tolerance)}"
    emit(first + more)
