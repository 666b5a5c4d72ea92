"""`planar-planner convert`: files in outside formats ⇄ scene files."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from pathlib import Path

from planar_planner.commands.scene_input import scene_of
from planar_planner.formats.registry import write_scene
from planar_planner.json_output import json_output
from planar_planner.output import check_writable, emit, written_aside
from planar_planner.problem import make_problem
from planar_planner.progress import Progress
from planar_planner.size import scene_size, size_json

FORMAT = "planar-planner/conversion"
VERSION = 1


def run(arguments: argparse.Namespace) -> int:
    """Read, check, write; print what was written. 0 unless the input is wrong."""
    output = json_output(arguments.json)
    check_writable(arguments.out)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    with Progress(sys.stderr, "checking the shapes", quiet=arguments.quiet):
        make_problem(scene)
    content = scene.to_dict()
    files: Mapping[Path, bytes]
    if arguments.out.suffix.lower() == ".json":
        text = json.dumps(content, indent=1, allow_nan=False) + "\n"
        files = {arguments.out: text.encode()}
    else:
        files = write_scene(content, arguments.out)
    for file, data in files.items():
        check_writable(file)
        with written_aside(file) as aside:
            aside.write_bytes(data)
    size = scene_size(scene)
    if not output.to_stdout:
        emit(
            f"{', '.join(map(str, files))}: robot of {size.robot_vertices} vertices, "
            f"{size.obstacle_polygons} obstacle(s) of {size.obstacle_vertices} vertices"
        )
    output.write(
        {
            "format": FORMAT,
            "version": VERSION,
            "scene": scene.name,
            "files": [str(file) for file in files],
            **size_json(size),
            "notes": list(scene.notes),
        }
    )
    return 0
