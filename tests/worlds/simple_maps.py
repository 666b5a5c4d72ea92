"""Maps of a scene that keep its answer: turned, mirrored, moved and scaled, in doubles.

A quarter turn and a mirror keep the coordinates exactly; the others round them.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable

from worlds.maps import mapped
from worlds.scene import Scene

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
