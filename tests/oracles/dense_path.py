"""Dense check of a path by shapely: how deep the robot ever enters what it must not enter.

Samples cannot prove a path, but every violation found is real. The robot placed at a sample is off
by a few units in the last place of its coordinates, and shapely's overlay by somewhat more where
edges are nearly parallel. ``TOLERANCE`` is a thousand times what either amounts to in practice, and
a millionth of the smallest gap of any shipped scene.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from oracles.scene_shapes import Shapes, shapes

TOLERANCE = (
    1e-12  # of the scene's size: what rounding may show as depth on a path that only touches
)
STEP = 5e-4  # of the scene's size: greatest motion of any robot point between two samples
BATCH = 4096  # samples placed at once, which bounds memory

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Violation:
    """Worst findings along a path; all zero on a path without a fault."""

    depth: float  # width of the overlap with an obstacle, in the direction where it is least
    area: float  # of the overlap
    outside: float  # how far body or reference point leave their boxes
    where: tuple[float, float, float]  # configuration of the worst depth or excess
    samples: int
    size: float  # of the scene

    @property
    def within_rounding(self) -> bool:
        """Whether nothing was found that rounding cannot explain."""
        return max(self.depth, self.outside) <= TOLERANCE * self.size


def interpolate(path: Floats, radius: float, step: float) -> Floats:
    """Points of a piecewise linear path with its waypoints; no robot point moves more than step."""
    motion = np.diff(path, axis=0)
    length = np.hypot(motion[:, 0], motion[:, 1]) + radius * np.abs(motion[:, 2])
    pieces = [path[:1]]
    for k, count in enumerate(np.maximum(1, np.ceil(length / step).astype(int))):
        weight = (np.arange(1, count + 1) / count)[:, None]
        pieces.append((1.0 - weight) * path[k] + weight * path[k + 1])
    return np.concatenate(pieces)


def _placed(scene: Shapes, samples: Floats) -> NDArray[np.object_]:
    """Robot at each sample."""
    vertices = shapely.get_coordinates(scene.robot)
    c, s = np.cos(samples[:, 2]), np.sin(samples[:, 2])
    x = c[:, None] * vertices[:, 0] - s[:, None] * vertices[:, 1] + samples[:, :1]
    y = s[:, None] * vertices[:, 0] + c[:, None] * vertices[:, 1] + samples[:, 1:2]
    copies = np.repeat(np.array([scene.robot], dtype=object), len(samples))
    placed: NDArray[np.object_] = shapely.set_coordinates(
        copies, np.stack([x, y], axis=2).reshape(-1, 2)
    )
    return placed


def _outside(points: Floats, box: tuple[float, float, float, float]) -> Floats:
    """How far the bounds (M, 4) of shapes leave a box; 0 inside."""
    limits = np.array(box)
    excess = np.concatenate([limits[:2] - points[:, :2], points[:, 2:] - limits[2:]], axis=1)
    return np.asarray(np.maximum(excess.max(axis=1), 0.0))


def check_path(scene: dict[str, Any], path: ArrayLike, *, step: float = STEP) -> Violation:
    """Sample a path densely and return the worst violations.

    Parameters
    ----------
    scene
        Parsed scene file.
    path
        Waypoints (N, 3), theta unwrapped.
    step
        Greatest motion of a robot point between samples, relative to the scene's size.
    """
    made = shapes(scene)
    waypoints = np.asarray(path, dtype=np.float64).reshape(-1, 3)
    samples = interpolate(waypoints, made.radius, step * made.size)
    obstacles = np.array(made.obstacles, dtype=object)
    tree = shapely.STRtree(obstacles)
    depth = np.zeros(len(samples))
    area = np.zeros(len(samples))
    outside = np.zeros(len(samples))
    for first in range(0, len(samples), BATCH):
        batch = samples[first : first + BATCH]
        robots = _placed(made, batch)
        here = slice(first, first + len(batch))
        if made.box is not None:
            outside[here] = _outside(shapely.bounds(robots), made.box)
        if made.reference_bounds is not None:
            ends = np.concatenate([batch[:, :2], batch[:, :2]], axis=1)
            outside[here] = np.maximum(outside[here], _outside(ends, made.reference_bounds))
        which, what = tree.query(robots, predicate="intersects")
        common = shapely.intersection(robots[which], obstacles[what])
        overlap = shapely.area(common)
        np.maximum.at(area, first + which, overlap)
        deep = overlap > 0.0
        np.maximum.at(depth, first + which[deep], _widths(common[deep]))
    worst = int(np.argmax(np.maximum(depth, outside)))
    return Violation(
        depth=float(depth.max()),
        area=float(area.max()),
        outside=float(outside.max()),
        where=tuple(samples[worst].tolist()),
        samples=len(samples),
        size=made.size,
    )


def _widths(overlaps: NDArray[np.object_]) -> Floats:
    """Greatest width of an overlap's polygonal parts, each the least over its hull's directions."""
    widths = np.zeros(len(overlaps))
    parts, owner = shapely.get_parts(overlaps, return_index=True)
    solid = shapely.area(parts) > 0.0
    for part, k in zip(parts[solid], owner[solid], strict=True):
        hull = shapely.get_coordinates(part.convex_hull)
        edges = np.diff(hull, axis=0)
        normals = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.hypot(*edges.T)[:, None]
        heights = hull @ normals.T
        widths[k] = max(widths[k], float(np.ptp(heights, axis=0).min()))
    return widths
