"""When all links of a channel are tested, and when only those up to the first that fails."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_planner import Options, load_scene, solve
from planar_planner.core import ask, make_core
from planar_planner.margins.offset import Offsets
from planar_planner.problem import make_problem
from scenarios.model import box, scene

BAFFLES = 300


def chain() -> dict[str, Any]:
    """Return a bar that must pass baffles open at the top and at the bottom in turn."""
    baffles = [
        box(2.0 * k + 1.8, -1.0, 2.0 * k + 2.0, 2.3)
        if k % 2
        else box(2.0 * k + 1.8, 1.7, 2.0 * k + 2.0, 5.0)
        for k in range(BAFFLES)
    ]
    length = 2.0 * BAFFLES + 2.0
    return scene(
        "baffles",
        "A bar past baffles.",
        workspace=(0.0, 0.0, length, 4.0),
        robot=box(-0.6, -0.1, 0.6, 0.1),
        obstacles=baffles,
        start=(0.9, 2.0, 1.5),
        goal=(length - 0.9, 2.0, 1.5),
    )


def test_a_long_chain_of_gates_is_linked_in_few_rounds() -> None:
    stats = solve(chain()).stats
    assert stats["faces_tested"] > BAFFLES
    assert stats["search_rounds"] < 5 * BAFFLES


def test_a_bottleneck_that_is_about_to_close_is_not_made_dearer_by_other_links() -> None:
    """With all links tested each time the search takes 24 million steps."""
    problem = make_problem(load_scene("maze-blocked"))
    body = Offsets(problem.robot).between(-0.1453, -0.1447)
    assert body.polygons is not None
    problem = replace(problem, robot=body.polygons)
    answer = ask(make_core(problem), problem, Options())
    assert answer["verdict"] == "no_path"
    assert answer["stats"]["faces_tested"] > 10_000
    assert answer["stats"]["search_expansions"] < 4_000_000
