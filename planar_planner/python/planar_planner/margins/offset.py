"""The robot grown or shrunk by a distance: the family A(m) of `--by offset`.

A(m) = A + D_m, the Minkowski sum with a disc, for m >= 0; for m < 0 the erosion, the points of A at
distance |m| or more from A's complement. A is the union of the robot's polygons.

- *Grown.* (K_1 ∪ ... ∪ K_n) + D = (K_1 + D) ∪ ... ∪ (K_n + D): the body is the union of the convex
  pieces, which `pdg` computes exactly, each grown (`rounded_hull`). Holes close as the pieces round
  them meet.
- *Shrunk.* Polygons that lie apart are shrunk separately: a disc inside the union is inside one of
  them, because it is connected. For polygons that touch or overlap this would be wrong along their
  common part, so they are refused.

A free A(m) keeps the robot |m| away from everything if m >= 0.
"""

from __future__ import annotations

import math

import numpy as np
import shapely

import pdg
from planar_planner.margins.body import Body, ClaimError, Floats, polygons_of, shapes_of
from planar_planner.margins.erosion import depths, eroded
from planar_planner.margins.rounded_hull import circumscribed, inner_radius, outer_radius
from planar_planner.problem.make import Polygons

GAP = 0.2
"""outer - inner as a part of the bracket that a body halves: a query leaves at most (1 + GAP) / 2
of the bracket. The number of vertices grows with the inverse square root of the gap."""


class Offsets:
    """The robot's offsets as a `Family`; lengths in the scene's unit."""

    neutral = 0.0
    monotone = True

    def __init__(self, robot: Polygons) -> None:
        self._robot = robot
        self._shapes = shapes_of(robot)
        self._pieces = list(pdg.convex_pieces([_polygon(shape) for shape in self._shapes]))
        self.vanishing = -max(map(_inradius_bound, self._shapes))

    def between(self, low: float, high: float) -> Body:
        """Return a body with low < inner <= outer < high; the robot itself if 0 is the middle.

        Raises
        ------
        ClaimError
            If no such body could be certified.
        """
        middle = 0.5 * (low + high)
        gap = GAP * (high - low)
        if middle == 0.0:
            return Body(self._robot, 0.0, 0.0)
        gap = min(gap, abs(middle))  # a body is then either grown or shrunk, not both
        return self._grown(middle, gap) if middle > 0.0 else self._shrunk(-middle, gap)

    def raised(self, body: Body, clearance: float) -> float:
        """Return inner plus the clearance for a grown body, rounded down; inner for a shrunk one.

        (A + D_m) + D_c = A + D_{m + c}. No such law holds for a shrunk body, because growing it
        again does not restore the parts that it has lost.
        """
        if body.inner < 0.0 or not math.isfinite(clearance):
            return body.inner
        return math.nextafter(body.inner + clearance, -math.inf)

    def _grown(self, middle: float, gap: float) -> Body:
        radius = middle - 0.5 * gap
        grown = [circumscribed(piece, radius, gap) for piece in self._pieces]
        pairs = list(zip(self._pieces, grown, strict=True))
        return Body(
            polygons_of([[ring] for ring in grown]),
            min(inner_radius(piece, ring) for piece, ring in pairs),
            max(outer_radius(piece, ring) for piece, ring in pairs),
        )

    def _shrunk(self, middle: float, gap: float) -> Body:
        _check_apart(self._shapes)
        depth = middle - 0.5 * gap
        parts: list[list[Floats]] = []
        shallow, deep = math.inf, 0.0
        for shape in self._shapes:
            left = eroded(shape, depth, 0.75 * gap)
            bounds = depths(shape, left, depth + gap)
            shallow = min(shallow, bounds[0]) if left else shallow
            deep = max(deep, bounds[1])
            parts += left
        if not parts:
            return Body(None, -deep, -depth)
        return Body(polygons_of(parts), -deep, -shallow)


def _inradius_bound(shape: list[Floats]) -> float:
    """Return more than the radius of any disc in the polygon: half its box's shorter side."""
    low, high = shape[0].min(axis=0), shape[0].max(axis=0)
    return math.nextafter(float((high - low).min()), math.inf) * 0.5


def _polygon(shape: list[Floats]) -> shapely.Polygon:
    return shapely.Polygon(shape[0], shape[1:])


def _check_apart(shapes: list[list[Floats]]) -> None:
    polygons = np.array([_polygon(shape) for shape in shapes])
    for i, polygon in enumerate(polygons[:-1]):
        if shapely.intersects(polygon, polygons[i + 1 :]).any():
            raise ClaimError(
                "polygons of the robot touch or overlap, so it cannot be shrunk: merge them"
            )
