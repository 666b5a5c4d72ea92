"""The thinnest place of a wall of FULL cells."""

from typing import Any

import numpy as np

from planar_planner import Planner, margin
from scenarios.bug_trap import bug_trap
from scenarios.model import box, scene


def _gate(width: float, gap: float) -> dict[str, Any]:
    """Return a room whose wall, 0.3 thick at half its height, has one gap."""
    middle, left = 0.5 * width, 0.225 * width
    return dict(
        scene(
            "gate",
            "A box before one gap.",
            workspace=(0.0, 0.0, width, width),
            robot=box(-0.45, -0.3, 0.45, 0.3),
            obstacles=[
                box(0.0, middle, left, middle + 0.3),
                box(left + gap, middle, width, middle + 0.3),
            ],
            start=(2.0, 2.0, 0.0),
            goal=(width - 3.0, width - 3.0, 1.57),
        )
    )


def test_a_neck_that_is_too_narrow_is_the_bottleneck() -> None:
    """The robot is 0.5 high, and the neck lies about y = 0.

    At 0.4 the way overlaps elsewhere by 0.078, which is more than by its 0.075 in the neck.
    """
    for neck in (0.36, 0.41, 0.44):
        planner = Planner(bug_trap(neck, "narrow"))
        assert planner.solve().verdict == "no_path"
        found = planner.bottleneck()
        assert found is not None
        assert abs(found.at[1]) < 0.2
        assert found.collides[found.index]
        assert np.linalg.norm(found.crossing[0] - found.crossing[-1]) > 0.0


def test_the_bottleneck_collides_as_its_placement_does() -> None:
    planner = Planner("gear-jammed")
    planner.solve()
    found = planner.bottleneck()
    assert found is not None
    again = Planner("gear-jammed")
    assert again._core is not None
    for q, collides in zip(found.way, found.collides, strict=True):
        if collides:  # elsewhere a configuration may collide too, in a cell that is not proven to
            assert again._core.placement(tuple(q))["state"] == "colliding"
    assert found.collides[found.index]


def test_it_is_in_the_only_gap_and_states_no_length() -> None:
    """A box of 0.9 by 0.6 before one gap of a wall. The margin says how much it lacks."""
    for width, gap in ((8.0, 0.58), (8.0, 0.4), (20.0, 0.5)):
        scene = _gate(width, gap)
        planner = Planner(scene)
        assert planner.solve().verdict == "no_path"
        found = planner.bottleneck()
        assert found is not None
        assert found.collides[found.index]
        assert abs(found.at[0] - (0.225 * width + 0.5 * gap)) < 0.3
        assert not hasattr(found, "depth") and not hasattr(found, "depths")
        lack = margin(scene)
        assert lack.lower <= -0.5 * (0.6 - gap) <= lack.upper
        assert lack.upper - lack.lower <= lack.width


def test_the_way_leads_from_start_to_goal() -> None:
    planner = Planner("slot-jammed")
    planner.solve()
    found = planner.bottleneck()
    assert found is not None
    cells, problem = planner.cells(), planner.problem
    for end, near in ((problem.start, found.way[0]), (problem.goal, found.way[-1])):
        theta = end[2] % (2 * np.pi)
        q = np.array([end[0], end[1], theta])
        holds = np.all((cells.lower <= q) & (q <= cells.upper), axis=1)
        face = np.array([near[0], near[1], near[2] % (2 * np.pi)])
        slack = 1e-9
        touches = np.all((cells.lower - slack <= face) & (face <= cells.upper + slack), axis=1)
        assert np.any(holds & touches)


def test_a_disc_in_the_robots_place_has_one_too() -> None:
    planner = Planner("disc-jammed")
    assert planner.solve().stats.decided_by == "disc"
    found = planner.bottleneck()
    assert found is not None
    assert found.collides[found.index]


def test_a_path_has_none() -> None:
    planner = Planner("slot")
    assert planner.bottleneck() is None
    planner.solve()
    assert planner.bottleneck() is None


def test_it_is_the_same_every_time() -> None:
    ways = []
    for _ in range(2):
        planner = Planner("snowflake-jammed")
        planner.solve()
        found = planner.bottleneck()
        assert found is not None
        ways.append(found.way.tobytes())
    assert ways[0] == ways[1]


def test_a_goal_that_is_a_region_is_reached_through_the_wall() -> None:
    """The cage's mouth lies between x = 7 and 8 and is narrower than the robot."""
    planner = Planner("cage")
    assert planner.solve().verdict == "no_path"
    found = planner.bottleneck()
    assert found is not None
    assert found.collides[found.index]
    assert np.linalg.norm(found.crossing[0, :2] - found.crossing[-1, :2]) > 0.0
