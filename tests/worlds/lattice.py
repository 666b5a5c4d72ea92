"""Scenes on a lattice whose answer is known exactly, contacts, exact fits and pinches included.

Boxes move among boxes without turning, all coordinates multiples of `STEP`. A translation is free
unless it moves the interior of a box of the robot onto an obstacle; such translations form an open
box, whose sides lie on the lattice again. So free space is a union of vertices, open edges and open
faces of the lattice, and a walk from each to those in its closure, or whose closure it is in, finds
what is connected.
"""

from __future__ import annotations

from collections.abc import Iterable
from random import Random

from worlds.scene import Scene

STEP = 0.5
SIDE = 8  # of the world, in steps

Box = tuple[int, int, int, int]  # xmin, ymin, xmax, ymax, in steps
Cell = tuple[int, int]  # twice a point in steps: even on the lattice, odd between


def lattice_scene(rng: Random) -> tuple[Scene, bool]:
    """Return a scene, and whether there is a path, with ends that often touch."""
    while True:
        robot = _robot(rng)
        obstacles = _boxes(rng)
        free = free_cells(robot, obstacles)
        ends = sorted(cell for cell in free if cell[0] % 2 == 0 and cell[1] % 2 == 0)
        if len(ends) > 1:
            break
    tight = [end for end in ends if len(_neighbours(end, free)) < 4]  # they touch something
    start, goal = (rng.choice(tight if tight and rng.random() < 0.8 else ends) for _ in range(2))
    scene: Scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0.0, 0.0, STEP * SIDE, STEP * SIDE]},
        "rotation": False,
        "robot": {"type": "MultiPolygon", "coordinates": [[_ring(box)] for box in robot]},
        "obstacles": [{"type": "Polygon", "coordinates": [_ring(box)]} for box in obstacles],
        "start": [0.5 * STEP * start[0], 0.5 * STEP * start[1], 0.0],
        "goal": [0.5 * STEP * goal[0], 0.5 * STEP * goal[1], 0.0],
    }
    return scene, goal in reached(start, free)


def _robot(rng: Random) -> list[Box]:
    """Return one box or two that share a side, the origin in a corner of the first."""
    w, h = rng.choice((1, 1, 2)), rng.choice((1, 1, 2))
    boxes = [(0, 0, w, h)]
    if rng.random() < 0.3:
        boxes.append((0, h, 1, h + 1))
    return boxes


def _boxes(rng: Random) -> list[Box]:
    boxes = []
    for _ in range(rng.randrange(4, 13)):
        x, y = rng.randrange(-1, SIDE), rng.randrange(-1, SIDE)
        long, wide = rng.randrange(1, 5), 1
        w, h = (long, wide) if rng.random() < 0.5 else (wide, long)
        boxes.append((x, y, x + w, y + h))
    return boxes


def _ring(box: Box) -> list[list[float]]:
    x0, y0, x1, y1 = (STEP * v for v in box)
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def free_cells(robot: list[Box], obstacles: list[Box]) -> set[Cell]:
    """Return the vertices, edges and faces at which the robot is free and in the world."""
    blocked = [
        (2 * (b[0] - a[2]), 2 * (b[1] - a[3]), 2 * (b[2] - a[0]), 2 * (b[3] - a[1]))
        for a in robot
        for b in obstacles
    ]
    low = [-2 * min(box[k] for box in robot) for k in (0, 1)]
    high = [2 * SIDE - 2 * max(box[k] for box in robot) for k in (2, 3)]
    return {
        (x, y)
        for x in range(low[0], high[0] + 1)
        for y in range(low[1], high[1] + 1)
        if not any(b[0] < x < b[2] and b[1] < y < b[3] for b in blocked)
    }


def _neighbours(cell: Cell, free: set[Cell]) -> list[Cell]:
    x, y = cell
    near: Iterable[Cell] = ((x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1))
    return [other for other in near if other in free]


def reached(start: Cell, free: set[Cell]) -> set[Cell]:
    """Return the cells that are connected with the start's."""
    found, todo = {start}, [start]
    while todo:
        for other in _neighbours(todo.pop(), free):
            if other not in found:
                found.add(other)
                todo.append(other)
    return found
