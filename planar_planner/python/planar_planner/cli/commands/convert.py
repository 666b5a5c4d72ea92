"""`planar-planner convert`: converts between scene files and files in other formats."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.shared import DONE, add_command, add_json, add_scene
from planar_planner.cli.json_output import JsonOutput, json_output
from planar_planner.cli.progress import Progress
from planar_planner.formats.exporting import write_scene
from planar_planner.output_files import check_distinct, check_writable, emit, written_aside
from planar_planner.scene.size import scene_size, size_json

FORMAT = "planar-planner/conversion"
VERSION = 1


def add(commands: Any) -> None:
    """Add the command."""
    convert = add_command(
        commands,
        "convert",
        "convert a file in another format into a scene file, or a scene into such a file",
        examples=(
            "convert corner corner.svg",
            "convert corner.svg corner.json --flatten inwards --tolerance 0.01",
            "convert gear gear.dxf",
        ),
        status=DONE,
    )
    add_scene(convert)
    convert.add_argument(
        "out",
        metavar="OUT",
        type=Path,
        help="file to write: .json (scene), .geojson, .wkt, .svg, .dxf, .csv or .txt (with .rob)",
    )
    add_importing(convert)
    add_json(convert, "what was written and repaired")
    convert.add_argument("--quiet", action="store_true", help="do not report repairs")
    convert.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Read, check and write the scene, report the files written, and return 0."""
    output = json_output(arguments.json)
    check_writable(arguments.out)
    scene = scene_of(arguments, arguments.scene, quiet=arguments.quiet)
    from planar_planner.problem.make import make_problem  # takes numpy

    with Progress(sys.stderr, "checking the shapes", quiet=arguments.quiet):
        make_problem(scene)
    content = scene.to_dict()
    files: Mapping[Path, bytes]
    if arguments.out.suffix.lower() == ".json":
        text = json.dumps(content, indent=1, allow_nan=False) + "\n"
        files = {arguments.out: text.encode()}
    else:
        files = write_scene(content, arguments.out)
    _check_companions(arguments, files, output)
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
            **scene.imported.to_json(),
        }
    )
    return 0


def _check_companions(
    arguments: argparse.Namespace, files: Mapping[Path, bytes], output: JsonOutput
) -> None:
    """Refuse files beside the named one, as a ``.rob`` is, that are an input or another output."""
    inputs = {"the scene": Path(arguments.scene)}
    if arguments.robot is not None:
        inputs["--robot"] = arguments.robot
    outputs = {file.name: file for file in files}
    check_distinct(inputs, outputs if output.file is None else outputs | {"--json": output.file})
