"""A search that does not end by itself, for tests of limits and interrupts."""

from __future__ import annotations

import json
from pathlib import Path

from worlds.small import square

ENDLESS = ["--resolution", "1e-300", "--max-cells", "10000000000", "--max-memory", "1T"]


def long_search(folder: Path) -> str:
    """Write a scene that is far from decided after a second: contact all round, at any cell size.

    The door is exactly as wide as the robot, so cells in it can be neither free nor full.
    """
    wall = [
        {"type": "Polygon", "coordinates": [[[4, -1], [6, -1], [6, 4.5], [4, 4.5]]]},
        {"type": "Polygon", "coordinates": [[[4, 5.5], [6, 5.5], [6, 11], [4, 11]]]},
    ]
    content = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 10]},
        "robot": {"type": "Polygon", "coordinates": [square(0, 0, 0.5)]},
        "obstacles": wall,
        "start": [2, 5, 0.3],
        "goal": [8, 5, 0.3],
    }
    file = folder / "scene.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    return str(file)
