"""Straight motions of the robot, and bounds that hold all along them.

docs/certificate.md, "Verdict path": bounding boxes, obstacle edges, robot edges.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from planar_planner.checker.pieces import Edge
from planar_planner.checker.records import Waypoint
from planar_planner.checker.rotations import (
    ANGLE_BITS,
    ROTATION_BITS,
    Rotation,
    angle_units,
    rotation,
)
from planar_planner.checker.vectors import ONE, Rectangle, Vector, bounding_box, cross, dot


class Motion(NamedTuple):
    """The configurations (t + λ g, θ + λ ω), |λ| ≤ 1; t and g are rounded, by less than a unit."""

    middle: Vector  # t
    half_way: Vector  # g
    rotation: Rotation  # by θ
    half_turn: int  # ω in units of 2^-ROTATION_BITS, off by at most 2

    def most_turn(self) -> int:
        """Return an upper bound of |ω|."""
        return abs(self.half_turn) + 2


def make_motion(a: Waypoint, b: Waypoint, begin: int, end: int) -> Motion:
    """Return the part of a straight motion from parameter begin to end, both in units."""
    s, h = Fraction(begin + end, 2 * ONE), Fraction(end - begin, 2 * ONE)
    radians, turns = Fraction(b.theta) - Fraction(a.theta), b.turns - a.turns
    middle = a.x + math.floor(s * (b.x - a.x)), a.y + math.floor(s * (b.y - a.y))
    half_way = math.floor(h * (b.x - a.x)), math.floor(h * (b.y - a.y))
    half_turn = angle_units(h * radians, h * turns) >> (ANGLE_BITS - ROTATION_BITS)
    turned = rotation(Fraction(a.theta) + s * radians, a.turns + s * turns)
    return Motion(middle, half_way, turned, half_turn)


def swept_box(vertices: Iterable[Vector], motion: Motion) -> Rectangle:
    """Return a box that holds the vertices during a motion."""
    (tx, ty), (gx, gy), (c, s), _ = motion
    most = motion.most_turn()
    corners = []
    for x, y in vertices:
        u, v, e = x * c - y * s, x * s + y * c, (abs(x) + abs(y)) * (most + 1)
        corners += [(u - e, v - e), (u + e, v + e)]
    xmin, ymin, xmax, ymax = (side >> ROTATION_BITS for side in bounding_box(corners))
    gx, gy = abs(gx) + 3, abs(gy) + 3  # for what is rounded
    return xmin + tx - gx, ymin + ty - gy, xmax + tx + gx, ymax + ty + gy


def stays_outside(edge: Edge, vertex: Vector, motion: Motion) -> bool:
    """Prove that the edge's function, for the vertex, is at least 0 during the motion.

    With v and w its sinusoid's value and derivative at θ and the slope of the translation it is at
    least C + v − |slope + w ω| − max(v, 0) ω²/2 − |w| |ω|³/6; for an edge of the robot less what
    turning changes about the slope.
    """
    t, g, (c, s), omega = motion
    most = motion.most_turn()
    C, D, E = edge.sinusoid(vertex, t)
    v, w, error = D * c + E * s, E * c - D * s, abs(D) + abs(E)
    G, H = dot(edge.normal, g), cross(edge.normal, g)
    slope, spare = G << ROTATION_BITS, 4 * sum(map(abs, edge.normal)) << ROTATION_BITS  # t, g
    if not edge.of_obstacle:
        slope, off = -(G * c + H * s), abs(G) + abs(H)
        spare += off + ((abs(slope) + off) * most**2 >> 2 * ROTATION_BITS + 1)
        spare += (abs(H * c - G * s) + off) * most >> ROTATION_BITS
    spare += (max(v, 0) + error) * most**2 >> 2 * ROTATION_BITS + 1
    spare += (abs(w) + error) * most**3 // (6 << 3 * ROTATION_BITS)
    spare += error * ((most >> ROTATION_BITS) + 5) + 9  # v, w, ω and the divisions are rounded
    return (C << ROTATION_BITS) + v - abs(slope + (w * omega >> ROTATION_BITS)) >= spare
