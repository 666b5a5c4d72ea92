"""Queries to Chipmunk about what the robot touches, repeated where an answer cannot be right.

Where bodies touch or are aligned to the last bit, Chipmunk's search for the shortest separating
translation (GJK, then EPA) may end at a wrong feature. It then reports a depth of up to the size of
the bodies where there is none (for one in fourteen pairs of small integer polygons that touch
exactly), or no contact where there is depth (for one in six hundred that overlap). But the depth
changes by at most a point's displacement. So each answer is compared with the answer at a
configuration a billionth of the reach away, where nothing is aligned to the last bit. If the two
disagree, the median of nine answers counts.
"""

from __future__ import annotations

import math
import statistics
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from planar_planner.physics.report import Contact
from planar_planner.physics.world import World
from planar_planner.scene.fields import Configuration
from planar_planner.tolerances import ASIDE

ASKED_ASIDE = 8
"""Number of queries beside the configuration if the first two answers disagree. The median of all
nine answers counts, so four of them may be wrong."""


@dataclass(frozen=True)
class Findings:
    """What the robot touches along configurations.

    Attributes
    ----------
    contacts : tuple of Contact
        Deepest first.
    depths : NDArray, shape (N,)
        Deepest penetration at each configuration; 0 where it touches or is free.
    doubted : int
        Configurations where two answers disagreed. If the first answer was the wrong one, the depth
        is a lower bound, accurate to two billionths of the reach.
    """

    contacts: tuple[Contact, ...]
    depths: NDArray[np.float64]
    doubted: int

    @property
    def deepest(self) -> float:
        """Deepest penetration; 0 without contact."""
        return float(self.depths.max(initial=0.0))


def find_contacts(world: World, configurations: NDArray[np.float64]) -> Findings:
    """Ask Chipmunk what the robot touches at each configuration.

    Parameters
    ----------
    world : World
        The function moves its robot, which need not be in the space.
    configurations : (N, 3)
        (x, y, theta), in the scene's unit and radians.
    """
    counts: dict[str, int] = {}
    deepest: dict[str, tuple[float, Configuration]] = {}
    depths = np.zeros(len(configurations))
    doubted = 0
    for k, (x, y, theta) in enumerate(configurations.tolist()):
        here, unsure = touched(world, (x, y, theta))
        depths[k] = max(here.values(), default=0.0)
        doubted += unsure
        for what, depth in here.items():
            counts[what] = counts.get(what, 0) + 1
            if what not in deepest or depth > deepest[what][0]:
                deepest[what] = (depth, (x, y, theta))
    found = [Contact(what, counts[what], *deepest[what]) for what in counts]
    return Findings(tuple(sorted(found, key=lambda contact: -contact.depth)), depths, doubted)


def touched(world: World, q: Configuration) -> tuple[dict[str, float], bool]:
    """Return the depth in each thing that the robot touches, and whether answers disagreed.

    Parameters
    ----------
    world : World
        The function moves its robot.
    q : (x, y, theta)
        In the scene's unit and radians. The depths are in the scene's unit too.
    """
    aside = ASIDE / world.scale
    first = reported(world, q)
    second = reported(world, _beside(q, aside, 1.0))
    if _agree(first, second, aside):
        return first, False
    others = [reported(world, _beside(q, aside, angle)) for angle in range(2, ASKED_ASIDE + 1)]
    answers = [first, second, *others]
    held = {}
    for what in sorted(set().union(*answers)):
        depth = first.get(what, 0.0)
        middle = statistics.median(answer.get(what, 0.0) for answer in answers)
        held[what] = depth if abs(depth - middle) <= aside else max(0.0, middle - aside)
    return held, True


def _agree(one: dict[str, float], other: dict[str, float], aside: float) -> bool:
    return all(abs(one.get(what, 0.0) - other.get(what, 0.0)) <= aside for what in {*one, *other})


def reported(world: World, q: Configuration) -> dict[str, float]:
    """Return the depth in each thing that the robot touches, as Chipmunk reports it."""
    x, y, theta = q
    world.robot.position = x * world.scale, y * world.scale
    world.robot.angle = theta
    depths: dict[str, float] = {}
    for shape in world.robot.shapes:
        for hit in world.space.shape_query(shape):
            if hit.shape is None or hit.shape.body is world.robot:
                continue
            what = world.names[hit.shape.collision_type]
            for point in hit.contact_point_set.points:
                depths[what] = max(depths.get(what, 0.0), -point.distance / world.scale)
    return depths


def _beside(q: Configuration, aside: float, angle: float) -> Configuration:
    """Return a configuration at distance `aside`; whole radians avoid the directions of edges."""
    return q[0] + aside * math.cos(angle), q[1] + aside * math.sin(angle), q[2]
