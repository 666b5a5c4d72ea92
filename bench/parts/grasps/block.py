"""The block that is grasped: a prism whose four side faces each take one finger.

[GFE] does not give its block. On the x axis ours is a FIT to rows (a1)–(a5) of Table I: the thumb
touches at a distance of 0.75 √3 from the origin and the middle finger at 0.75, with μ = μ_s = 0.2,
which gives all ten published values. The rest is our own choice: the cross-section is a trapezoid
with parallel sides of 2.4 and 1.2, so that thumb, index and ring finger alone can hold it.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg.grasp import Contact, soft_finger

FingerName = Literal["thumb", "middle", "index", "ring"]
FRICTION = TORSION = 0.2
THUMB, MIDDLE = 0.75 * 3**0.5, 0.75  # distances of two faces from the origin: the fit
HALF_WIDTHS = 1.2, 0.6  # of the thumb's and of the middle finger's face: our own
UP = np.array([0.0, 0.0, 1.0])


def face(finger: FingerName) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return a face's centroid and its unit inward normal, in the block's frame."""
    if finger == "thumb":
        return np.array([-THUMB, 0, 0]), np.array([1.0, 0, 0])
    if finger == "middle":
        return np.array([MIDDLE, 0, 0]), np.array([-1.0, 0, 0])
    side = 1.0 if finger == "index" else -1.0
    along = np.array([THUMB + MIDDLE, side * (HALF_WIDTHS[1] - HALF_WIDTHS[0]), 0.0])
    along /= np.linalg.norm(along)
    centroid = np.array([(MIDDLE - THUMB) / 2, side * sum(HALF_WIDTHS) / 2, 0.0])
    return centroid, side * np.cross(along, UP)


def contact(finger: FingerName, slide: float = 0.0) -> Contact:
    """Return the contact at a face's centroid, slid along the face away from the thumb."""
    centroid, normal = face(finger)
    tangent = np.cross(UP, normal)
    if tangent[0] < 0:
        tangent = -tangent
    if finger in ("thumb", "middle"):
        return soft_finger(centroid, normal, FRICTION, TORSION, UP)
    return soft_finger(centroid + slide * tangent, normal, FRICTION, TORSION, UP)
