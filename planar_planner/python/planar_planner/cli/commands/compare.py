"""`planar-planner compare`: runs this planner and OMPL's planners on the same scenes."""

from __future__ import annotations

import argparse
import platform
import sys
from importlib.metadata import version
from typing import Any

from planar_planner.cli.arguments.importing import STDIN, add_importing, scene_of
from planar_planner.cli.arguments.shared import (
    DONE,
    add_command,
    add_json,
    add_plot,
    real_number,
    whole_number,
)
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.errors import OptionsError
from planar_planner.ompl.comparison import table, to_json
from planar_planner.ompl.samplers import DEFAULT_SAMPLERS
from planar_planner.output_files import check_writable, emit, written_aside


def add(commands: Any) -> None:
    """Add the command."""
    compare = add_command(
        commands,
        "compare",
        "compare with OMPL's planners in one run; needs the extra [ompl]",
        examples=(
            "compare slot --runs 3 --timeout 2",
            "compare corner slot --planners RRTConnect,PRM --runs 3 --timeout 2 --plot times.svg",
        ),
        status=DONE,
    )
    compare.add_argument(
        "scenes",
        metavar="SCENE",
        nargs="+",
        help="built-in names (see list) or files, scenes or any other known format",
    )
    compare.add_argument(
        "--planners",
        metavar="A,B,…",
        default=",".join(DEFAULT_SAMPLERS),
        help="names of OMPL's planners (default: %(default)s)",
    )
    for name, metavar, kind, default, what in (
        ("runs", "N", whole_number, 11, "number of runs of each planner"),
        ("timeout", "SECONDS", real_number, 10.0, "longest time of a run"),
        ("resolution", "FRACTION", real_number, 0.002, "resolution of OMPL's motion validation"),
        ("seed", "N", whole_number, 0, "run i (from 0) of a planner uses the seed N + i + 1"),
    ):
        compare.add_argument(
            f"--{name}",
            metavar=metavar,
            type=kind,
            default=default,
            help=f"{what} (default: %(default)s)",
        )
    add_json(compare, "all runs")
    add_importing(compare)
    add_plot(compare, "draw times to the first solution")
    compare.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Compare, report scene by scene, and write JSON and picture; return 0."""
    from planar_planner.ompl.compare import Settings, check_scene, compare, require_ompl

    settings = Settings(
        planners=tuple(part.strip() for part in arguments.planners.split(",") if part.strip()),
        runs=arguments.runs,
        timeout=arguments.timeout,
        resolution=arguments.resolution,
        seed=arguments.seed,
    )
    output = json_output(arguments.json)
    quiet = output.to_stdout
    if arguments.plot is not None:
        check_writable(arguments.plot)
    if arguments.scenes.count(STDIN) > 1:
        raise OptionsError("standard input is one scene: name - once")
    require_ompl()
    scenes = [scene_of(arguments, name, quiet=quiet) for name in arguments.scenes]
    for scene in scenes:  # a mistake in the last scene is reported before the first run
        check_scene(scene)
    comparisons = []
    for scene in scenes:
        with Progress(sys.stderr, scene.name) as progress:
            comparisons.append(compare(scene, settings, progress.step))
        if not quiet:
            emit(table(comparisons[-1], settings))
    output.write(to_json(comparisons, settings, _versions()))
    if arguments.plot is not None:
        from planar_planner.pictures.comparison import draw_comparison

        with written_aside(arguments.plot) as aside:
            draw_comparison(comparisons, settings, aside, arguments.plot.suffix)
    return 0


def _versions() -> dict[str, str]:
    return {
        "planar-planner": version("planar-planner"),
        "ompl": version("ompl"),
        "python": platform.python_version(),
    }
