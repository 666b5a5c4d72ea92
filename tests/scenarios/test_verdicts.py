"""Expected verdicts of the manifest, proved without the planner.

Flood fills of sound C-space grids for the scenes where they are cheap (the others are proved by
``tests/oracles/decisive.py``), and the analytic criterion for the corner.
"""

import json
from typing import Literal

import numpy as np
import pytest

from oracles.decisive import FOLDER, QUICK, SLOW, listed, proves
from oracles.grid import decide, flood, free_cells, make_grid
from oracles.rectilinear import is_joined
from oracles.scene_shapes import shapes
from scenarios import corner, escape, gear, maze


@pytest.mark.parametrize("name", QUICK)
def test_grid_proves_expected_verdict(name: str) -> None:
    assert proves(name)


def test_grid_never_proves_the_opposite() -> None:
    """A sound grid proves one claim at most, at any step."""
    for name, entry in listed().items():
        if name not in QUICK:
            continue
        scene = json.loads((FOLDER / entry["file"]).read_text(encoding="utf-8"))
        opposite = "no_path" if entry["expected"] == "path" else "path"
        assert not decide(scene, 2.0 * QUICK[name], claim=opposite), name


def test_every_scene_is_proved_somewhere() -> None:
    analytic = {"corner", "corner-too-long", "cage", "cage-open"}
    by_planner = {"gear", "gear-tight"}  # too tight for a uniform grid: their paths are checked
    by_planner |= {"disassembly", "disassembly-jammed", "piano-anywhere"}  # and certificates
    by_planner |= {"peg", "peg-jammed", "locked", "unlocked"}
    assert set(QUICK) | set(SLOW) | analytic | by_planner | set(EXACT) == set(listed())


EXACT = ("exact-maze", "exact-maze-ulp", "sliding-block", "sliding-block-ulp")


@pytest.mark.parametrize("name", EXACT)
def test_a_flood_fill_of_coordinates_proves_exact_fits(name: str) -> None:
    entry = listed()[name]
    scene = json.loads((FOLDER / entry["file"]).read_text(encoding="utf-8"))
    assert is_joined(scene) is (entry["expected"] == "path")


def test_cages_lie_on_either_side_of_the_critical_mouth() -> None:
    """A convex body passes a gap that is at least as wide as the body, and no other."""
    width = 2.0 * np.cos(np.pi / 16)
    assert 0.97 * width > escape.CAGING_MOUTH
    assert 1.01 * width < escape.OPEN_MOUTH


def test_corner_scenes_lie_on_either_side_of_the_critical_length() -> None:
    critical = corner.critical_length(corner.DEFAULT_WIDTH)
    assert 0.99 * critical > corner.PATH_LENGTH
    assert 1.01 * critical < corner.TOO_LONG


@pytest.mark.parametrize(
    ("length", "claim"), [(1.7, "path"), (2.35, "no_path")], ids=["short", "long"]
)
def test_critical_length_of_a_wide_rectangle(
    length: float, claim: Literal["path", "no_path"]
) -> None:
    """Width 0.4: critical length 2.03, here off by 16 percent, within the grid's reach."""
    scene = json.loads(json.dumps(corner.corner(length, 0.4)))
    assert decide(scene, 0.04, claim=claim)


def test_gear_gaps_are_in_order() -> None:
    gaps = [gear.JAMMED_GAP, gear.CRITICAL_GAP, gear.TIGHT_GAP, gear.PATH_GAP, gear.WIDE_GAP]
    assert gaps == sorted(gaps)
    assert gear.TIGHT_GAP < 1.01 * gear.CRITICAL_GAP
    assert gear.WIDE_GAP > 2.0 * gear.ROBOT_TIP_RADIUS


def test_maze_needs_turning() -> None:
    """At the angle of the start, no translation reaches the goal's cell of the maze."""
    made = shapes({**json.loads(json.dumps(maze.maze())), "rotation": False})
    grid = make_grid(made, 0.05)
    start = grid.index(list(maze.maze()["start"]))
    free = free_cells(made, grid, side="superset")
    assert free[start]
    _, x, y = np.nonzero(flood(free, start, diagonal=True))
    last = maze.SIZE - 1
    assert not np.any((grid.x[x] > last) & (grid.y[y] > last))
