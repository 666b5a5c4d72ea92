"""The situations of [GFE] section V, and what its Table I says of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from parts.grasps import block
from parts.grasps.block import FingerName
from parts.grasps.four_finger_hand import HandPose, reaching
from pdg.grasp import Contact, Finger
from pdg.sets import Ball, Box, ConvexSet, CrossPolytope, Ellipsoid, Segment

TWO: tuple[FingerName, ...] = ("thumb", "middle")
THREE: tuple[FingerName, ...] = ("thumb", "index", "ring")
FOUR: tuple[FingerName, ...] = ("thumb", "middle", "index", "ring")
STRAIGHT = HandPose()
SHIFT = -0.1  # along x, towards the thumb, in (c), (f), (h): our own choice
ROLL = math.radians(8.0)  # about x, in (d), (g): our own choice


class Published(NamedTuple):
    """One half of a row of Table I."""

    value: float
    iterations: int
    seconds: float


@dataclass(frozen=True)
class Situation:
    """One row.

    Attributes
    ----------
    name : str
        As in the paper.
    fingers : tuple of str
        Which touch the block.
    locked : bool
        Whether joint 1 of each is locked.
    pose : HandPose
        Pose of the palm.
    slides : bool
        Whether index and ring finger move along their faces, so that their bending axes stay
        parallel to these.
    q : callable
        Makes Q of a number of dimensions, 6.
    whole, active : Published or None
        Table I of d_Q(W) and of d_Q(W^a); it lists each set of contacts once.
    dimension : int
        Of W^a, as published.
    formula : callable or None
        d_Q(W) in the fit, from α, γ and whether in six dimensions.
    """

    name: str
    fingers: tuple[FingerName, ...]
    locked: bool
    dimension: int
    active: Published
    whole: Published | None = None
    pose: HandPose = STRAIGHT
    slides: bool = False
    q: Callable[[int], ConvexSet] = Ball
    formula: Callable[[float, float, bool], float] | None = None

    def hand(self) -> list[Finger]:
        """Return the fingers in their pose."""
        return [
            reaching(name, contact, self.pose, self.locked)
            for name, contact in zip(self.fingers, self.contacts(), strict=True)
        ]

    def contacts(self) -> list[Contact]:
        """Return where they touch."""
        return [block.contact(name, self._slide(name)) for name in self.fingers]

    def _slide(self, name: FingerName) -> float:
        if not self.slides:
            return 0.0
        normal = block.face(name)[1]
        return self.pose.shift * abs(float(normal[1]))  # the face's direction is perpendicular


def long_ellipsoid(dimension: int) -> ConvexSet:
    """Semi-axis 2 along the first force component, 1 along all others."""
    return Ellipsoid(np.array([2.0, *np.ones(dimension - 1)]))


def unit_cross_polytope(dimension: int) -> ConvexSet:
    """Q of the 1-norm distance as Table I means it: the cross-polytope."""
    return CrossPolytope(np.ones(dimension))


def unit_cube(dimension: int) -> ConvexSet:
    """Q of the infinity-norm distance."""
    return Box(np.ones(dimension))


def unit_segment(dimension: int) -> ConvexSet:
    """From -1 to 1 along the first force component."""
    end = np.eye(dimension)[0]
    return Segment(-end, end)


def fit_parameters() -> tuple[float, float]:
    """Return α = L_1/(2 μ L) and γ = 1/(2 μ L), where 2 L = L_1 + L_2."""
    span = block.THUMB + block.MIDDLE
    return block.THUMB / (block.FRICTION * span), 1 / (block.FRICTION * span)


def _two_fingers(
    name: str,
    q: Callable[[int], ConvexSet],
    active: Published,
    whole: Published,
    formula: Callable[[float, float, bool], float],
) -> Situation:
    """Return a row (a1) to (a5): they differ in Q alone."""
    return Situation(name, TWO, True, 3, active, whole, q=q, formula=formula)


SITUATIONS: Sequence[Situation] = (
    _two_fingers(
        "a1",
        Ball,
        Published(0.2425, 3, 0.0028),
        Published(0.2425, 437, 155.18),
        lambda a, g, _: 1 / math.sqrt(1 + a * a + g * g),
    ),
    _two_fingers(
        "a2",
        long_ellipsoid,
        Published(0.2236, 4, 0.0040),
        Published(0.2235, 359, 108.93),
        lambda a, g, _: 1 / math.sqrt(4 + a * a + g * g),
    ),
    _two_fingers(
        "a3",
        unit_cross_polytope,
        Published(0.3155, 3, 0.0039),
        Published(0.3154, 96, 11.330),
        lambda a, g, _: 1 / max(1, a, g),
    ),
    _two_fingers(
        "a4",
        unit_cube,
        Published(0.1513, 4, 0.0032),
        Published(0.1119, 82, 6.1654),
        lambda a, g, six: 1 / (1 + (math.sqrt(2) if six else 1) * (a + g)),
    ),
    _two_fingers(
        "a5",
        unit_segment,
        Published(1.0, 2, 0.0026),
        Published(1.0, 18, 0.2989),
        lambda _a, _g, _: 1.0,
    ),
    Situation("b1", THREE, True, 5, Published(0.1238, 4, 0.0144)),
    Situation(
        "b2", THREE, False, 6, Published(0.2131, 104, 9.4171), Published(0.3399, 169, 19.997)
    ),
    Situation("c", THREE, False, 6, Published(0.0720, 38, 1.0430), pose=HandPose(shift=SHIFT)),
    Situation("d", THREE, False, 6, Published(0.1087, 25, 0.3657), pose=HandPose(roll=ROLL)),
    Situation("e1", FOUR, True, 5, Published(0.3586, 23, 0.0966)),
    Situation("e2", FOUR, False, 6, Published(0.3693, 90, 5.8219), Published(0.5624, 186, 21.907)),
    Situation("f", FOUR, False, 6, Published(0.0395, 16, 0.2188), pose=HandPose(shift=SHIFT)),
    Situation("g", FOUR, False, 6, Published(0.1536, 27, 0.5031), pose=HandPose(roll=ROLL)),
    Situation(
        "h",
        FOUR,
        False,
        6,
        Published(0.2882, 79, 3.9711),
        Published(0.4916, 243, 35.923),
        HandPose(shift=SHIFT),
        slides=True,
    ),
)
