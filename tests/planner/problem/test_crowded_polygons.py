"""Large polygons with long edges between crowded vertices, which take a way of their own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import pdg
from planar_planner import Planner, load_scene
from support.scene_gate import polygon

TEETH = 2000
STEP = 2.0**-10  # so that all coordinates, and twice the area, are exact
WIDTH = TEETH * STEP


def sheaf() -> list[list[float]]:
    """Return a zigzag between two rows of vertices, whose long edges cross triangles of both."""
    teeth = [[k * STEP, 0.0] for k in range(TEETH)]
    tips = [[k * STEP + 3 * WIDTH, 10.0] for k in range(TEETH)]
    zigzag = [point for pair in zip(teeth, tips, strict=True) for point in pair]
    return [*zigzag, [5 * WIDTH, 10.0], [5 * WIDTH, -5.0], [-1.0, -5.0]]


def twice_area(ring: Any) -> float:
    x, y = np.asarray(ring).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def test_the_pieces_tile_it() -> None:
    ring = sheaf()
    pieces = pdg.convex_pieces([ring], cover=False)
    areas = [twice_area(piece) for piece in pieces]
    assert min(areas) > 0.0
    assert sum(areas) == abs(twice_area(ring))


@pytest.mark.parametrize("role", ["obstacle", "goal"])
def test_a_scene_with_it_is_answered(role: str) -> None:
    ring = sheaf()
    shape = polygon([*ring, ring[0]])
    goal = [5 * WIDTH + 5, -2, 0] if role == "obstacle" else {"region": shape, "theta": [0, 1]}
    box = polygon([[-1, -0.2], [1, -0.2], [1, 0.2], [-1, 0.2], [-1, -0.2]])
    scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [-20, -20, 40, 40]},
        "robot": box,
        "obstacles": [shape] if role == "obstacle" else [],
        "start": [-10, 0, 0],
        "goal": goal,
    }
    assert Planner(load_scene(scene)).solve().verdict == "path"
