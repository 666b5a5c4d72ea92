"""Random bodies for the tests of pdg."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import affinity

from oracles.placing import Array


def convex(random: np.random.Generator, size: float = 5.0, corners: int = 9) -> Array:
    """Hull of random points: strictly convex, counter-clockwise."""
    points = random.uniform(-size, size, (int(random.integers(3, corners + 1)), 2))
    hull = shapely.multipoints(points).convex_hull
    return np.asarray(shapely.get_coordinates(shapely.orient_polygons(hull).exterior)[:-1])


def blob(random: np.random.Generator, parts: int = 6) -> shapely.MultiPolygon | shapely.Polygon:
    """Union of random rectangles and convex polygons less some discs: with holes and parts."""
    shapes = []
    for _ in range(parts):
        w, h = random.uniform(0.5, 4, 2)
        shape = (
            shapely.box(0, 0, w, h) if random.random() < 0.6 else shapely.Polygon(convex(random, 2))
        )
        shape = affinity.rotate(shape, random.uniform(0, 360))
        shapes.append(affinity.translate(shape, *random.uniform(-4, 4, 2)))
    union = shapely.union_all(shapes)
    for _ in range(int(random.integers(0, 3))):
        hole = shapely.Point(random.uniform(-3, 3, 2)).buffer(random.uniform(0.2, 1), quad_segs=3)
        union = union.difference(hole)
    return union
