"""Pairs of convex polygons at several configurations each: random and degenerate ones."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import shapely

import pdg
from oracles.placing import Array, placed

POSES = 10  # for each pair of bodies, in one batch
Bodies = tuple[Array, Array, Array]  # A, B, poses
Family = Callable[[np.random.Generator], Bodies]


def hull(points: Array) -> Array:
    """Return the convex hull, counter-clockwise."""
    shape = shapely.orient_polygons(shapely.multipoints(points).convex_hull)
    return np.asarray(shapely.get_coordinates(shape.exterior)[:-1])


def body(random: np.random.Generator, size: float = 1.0) -> Array:
    """Return the hull of a few random points."""
    return hull(random.uniform(-size, size, (int(random.integers(3, 12)), 2)))


def regular(sides: int, radius: float = 1.0) -> Array:
    """Return a regular polygon."""
    angles = 2 * np.pi * np.arange(sides) / sides
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def anywhere(random: np.random.Generator, reach: float = 1.5) -> Array:
    """Return some configurations."""
    return random.uniform((-reach, -reach, -4), (reach, reach, 4), (POSES, 3))


def random_pairs(random: np.random.Generator) -> Bodies:
    """Return two random bodies anywhere."""
    return body(random), body(random), anywhere(random)


def coincident(random: np.random.Generator) -> Bodies:
    """Return the same body twice, at rest, turned by right angles, or moved by almost nothing."""
    a = body(random) if random.random() < 0.7 else np.array([(-1.0, -1), (1, -1), (1, 1), (-1, 1)])
    poses = np.zeros((POSES, 3))
    poses[3:6, 2] = np.pi / 2 * np.arange(1, 4)
    poses[6:, :2] = random.normal(size=(POSES - 6, 2)) * 10.0 ** random.uniform(-18, -8)
    return a, a, poses


def concentric(random: np.random.Generator) -> Bodies:
    """Return regular polygons about one centre: every way out is as long as the next, or nearly."""
    a, b = (regular(int(n)) for n in random.integers(3, 17, 2))
    if random.random() < 0.02:
        a = b = regular(int(random.choice([64, 128])))
    poses = np.zeros((POSES, 3))
    poses[3:, 2] = random.uniform(-4, 4, POSES - 3)
    return a * random.choice([1.0, 0.5, 1e-3]), b, poses


def parallel(random: np.random.Generator) -> Bodies:
    """Return rectangles with parallel sides, on a grid and off it."""

    def box() -> Array:
        w, h = random.integers(1, 5, 2)
        return np.array([(0.0, 0), (w, 0), (w, h), (0, h)])

    a, b = box(), box()
    poses = np.column_stack([random.integers(-5, 6, (POSES, 2)), np.zeros(POSES)]).astype(float)
    poses[7:, :2] += random.normal(size=(3, 2)) * 10.0 ** random.uniform(-17, 0)
    if random.random() < 0.5:
        turn = random.uniform(-4, 4)
        poses[:, 2] = turn
        b = placed(b, np.array([0.0, 0.0, turn]))
        poses[:, :2] = placed(poses[:, :2], np.array([0.0, 0.0, turn]))
    return a, b, poses


def slivers(random: np.random.Generator) -> Bodies:
    """Return bodies as thin as a billionth or a billionth of a billionth of their length."""
    thin = np.array([1.0, 10.0 ** random.uniform(-18, -3)])
    a = hull(np.array([(0.0, 0.0), (1.0, 0.0), (random.uniform(), 1.0)]) * thin)
    b = body(random)
    if random.random() < 0.5:
        other = np.array([1.0, 10.0 ** random.uniform(-12, -3)])
        b = hull(np.array([(0.0, 0.0), (1.0, 0.0), (random.uniform(), 1.0)]) * other)
    poses = anywhere(random, 0.7)
    poses[:5, 2] = 0.0
    return a, b, poses


def sizes(random: np.random.Generator) -> Bodies:
    """Return one body up to a million million times larger than the other."""
    small = 10.0 ** random.uniform(-12, -2)
    a, b = body(random, small), body(random)
    poses = anywhere(random)
    corner = b[int(random.integers(len(b)))]
    poses[5:, :2] = corner + small * random.normal(size=(5, 2))
    return (a, b, poses) if random.random() < 0.5 else (b, a, poses * (1, 1, 0))


def near_contact(random: np.random.Generator) -> Bodies:
    """Return bodies that overlap or miss each other by next to nothing."""
    a, b, poses = random_pairs(random)
    for pose in poses:
        found = pdg.translational_depth(a, b, pose.tolist())
        sign = random.choice([-1.0, 1.0])
        step = found.depth + sign * 10.0 ** random.uniform(-17, -3)
        pose[:2] += step * np.array(found.direction)
    return a, b, poses


def far_away(random: np.random.Generator) -> Bodies:
    """Return bodies a million times their size from the origin."""
    a, b, poses = random_pairs(random)
    place = 10.0 ** random.uniform(1, 6) * random.normal(size=2)
    return a, b + place, poses + np.array([*place, 0.0])


FAMILIES: dict[str, Family] = {
    "random": random_pairs,
    "coincident": coincident,
    "concentric": concentric,
    "parallel edges": parallel,
    "slivers": slivers,
    "very different sizes": sizes,
    "near contact": near_contact,
    "far from the origin": far_away,
}
