"""A scene as a Chipmunk space; lengths in there are the scene's times a power of two."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import OptionsError
from planar_planner.physics.shapes import (
    Shape,
    least_width,
    obstacle_shapes,
    robot_shapes,
    scale_of,
)
from planar_planner.planning.path_samples import reach
from planar_planner.problem.make import Problem
from planar_planner.tolerances import CHIPMUNK_ROUNDINGS

if TYPE_CHECKING:
    from types import ModuleType

    import pymunk


CELLS_ACROSS = 256
"""Cells of the spatial hash from side to side, at most: a wall is entered in all that it covers."""

CELLS_FROM_ORIGIN = 2**24
"""Most cells from the origin: Chipmunk numbers them by 32-bit integers."""

CELLS_PER_SHAPE = 10
"""Entries of the hash table a shape; Chipmunk's documentation advises ten."""


@dataclass(frozen=True)
class World:
    """A scene in Chipmunk; the robot is a body with shapes, not yet in the space.

    Attributes
    ----------
    space : pymunk.Space
        Holds the obstacles as static shapes; a shape's collision_type is its index in `names`.
    robot : pymunk.Body
        Its position is that of the reference point.
    names : tuple of str
        What the obstacles' shapes belong to.
    scale : float
        Lengths in the space are the scene's times this power of two.
    thinnest : float
        Least width of a piece of the robot plus that of an obstacle's; the scene's unit.
    """

    space: pymunk.Space
    robot: pymunk.Body
    names: tuple[str, ...]
    scale: float
    thinnest: float


def engine() -> ModuleType:
    """Import pymunk.

    Raises
    ------
    OptionsError
        If it is not installed, naming the extra that brings it.
    """
    try:
        import pymunk
    except ImportError:
        raise OptionsError(
            'physics needs pymunk, which is not installed: pip install "planar-planner[physics]"'
        ) from None
    return pymunk


def engine_name() -> str:
    """Return the versions of Chipmunk and pymunk."""
    pymunk = engine()
    return f"Chipmunk {pymunk.chipmunk_version.partition('-')[0]} in pymunk {pymunk.version}"


def make_world(problem: Problem, *, dynamic: bool) -> World:
    """Build the space: obstacles, walls, and the robot's body, which forces can move or only we.

    Parameters
    ----------
    problem : Problem
        The scene.
    dynamic : bool
        Whether the robot has mass, of density one; else it is kinematic: only we move it.
    """
    pymunk = engine()
    scale = scale_of(problem)
    obstacles, pieces = obstacle_shapes(problem, scale), robot_shapes(problem, scale)
    space = pymunk.Space()
    if obstacles:
        space.use_spatial_hash(*_cells(obstacles))
    for index, shape in enumerate(obstacles):
        static = _poly(space.static_body, shape)
        static.collision_type = index
        space.add(static)
    body = _body(dynamic=dynamic, turning=problem.rotation)
    for shape in pieces:
        poly = _poly(body, shape)
        if dynamic and problem.rotation:
            poly.density = 1.0  # Chipmunk sums mass, moment of inertia and centre of gravity
    thinnest = (least_width(pieces) + least_width(obstacles)) / scale
    return World(space, body, tuple(shape.what for shape in obstacles), scale, thinnest)


def rounding(problem: Problem, configurations: NDArray[np.float64]) -> float:
    """Return how far off a depth that Chipmunk reports may be there, in the scene's unit."""
    radius = reach(problem.robot)
    fixed = [problem.obstacles.coords.ravel(), np.array(problem.workspace_box or ())]
    if problem.workspace is not None:
        fixed.append(problem.workspace.coords.ravel())
    largest = max(
        float(np.abs(np.concatenate(fixed)).max(initial=0.0)),
        radius + float(np.abs(configurations[:, :2]).max()),
        radius * float(np.abs(configurations[:, 2]).max()),
    )
    return CHIPMUNK_ROUNDINGS * (sys.float_info.epsilon / 2.0) * largest


def _cells(shapes: list[Shape]) -> tuple[float, int]:
    """Return size and number of a spatial hash's cells.

    Chipmunk's other index, a tree, remembers for each pair the features that were last in contact
    and starts from them: on edges that touch, its search then may end at a wrong feature and report
    a depth of half the robot where there is none (tests/planner/physics). The hash
    starts each search afresh.
    """
    vertices = np.concatenate([shape.vertices for shape in shapes])
    extent = float((vertices.max(axis=0) - vertices.min(axis=0)).max())
    largest = float(np.abs(vertices).max())
    return max(1.0, extent / CELLS_ACROSS, largest / CELLS_FROM_ORIGIN), CELLS_PER_SHAPE * len(
        shapes
    )


def _body(*, dynamic: bool, turning: bool) -> pymunk.Body:
    make = engine().Body
    body: pymunk.Body
    if not dynamic:
        body = make(body_type=make.KINEMATIC)
    elif turning:
        body = make()
    else:
        body = make(mass=1.0, moment=math.inf)
    return body


def _poly(body: pymunk.Body, shape: Shape) -> pymunk.Poly:
    poly: pymunk.Poly = engine().Poly(body, shape.vertices.tolist())  # of radius 0
    poly.friction = poly.elasticity = 0.0  # as in the planner, contact holds nothing back
    return poly
