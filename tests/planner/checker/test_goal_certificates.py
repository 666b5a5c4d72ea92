"""Certificates of goals that are sets: what the checker must not accept, and its predicates."""

from __future__ import annotations

import copy
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import load_scene
from planar_planner.checker.goal_area import GoalArea, in_polygon, meets_rectangle
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateRejected
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.make import make_problem
from worlds.goal_worlds import Scene, answer, rectangle, slot

BEYOND = rectangle(7, 2, 9, 8)


def certificate(scene: Scene) -> dict[str, Any]:
    found = answer(scene).certificate
    assert found is not None
    return found


def for_scene(content: dict[str, Any], scene: Scene) -> dict[str, Any]:
    """Return a certificate that claims to be another scene's: a forger can compute a hash too."""
    changed = copy.deepcopy(content)
    changed["scene"] = fingerprint(make_problem(load_scene(scene)))
    return changed


def rejected(scene: Scene, content: dict[str, Any], reason: str) -> None:
    with pytest.raises(CertificateRejected, match=reason):
        verify_certificate(scene, content)


def test_the_goal_is_part_of_the_scene_certified() -> None:
    goals: list[Any] = [{"region": BEYOND}, {"region": BEYOND, "theta": [0, 1]}]
    goals += [{"region": rectangle(7, 2, 9, 8.5)}, {"escape": BEYOND}, [8, 5, 0]]
    hashes = [fingerprint(make_problem(load_scene(slot(0.6, goal)))) for goal in goals]
    assert len(set(hashes)) == len(goals)
    rejected(slot(0.6, goals[1]), certificate(slot(0.6, goals[0])), "is not the one certified")


def test_equal_goals_written_differently_are_the_same() -> None:
    closed = rectangle(7, 2, 9, 8)
    closed["coordinates"][0].append([7, 2])
    same = {"region": closed, "theta": [1, 1 + 2 * math.pi]}  # a whole turn: any
    content = certificate(slot(0.6, {"region": BEYOND}))
    verify_certificate(slot(0.6, same), content)


@pytest.mark.parametrize(
    ("goal", "reason"),
    [
        ({"region": rectangle(8.9, 2, 9.5, 8)}, "is outside the goal"),
        ({"region": BEYOND, "theta": [2.5, 2.6]}, "has a theta that is no goal's"),
        ({"escape": rectangle(6, 1, 9.5, 9)}, "is outside the goal"),
    ],
)
def test_a_path_to_another_place_is_rejected(goal: Any, reason: str) -> None:
    content = certificate(slot(0.6, {"region": rectangle(7, 2, 8, 8), "theta": [-1, 1]}))
    other = slot(0.6, goal)
    rejected(other, for_scene(content, other), reason)


def test_a_path_that_stops_short_is_rejected() -> None:
    scene = slot(0.6, {"region": BEYOND})
    content = certificate(scene)
    content["waypoints"].pop()
    content["segments"].pop()
    rejected(scene, content, "is outside the goal")


def test_a_contact_tolerance_does_not_widen_the_goal() -> None:
    scene = slot(0.6, {"region": BEYOND})
    content = certificate(scene)
    x = content["waypoints"][-1][0]
    other = slot(0.6, {"region": rectangle(x + 1e-3, 2, 9, 8)})
    content = for_scene(content, other) | {"contact_tolerance": 0.01}
    with pytest.raises(CertificateRejected, match="is outside the goal"):
        verify_certificate(other, content, contact_tolerance=0.01)


def test_whole_turns_at_the_end_are_free_and_others_are_not() -> None:
    scene = slot(0.6, {"region": BEYOND, "theta": [1, 2]})
    content = certificate(scene)
    content["waypoints"][-1][3] += 1  # another motion: nobody has shown that it is free
    rejected(scene, content, "segments")
    content["waypoints"][-1][2] += 2 * math.pi
    content["waypoints"][-1][3] -= 2
    rejected(scene, content, "has a theta that is no goal's")


