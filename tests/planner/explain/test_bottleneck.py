"""The thinnest place of a wall of FULL cells."""

import numpy as np
import pytest

from planar_planner import Planner
from scenarios.bug_trap import bug_trap
from scenarios.gear import gear


def test_a_neck_that_is_too_narrow_is_the_bottleneck() -> None:
    """The robot is 0.5 high: centred in the neck it overlaps by half of what is missing."""
    for neck in (0.36, 0.4, 0.44):
        planner = Planner(bug_trap(neck, "narrow"))
        assert planner.solve().verdict == "no_path"
        found = planner.bottleneck()
        assert found is not None
        least = 0.5 * (0.5 - neck)
        assert least * (1 - 1e-9) < found.depth < least + 0.02
        assert abs(found.at[1]) < 0.2  # the neck lies about y = 0
        assert np.linalg.norm(found.crossing[0] - found.crossing[-1]) > 0.0


def test_depths_are_those_of_the_placements() -> None:
    planner = Planner("gear-jammed")
    planner.solve()
    found = planner.bottleneck()
    assert found is not None
    again = Planner("gear-jammed")
    depth = again._core.placement(tuple(found.at))["depth"]
    assert depth == pytest.approx(found.depth, rel=1e-12)
    assert found.depth == found.depths[found.index] > 0.0
    assert np.all(found.depths >= 0.0)


def test_it_says_how_much_gears_lack() -> None:
    """Half of the gap that is missing: the critical gap is 1.66336 (docs/gallery.md)."""
    planner = Planner(gear(gap=1.6, name="jammed"))
    assert planner.solve().verdict == "no_path"
    found = planner.bottleneck()
    assert found is not None
    assert found.depth == pytest.approx(0.5 * (1.66336 - 1.6), rel=0.1)


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
    assert planner.solve().stats["decided_by"] == "disc"
    found = planner.bottleneck()
    assert found is not None
    assert found.depth > 0.0


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
    assert found.depth > 0.0
    assert np.linalg.norm(found.crossing[0, :2] - found.crossing[-1, :2]) > 0.0
