"""Gear family: a small gear must mesh its way through the gap between two fixed gears.

Reconstruction of [PDG] Figure 14 (Zhang, Kim, Varadhan, Manocha, Generalized Penetration Depth
Computation, 2006): the paper gives neither coordinates nor tooth counts. The one parameter is the
tip gap, the distance between the tip circles of the fixed gears. The robot's tip circle has a
diameter of 2: from a tip gap of 2 on it passes without meshing.
"""

import math

from scenarios.model import Geometry, Point, Ring, Scene, polar, polygon, scene

ROBOT_TEETH = 8
FIXED_TEETH = 16
ROBOT_TIP_RADIUS = 1.0
FIXED_TIP_RADIUS = 2.0
TOOTH_HEIGHT = 0.3
TIP_FRACTION = 0.2  # of the angular pitch, at the tip circle
ROOT_FRACTION = 0.5  # of the angular pitch, at the root circle

# Tip gaps of the shipped scenes. The critical gap was bracketed by bisection with the planner: no
# path at 1.66335861, a path at 1.66335873; slices of C-space sampled with shapely: 1.663 to 1.669.
WIDE_GAP = 2.2
PATH_GAP = 1.72
CRITICAL_GAP = 1.6633587
TIGHT_GAP = 1.675
JAMMED_GAP = 1.6

WALL_OVERLAP = 0.1  # how far the fixed gears reach through the walls: no way round them


def gear_ring(
    teeth: int, tip_radius: float, centre: Point = (0.0, 0.0), phase: float = 0.0
) -> Ring:
    """Outline of a gear with trapezoidal teeth, four vertices per tooth, anticlockwise.

    Parameters
    ----------
    teeth
        Number of teeth.
    tip_radius
        Circumradius; the root circle lies ``TOOTH_HEIGHT`` below it.
    centre
        Position of the axle.
    phase
        Angle of the middle of tooth 0, radians.
    """
    pitch = 2.0 * math.pi / teeth
    root_radius = tip_radius - TOOTH_HEIGHT
    ring: Ring = []
    for k in range(teeth):
        middle = phase + k * pitch
        ring += [
            polar(root_radius, middle - 0.5 * ROOT_FRACTION * pitch, centre),
            polar(tip_radius, middle - 0.5 * TIP_FRACTION * pitch, centre),
            polar(tip_radius, middle + 0.5 * TIP_FRACTION * pitch, centre),
            polar(root_radius, middle + 0.5 * ROOT_FRACTION * pitch, centre),
        ]
    return ring


def fixed_gears(gap: float) -> list[Geometry]:
    """Return the two fixed gears, above and below the x axis, teeth pointing at each other."""
    height = FIXED_TIP_RADIUS + 0.5 * gap
    return [
        polygon(gear_ring(FIXED_TEETH, FIXED_TIP_RADIUS, (0.0, height), 0.5 * math.pi)),
        polygon(gear_ring(FIXED_TEETH, FIXED_TIP_RADIUS, (0.0, -height), 0.5 * math.pi)),
    ]


def gear(gap: float = PATH_GAP, name: str = "gear") -> Scene:
    """Gear scene with a given tip gap.

    Parameters
    ----------
    gap
        Distance between the tip circles of the fixed gears, in scene units (robot diameter 2).
    name
        Name of the scene.
    """
    if not 0.0 < gap <= 4.0:
        raise ValueError(f"gear: tip gap is {gap}, must be in (0, 4]")
    top = 2.0 * FIXED_TIP_RADIUS + 0.5 * gap - WALL_OVERLAP
    return scene(
        name,
        f"An 8-tooth gear of diameter 2 must pass between two fixed 16-tooth gears, tip gap {gap}.",
        workspace=(-4.5, -top, 4.5, top),
        robot=polygon(gear_ring(ROBOT_TEETH, ROBOT_TIP_RADIUS)),
        obstacles=fixed_gears(gap),
        start=(-3.3, 1.5, 0.0),
        goal=(3.3, -1.5, 0.0),
    )
