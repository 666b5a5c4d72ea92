"""When all links of a channel are tested, and when only those up to the first that fails."""

from __future__ import annotations

import math
from dataclasses import replace

from planar_planner import Options, load_scene, solve
from planar_planner.margins.offset import Offsets
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem
from scenarios.model import Scene, box, scene

BAFFLES = 1000
PITCH, HEIGHT, OPENING = 3.0, 4.0, 1.2


def chain() -> Scene:
    """Return a bar that must pass baffles open at the top and at the bottom in turn."""
    baffles = []
    for k in range(BAFFLES):
        x = PITCH * (k + 1)
        low, high = (-1.0, HEIGHT - OPENING) if k % 2 == 0 else (OPENING, HEIGHT + 1.0)
        baffles.append(box(x - 0.1, low, x + 0.1, high))
    length = PITCH * (BAFFLES + 1)
    return scene(
        "baffles",
        "A bar past baffles.",
        workspace=(0.0, 0.0, length, HEIGHT),
        robot=box(-0.8, -0.2, 0.8, 0.2),
        obstacles=baffles,
        start=(0.5 * PITCH, 0.5 * HEIGHT, 0.5 * math.pi),
        goal=(length - 0.5 * PITCH, 0.5 * HEIGHT, 0.5 * math.pi),
    )


def test_a_long_chain_of_gates_is_linked_in_few_rounds() -> None:
    """Testing links only up to the first that fails takes 1,396 rounds."""
    stats = solve(chain()).stats
    assert stats.faces_tested > BAFFLES
    assert stats.search_rounds < BAFFLES // 2


def test_a_bottleneck_that_is_about_to_close_is_not_made_dearer_by_other_links() -> None:
    """With all links tested each time the search takes 24 million steps."""
    problem = make_problem(load_scene("maze-blocked"))
    body = Offsets(problem.robot).between(-0.1453, -0.1447)
    assert body.polygons is not None
    problem = replace(problem, robot=body.polygons)
    core = make_core(problem, without=["shift", "survey"])  # with them it takes a part of this
    answer = ask(core, problem, Options())
    assert answer["verdict"] == "no_path"
    assert answer["stats"].faces_tested > 10_000
    assert answer["stats"].search_expansions < 4_000_000
