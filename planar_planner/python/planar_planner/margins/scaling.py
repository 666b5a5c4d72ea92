"""The robot scaled about a point: the family A(m) of `--by scale`.

A(m) = c + m (A - c), m >= 0, c the reference point (the origin of the robot's frame) or the
centroid. m = 1 is the robot at its own size; m = 0 is a point, which is always free.

These bodies grow with m if A is star-shaped about c, that is, if every point of A is visible from
c. A is star-shaped if c is to the left of, or on, every edge of an anticlockwise outline without
holes (exact). Otherwise a larger robot is not a superset of a smaller one. Both verdicts are still
proven, each for its own factor, but there may be more than one change between the two factors.

*Rounding.* Scaled vertices are rounded, each by some distance up to e. Let D_k be a disc about c of
radius k > 0 to the left of every edge, so that A is star-shaped about each of its points. Then
m A + t D_k is inside (m + t) A, with c as origin: (m a + t d) / (m + t) is between a and d, which
sees a. The rounded outline is within e of the exact one, so its points are outside (m - e/k) A and
inside (m + e/k) A, and so the body lies between these two. With k = 0, and for robots that are not
star-shaped, the factor is that of the exact body and the verdict that of the rounded one.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Literal

import numpy as np

from planar_planner.margins.body import UNIT_ROUNDOFF, Body, Floats, polygons_of, shapes_of
from planar_planner.margins.segments import rounding_of
from planar_planner.problem.make import Polygons

Centre = Literal["reference", "centroid"]


class Scalings:
    """The robot's scalings as a `Family`; factors without unit."""

    neutral = 1.0
    vanishing = 0.0

    def __init__(self, robot: Polygons, about: Centre) -> None:
        self._shapes = shapes_of(robot)
        self.centre = np.zeros(2) if about == "reference" else _centroid(self._shapes)
        self.reach = float(np.hypot(*(robot.coords - self.centre).T).max())
        self._robot = robot
        self.monotone = all(_sees(shape, self.centre) for shape in self._shapes)
        self._kernel = _kernel_radius(self._shapes, self.centre) if self.monotone else 0.0

    def between(self, low: float, high: float) -> Body:
        """Return the body scaled by the middle of the two factors, rounded."""
        factor = 0.5 * (low + high)
        if factor == 1.0:
            return Body(self._robot, 1.0, 1.0)
        shapes = [[self.centre + factor * (r - self.centre) for r in s] for s in self._shapes]
        if self._kernel == 0.0:
            return Body(polygons_of(shapes), factor, factor)
        largest = float(np.abs(self.centre).max()) + factor * self.reach
        # There are three roundings per coordinate, each of u times an operand of a sum or product.
        error = 8.0 * UNIT_ROUNDOFF * largest / self._kernel
        return Body(polygons_of(shapes), factor - error, factor + error)

    def raised(self, body: Body, clearance: float) -> float:
        """Return the factor up to which a path holds that keeps the body this far from obstacles.

        (m + t) A is inside m A + D_{t R}, where R is the largest distance of a vertex from c.
        """
        if not self.monotone or not math.isfinite(clearance):
            return body.inner
        reach = self.reach * (1.0 + 8.0 * UNIT_ROUNDOFF)
        return math.nextafter(body.inner + clearance / reach, -math.inf)


def _sees(shape: list[Floats], centre: Floats) -> bool:
    """Return whether c is to the left of or on each edge of the one, anticlockwise ring; exact."""
    if len(shape) > 1:
        return False
    cx, cy = (Fraction(float(v)) for v in centre)
    corners = [(Fraction(x) - cx, Fraction(y) - cy) for x, y in shape[0].tolist()]
    crosses = [
        ax * by - ay * bx
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    return min(crosses) >= 0 or max(crosses) <= 0


def _kernel_radius(shapes: list[list[Floats]], centre: Floats) -> float:
    """Return a radius, rounded down, of a disc about c to the left of every edge; 0 if none."""
    least = math.inf
    for shape in shapes:
        d = shape[0] - centre
        e = np.roll(d, -1, axis=0) - d
        length = np.hypot(e[:, 0], e[:, 1])
        distance = np.abs(e[:, 0] * d[:, 1] - e[:, 1] * d[:, 0]) / length
        least = min(least, float(distance.min()) - rounding_of(shape[0], centre[np.newaxis]))
    return max(least, 0.0)


def _centroid(shapes: list[list[Floats]]) -> Floats:
    """Return the centroid of the polygons, each counted once, in rounded arithmetic."""
    import shapely

    centre = shapely.MultiPolygon([(s[0], s[1:]) for s in shapes]).centroid
    return np.array([centre.x, centre.y])
