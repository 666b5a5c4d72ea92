"""Squares, and one small scene."""

from __future__ import annotations

from typing import Any


def square(x: float, y: float, half: float = 0.5) -> list[list[float]]:
    """Return the closed ring of an axis-parallel square."""
    return [
        [x - half, y - half],
        [x + half, y - half],
        [x + half, y + half],
        [x - half, y + half],
        [x - half, y - half],
    ]


def small_scene() -> dict[str, Any]:
    """Return a valid scene: a unit square, one obstacle in a box, free start and goal."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "name": "small",
        "description": "one obstacle",
        "workspace": {"box": [0.0, 0.0, 10.0, 10.0]},
        "robot": {"type": "Polygon", "coordinates": [square(0, 0)]},
        "obstacles": [{"type": "Polygon", "coordinates": [square(5, 5, 1.0)]}],
        "start": [1.0, 1.0, 0.0],
        "goal": [9.0, 9.0, 0.0],
    }
