"""`planar-planner compare`: ours and OMPL's planners on scenes in one run."""

from __future__ import annotations

import argparse
import platform
import sys
from importlib.metadata import version

from planar_planner.commands.scene_input import scene_of
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, emit, written_aside
from planar_planner.progress import Progress


def run(arguments: argparse.Namespace) -> int:
    """Compare, and report scene by scene; then JSON and picture. 0 unless the input is wrong."""
    from planar_planner.compare import Settings, check_scene, compare, require_ompl
    from planar_planner.comparison import table, to_json

    settings = Settings(
        planners=tuple(part.strip() for part in arguments.planners.split(",") if part.strip()),
        runs=arguments.runs,
        limit=arguments.limit,
        resolution=arguments.resolution,
        seed=arguments.seed,
    )
    output = json_output(arguments.json)
    quiet = output.to_stdout
    if arguments.plot is not None:
        check_writable(arguments.plot)
    require_ompl()
    scenes = [scene_of(arguments, name, quiet=quiet) for name in arguments.scenes]
    for scene in scenes:  # a mistake in the last one shows before the first one's runs
        check_scene(scene)
    comparisons = []
    for scene in scenes:
        with Progress(sys.stderr, scene.name) as progress:
            comparisons.append(compare(scene, settings, progress.step))
        if not quiet:
            emit(table(comparisons[-1], settings))
    output.write(to_json(comparisons, settings, _versions()))
    if arguments.plot is not None:
        from planar_planner.comparison_plot import draw_comparison

        with written_aside(arguments.plot) as aside:
            draw_comparison(comparisons, settings, aside, arguments.plot.suffix)
    return 0


def _versions() -> dict[str, str]:
    return {
        "planar-planner": version("planar-planner"),
        "ompl": version("ompl"),
        "python": platform.python_version(),
    }
