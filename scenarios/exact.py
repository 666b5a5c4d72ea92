"""Scenes in which everything fits exactly, and twins that are off by a last place or a decimal."""

import math

from scenarios import maze
from scenarios.model import Geometry, Ring, Scene, box, polygon, scene

SIZE = 12  # cells along each side of the exact maze
SEED = 5
ULP = 2.0**-45  # of a coordinate between 128 and 256: far less than rounded arithmetic can tell
NARROW_SLOT = 0.099  # at its mouth, for a peg of 0.1
NARROW_MOUTH = 1.9  # of a cavity for a part of 2


def exact_maze(*, blocked: bool = False, name: str = "exact-maze") -> Scene:
    """Return a maze of unit squares whose corridors are as wide as the block in them.

    Its cells are the squares at odd coordinates, so every wall is a whole square. A twin has one
    square of the only way narrowed by `ULP`.
    """
    links = maze.perfect_maze(SIZE, SEED)
    way = maze.solution(links, SIZE)
    side = 2 * SIZE + 1
    open_squares = {(2 * c + 1, 2 * r + 1) for c in range(SIZE) for r in range(SIZE)}
    for link in links:
        (a, b), (c, d) = sorted(link)
        open_squares.add((a + c + 1, b + d + 1))
    walls: list[Geometry] = [
        box(x, y, x + 1, y + 1)
        for y in range(1, side - 1)
        for x in range(1, side - 1)
        if (x, y) not in open_squares
    ]
    if blocked:
        (a, b), (c, d) = way[len(way) // 2 - 1 : len(way) // 2 + 1]
        x, y = a + c + 1, b + d + 1  # the square between two cells of the way
        edge = ULP if a != c else 0.0
        beside = box(x, y, x + 1, y + edge) if a != c else box(x, y, x + ULP, y + 1)
        walls.append(beside)
    how = "one corridor is narrower by 3e-14" if blocked else "every corridor is as wide as it"
    return scene(
        name,
        f"A block of 1 in a maze of unit squares; it may not turn, and {how}.",
        workspace=(1.0, 1.0, float(side - 1), float(side - 1)),
        rotation=False,
        robot=box(0.0, 0.0, 1.0, 1.0),
        obstacles=walls,
        start=(1.0, 1.0, 0.0),
        goal=(float(side - 2), float(side - 2), 0.0),
    )


def peg(mouth: float = 0.1, name: str = "peg") -> Scene:
    """Return a peg that is to be turned upright and put into a slot of 0.1, down to its ground."""
    right = round(1.3 + mouth, 3)
    return scene(
        name,
        f"A peg of 0.1 by 0.4, and a slot of 0.1 that is {mouth:g} wide at its mouth.",
        workspace=(0.0, 0.0, 2.0, 1.2),
        robot=box(0.0, 0.0, 0.1, 0.4),
        obstacles=[
            box(0.0, 0.1, 1.3, 0.6),
            box(1.4, 0.1, 2.0, 0.6),
            box(right, 0.5, 2.0, 0.6),
        ],
        start=(0.5, 0.7, 0.5),
        goal=(1.3, 0.1, 0.0),
    )


def sliding_block(high: float = 6.0, name: str = "sliding-block") -> Scene:
    """Return an L-shaped block that slides between fixed blocks, touching them all the way.

    The way leads over a block that is 6 high; a twin has one that is higher by `ULP`.
    """
    return scene(
        name,
        "An L of three unit squares that may not turn slides between fixed blocks; every gap is "
        + ("as wide as it." if high == 6.0 else "as wide as it but one, by 3e-14."),
        workspace=(0.0, 0.0, 9.0, 9.0),
        rotation=False,
        robot=polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]),
        obstacles=[
            box(5.0, 2.0, 9.0, 4.0),
            box(3.0, 2.0, 5.0, 3.0),
            box(6.0, 6.0, 7.0, 7.0),
            box(2.0, 4.0, 3.0, 5.0),
            box(5.0, 8.0, 7.0, 9.0),
            box(1.0, 8.0, 3.0, 9.0),
            box(3.0, 4.0, 4.0, high),
        ],
        start=(0.0, 0.0, 0.0),
        goal=(7.0, 7.0, 0.0),
    )


def locked(mouth: float = NARROW_MOUTH, name: str = "locked") -> Scene:
    """Return a square part that fills its cavity; the mouth above is narrower, or as wide."""
    left = 5.0 - mouth / 2
    ring: Ring = [(2, 1), (8, 1), (8, 4), (left + mouth, 4), (left + mouth, 3), (6, 3)]
    ring += [(6, 2), (6, 1.5), (4, 1.5), (4, 3), (left, 3), (left, 4), (2, 4)]
    return scene(
        name,
        f"A part of 2 by 1.5 fills a cavity whose mouth is {mouth:g} wide.",
        workspace=(0.0, 0.0, 10.0, 8.0),
        robot=box(-1.0, 0.0, 1.0, 1.5),
        obstacles=[polygon(ring)],
        start=(5.0, 1.5, 0.0),
        goal=(2.0, 5.0, math.pi / 2),
    )
