"""Maps of a scene that keep its answer: similarities, exact in doubles or rounded.

Points are complex numbers z = x + iy. The world is mapped by z → f z + s or z → f z̄ + s, the body,
in its own frame, by z → f z or z → f z̄. Plane rotations commute, and a reflection turns them
round, so with the same θ (or −θ) the mapped robot stands at the image of where the robot stood.
No angle has to be changed for any f, and no coordinate is rounded: f is a complex number of few
bits, coordinates are multiples of a grid (`snapped`), and what would be rounded raises an error.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from worlds.scene import Scene

Point = tuple[Fraction, Fraction]
PointMap = Callable[[Point], Point]

GRID_BITS = 21  # of a snapped scene's size: 2^-21 = 5e-7; with a shift of 2^30 sizes 52 bits in all


class RoundedError(ArithmeticError):
    """A coordinate has no double: the map is not exact for this scene."""


def double(value: Fraction) -> float:
    """Return the double that a fraction is; raise if it is none."""
    nearest = float(value)
    if Fraction(nearest) != value:
        raise RoundedError(f"{value} is no double")
    return nearest


@dataclass(frozen=True)
class Similarity:
    """z → factor z + shift; of z̄ if `mirrored`."""

    factor: complex = 1.0
    shift: complex = 0.0
    mirrored: bool = False

    def body(self, point: Point) -> Point:
        """Map a point of the robot's frame: exact."""
        x, y = point[0], -point[1] if self.mirrored else point[1]
        a, b = Fraction(self.factor.real), Fraction(self.factor.imag)
        return a * x - b * y, b * x + a * y

    def world(self, point: Point) -> Point:
        """Map a point of the world: exact."""
        x, y = self.body(point)
        return x + Fraction(self.shift.real), y + Fraction(self.shift.imag)

    @property
    def keeps_boxes(self) -> bool:
        """Whether axis-parallel boxes stay so."""
        return self.factor.real == 0 or self.factor.imag == 0


def map_points(value: Any, change: Callable[[list[float]], list[float]]) -> Any:
    """Return nested lists of points with every point changed."""
    if isinstance(value[0], (int, float)):
        return change(value)
    return [map_points(item, change) for item in value]


def exactly(change: PointMap) -> Callable[[list[float]], list[float]]:
    """Return a map of points given as doubles; it raises where the image is no double."""

    def mapped(point: list[float]) -> list[float]:
        x, y = change((Fraction(point[0]), Fraction(point[1])))
        return [double(x), double(y)]

    return mapped


def _box(box: list[float], change: Callable[[list[float]], list[float]]) -> list[float]:
    (ax, ay), (bx, by) = change(box[:2]), change(box[2:])
    return [min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)]


def box_polygon(box: list[float]) -> dict[str, Any]:
    """Return an axis-parallel box as a GeoJSON Polygon."""
    x0, y0, x1, y1 = box
    return {"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]]}


def mapped(
    scene: Scene,
    world: Callable[[list[float]], list[float]],
    body: Callable[[list[float]], list[float]],
    angle: Callable[[float], float],
    *,
    keeps_boxes: bool,
) -> Scene | None:
    """Return the scene with world, body and angles mapped.

    A workspace's box that does not stay one becomes a polygon. Bounds of the reference point are
    axis-parallel by definition: None if they do not stay so.
    """
    out = copy.deepcopy(scene)
    room = out.get("workspace")
    if not keeps_boxes:
        if "reference_bounds" in out:
            return None
        if room is not None and "box" in room:
            room = out["workspace"] = box_polygon(room["box"])
    if "reference_bounds" in out:
        out["reference_bounds"] = _box(out["reference_bounds"], world)
    if room is not None and "box" in room:
        room["box"] = _box(room["box"], world)
    elif room is not None:
        room["coordinates"] = map_points(room["coordinates"], world)
    out["robot"]["coordinates"] = map_points(out["robot"]["coordinates"], body)
    for shape in out["obstacles"]:
        shape["coordinates"] = map_points(shape["coordinates"], world)
    for end in ("start", "goal"):
        x, y, theta = out[end]
        out[end] = [*world([x, y]), angle(theta)]
    return out


def similar(scene: Scene, by: Similarity) -> Scene | None:
    """Return the exact image of a scene; None if its bounds of the reference point have none."""
    return mapped(
        scene,
        exactly(by.world),
        exactly(by.body),
        (lambda theta: -theta) if by.mirrored else (lambda theta: theta),
        keeps_boxes=by.keeps_boxes,
    )


def rounded(scene: Scene, turn: float, factor: float, shift: tuple[float, float]) -> Scene | None:
    """Return the scene in the units `factor`, turned and moved, in doubles: all is rounded."""
    c, s = math.cos(turn), math.sin(turn)

    def world(p: list[float]) -> list[float]:
        x, y = factor * p[0], factor * p[1]
        return [c * x - s * y + shift[0], s * x + c * y + shift[1]]

    return mapped(
        scene,
        world,
        lambda p: [factor * p[0], factor * p[1]],
        lambda theta: theta + turn,
        keeps_boxes=turn == 0,
    )


def exchanged(scene: Scene) -> Scene:
    """Return the scene with start and goal exchanged."""
    return {**copy.deepcopy(scene), "start": list(scene["goal"]), "goal": list(scene["start"])}


def _numbers(value: Any) -> Iterator[float]:
    if isinstance(value, (int, float)):
        yield float(value)
    else:
        for item in value:
            yield from _numbers(item)


def size(scene: Scene) -> float:
    """Return the largest coordinate's magnitude as a power of two that is not below it."""
    room = scene.get("workspace") or {}
    shapes = [scene["robot"], *scene["obstacles"]] + ([room] if "coordinates" in room else [])
    values = [scene["start"][:2], scene["goal"][:2], *(shape["coordinates"] for shape in shapes)]
    values += [room["box"]] if "box" in room else []
    values += [scene["reference_bounds"]] if "reference_bounds" in scene else []
    return float(2.0 ** math.ceil(math.log2(max(map(abs, _numbers(values))))))


def snapped(scene: Scene) -> Scene:
    """Return the scene on a grid of `GRID_BITS` bits: another scene, near, for exact maps."""
    step = size(scene) * 2.0**-GRID_BITS

    def snap(p: list[float]) -> list[float]:
        return [step * round(p[0] / step), step * round(p[1] / step)]

    done = mapped(scene, snap, snap, lambda theta: theta, keeps_boxes=True)
    assert done is not None
    return done
