"""Field family: a robot of several pieces among random polygons, from corner to corner."""

import math
import random

from scenarios.model import Geometry, Point, Scene, box, multi_polygon, polygon, scene

COUNT = 2000
SEED = 7
SPACING = 2.7  # side of the square that each polygon has to itself on average
PLACES = 4  # decimals of the coordinates
CLEAR = 2.5  # obstacles keep this far from the reference point at start and goal
ANNEX_WALL = 2.0  # thickness of the wall between field and annex


def robot() -> Geometry:
    """Three separate pieces, rigidly linked: an arrow head, a bar and a notched tail."""
    head = polygon([(0.3, -0.4), (0.9, 0.0), (0.3, 0.4)])
    bar = polygon([(-0.35, -0.12), (0.25, -0.12), (0.25, 0.12), (-0.35, 0.12)])
    tail = polygon([(-0.9, -0.4), (-0.4, -0.3), (-0.4, 0.3), (-0.9, 0.4), (-0.65, 0.0)])
    return multi_polygon([head, bar, tail])


def random_polygon(rng: random.Random, centre: Point) -> Geometry:
    """Polygon of 3 to 8 vertices, star-shaped about its centre, convex or not, radius 0.3 to 1."""
    count = rng.randint(3, 8)
    size = rng.uniform(0.6, 1.0)
    turn = rng.random()
    ring = []
    for k in range(count):
        angle = 2.0 * math.pi * (turn + (k + rng.uniform(-0.3, 0.3)) / count)
        radius = size * rng.uniform(0.5, 1.0)
        x, y = centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
        ring.append((round(x, PLACES), round(y, PLACES)))
    return polygon(ring)


def _scatter(
    rng: random.Random, count: int, lower: Point, upper: Point, keep_clear: list[Point]
) -> list[Geometry]:
    """Return polygons with centres uniform in a rectangle, clear of some points; may overlap."""
    made: list[Geometry] = []
    while len(made) < count:
        centre = rng.uniform(lower[0], upper[0]), rng.uniform(lower[1], upper[1])
        if all(max(abs(centre[0] - x), abs(centre[1] - y)) > CLEAR for x, y in keep_clear):
            made.append(random_polygon(rng, centre))
    return made


def field(
    count: int = COUNT,
    far: int = 0,
    seed: int = SEED,
    *,
    annex: bool = False,
    name: str = "field",
) -> Scene:
    """Field scene.

    Parameters
    ----------
    count
        Number of obstacles in the field; its area grows with it, the density stays.
    far
        Number of further obstacles, in an annex of the workspace behind a thick wall, as far from
        every channel between start and goal as the field is wide.
    seed
        Seed of field and annex; the field is the same whatever ``far`` is.
    annex
        Make wall and annex even if ``far`` is 0: the fair comparison for ``far > 0``.
    name
        Name of the scene.
    """
    if count < 1 or far < 0:
        raise ValueError(f"field: count is {count}, far is {far}; need count >= 1, far >= 0")
    side = round(SPACING * math.sqrt(count), 1)
    start, goal = (2.0, 2.0), (side - 2.0, side - 2.0)
    obstacles = _scatter(random.Random(seed), count, (0.0, 0.0), (side, side), [start, goal])
    right = side
    if annex or far > 0:
        wall_end = side + ANNEX_WALL
        right = 3.0 * side
        obstacles.append(box(side, -1.0, wall_end, side + 1.0))
        obstacles += _scatter(
            random.Random(seed + 1), far, (2.0 * side, 0.0), (right, side), keep_clear=[]
        )
    return scene(
        name,
        f"A robot of three pieces among {count} random polygons, seed {seed}"
        + (f", and {far} more behind a wall." if right > side else "."),
        workspace=(0.0, 0.0, right, side),
        robot=robot(),
        obstacles=obstacles,
        start=(*start, 0.0),
        goal=(*goal, 1.0),
    )
