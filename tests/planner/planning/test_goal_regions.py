"""Goals that are sets: verdicts against point goals, critical families, cages, disassembly."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import DecidedBy, Options, Planner, SceneError, margin, solve
from worlds.goal_worlds import LIMITS, Scene, answer, cage, in_goal, moved, rectangle, shape, slot
from worlds.random_scenes import random_scene
from worlds.scene import plain

BEYOND = rectangle(7, 2, 9, 8)
TOLERANCES = [1e-2, 1e-4, 1e-7]


@pytest.mark.parametrize("theta", ["any", [1, 2], [3, 3.5], [-1, 0], [1.5, 1.5]])
@pytest.mark.parametrize("off", TOLERANCES)
def test_a_region_behind_a_slot_is_reached_or_proven_out_of_reach(off: float, theta: Any) -> None:
    goal = {"region": BEYOND, "theta": theta}
    assert answer(slot(0.5 + off, goal)).verdict == "path"
    assert answer(slot(0.5 - off, goal)).verdict == "no_path"


@pytest.mark.parametrize("off", TOLERANCES)
def test_a_robot_that_may_not_turn(off: float) -> None:
    for goal in ({"region": BEYOND}, {"region": BEYOND, "theta": [6, 7]}):
        assert answer(slot(0.5 + off, goal, rotation=False)).verdict == "path"
        assert answer(slot(0.5 - off, goal, rotation=False)).verdict == "no_path"


def test_without_rotation_the_start_has_to_have_an_angle_of_the_goal() -> None:
    with pytest.raises(SceneError, match=r"goal\.theta: must hold theta of start"):
        solve(slot(1.0, {"region": BEYOND, "theta": [1, 2]}, rotation=False))


@pytest.mark.parametrize("turns", [-3, 0, 1, 100])
def test_an_interval_counts_up_to_whole_turns(turns: int) -> None:
    """Angles near half a turn only, written on either side of the seam."""
    low = 3.0 + turns * math.tau
    result = answer(slot(1.2, {"region": BEYOND, "theta": [low, low + 0.3]}))
    assert result.verdict == "path"
    assert abs(math.remainder(result.path[-1, 2] - 3.15, math.tau)) <= 0.15 + 1e-9


def test_an_angle_that_the_corridor_does_not_allow() -> None:
    """The bar, 2 long, cannot stand upright in a corridor 1.5 high; lying it fits."""
    corridor = rectangle(6.5, 0.25, 8.5, 1.25)
    low = [rectangle(0, 1.5, 10, 10)]
    scene = slot(9, {"region": corridor, "theta": [1.3, 1.8]}, obstacles=low, start=[2, 0.75, 0])
    assert answer(scene).verdict == "no_path"
    scene["goal"]["theta"] = [-0.2, 1.8]
    assert answer(scene).verdict == "path"


def test_a_region_in_collision_is_proven_so() -> None:
    goal = {"region": rectangle(4.6, 6, 5.4, 8)}
    assert answer(slot(1.0, goal)).verdict == "no_path"


def test_a_region_partly_in_collision_is_reached_where_it_is_free() -> None:
    result = answer(slot(1.0, {"region": rectangle(4.6, 6, 6.2, 8)}))
    assert result.verdict == "path"
    assert result.path[-1, 0] > 5.5


def test_a_region_out_of_bounds_is_proven_out_of_reach() -> None:
    assert answer(slot(1.0, {"region": rectangle(12, 2, 14, 3)})).verdict == "no_path"


def test_a_start_in_the_goal_stays() -> None:
    scene = slot(0.4, {"region": rectangle(1, 1, 9, 9), "theta": [-0.5, 0.5]})
    result = answer(scene)
    assert result.verdict == "path"
    assert result.stats.path_length == result.stats.path_turning == 0.0
    scene["start"][2] = 2 * math.tau  # the same angle, whole turns on
    result = answer(scene)
    assert result.stats.path_turning < 1e-12


def test_holes_and_several_polygons() -> None:
    """A frame round the room that the bar's middle cannot enter, then one that it can."""

    def frame(width: float) -> dict[str, Any]:
        far = 10 - width
        hole = [[width, width], [width, far], [far, far], [far, width]]
        return {"type": "Polygon", "coordinates": [*rectangle(0, 0, 10, 10)["coordinates"], hole]}

    assert answer(slot(0.4, {"region": frame(0.24)})).verdict == "no_path"
    result = answer(slot(0.4, {"region": frame(0.26)}))
    assert result.verdict == "path"
    assert result.path[-1, 0] < 4.5
    two = {"type": "MultiPolygon", "coordinates": [BEYOND["coordinates"]]}
    two["coordinates"].append(rectangle(1, 8, 2, 9)["coordinates"])
    result = answer(slot(0.4, {"region": two}))
    assert result.verdict == "path"
    assert result.path[-1, 1] >= 8


