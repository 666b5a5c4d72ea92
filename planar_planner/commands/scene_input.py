"""The scene that a command's arguments name, and telling the user what an importer did."""

from __future__ import annotations

import argparse
import sys

from planar_planner.command_arguments.importing import import_options
from planar_planner.errors import one_line
from planar_planner.output import complain
from planar_planner.progress import Progress
from planar_planner.scene import Scene, load_scene


def scene_of(arguments: argparse.Namespace, name: str, *, quiet: bool = False) -> Scene:
    """Load a scene with the ends, robot and readings that the arguments ask for."""
    with Progress(sys.stderr, f"reading {one_line(name)}", quiet=quiet):
        scene = load_scene(name, import_options(arguments))
    if not quiet:
        for note in scene.notes:
            complain(f"{name}: {note}")
    return scene
