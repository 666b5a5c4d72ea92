"""The reader of parking-competition cases (TPCAP): start, goal and obstacles as a list of numbers.

The list has x₀, y₀, θ₀, x₁, y₁, θ₁, the number n of obstacles, their n numbers of vertices, then
all vertices as x, y, in a row or a column. The robot is the competition's car, whose reference
point is the middle of the rear axle.
"""

from __future__ import annotations

import re
from pathlib import Path

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.rings import polygons_of
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Shape
from planar_planner.formats.reading import angle, coordinate, text_of, whole
from planar_planner.scene.fields import Configuration

REAR_OVERHANG = 0.929
WHEELBASE = 2.8
FRONT_OVERHANG = 0.96
WIDTH = 1.942

_FRONT = 3.76  # WHEELBASE + FRONT_OVERHANG; their sum in doubles is this double
CAR: Shape = [
    [
        (-REAR_OVERHANG, -WIDTH / 2),
        (_FRONT, -WIDTH / 2),
        (_FRONT, WIDTH / 2),
        (-REAR_OVERHANG, WIDTH / 2),
    ]
]
_MOST = 10**6  # most obstacles of a case, and most vertices of an obstacle


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a case."""
    del path
    values = re.split(r"[,;\s]+", text_of(data).strip(" ,;\t\r\n"))
    if len(values) < 7:
        found = len(values) if values[0] else 0
        raise SceneError(f"a case begins with seven numbers, but the file has {found}")
    names = [f"value {i + 1}" for i in range(len(values))]
    start, goal = (_configuration(values, names, first) for first in (0, 3))
    count = whole(values[6], f"{names[6]} (number of obstacles)", 0, _MOST)
    sizes = []
    for k in range(count):
        place = f"value {8 + k} (vertices of obstacle {k + 1})"
        if 7 + k >= len(values):
            raise SceneError("is missing; the file ends before it", place)
        sizes.append(whole(values[7 + k], place, 1, _MOST))
    expected = 7 + count + 2 * sum(sizes)
    if len(values) != expected:
        raise SceneError(f"has {len(values)} values, but it announces {expected}")
    if options.robot is None and options.footprint is None:
        notes.say(
            f"the robot is the competition's car, {_FRONT + REAR_OVERHANG!r} by {WIDTH!r} metres, "
            "with the middle of its rear axle as reference point; its steering is not modelled"
        )
    parts = Parts(robot=[CAR], start=start, goal=goal)
    at = 7 + count
    for k, size in enumerate(sizes):
        ring = [
            (coordinate(values[i], names[i]), coordinate(values[i + 1], names[i + 1]))
            for i in range(at, at + 2 * size, 2)
        ]
        at += 2 * size
        name = f"obstacle {k + 1}"
        parts.add_obstacles(polygons_of([ring], name, notes), name)
    return parts


def _configuration(values: list[str], names: list[str], first: int) -> Configuration:
    x, y = (coordinate(values[i], names[i]) for i in (first, first + 1))
    return x, y, angle(values[first + 2], names[first + 2])