@pytest.mark.parametrize("off", TOLERANCES)
@pytest.mark.parametrize("form", ["polygon", "plain"])
def test_a_cage_holds_what_is_wider_than_its_mouth(off: float, form: str) -> None:
    """The 16-gon is 2 wide between vertices, and 2 cos(pi/16) between edges."""
    width = 2 * math.cos(math.pi / 16)
    goal: Any = {"escape": rectangle(-2, -2, 10, 10)} if form == "polygon" else "escape"
    for gap, verdict in ((width + off, "path"), (width - off, "no_path")):
        scene = cage(gap, goal)
        if form == "polygon":
            assert answer(scene).verdict == verdict
            continue
        result = solve(scene, LIMITS)
        assert result.verdict == verdict
        if verdict == "path":  # clear of the obstacles' box
            x, y = result.path[-1, :2]
            assert max(-x, x - 8, -y, y - 8) >= 1.0


def test_a_ring_on_a_post_with_a_head_does_not_come_off() -> None:
    """A C around a post: it comes off through its mouth if the post is thin enough for that."""

    def scene(mouth: float) -> Scene:
        ring = [[-1.5, -1.5], [1.5, -1.5], [1.5, 1.5], [-1.5, 1.5], [-1.5, mouth / 2]]
        ring += [[-1, mouth / 2], [-1, 1], [1, 1], [1, -1], [-1, -1], [-1, -mouth / 2]]
        ring += [[-1.5, -mouth / 2]]
        return {
            "format": "planar-planner/scene",
            "version": 1,
            "reference_bounds": [-8, -8, 8, 8],
            "robot": shape(ring),
            "obstacles": [rectangle(-0.4, -0.4, 0.4, 0.4)],
            "start": [0, 0, 0],
            "goal": {"escape": rectangle(-2, -2, 2, 2)},
        }

    assert answer(scene(0.81)).verdict == "path"
    assert answer(scene(0.79)).verdict == "no_path"


@pytest.mark.parametrize("angle", [0.0, 0.3, math.pi / 2, 2.0])
def test_turning_and_moving_the_world_changes_no_verdict(angle: float) -> None:
    goals: list[Any] = [
        {"escape": rectangle(-2, -2, 10, 10)},
        {"region": rectangle(9, 3, 12, 5), "theta": [1, 2]},
    ]
    for goal in goals:
        for gap, verdict in ((2.1, "path"), (1.9, "no_path")):
            assert answer(moved(cage(gap, goal), angle, 100.0, -7.0)).verdict == verdict


def test_a_tiny_region_is_as_good_as_its_point() -> None:
    for seed in range(12):
        scene = plain(random_scene(seed))
        x, y, theta = scene["goal"]
        expected = solve(scene, Options(max_cells=3000))
        small = 1e-9
        scene["goal"] = {"region": rectangle(x - small, y - small, x + small, y + small)}
        scene["goal"]["theta"] = [theta - small, theta + small]
        result = answer(scene, Options(max_cells=6000))
        if "undecided" not in (expected.verdict, result.verdict):
            assert result.verdict == expected.verdict


def test_random_regions_agree_with_goals_sampled_from_them() -> None:
    """No goal of a region that is proven out of reach is reached."""
    rng = np.random.default_rng(7)
    decided = 0
    for seed in range(25):
        scene = plain(random_scene(seed))
        angles = np.sort(rng.uniform(-7, 7, 2)).tolist()
        center, radius = rng.uniform(2, 8, 2), rng.uniform(0.3, 2.0)
        around = shapely.Point(center).buffer(radius, quad_segs=2)
        region = {"type": "Polygon", "coordinates": [[list(p) for p in around.exterior.coords]]}
        goal: dict[str, Any] = {"region": region}
        if scene.get("rotation", True):
            goal["theta"] = angles
        result = answer({**scene, "goal": goal}, Options(max_cells=4000))
        decided += result.verdict != "undecided"
        planner = Planner(scene)
        for _ in range(4):
            point = (center + rng.uniform(-radius, radius, 2)).tolist()
            theta = rng.uniform(*angles) if "theta" in goal else scene["start"][2]
            if not in_goal(goal, [*point, theta]):
                continue
            try:
                found = planner.solve(goal=[*point, theta], options=Options(max_cells=3000))
            except SceneError:  # it collides
                continue
            if found.verdict == "path":
                assert result.verdict != "no_path"
    assert decided >= 20


