"""The text of a margin, for people."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from planar_planner.errors import one_line
from planar_planner.scene.geojson import title_of_obstacle

if TYPE_CHECKING:
    from planar_planner.margins.result import Margin, NarrowPlace
    from planar_planner.margins.surroundings import NearestPoints

_VERDICTS = {
    "path": "a path exists",
    "no_path": "no path, proven",
    "undecided": "undecided",
}
_BINDINGS = {
    "way": "a larger robot has no way through",
    "start": "a larger robot collides at the start",
    "goal": "a larger robot collides at the goal",
    "size": "only a robot that is shrunk to nothing passes",
    "none": "no obstacle is in the way",
}


def _as_it_is(text: str) -> str:
    return text


def margin_headline(margin: Margin, style: Callable[[str], str] = _as_it_is) -> str:
    """Return the bracket in one line; `style` is applied to the verdict."""
    verdict = style(_VERDICTS[margin.verdict])
    return f"{one_line(margin.scene)}: {verdict}; {_range(margin)}"


def margin_details(margin: Margin) -> str:
    """Return what bounds the margin, the narrowest place, and the work."""
    counts = margin.counts
    lines = [
        margin.reason and f"stopped short: {margin.reason}",
        f"bound by: {_BINDINGS[margin.binding]}",
        _monotone_line(margin),
        f"clearance: {_length(margin.start_clearance)} at the start, "
        f"{_length(margin.goal_clearance)} at the goal",
        *_narrow_place_lines(margin),
        f"work: {counts['queries']} queries, {counts['recertified']} answered by an earlier path, "
        f"{counts['cells']:,} cells, {margin.seconds:.2f} s",
    ]
    return "\n".join(f"  {one_line(line)}" for line in lines if line)


def _range(margin: Margin) -> str:
    if math.isinf(margin.lower):
        return "the robot can have any size"
    digits = 2 + max(0, math.ceil(-math.log10(margin.width)))
    low, high = _rounded(margin.lower, digits), _rounded(margin.upper, digits)
    what = "scaled by" if margin.by == "scale" else "grown by"
    if margin.by == "offset" and margin.upper <= 0.0:
        low, high = _rounded(-margin.lower, digits), _rounded(-margin.upper, digits)
        return f"a path for the robot shrunk by {low!r}, no path for one shrunk by {high!r}"
    return f"a path for the robot {what} {low!r}, no path for one {what} {high!r}"


def _rounded(value: float, digits: int) -> float:
    """Round to decimal places; 0 has no sign, so that nothing prints as -0.0."""
    return round(value, digits) + 0.0


def _monotone_line(margin: Margin) -> str:
    if margin.monotone:
        return ""
    return "the robot is not star-shaped about the centre: a larger robot may have a path again"


def _narrow_place_lines(margin: Margin) -> list[str]:
    place = margin.narrow_place
    if place is None:
        return []
    x, y, theta = place.configuration
    return [
        f"narrowest at x {x:.6g}, y {y:.6g}, theta {theta:.6g}: {place.clearance:.3g} to "
        f"{touched(place)}"
    ]


def touched(place: NarrowPlace) -> str:
    """Return what pinches the robot at a narrow place, each thing once, the nearest first."""
    return ", ".join(dict.fromkeys(_name(contact) for contact in place.contacts))


def _name(contact: NearestPoints) -> str:
    if contact.obstacle < 0:
        return "the workspace"
    return title_of_obstacle(contact.name, contact.obstacle)


def _length(value: float) -> str:
    return "unbounded" if math.isinf(value) else f"{value:.6g}"
