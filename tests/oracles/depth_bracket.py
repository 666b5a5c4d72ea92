"""PD^g under the displacement metric, bracketed by branch and bound over the angle: a slow oracle.

Written with shapely and numpy only, in plain doubles, good to some 1e-9 of the bodies' size.

At a fixed angle the translations that collide are the interior of a Minkowski sum, and the
displacement DISP(q0, q) is convex in the translation: its least value over the free ones is at its
own minimum, if that is free, or on the sum's boundary. For angles within w of θ each point of A is
within δ = 2 r sin(w / 2) of its place at θ, so what is free there is free at θ from B eroded by δ,
and DISP differs by δ at most: the least DISP against the eroded B, less δ, is a lower bound.
"""

from __future__ import annotations

import heapq
import itertools
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from oracles.placing import Array, Pose, placed

FIRST = 16  # intervals to begin with
SEARCH = 80  # golden-section steps along an edge: (0.618)^80 < 1e-16
# Arcs of shapely's buffers are chords of so many parts of a quarter turn. Radii are widened by
# EROSION, so that the chords lie outside the circle that is meant.
SEGMENTS = 4
EROSION = 1.0 / math.cos(math.pi / (4 * SEGMENTS))
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


@dataclass(frozen=True)
class Bracket:
    """PD^g under DISP lies in [lower, upper] (length), after `seconds` of the processor's time."""

    seconds: float
    lower: float
    upper: float

    @property
    def gap(self) -> float:
        """Width relative to the upper end."""
        return (self.upper - self.lower) / self.upper if self.upper > 0 else 0.0


def triangles(body: shapely.Geometry) -> list[Array]:
    """Return a partition of a body."""
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(body))
    return [shapely.get_coordinates(part)[:3] for part in parts]


def refine(A: shapely.Geometry, B: shapely.Geometry, q0: Pose) -> Iterator[Bracket]:
    """Yield brackets, each within the last, as long as one asks for them."""
    began = time.process_time()
    slices = Slices(A, B, q0)
    tick = itertools.count()
    half = math.pi / FIRST
    middles = [q0[2] + (2 * k + 1 - FIRST) * half for k in range(FIRST)]
    upper = min(slices.least(middle, 0.0) for middle in (q0[2], *middles))
    heap = [(slices.lower(middle, half), next(tick), middle, half) for middle in middles]
    heapq.heapify(heap)
    while heap:
        lower, _, middle, half = heapq.heappop(heap)
        if lower >= upper:
            break
        yield Bracket(time.process_time() - began, lower, upper)
        for child in (middle - 0.5 * half, middle + 0.5 * half):
            upper = min(upper, slices.least(child, 0.0))
            bound = slices.lower(child, 0.5 * half)
            heapq.heappush(heap, (max(lower, bound), next(tick), child, 0.5 * half))
    yield Bracket(time.process_time() - began, upper, upper)


class Slices:
    """Least displacements at fixed angles."""

    def __init__(self, A: shapely.Geometry, B: shapely.Geometry, q0: Pose) -> None:
        self._pieces = triangles(A)
        self._hull = shapely.get_coordinates(A.convex_hull)[:-1]
        self._body = B
        self._q0 = q0
        self._reach = float(np.hypot(*self._hull.T).max())
        self._radius = float(shapely.minimum_bounding_radius(A))

    def lower(self, theta: float, half: float) -> float:
        """Return a lower bound for all angles within `half` of `theta`."""
        shift = 2.0 * self._reach * math.sin(0.5 * half)
        nearest = max(0.0, abs(theta - self._q0[2]) - half)
        turning = 2.0 * math.sin(0.5 * min(nearest, math.pi)) * self._radius
        return max(turning, self.least(theta, shift) - shift)

    def least(self, theta: float, erosion: float) -> float:
        """Return the least DISP from q0 over translations free of B, eroded, at an angle."""
        body = self._body.buffer(-EROSION * erosion, quad_segs=SEGMENTS) if erosion else self._body
        moves = placed(self._hull, (0.0, 0.0, theta)) - placed(self._hull, self._q0)
        best = _centre(-moves)
        if body.is_empty:
            return float(np.hypot(*(best + moves).T).max())
        turned = [placed(piece, (0.0, 0.0, theta)) for piece in self._pieces]
        sums = [
            shapely.multipoints((b[:, None] - a[None]).reshape(-1, 2)).convex_hull
            for a in turned
            for b in triangles(body)
        ]
        colliding = shapely.union_all(sums)
        if not shapely.contains_properly(colliding, shapely.Point(best)):
            return float(np.hypot(*(best + moves).T).max())
        return _least_on(_edges(colliding), moves)


def _centre(points: Array) -> Array:
    """Return the centre of the smallest circle round points, good to some 1e-9 of its radius."""
    circle = shapely.minimum_bounding_circle(shapely.multipoints(points))
    if circle.is_empty or circle.geom_type != "Polygon":  # all in one place
        return np.asarray(points[0])
    return np.asarray(shapely.get_coordinates(circle.centroid)[0])


def _edges(region: shapely.Geometry) -> tuple[Array, Array]:
    """Return begin and end of each boundary edge."""
    begins, ends = [], []
    for ring in shapely.get_parts(region.boundary):
        points = shapely.get_coordinates(ring)
        begins.append(points[:-1])
        ends.append(points[1:])
    return np.concatenate(begins), np.concatenate(ends)


def _least_on(edges: tuple[Array, Array], moves: Array) -> float:
    """Minimise max over moves of |t + move| over edges: convex along each, golden section."""
    begin, end = edges

    def value(s: Array) -> Array:
        t = begin + s[:, None] * (end - begin)
        return np.asarray(np.hypot(*np.moveaxis(t[:, None, :] + moves[None], 2, 0)).max(axis=1))

    low, high = np.zeros(len(begin)), np.ones(len(begin))
    for _ in range(SEARCH):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        keep_left = value(left) < value(right)
        high = np.where(keep_left, right, high)
        low = np.where(keep_left, low, left)
    return float(min(value(0.5 * (low + high)).min(), value(np.zeros(len(begin))).min()))
