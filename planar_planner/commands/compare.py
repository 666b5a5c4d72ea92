"""`planar-planner compare`: ours and OMPL's planners on scenes in one run."""

from __future__ import annotations

import argparse
import json
import platform
from importlib.metadata import version
from pathlib import Path

from planar_planner.commands.scene_input import scene_of
from planar_planner.output import check_writable, emit, written_aside

_STDOUT = "-"


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
    json_file = None if arguments.json in (None, _STDOUT) else Path(arguments.json)
    for file in (json_file, arguments.plot):
        if file is not None:
            check_writable(file)
    require_ompl()
    quiet = arguments.json == _STDOUT
    scenes = [scene_of(arguments, name, quiet=quiet) for name in arguments.scenes]
    for scene in scenes:  # a mistake in the last one shows before the first one's runs
        check_scene(scene)
    comparisons = []
    for scene in scenes:
        comparisons.append(compare(scene, settings))
        if not quiet:
            emit(table(comparisons[-1], settings))
    text = json.dumps(to_json(comparisons, settings, _versions()), indent=1, allow_nan=False)
    if quiet:
        emit(text)
    if json_file is not None:
        with written_aside(json_file) as aside:
            aside.write_text(text + "\n", encoding="utf-8")
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
