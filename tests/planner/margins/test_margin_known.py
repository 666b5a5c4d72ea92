"""Brackets hold the margins that a formula gives, and say what binds."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from planar_planner import Options, SceneError, margin
from planar_planner.errors import OptionsError
from scenarios.corner import corner
from scenarios.model import box, scene
from scenarios.slot import BAR, STEM, slot
from scenarios.small import window


def _slit(opening: float, bar: float, *, rotation: bool = True) -> dict[str, Any]:
    """Return a bar of thickness `bar` and a wall with an opening that its thin side must pass."""
    h = 0.5 * opening
    return dict(
        scene(
            "slit",
            "A bar through a slit.",
            workspace=(-4.0, -3.0, 4.0, 3.0),
            rotation=rotation,
            robot=box(-0.9, -0.5 * bar, 0.9, 0.5 * bar),
            obstacles=[box(-0.2, h, 0.2, 3.0), box(-0.2, -3.0, 0.2, -h)],
            start=(-2.4, 0.0, 0.0),
            goal=(2.4, 0.0, 0.0),
        )
    )


def _square_room(side: float) -> dict[str, Any]:
    """Return a unit square that must turn by an eighth in a room of its own."""
    h = 0.5 * side
    return dict(
        scene(
            "turn",
            "A square that must turn in a square room.",
            workspace=(-h, -h, h, h),
            robot=box(-0.5, -0.5, 0.5, 0.5),
            obstacles=[],
            start=(0.0, 0.0, 0.0),
            goal=(0.0, 0.0, 0.25 * math.pi),
        )
    )


# Corner, grown: the walls at distance m leave a corridor up to the disc of radius m about the inner
# corner, sqrt(2) (1 - m) - l / 2 - w = m. Shrunk by s: sqrt(2) = l / 2 - s + w - 2 s.
# Square room: grown, it turns through 45 degrees, where its corners are sqrt(2) / 2 + m from its
# centre; the goal itself is in that place, so that the goal binds.
KNOWN = {
    "slit": (_slit(0.5, 0.3), 0.1, "way"),
    "slit without turning": (_slit(0.5, 0.3, rotation=False), 0.1, "way"),
    "slit too narrow": (_slit(0.3, 0.5), -0.1, "way"),
    "slot": (slot(1.4), 0.5 * (1.4 - BAR - STEM), "way"),
    "slot-jammed": (slot(1.1), 0.5 * (1.1 - BAR - STEM), "way"),
    "corner": (corner(2.5, 0.1), (math.sqrt(2.0) - 1.35) / (1.0 + math.sqrt(2.0)), "way"),
    "corner-too-long": (corner(2.7, 0.1), -(1.45 - math.sqrt(2.0)) / 3.0, "way"),
    "turn": (_square_room(1.6), 0.8 - math.sqrt(0.5), "goal"),
    "window-fixed": (window(rotation=False), -0.2, "size"),
}


@pytest.mark.parametrize("name", KNOWN)
def test_the_bracket_holds_the_margin(name: str) -> None:
    made, expected, binding = KNOWN[name]
    found = margin(made, width=1e-3)
    assert found.lower <= expected <= found.upper
    assert found.upper - found.lower <= 1e-3
    assert (found.decided, found.binding) == (True, binding)
    assert found.verdict == ("path" if expected > 0.0 else "no_path")


@pytest.mark.parametrize("width", [1e-1, 1e-5])
def test_the_bracket_is_as_narrow_as_asked(width: float) -> None:
    found = margin(_slit(0.5, 0.3), width=width)
    assert found.lower <= 0.1 <= found.upper
    assert 0.0 < found.upper - found.lower <= width


def test_scaling_a_bar_through_a_slit() -> None:
    found = margin(_slit(0.5, 0.3), by="scale", width=1e-4)
    assert found.lower <= 5.0 / 3.0 <= found.upper
    assert found.upper - found.lower <= 1e-4
    assert (found.monotone, found.binding, found.verdict) == (True, "way", "path")


def test_scaling_about_the_centroid() -> None:
    content = _slit(0.5, 0.3)
    content["robot"]["coordinates"] = [
        [[x + 1.0, y] for x, y in ring] for ring in content["robot"]["coordinates"]
    ]
    content["start"], content["goal"] = [-3.4, 0.0, 0.0], [1.4, 0.0, 0.0]
    found = margin(content, by="scale", about="centroid", width=1e-3)
    assert found.lower <= 5.0 / 3.0 <= found.upper
    assert found.monotone
    assert not margin(content, by="scale", about="reference", width=1e-1).monotone


def test_the_bottleneck_is_in_the_slit() -> None:
    found = margin(_slit(0.5, 0.3), width=1e-3)
    place = found.narrow_place
    assert place is not None
    assert abs(place.configuration[0]) < 1.2
    assert place.configuration[1] == pytest.approx(0.0, abs=1e-3)
    assert math.sin(place.configuration[2]) == pytest.approx(0.0, abs=1e-2)
    assert place.clearance == pytest.approx(0.1, abs=2e-3)
    assert {contact.obstacle for contact in place.contacts} == {0, 1}
    for contact in place.contacts:
        apart = math.dist(contact.robot_point, contact.obstacle_point)
        assert contact.distance == pytest.approx(apart)


def test_a_start_that_collides_is_freed_by_shrinking() -> None:
    content = _slit(0.5, 0.3)
    content["start"] = [-3.2, 0.0, 0.0]  # 0.1 beyond the workspace
    found = margin(content, width=1e-3)
    assert (found.binding, found.verdict) == ("start", "no_path")
    assert found.lower <= -0.1 <= found.upper
    assert found.start_clearance == 0.0


def test_nothing_in_the_way() -> None:
    content = _slit(0.5, 0.3)
    del content["workspace"]
    content["obstacles"], content["reference_bounds"] = [], [-4.0, -4.0, 4.0, 4.0]
    for by in ("offset", "scale"):
        found = margin(content, by=by)
        assert (found.lower, found.upper, found.binding) == (math.inf, math.inf, "none")
        assert found.decided
        assert found.to_json()["lower"] is None


def test_a_limit_is_told_with_the_bracket_reached() -> None:
    found = margin(slot(1.4), Options(max_cells=1), width=1e-4)
    assert found.reason
    assert not found.decided
    assert found.lower <= 0.075 <= found.upper


@pytest.mark.parametrize(("numbers", "verdict"), [("decimals", "path"), ("doubles", "no_path")])
def test_what_numbers_mean_decides_the_sign_of_a_touching_start(numbers: str, verdict: str) -> None:
    content = {**_slit(0.5, 0.3), "numbers": numbers}
    content["start"] = [-3.1, 0.0, 0.0]  # touches the workspace; its double overlaps by an ulp
    found = margin(content, width=1e-3)
    assert found.lower <= 0.0 <= found.upper
    assert (found.binding, found.verdict, found.decided) == ("start", verdict, True)
    assert found.decimal_places == (2 if numbers == "decimals" else None)
    assert not len(found.path) or np.allclose(found.path[0], content["start"], atol=0, rtol=0)


def test_an_exact_fit_has_the_margin_of_its_decimals() -> None:
    """The slit is as wide as the robot; in doubles it may be too narrow by a last place."""
    content = _slit(0.3, 0.3)
    found = margin(content, width=1e-3)
    assert found.lower == 0.0 <= found.upper <= 1e-3
    assert (found.verdict, found.decimal_places) == ("path", 2)


def test_refused() -> None:
    for width in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(OptionsError, match="width must be positive and finite"):
            margin("slot", width=width)
    with pytest.raises(SceneError, match="reference_bounds"):
        content = _slit(0.5, 0.3)
        content["reference_bounds"] = [-1.0, -1.0, 1.0, 1.0]
        margin(content)
