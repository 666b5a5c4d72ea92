"""Maze family: an L-shaped robot in a seeded perfect maze, which must turn at every corner.

Cells are unit squares. The robot is longer than a corridor is wide, so it can only travel along a
corridor with its long leg in the corridor's direction.
"""

import math
import random
from typing import TypeAlias

from scenarios.model import Configuration, Geometry, Ring, Scene, box, polygon, scene

Cell: TypeAlias = tuple[int, int]  # column, row
Link: TypeAlias = frozenset[Cell]  # an opening between two neighbouring cells

SIZE = 20
SEED = 14
WALL = 0.1  # thickness: corridors are 1 - WALL wide

LONG_LEG = 1.2
SHORT_LEG = 0.5
THICKNESS = 0.25


def robot_ring() -> Ring:
    """Outline of the L, long leg along x; the reference point is the middle of its bounding box."""
    x, y = 0.5 * LONG_LEG, 0.5 * SHORT_LEG
    return [
        (-x, -y),
        (x, -y),
        (x, -y + THICKNESS),
        (-x + THICKNESS, -y + THICKNESS),
        (-x + THICKNESS, y),
        (-x, y),
    ]


def _neighbours(cell: Cell, size: int) -> list[Cell]:
    column, row = cell
    around = [(column + 1, row), (column, row + 1), (column - 1, row), (column, row - 1)]
    return [(c, r) for c, r in around if 0 <= c < size and 0 <= r < size]


def perfect_maze(size: int, seed: int) -> set[Link]:
    """Return the openings of a random spanning tree of the grid: Wilson's algorithm."""
    rng = random.Random(seed)
    cells = [(column, row) for row in range(size) for column in range(size)]
    in_tree = {cells[rng.randrange(len(cells))]}
    links: set[Link] = set()
    for root in cells:
        next_cell: dict[Cell, Cell] = {}
        cell = root
        while (
            cell not in in_tree
        ):  # a random walk; leaving a cell again overwrites, which erases loops
            around = _neighbours(cell, size)
            next_cell[cell] = around[rng.randrange(len(around))]
            cell = next_cell[cell]
        cell = root
        while cell not in in_tree:
            in_tree.add(cell)
            links.add(frozenset((cell, next_cell[cell])))
            cell = next_cell[cell]
    return links


def solution(links: set[Link], size: int) -> list[Cell]:
    """Return the only way from cell (0, 0) to cell (size - 1, size - 1)."""
    parent: dict[Cell, Cell] = {(0, 0): (0, 0)}
    stack: list[Cell] = [(0, 0)]
    while stack:
        cell = stack.pop()
        for other in _neighbours(cell, size):
            if other not in parent and frozenset((cell, other)) in links:
                parent[other] = cell
                stack.append(other)
    way = [(size - 1, size - 1)]
    while way[-1] != (0, 0):
        way.append(parent[way[-1]])
    return way[::-1]


def _runs(closed: list[bool]) -> list[tuple[int, int]]:
    """Maximal runs [first, last + 1) of true values."""
    runs: list[tuple[int, int]] = []
    for k, value in enumerate(closed):
        if value and runs and runs[-1][1] == k:
            runs[-1] = (runs[-1][0], k + 1)
        elif value:
            runs.append((k, k + 1))
    return runs


def walls(links: set[Link], size: int) -> list[Geometry]:
    """Inner walls as rectangles, one for each straight run; runs overlap where they meet."""
    h = 0.5 * WALL
    rectangles: list[Geometry] = []
    for line in range(1, size):
        upright = [frozenset(((line - 1, row), (line, row))) not in links for row in range(size)]
        level = [frozenset(((c, line - 1), (c, line))) not in links for c in range(size)]
        rectangles += [box(line - h, a - h, line + h, b + h) for a, b in _runs(upright)]
        rectangles += [box(a - h, line - h, b + h, line + h) for a, b in _runs(level)]
    return rectangles


def _parked(cell: Cell, ahead: Cell) -> Configuration:
    """Return a configuration in an end cell, long leg along the way out, clear of the walls."""
    dx, dy = ahead[0] - cell[0], ahead[1] - cell[1]
    shift = 0.5 * LONG_LEG - 0.5 + 0.5 * WALL + 0.1
    return cell[0] + 0.5 + shift * dx, cell[1] + 0.5 + shift * dy, math.atan2(dy, dx)


def maze(size: int = SIZE, seed: int = SEED, *, blocked: bool = False, name: str = "maze") -> Scene:
    """Maze scene.

    Parameters
    ----------
    size
        Number of rows and columns.
    seed
        Seed of the maze.
    blocked
        Close the only way in the middle with one more wall.
    name
        Name of the scene.
    """
    if size < 2:
        raise ValueError(f"maze: size is {size}, must be at least 2")
    links = perfect_maze(size, seed)
    way = solution(links, size)
    start, goal = _parked(way[0], way[1]), _parked(way[-1], way[-2])
    if blocked:
        middle = len(way) // 2
        links.remove(frozenset((way[middle], way[middle + 1])))
    return scene(
        name,
        f"An L-shaped robot in a {size} x {size} maze, seed {seed}, must turn at corners"
        + (", and one wall more closes the only way." if blocked else "."),
        workspace=(0.0, 0.0, float(size), float(size)),
        robot=polygon(robot_ring()),
        obstacles=walls(links, size),
        start=start,
        goal=goal,
    )
