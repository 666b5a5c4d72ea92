"""Flood fill of a uniform C-space grid whose cells are labelled soundly.

A cell is a box in (x, y, theta) with centre q_c; no point of the robot moves further than
    delta = sqrt(h_x^2 + h_y^2) + 2 R sin(h_theta / 2)
between q_c and any other configuration of the cell (displacement metric). Hence
- if the robot *grown* by delta is free at q_c, the whole cell is free;
- if the robot *shrunk* by delta overlaps an obstacle at q_c, the whole cell is forbidden.
So a chain of free cells proves a path, and a start cut off by forbidden cells proves that
there is none; if neither holds the grid is not decisive. Each slice of constant theta is an exact
Minkowski sum of convex pieces, taken by shapely; ``ROUNDING`` covers its rounding, about 1e-15 of
the coordinates.
"""

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from oracles.scene_shapes import Shapes, shapes

ROUNDING = 1e-9  # added to delta, relative to the domain: a million times shapely's error
CONVEX = 1e-13  # depth of a dent that counts as rounding, over the perimeter: far below ROUNDING
ARC_SEGMENTS = 3  # straight pieces for a quarter circle where a corner is rounded by growing
ARC_FACTOR = 1.0 / math.cos(math.pi / (4 * ARC_SEGMENTS))  # polygonal arc outside the true one

Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class Grid:
    """Uniform cells over the domain; theta wraps round."""

    x: NDArray[np.float64]  # centres
    y: NDArray[np.float64]
    theta: NDArray[np.float64]
    delta: float  # motion bound of a cell

    def index(self, q: list[float]) -> tuple[int, int, int]:
        """Cell (theta, x, y) that holds a configuration."""
        nt = len(self.theta)
        it = math.floor((q[2] - self.theta[0]) / (2.0 * math.pi) * nt + 0.5) % nt
        return it, int(np.abs(self.x - q[0]).argmin()), int(np.abs(self.y - q[1]).argmin())


def make_grid(scene: Shapes, step: float) -> Grid:
    """Cells of side at most ``step``, turning the robot's furthest point by at most ``step``."""
    xmin, ymin, xmax, ymax = scene.reference_domain
    nx, ny = math.ceil((xmax - xmin) / step), math.ceil((ymax - ymin) / step)
    hx, hy = 0.5 * (xmax - xmin) / nx, 0.5 * (ymax - ymin) / ny
    nt = math.ceil(2.0 * math.pi * scene.radius / step) if scene.rotation else 1
    turn = 2.0 * scene.radius * math.sin(0.5 * math.pi / nt) if scene.rotation else 0.0
    return Grid(
        x=xmin + hx * (2.0 * np.arange(nx, dtype=np.float64) + 1.0),
        y=ymin + hy * (2.0 * np.arange(ny, dtype=np.float64) + 1.0),
        theta=scene.theta + 2.0 * math.pi * np.arange(nt) / nt,
        delta=math.hypot(hx, hy) + turn + ROUNDING * scene.size,
    )


def triangles(geometry: BaseGeometry) -> list[BaseGeometry]:
    """Triangles whose union is the geometry."""
    return list(shapely.get_parts(shapely.constrained_delaunay_triangles(geometry)))


def convex_pieces(geometry: BaseGeometry) -> list[BaseGeometry]:
    """Convex polygons whose union is the geometry: triangles, joined where they stay convex.

    A joined piece is a hull that exceeds the triangles by `CONVEX` of its perimeter at most.
    """
    if _is_convex(geometry):
        return [geometry.convex_hull]
    pieces: list[BaseGeometry] = []
    for triangle in triangles(geometry):
        for k, piece in enumerate(pieces):
            joined = shapely.union(piece, triangle)
            if _is_convex(joined):
                pieces[k] = joined.convex_hull
                break
        else:
            pieces.append(triangle)
    return pieces


def _is_convex(geometry: BaseGeometry) -> bool:
    """Whether a polygon's vertices lie on the boundary of its hull, up to rounding."""
    if geometry.geom_type != "Polygon" or len(geometry.interiors):
        return False
    hull = geometry.convex_hull
    dent = shapely.hausdorff_distance(geometry.exterior, hull.exterior)
    return bool(dent <= CONVEX * hull.length)


def translational_obstacle(
    robot: list[BaseGeometry], obstacles: list[BaseGeometry], theta: float
) -> BaseGeometry:
    """Translations at which the turned convex pieces of the robot overlap convex obstacles."""
    c, s = math.cos(theta), math.sin(theta)
    points, owner = shapely.get_coordinates(np.array(obstacles), return_index=True)
    sums = []
    for piece in robot:
        turned = shapely.get_coordinates(piece) @ np.array([[c, s], [-s, c]])  # rows: p R^T
        cloud = (points[:, None, :] - turned[None, :, :]).reshape(-1, 2)
        clouds = shapely.multipoints(cloud, indices=np.repeat(owner, len(turned)))
        sums.append(shapely.convex_hull(clouds))
    return shapely.union_all(np.concatenate(sums))


