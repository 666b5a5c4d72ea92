"""Planar models after the 2006 paper: hammer and notches, spoon in cup, two pawns.

[PDG] Zhang, Kim, Varadhan, Manocha, *Generalized Penetration Depth Computation*, 2006, shows its
models (Figures 6, 8, 9 and 10) but gives no coordinates. These are outlines of our own, drawn in
the plane after the figures; numbers measured on them are not comparable with the paper's, whose
models are solids. Its section 7 interpolates 101 configurations linearly; so does
`Model.configurations`.

``python bench/depth_models.py`` prints what the models consist of.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

Pose = tuple[float, float, float]
SAMPLES = 101  # [PDG] section 7


@dataclass(frozen=True)
class Model:
    """A movable and a fixed body, and the motion along which depths are asked for.

    Attributes
    ----------
    name : str
        As in the paper.
    moving, fixed : shapely.Polygon
        Each in its own frame, in one unit of length.
    start, end : tuple of float
        Configurations (x, y, theta) of the moving body, theta in radians.
    """

    name: str
    moving: shapely.Polygon
    fixed: shapely.Polygon
    start: Pose
    end: Pose

    def configurations(self, samples: int = SAMPLES) -> NDArray[np.float64]:
        """Return (1 - t) start + t end for evenly spaced t in [0, 1], shape (samples, 3)."""
        t = np.linspace(0.0, 1.0, samples)[:, None]
        return np.asarray((1.0 - t) * np.array(self.start) + t * np.array(self.end))


def _arc(
    centre: tuple[float, float], radii: tuple[float, float], span: tuple[float, float], parts: int
) -> list[tuple[float, float]]:
    """Return `parts` + 1 points of an ellipse, angles in degrees."""
    angles = np.radians(np.linspace(*span, parts + 1))
    (x, y), (rx, ry) = centre, radii
    return [(x + rx * math.cos(a), y + ry * math.sin(a)) for a in angles]


def _mirrored(right: list[tuple[float, float]]) -> shapely.Polygon:
    """Return the polygon with this right half, from the lowest point up, mirrored in x = 0."""
    left = [(-x, y) for x, y in reversed(right) if x != 0.0]
    return shapely.Polygon([*right, *left])


def hammer() -> shapely.Polygon:
    """Return the hammer: handle downwards, face to the right, peen to the left."""
    return shapely.Polygon(
        [
            *((-0.30, -3.4), (-0.15, -3.5), (0.15, -3.5), (0.30, -3.4)),  # the handle's end
            *((0.36, -2.9), (0.36, -1.6), (0.26, -0.9), (0.24, 1.6)),
            *((0.70, 1.6), (0.80, 1.75), (1.10, 1.75), (1.10, 1.55), (1.20, 1.45), (1.55, 1.45)),
            *((1.65, 1.55), (1.65, 2.65), (1.55, 2.75), (1.20, 2.75), (1.10, 2.65), (1.10, 2.45)),
            *((0.80, 2.45), (0.70, 2.60), (-0.55, 2.60), (-1.05, 2.45), (-1.60, 2.12)),
            *((-1.60, 1.95), (-0.75, 1.75), (-0.55, 1.60)),
            *((-0.24, 1.6), (-0.26, -0.9), (-0.36, -1.6), (-0.36, -2.9)),
        ]
    )


def notch(width: float) -> shapely.Polygon:
    """Return a block with a chamfered notch of this width in its upper side; 12 vertices."""
    half, chamfer = 0.5 * width, 0.25
    return _mirrored(
        [
            *((6.0, -5.5), (6.0, 2.2), (5.7, 2.5)),
            *((half + chamfer, 2.5), (half, 2.5 - chamfer), (half, -4.2)),
        ]
    )


def cup() -> shapely.Polygon:
    """Return the section of a cup with a rounded inside and an ear, which makes a hole."""
    wall = shapely.Polygon(
        [
            *_arc((0.0, 0.0), (3.0, 3.4), (180.0, 360.0), 20),  # outside, left to right
            *((3.0, 3.0), (2.9, 3.12), (2.75, 3.12), (2.65, 3.0)),  # the right rim
            *_arc((0.0, 0.0), (2.65, 3.0), (360.0, 180.0), 18),  # inside, right to left
            *((-2.65, 3.0), (-2.75, 3.12), (-2.9, 3.12), (-3.0, 3.0)),
        ]
    )
    foot = shapely.Polygon([(-1.4, -3.8), (1.4, -3.8), (1.0, -3.15), (-1.0, -3.15)])
    ear = shapely.Polygon(
        [
            *_arc((2.95, 0.6), (1.7, 1.5), (-90.0, 90.0), 10),
            *_arc((2.95, 0.6), (1.3, 1.1), (90.0, -90.0), 8),
        ]
    )
    return shapely.union_all([wall, foot, ear])


def spoon() -> shapely.Polygon:
    """Return the side view of a spoon: bent handle to the upper right, bowl at the origin."""
    return shapely.Polygon(
        [
            *((-1.25, 0.12), *_arc((0.0, 0.1), (1.25, 0.62), (190.0, 330.0), 9)),  # below the bowl
            *((1.5, -0.02), (2.4, 0.55), (4.2, 1.75), (5.0, 2.2), (5.35, 2.3)),
            *((5.4, 2.42), (5.25, 2.5), (4.9, 2.42), (4.1, 1.97), (2.3, 0.78), (1.45, 0.24)),
            *(
                (1.1, 0.12),
                *_arc((0.0, 0.12), (1.05, 0.44), (345.0, 195.0), 8),
            ),  # the bowl's inside
        ]
    )


def pawn(size: float) -> shapely.Polygon:
    """Return the outline of a chess pawn, standing on y = 0, of height 5 times `size`."""
    right = [
        *((0.0, 0.0), (1.45, 0.0), (1.5, 0.1), (1.5, 0.45), (1.3, 0.62), (1.32, 0.8)),
        *((1.1, 1.05), (0.85, 1.4), (0.65, 1.85), (0.55, 2.35), (0.52, 2.85)),
        *((0.9, 3.02), (0.95, 3.15), (0.9, 3.28), (0.55, 3.38)),
        *_arc((0.0, 4.1), (0.9, 0.9), (-50.0, 90.0), 9)[:-1],
        (0.0, 5.0),
    ]
    return _mirrored([(size * x, size * y) for x, y in right])


def models() -> list[Model]:
    """Return the four models with the motions along which they are sampled."""
    half_turn = ((0.8, -0.9, 0.0), (0.8, -0.9, math.pi))
    return [
        Model("hammer", hammer(), notch(4.4), *half_turn),
        Model("hammer in narrow notch", hammer(), notch(3.5), *half_turn),
        Model("spoon in cup", spoon(), cup(), (-1.2, -1.9, -0.4), (1.9, -1.5, 1.9)),
        Model("pawn", pawn(0.45), pawn(1.0), (-1.6, 1.0, 0.0), (1.3, 2.2, 2.0)),
    ]
