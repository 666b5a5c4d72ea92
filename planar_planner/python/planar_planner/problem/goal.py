"""Goals that are sets of configurations: the raw value → a valid region.

The reference point lies in a closed region, with theta in a closed interval; or it has escaped from
a polygon, which is the region outside it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, shown
from planar_planner.problem.polygons import Polygons
from planar_planner.problem.rings import Judge, clean_polygons
from planar_planner.scene import fields
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.input_limits import MIN_COORDINATE
from planar_planner.scene.raw_polygons import read_polygons

FORMS = '[x, y, theta], {"region": Polygon, "theta": [lo, hi]}, {"escape": Polygon} or "escape"'


@dataclass(frozen=True, eq=False)
class GoalSet:
    """Every configuration with the reference point in some polygons and theta in an interval.

    Attributes
    ----------
    polygons : Polygons
        World frame; they are closed: their boundary is part of the goal.
    angles : (lo, hi) or None
        Closed, in radians and up to whole turns, lo <= hi < lo + 2π; None if any theta will do.
        Where the robot may not turn, the start's theta lies in it.
    left : Polygons or None
        The polygon that an escape leaves behind; `polygons` is then the plane outside it, up to a
        frame that no robot within its bounds reaches.
    """

    polygons: Polygons
    angles: tuple[float, float] | None
    left: Polygons | None = None


Goal = Configuration | GoalSet


@dataclass(frozen=True, eq=False)
class Surroundings:
    """What an escape depends on besides its polygon, and who judges polygons."""

    robot: Polygons
    obstacles: Polygons
    workspace_box: Box | None
    workspace: Polygons | None
    reference_bounds: Box | None
    judge: Judge


def is_region(value: object) -> bool:
    """Whether a raw goal is meant as a set rather than as a configuration."""
    return isinstance(value, (Mapping, str))


def read_region(value: object, around: Surroundings) -> GoalSet:
    """Return the set of configurations that a raw goal describes.

    Parameters
    ----------
    value : object
        As in a scene file; lists, dicts, numbers and strings only.
    around : Surroundings
        The rest of the problem.

    Raises
    ------
    SceneError
        If it is of none of the forms, its polygons are not valid, or nothing within the bounds is
        outside the obstacles' surroundings; without a source.
    """
    if value == "escape":
        return _outside_all_obstacles(around)
    if not isinstance(value, dict) or ("region" in value) == ("escape" in value):
        raise SceneError(f"must be {FORMS}", "goal", shown(value))
    if "region" in value:
        fields.only_known(value, ["region", "theta"], "goal")
        polygons = _polygons("goal.region", value["region"], around.judge)
        return GoalSet(polygons, _angles(value.get("theta", "any")))
    fields.only_known(value, ["escape"], "goal")
    left = _polygons("goal.escape", value["escape"], around.judge)
    if len(left) != 1 or len(left.ring_starts) != 2:
        raise SceneError("must be one polygon without holes", "goal.escape")
    return _outside(left, around)


def allows_angle(angles: tuple[float, float] | None, theta: float, slack: float) -> bool:
    """Whether theta, up to whole turns and `slack`, lies in the interval."""
    if angles is None:
        return True
    middle, half = 0.5 * (angles[0] + angles[1]), 0.5 * (angles[1] - angles[0])
    return abs(math.remainder(theta - middle, math.tau)) <= half + slack


def _polygons(field: str, value: object, judge: Judge) -> Polygons:
    shape = clean_polygons(read_polygons([(field, value)]), judge)
    return Polygons(shape.coords, shape.ring_starts, shape.polygon_starts)


def _angles(value: Any) -> tuple[float, float] | None:
    if value == "any":
        return None
    if not isinstance(value, list) or len(value) != 2:
        raise SceneError('must be [lo, hi] or "any"', "goal.theta", shown(value))
    low, high = (fields.angle(v, f"goal.theta[{i}]") for i, v in enumerate(value))
    if low > high:
        raise SceneError(
            "lo must not exceed hi; an interval across half a turn ends beyond it, as in [3, 4]",
            "goal.theta",
            shown(value),
        )
    return None if high - low >= math.tau else (low, high)


def _reach(robot: Polygons) -> float:
    """Return the greatest distance of the robot's points from its reference point, rounded up."""
    farthest = max(math.hypot(x, y) for x, y in robot.coords.tolist())
    return math.nextafter(math.nextafter(farthest, math.inf), math.inf)  # hypot is off by one


def _outside_all_obstacles(around: Surroundings) -> GoalSet:
    """Return the outside of the obstacles' bounding box, grown by the robot's reach.

    With its reference point there the robot is clear of the box, whatever its theta.
    """
    if not len(around.obstacles):
        raise SceneError('"escape" needs obstacles to escape from', "goal")
    reach = _reach(around.robot)
    low = np.nextafter(around.obstacles.coords.min(axis=0) - reach, -np.inf)
    high = np.nextafter(around.obstacles.coords.max(axis=0) + reach, np.inf)
    # Outwards too: what is next to zero is no coordinate of exact arithmetic.
    low = np.where(np.abs(low) < MIN_COORDINATE, -MIN_COORDINATE, low)
    high = np.where(np.abs(high) < MIN_COORDINATE, MIN_COORDINATE, high)
    box = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
    rectangles = list(_bounding_boxes(around))
    beyond = [
        all((r[side] < box[side]) if side < 2 else (box[side] < r[side]) for r in rectangles)
        for side in range(4)
    ]
    if not any(beyond):
        raise SceneError(
            '"escape" leads out of the box of the obstacles, grown by the robot\'s reach, but the '
            'bounds end inside it; widen them, or name a polygon: {"escape": Polygon}',
            "goal",
            str([float(f"{v:.6g}") for v in box]),
        )
    return _outside(_rectangle(box), around)


def _outside(left: Polygons, around: Surroundings) -> GoalSet:
    """Return the closed plane outside a polygon, up to a frame.

    A reference point in bounds is within the robot's reach of the workspace or in the reference
    bounds, so the frame is farther out than that.
    """
    corners = [left.coords]
    corners += [np.array(r).reshape(2, 2) for r in _bounding_boxes(around)]
    low = np.concatenate(corners).min(axis=0)
    high = np.concatenate(corners).max(axis=0)
    margin = float((high - low).max()) + 2.0 * _reach(around.robot)
    (xmin, ymin), (xmax, ymax) = (low - margin).tolist(), (high + margin).tolist()
    frame = _rectangle((xmin, ymin, xmax, ymax)).coords
    coords = np.concatenate([frame, left.coords])
    return GoalSet(Polygons(coords, _starts(0, 4, len(coords)), _starts(0, 2)), None, left)


def _bounding_boxes(around: Surroundings) -> Iterable[Box]:
    if around.reference_bounds is not None:
        yield around.reference_bounds
    if around.workspace_box is not None:
        yield around.workspace_box
    if around.workspace is not None:
        low, high = around.workspace.coords.min(axis=0), around.workspace.coords.max(axis=0)
        yield float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _rectangle(box: Box) -> Polygons:
    xmin, ymin, xmax, ymax = box
    coords = np.array([[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]])
    return Polygons(coords, _starts(0, 4), _starts(0, 1))


def _starts(*values: int) -> NDArray[np.uint32]:
    return np.array(values, dtype=np.uint32)