def test_a_planner_takes_regions_one_after_another() -> None:
    planner = Planner(slot(0.4, [8, 5, 0.0]))
    assert planner.solve().verdict == "no_path"
    cells = planner.solve(goal={"region": BEYOND}).stats.labelled_cells
    assert planner.solve(goal={"region": shapely.box(7, 2, 9, 8)}).verdict == "no_path"
    assert cells < 300  # most of them were there
    assert planner.solve(goal={"region": shapely.box(1, 1, 3, 3)}).verdict == "path"
    assert planner.solve(goal=[8, 5, 0.0]).verdict == "no_path"
    assert planner.solve(goal={"escape": rectangle(0, 0, 5, 10)}).verdict == "no_path"


def test_limits_leave_regions_undecided() -> None:
    scene = slot(0.4, {"region": BEYOND})
    assert answer(scene, Options(max_cells=50)).verdict == "undecided"
    assert answer(scene, Options(resolution=0.1)).verdict == "undecided"


def test_exact_fits_on_the_way_to_a_region() -> None:
    for goal in ({"region": BEYOND}, {"escape": rectangle(0, 0, 6, 10)}):
        found = answer(slot(0.5, goal), Options(timeout=2.0))
        assert (found.verdict, found.stats.decided_by) == ("path", DecidedBy.TAUT_PATH)
        for less in (2.0**-30, 2.0**-40, 2.0**-45):
            narrow = {**slot(0.5 - less, goal), "rotation": False}
            assert answer(narrow, Options(timeout=2.0)).verdict == "no_path", less


def test_answers_repeat() -> None:
    scene = slot(0.51, {"region": BEYOND, "theta": [1, 2]})
    first, second = solve(copy.deepcopy(scene)), solve(scene)
    assert first.path.tobytes() == second.path.tobytes()
    assert first.stats.labelled_cells == second.stats.labelled_cells


@pytest.mark.parametrize("gap", [1.9, 2.0])
def test_margins_of_cages_are_what_the_mouth_lacks_or_spares(gap: float) -> None:
    """Grown by d on every side the body is 2 d wider."""
    found = margin(cage(gap, {"escape": rectangle(-2, -2, 10, 10)}))
    spare = 0.5 * (gap - 2 * math.cos(math.pi / 16))
    assert found.lower <= spare <= found.upper
    assert found.upper - found.lower < 0.01
    assert math.isinf(found.goal_clearance)


@pytest.mark.parametrize("angle", [0.3, 0.7])
def test_contact_in_one_part_does_not_starve_another(angle: float) -> None:
    """The near part is reached by contact only, at a slanted wall: no cell is ever small enough."""
    c, s = math.cos(angle), math.sin(angle)

    def turned(*points: tuple[float, float]) -> list[list[float]]:
        return [[c * x - s * y, s * x + c * y] for x, y in points]

    touched = turned((-1, 0), (4.5, 0), (4.5, 0.25), (-1, 0.25))
    beyond = turned((7, 2), (9, 2), (9, 8), (7, 8))
    scene = slot(0.6, {"region": {"type": "MultiPolygon", "coordinates": [[touched], [beyond]]}})
    scene |= {
        "workspace": shape(turned((0, 0), (10, 0), (10, 10), (0, 10))),
        "obstacles": [
            shape(turned((4.5, 0), (5.5, 0), (5.5, 4), (4.5, 4))),
            shape(turned((4.5, 4.6), (5.5, 4.6), (5.5, 10), (4.5, 10))),
        ],
        "start": [*turned((2, 5))[0], angle],
    }
    assert answer(scene, Options(max_cells=10_000)).verdict == "path"
    alone = scene | {"goal": {"region": shape(touched)}}
    assert answer(alone, Options(max_cells=10_000)).verdict == "undecided"
