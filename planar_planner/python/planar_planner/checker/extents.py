"""Boxes, faces and points of configurations, and the domain that boxes divide."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import product
from typing import NamedTuple

from planar_planner.checker.arithmetic import (
    ROTATION_BITS,
    Angle,
    Rectangle,
    Rotation,
    Vector,
    bounding_box,
    rotation,
)
from planar_planner.checker.demands import demand
from planar_planner.checker.records import Box

THETA = 2
"""The axis of angles; x and y are 0 and 1."""


class Extent(NamedTuple):
    """The configurations of a box, a face or a point: translations and angles."""

    corners: list[Vector]  # of the translations
    first: Fraction  # turns; the angles are radians + 2π turns
    last: Fraction
    radians: Fraction = Fraction()

    def end_rotations(self) -> list[Rotation]:
        """Return the rotations by the first and last angle; one if they are the same."""
        return [rotation(self.radians, turns) for turns in sorted({self.first, self.last})]

    def box_of_origin(self, reference: Vector) -> Rectangle:
        """Return a rectangle that holds t − R(θ) reference for all translations and angles.

        Turning by at most h moves R(θ) p by at most h |p|.
        """
        xmin, ymin, xmax, ymax = bounding_box(self.corners)
        u, v = reference
        if not (u or v):
            return xmin, ymin, xmax, ymax
        c, s = rotation(self.radians, (self.first + self.last) / 2)
        x, y = (u * c - v * s) >> ROTATION_BITS, (u * s + v * c) >> ROTATION_BITS
        length = abs(u) + abs(v)
        # Half of the angles' range, in radians, is π times the range in turns, and π < 16/5.
        spread = math.floor(length * (self.last - self.first) * Fraction(16, 5))
        spread += (length >> ROTATION_BITS) + 3
        return xmin - x - spread, ymin - y - spread, xmax - x + spread, ymax - y + spread

    def halves(self) -> list[Extent]:
        """Return the halves of the angles."""
        middle = (self.first + self.last) / 2
        return [self._replace(last=middle), self._replace(first=middle)]


class Domain(NamedTuple):
    """The rectangle of translations whose dyadic parts are boxes; docs/certificate.md, Separation.

    Its sizes are multiples of 2^DEEPEST_LEVEL units, so that every corner of a box is a vector.
    """

    low: Vector
    size: Vector
    only_angle: Angle | None  # of a robot that may not turn; None: it may

    def extent(self, place: str, box: Box, axis: int | None = None) -> Extent:
        """Return the configurations of a box, or of a face normal to `axis`, inside the domain."""
        inside = all(k + (a != axis) <= 1 << level for a, (level, k) in enumerate(box))
        demand(inside, place, "reaches beyond the domain")
        turning = self.only_angle is None
        flat = box[THETA] == (0, 0) and axis != THETA
        demand(turning or flat, place, "has angles in a fixed scene")
        ends = [(k,) if a == axis else (k, k + 1) for a, (_, k) in enumerate(box)]
        steps = [self.size[a] >> box[a][0] for a in (0, 1)]
        xs, ys = ([self.low[a] + steps[a] * k for k in ends[a]] for a in (0, 1))
        corners = list(product(xs, ys))
        first, *last = (Fraction(k, 1 << box[THETA][0]) for k in ends[THETA])
        if self.only_angle is not None:
            radians, turns = self.only_angle
            return Extent(corners, turns, turns, radians)
        return Extent(corners, first, last[0] if last else first)
