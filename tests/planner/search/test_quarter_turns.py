"""The doubles nearest to multiples of π/2 mean quarter turns, for the planner and the checker."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest

from planar_planner import DecidedBy, StopReason, load_scene, solve, verify_certificate
from planar_planner.checker.arithmetic import ROTATION_BITS, angle_of, rotation
from planar_planner.scene.fields import radians_of

Content = dict[str, Any]
BAR = [[0, 0], [1, 0], [1, 2], [0, 2]]  # 1 wide; at a quarter turn 1 high
L_PIECE = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]


def rectangle(x0: float, y0: float, x1: float, y1: float) -> Content:
    ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    return {"type": "Polygon", "coordinates": [ring]}


def slot(start: list[Any], goal: list[Any], *, ceiling: float = 5, **fields: Any) -> Content:
    """Return two rooms and a slot between them, which is 1 high unless the ceiling is lower."""
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "robot": {"type": "Polygon", "coordinates": [BAR]},
        "obstacles": [rectangle(6, 0, 14, 4), rectangle(6, ceiling, 14, 10)],
        "workspace": {"box": [0, 0, 20, 10]},
        "start": start,
        "goal": goal,
    } | fields


def certified(content: Content) -> Any:
    scene = load_scene(content)
    result = solve(scene, certificate=True)
    assert result.certificate is not None
    assert verify_certificate(scene, result.certificate).verdict == result.verdict
    return result


def nearest(quarters: int) -> float:
    """Return the double nearest to a multiple of π/2."""
    half_pi = Fraction(15707963267948966192313216916397514420985846996876, 10**49)
    return float(quarters * half_pi)


@pytest.mark.parametrize("rotation_allowed", [True, False])
@pytest.mark.parametrize("quarters", [1, -1, 3, 5, -7, 4001])
def test_an_exact_fit_at_a_quarter_turn(quarters: int, rotation_allowed: bool) -> None:
    theta = nearest(quarters)
    y = 4 if quarters % 4 == 1 else 5  # the bar hangs from its origin at three quarters
    fields = {"rotation": rotation_allowed}
    content = slot([3, y, theta], [18 - 2 * (quarters % 4 == 3), y, theta], **fields)
    assert certified(content).stats.decided_by is DecidedBy.TAUT_PATH
    too_low = slot([3, y, theta], [16, y, theta], ceiling=5 - 2.0**-40, rotation=False)
    if quarters % 4 == 1:
        assert certified(too_low).stats.decided_by is DecidedBy.ODD_CHAIN


@pytest.mark.parametrize("neighbour", [-math.inf, math.inf])
def test_the_double_beside_a_quarter_turn_is_no_quarter_turn(neighbour: float) -> None:
    theta = math.nextafter(math.pi / 2, neighbour)
    content = slot([3, 4, theta], [16, 4, theta], rotation=False)
    assert solve(load_scene(content)).verdict != "path"


@pytest.mark.parametrize("quarters", [*range(-9, 10), 1001, -30_001, 600_003])
def test_the_checker_takes_the_nearest_double_for_the_quarter_turn(quarters: int) -> None:
    angle = angle_of(nearest(quarters))
    assert angle.quarters == quarters
    one = 1 << ROTATION_BITS
    exact = [(one, 0), (0, one), (-one, 0), (0, -one)][quarters % 4]
    assert rotation(angle.radians, angle.turns) == exact
    for beside in (-math.inf, math.inf):
        assert angle_of(math.nextafter(nearest(quarters), beside)).quarters is None


@pytest.mark.parametrize(
    ("text", "radians"),
    [
        ("90deg", math.pi / 2),
        ("-270 deg", nearest(-3)),
        ("0.25turn", math.pi / 2),
        ("1.25 turns", nearest(5)),
        ("45deg", math.pi / 4),
        ("1.5 rad", 1.5),
        ("1e1deg", math.radians(10)),
        (".5turn", math.pi),
    ],
)
def test_angles_with_units(text: str, radians: float) -> None:
    assert radians_of(text) == pytest.approx(radians, rel=1e-15, abs=0)
    assert angle_of(radians_of(text) or 0.0).quarters == angle_of(radians).quarters


@pytest.mark.parametrize(
    "text", ["", "90", "deg", "90 Deg", "1_0deg", "nan deg", "٣deg", "1e999deg"]
)
def test_what_is_no_angle(text: str) -> None:
    content = slot([3, 4, text], [16, 4, 0])
    with pytest.raises(
        ValueError, match=r"start\[2\]: must be a (number of radians|finite number)"
    ):
        solve(content)


def test_angles_with_units_in_scenes() -> None:
    content = slot([3, 4, "90deg"], [16, 4, "0.25turn"])
    assert certified(content).path[:, 2].tolist() == [math.pi / 2, math.pi / 2]


@pytest.mark.parametrize("robot", [BAR, L_PIECE])
def test_layers_are_joined_where_the_robot_has_to_turn(robot: list[list[int]]) -> None:
    """It turns in the room before an exact slot and in the room behind it."""
    content = slot([3, 5, 0.7], [17, 6, -0.4])
    content["robot"]["coordinates"] = [robot]
    if robot is L_PIECE:  # an L-shaped slot: an arm of the piece goes through a groove
        content["obstacles"][1] = rectangle(6, 6, 14, 10)
    result = certified(content)
    assert result.stats.decided_by is DecidedBy.JOINED_LAYERS
    assert len({*result.path[:, 2]} - {0.7, -0.4}) >= 1
    below = slot([3, 5, 0.7], [17, 6, -0.4], ceiling=5 - 2.0**-20)
    below["robot"] = content["robot"]
    if robot is BAR:
        assert certified(below).verdict == "no_path"


def test_two_slots_at_two_angles() -> None:
    """One is passed at 0, the other at a quarter turn, with a room between them to turn in."""
    content = slot([2, 4, 0.3], [16, 16, 1.0], workspace={"box": [0, 0, 20, 20]})
    content["robot"] = rectangle(0, 0, 2, 1)
    content["obstacles"] = [
        rectangle(5, 0, 9, 4),
        rectangle(5, 5, 9, 20),
        rectangle(9, 9, 14, 13),
        rectangle(15, 9, 20, 13),
    ]
    result = certified(content)
    assert result.stats.decided_by is DecidedBy.JOINED_LAYERS


def test_what_has_to_turn_where_it_touches_is_said_to() -> None:
    """A rectangle of 4 by 3 whose diagonal is as long as the room is wide."""
    content = slot([0.5, 1, 0], [4, 0.5, "90deg"], workspace={"box": [0, 0, 5, 5]}, obstacles=[])
    content["robot"] = rectangle(0, 0, 4, 3)
    result = solve(content)
    assert (result.verdict, result.stop_reason) == ("undecided", StopReason.TIGHT_TURN)
    wider = {**content, "workspace": {"box": [0, 0, 5.001, 5.001]}}
    assert certified(wider).verdict == "path"
    narrower = {**content, "workspace": {"box": [0, 0, 4.999, 4.999]}}
    assert certified(narrower).verdict == "no_path"
