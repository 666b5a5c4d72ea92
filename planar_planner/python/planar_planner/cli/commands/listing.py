"""`planar-planner list`: lists the built-in scenes; reads them without numpy and the core."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from typing import Any

from planar_planner.cli.arguments.shared import DONE, add_command, add_json
from planar_planner.cli.json_output import json_output
from planar_planner.cli.terminal import is_terminal
from planar_planner.load import load_scene
from planar_planner.output_files import emit
from planar_planner.scene.builtin import manifest
from planar_planner.scene.size import scene_size, size_json

FORMAT = "planar-planner/scenes"
VERSION = 1

_HEADINGS = ("scene", "obstacles", "vertices", "robot", "expected", "origin")
_NUMERIC = 3  # columns 1 to 3 are aligned to the right
_EXPECTED = 4


def add(commands: Any) -> None:
    """Add the command."""
    listing = add_command(
        commands,
        "list",
        "list the built-in scenes with size, expected verdict and origin",
        examples=("list", "list --json scenes.json"),
        status=DONE,
    )
    add_json(listing, "the list")
    listing.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print one line per scene, in the manifest's order."""
    output = json_output(arguments.json)
    scenes = [_entry(name, entry) for name, entry in manifest().items()]
    if not output.to_stdout:
        rows = [_row(scene) for scene in scenes]
        if is_terminal(sys.stdout):
            from planar_planner.cli.terminal_table import styled_table

            verdicts = [scene["expected"] for scene in scenes]
            emit(styled_table(_HEADINGS, rows, range(1, _NUMERIC + 1), _EXPECTED, verdicts))
        else:
            emit(_plain_table([_HEADINGS, *rows]))
    output.write({"format": FORMAT, "version": VERSION, "scenes": scenes})
    return 0


def _entry(name: str, entry: Mapping[str, Any]) -> dict[str, Any]:
    size = size_json(scene_size(load_scene(name)))
    facts = {key: entry[key] for key in ("expected", "origin", "licence")}
    return {"scene": name, **size, **facts}


def _row(scene: Mapping[str, Any]) -> tuple[str, ...]:
    return (
        scene["scene"],
        str(scene["obstacles"]["polygons"]),
        str(scene["obstacles"]["vertices"]),
        str(scene["robot"]["vertices"]),
        scene["expected"].replace("_", " "),
        scene["origin"],
    )


def _plain_table(rows: list[tuple[str, ...]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(_HEADINGS))]
    return "\n".join(_aligned(row, widths) for row in rows)


def _aligned(row: tuple[str, ...], widths: list[int]) -> str:
    cells = [
        cell.rjust(width) if 1 <= column <= _NUMERIC else cell.ljust(width)
        for column, (cell, width) in enumerate(zip(row, widths, strict=True))
    ]
    return "  ".join(cells).rstrip()
