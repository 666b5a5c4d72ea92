"""A four-finger hand of our own, for [GFE] says of its hand only how the joints are driven.

Palm frame: origin at the palm's centre, z away from the object, x and y as the block's when the
hand is straight above it. All lengths are in the block's unit.

Each finger has four revolute joints. Joint 1 turns about the palm's z axis through the finger's
base: it swings the plane in which the finger bends. Joints 2, 3, 4 turn about parallel axes,
perpendicular to that plane; joint 2 is at the base. The links are LINKS long, from joint 2 to 3,
3 to 4, and 4 to the fingertip, which touches the object. Joints 1, 2, 3 are driven; joint 4 turns
as much as joint 3 (`COUPLING`), as in [GFE] section V.

Bases: where the palm is `HEIGHT` above the block's middle and not shifted, each base is straight
above a point `STANDOFF` outside the centroid of its face, along the face's normal.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from parts.grasps import block
from parts.grasps.block import FingerName
from pdg.grasp import Contact, Finger, finger, revolute

LINKS = 1.2, 0.8, 0.6
HEIGHT = 1.6
STANDOFF = 0.5
COUPLING = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]], dtype=float)
LARGEST_BEND = np.radians(100.0)  # of joints 3 and 4


@dataclass(frozen=True)
class HandPose:
    """Where the palm is in the block's frame.

    Attributes
    ----------
    shift : float
        Along x, from straight above the block.
    roll : float
        Radians about the palm's own x axis, so that bases swing sideways.
    """

    shift: float = 0.0
    roll: float = 0.0

    @property
    def turn(self) -> NDArray[np.float64]:
        """Rotation from the palm's frame to the block's."""
        c, s = np.cos(self.roll), np.sin(self.roll)
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])

    @property
    def origin(self) -> NDArray[np.float64]:
        """The palm's centre in the block's frame."""
        return np.array([self.shift, 0.0, HEIGHT])


def base(name: FingerName) -> NDArray[np.float64]:
    """Return a finger's base in the palm's frame."""
    centroid, normal = block.face(name)
    outside = centroid - STANDOFF * normal
    return np.array([outside[0], outside[1], 0.0])


def reaching(name: FingerName, contact: Contact, pose: HandPose, joint_1_locked: bool) -> Finger:
    """Return the finger with its tip at the contact (inverse kinematics)."""
    at = base(name)
    tip = pose.turn.T @ (contact.position - pose.origin) - at
    inward = np.array([tip[0], tip[1], 0.0])
    distance = float(np.linalg.norm(inward))
    inward /= distance
    angles = bend(distance, -float(tip[2]))
    bending = np.cross(inward, block.UP)  # turning about it by +α lifts `down` towards `inward`
    joints_at = [at]
    for length, angle in zip(LINKS[:2], angles[:2], strict=True):
        link = length * (np.sin(angle) * inward - np.cos(angle) * block.UP)
        joints_at.append(joints_at[-1] + link)
    points = [at, *joints_at]
    axes = [block.UP, bending, bending, bending]
    joints = [
        revolute(pose.turn @ point + pose.origin, pose.turn @ axis)
        for point, axis in zip(points, axes, strict=True)
    ]
    modes: list[Literal["active", "locked", "free"]] = ["active", "active", "active"]
    if joint_1_locked:
        modes[0] = "locked"
    return finger(contact, joints, COUPLING, modes)


def bend(inward: float, down: float) -> tuple[float, float, float]:
    """Return each link's angle from straight down, towards the object, in the finger's plane."""

    def chain(curl: float) -> complex:
        return complex(sum(length * np.exp(1j * k * curl) for k, length in enumerate(LINKS)))

    def excess(curl: float) -> float:
        return abs(chain(curl)) - float(np.hypot(inward, down))

    if excess(0.0) < 0 or excess(LARGEST_BEND) > 0:
        raise ValueError(f"the finger cannot reach ({inward:.3g}, {-down:.3g})")
    curl = float(brentq(excess, 0.0, LARGEST_BEND, xtol=1e-15, rtol=1e-14))
    first = float(np.arctan2(inward, down) - np.angle(chain(curl)))
    return first, first + curl, first + 2 * curl