@pytest.mark.parametrize(
    "goal",
    [
        {"region": rectangle(3, 4, 9, 8)},
        {"region": rectangle(0, 0, 10, 10), "theta": [2, 2]},
        {"escape": rectangle(2, 2, 6, 6)},
        {"region": rectangle(1.5, 4.5, 1.5 + 2**-40, 4.5 + 2**-40)},
    ],
)
def test_a_wall_elsewhere_is_rejected(goal: Any) -> None:
    """The proof of one region is none of another that reaches over to the start's side."""
    content = certificate(slot(0.4, {"region": BEYOND}))
    other = slot(0.4, goal)
    rejected(other, for_scene(content, other), "may hold the goal")


def test_the_start_itself_in_the_goal_is_seen() -> None:
    content = certificate(slot(0.4, {"region": BEYOND, "theta": [1, 2]}))
    other = slot(0.4, {"region": rectangle(2, 5, 3, 6), "theta": [-1, 0]})  # the start on a corner
    rejected(other, for_scene(content, other), "may hold the goal")


def test_a_region_is_no_end_that_can_collide() -> None:
    scene = slot(0.4, {"region": rectangle(4.6, 6, 5.4, 8)})
    content = certificate(scene)
    kept = ("format", "version", "made_by", "scene", "robot_pieces", "obstacle_pieces")
    forged = {name: content[name] for name in kept}
    forged |= {"verdict": "no_path", "claim": "end", "end": "goal", "wall": "x_max"}
    rejected(scene, forged, "is a region")


def test_a_disc_stands_for_the_robot_and_its_region() -> None:
    ring = [[0.24 * math.cos(k / 4), 0.24 * math.sin(k / 4)] for k in range(25)]
    robot = {"type": "Polygon", "coordinates": [ring]}
    scene = slot(0.4, {"region": BEYOND, "theta": [1, 2]}, robot=robot)
    content = certificate(scene)
    assert content["claim"] == "disc"
    other = slot(0.4, {"region": rectangle(3, 4, 9, 8), "theta": [1, 2]}, robot=robot)
    rejected(other, for_scene(content, other), "may hold the goal")


def test_boxes_and_polygons_against_shapely() -> None:
    """Small whole numbers, so that touching is common."""
    rng = np.random.default_rng(5)
    met = 0
    for _ in range(400):
        hull = shapely.MultiPoint(rng.integers(0, 9, (6, 2))).convex_hull
        hole = shapely.MultiPoint(rng.integers(2, 7, (4, 2))).convex_hull
        body = hull.difference(hole) if hole.within(hull.buffer(-0.1)) else hull
        if body.geom_type != "Polygon":
            continue
        rings = [
            [(int(x), int(y)) for x, y in ring.coords[:-1]]
            for ring in (body.exterior, *body.interiors)
        ]
        x, y, width, height = (int(v) for v in rng.integers(0, 8, 4))
        box = (x, y, x + width // 3, y + height // 3)
        expected = body.intersects(shapely.box(*box)) or body.intersects(shapely.Point(x, y))
        assert meets_rectangle(rings, box) == expected
        assert in_polygon(rings, (x, y)) == body.intersects(shapely.Point(x, y))
        met += expected
    assert 50 < met < 350


@pytest.mark.parametrize("low", [-10.0, -3.2, 0.0, 2.5, 6.2, 1e5])
@pytest.mark.parametrize("length", [0.0, 0.1, 3.0, 6.2])
def test_angles_against_samples(low: float, length: float) -> None:
    """In 64ths of a turn; an end is a hair from none of them but 0."""
    goal = GoalArea([], (low, low + length))
    for k in range(64):
        span = Fraction(k, 64), Fraction(k + 1, 64)
        middle = math.tau * (k + 0.5) / 64
        gap = abs(math.remainder(middle - (low + 0.5 * length), math.tau)) - 0.5 * length
        assert goal.may_have_angle(*span) == (gap <= math.pi / 64 + 1e-9)


def test_an_angle_at_the_seam_is_on_both_sides() -> None:
    goal = GoalArea([], (0.0, 0.0))
    spans = [(Fraction(0), Fraction(1, 4)), (Fraction(3, 4), Fraction(1))]
    assert [goal.may_have_angle(*span) for span in spans] == [True, True]
    assert not goal.may_have_angle(Fraction(1, 4), Fraction(3, 4))