def _inside_box(
    robot: BaseGeometry, theta: float, grid: Grid, box: tuple[float, float, float, float]
) -> Bools:
    """Positions (x, y) at which the turned robot lies in a box."""
    c, s = math.cos(theta), math.sin(theta)
    points = shapely.get_coordinates(robot) @ np.array([[c, s], [-s, c]])
    low, high = points.min(axis=0), points.max(axis=0)
    in_x = (grid.x + low[0] >= box[0]) & (grid.x + high[0] <= box[2])
    in_y = (grid.y + low[1] >= box[1]) & (grid.y + high[1] <= box[3])
    inside: Bools = in_x[:, None] & in_y[None, :]
    return inside


def free_cells(
    scene: Shapes, grid: Grid, *, side: Literal["subset", "superset"], hulls: bool = False
) -> Bools:
    """Cells (theta, x, y) wholly free ("subset"), or all but those wholly forbidden ("superset").

    ``hulls`` puts the convex hull in the place of the robot and of each obstacle: quicker, and
    sound for the subset only.
    """
    if hulls and side == "superset":
        raise ValueError("hulls forbid more than the shapes do: not for side='superset'")
    sign = 1.0 if side == "subset" else -1.0
    robot = scene.robot.buffer(sign * grid.delta * ARC_FACTOR, quad_segs=ARC_SEGMENTS)
    free = np.ones((len(grid.theta), len(grid.x), len(grid.y)), dtype=bool)
    if robot.is_empty:
        return free  # only when shrunk: such a grid forbids nothing
    if hulls:
        robot_pieces = [robot.convex_hull]
        obstacles = [shape.convex_hull for shape in scene.obstacles]
    else:
        robot_pieces = convex_pieces(robot)
        obstacles = [piece for shape in scene.obstacles for piece in convex_pieces(shape)]
    xx, yy = np.meshgrid(grid.x, grid.y, indexing="ij")
    for k, theta in enumerate(grid.theta):
        here = free[k]
        if scene.box is not None:
            here &= _inside_box(robot, float(theta), grid, scene.box)
        if obstacles:
            forbidden = translational_obstacle(robot_pieces, obstacles, float(theta))
            shapely.prepare(forbidden)
            here[here] = ~shapely.contains_xy(forbidden, xx[here], yy[here])
    return free


def flood(free: Bools, seed: tuple[int, int, int], *, diagonal: bool) -> Bools:
    """Cells reached from a seed; axis 0 wraps, ``diagonal`` adds steps over edges and corners."""
    reached = np.zeros_like(free)
    if not free[seed]:
        return reached
    near = 3 if diagonal else 1
    offsets = [
        (a, b, c)
        for a in (-1, 0, 1)
        for b in (-1, 0, 1)
        for c in (-1, 0, 1)
        if 0 < abs(a) + abs(b) + abs(c) <= near
    ]
    nt, nx, ny = free.shape
    reached[seed] = True
    front = np.array([np.ravel_multi_index(seed, free.shape)])
    open_cells, seen = free.reshape(-1), reached.reshape(-1)
    while len(front):
        t, x, y = np.unravel_index(front, free.shape)
        found = []
        for a, b, c in offsets:
            inside = (x + b >= 0) & (x + b < nx) & (y + c >= 0) & (y + c < ny)
            cells = (((t + a) % nt) * nx + (x + b)) * ny + (y + c)
            cells = cells[inside]
            cells = cells[open_cells[cells] & ~seen[cells]]
            seen[cells] = True
            found.append(cells)
        front = np.concatenate(found)
    return reached


def decide(
    scene: dict[str, Any], step: float, *, claim: Literal["path", "no_path"], hulls: bool = False
) -> bool:
    """Tell whether a grid of this step proves the claim; False means that it is not decisive.

    Parameters
    ----------
    scene
        Parsed scene file.
    step
        Greatest side of a cell, in scene units.
    claim
        What to prove.
    hulls
        For a path only: work with convex hulls.
    """
    made = shapes(scene)
    grid = make_grid(made, step)
    start, goal = grid.index(scene["start"]), grid.index(scene["goal"])
    side: Literal["subset", "superset"] = "subset" if claim == "path" else "superset"
    free = free_cells(made, grid, side=side, hulls=hulls)
    if not (free[start] and free[goal]):
        return False  # a legal end never lies in a forbidden cell; in the subset it is undecided
    reached = bool(flood(free, start, diagonal=claim == "no_path")[goal])
    return reached if claim == "path" else not reached
