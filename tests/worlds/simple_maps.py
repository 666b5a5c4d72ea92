"""Maps of a scene that keep its answer: turned, mirrored, moved and scaled, in doubles.

A quarter turn and a mirror keep the coordinates exactly; the others round them.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import shapely

from worlds.maps import mapped
from worlds.scene import Scene, plain

GRID = 2.0**-24
"""What the vertices of a robot are rounded to, so that moving the origin by multiples of it, up to
2^28, is exact."""

Change = Callable[[list[float]], list[float]]


def _kept(point: list[float]) -> list[float]:
    return point


def _image(scene: Scene, world: Change, body: Change, angle: Callable[[float], float]) -> Scene:
    """Return the scene under maps that keep axis-parallel boxes."""
    image = mapped(scene, world, body, angle, keeps_boxes=True)
    assert image is not None
    return image


def quarter_turned(scene: Scene) -> Scene:
    """Turn the world by 90 degrees: exact in the coordinates, rounded in the angles."""
    return _image(scene, lambda p: [-p[1], p[0]], _kept, lambda a: a + 0.5 * math.pi)


def turned_body(scene: Scene) -> Scene:
    """Draw the robot at another angle in its own frame."""
    return _image(scene, _kept, lambda p: [p[1], -p[0]], lambda a: a + 0.5 * math.pi)


def mirrored(scene: Scene) -> Scene:
    """Mirror world and robot in the x axis."""

    def flip(p: list[float]) -> list[float]:
        return [p[0], -p[1]]

    return _image(scene, flip, flip, lambda a: -a)


def translated(scene: Scene, by: tuple[float, float]) -> Scene:
    """Move the world; coordinates are rounded."""
    return _image(scene, lambda p: [p[0] + by[0], p[1] + by[1]], _kept, lambda a: a)


def scaled(scene: Scene, factor: float) -> Scene:
    """Give world and robot in other units."""

    def grow(p: list[float]) -> list[float]:
        return [factor * p[0], factor * p[1]]

    return _image(scene, grow, grow, lambda a: a)


def wound(scene: Scene) -> Scene:
    """Put the goal some whole turns further round."""
    x, y, theta = scene["goal"]
    if scene.get("rotation", True):
        theta += 6.0 * math.pi
    return {**copy.deepcopy(scene), "goal": [x, y, theta]}


def gridded(scene: Scene) -> Scene:
    """Return the scene with its robot's vertices on the grid."""
    robot = shapely.transform(
        shapely.geometry.shape(scene["robot"]), lambda p: np.round(p / GRID) * GRID
    )
    return plain({**scene, "robot": shapely.geometry.mapping(robot)})


def moved_origin(scene: Scene, by: tuple[float, float]) -> Scene:
    """Return the same question with the robot's frame moved by -`by` against its body.

    The body is the same exactly. Start and goal are where the body stands the same, up to rounding
    at the magnitude of `by`. Scenes with reference bounds or a region would ask something else.
    """
    assert "reference_bounds" not in scene
    robot = shapely.transform(shapely.geometry.shape(scene["robot"]), lambda p: p + np.array(by))
    moved: dict[str, Any] = {**scene, "robot": shapely.geometry.mapping(robot)}
    for end in ("start", "goal"):
        x, y, theta = scene[end]
        c, s = math.cos(theta), math.sin(theta)
        moved[end] = [x - (c * by[0] - s * by[1]), y - (s * by[0] + c * by[1]), theta]
    return plain(moved)
