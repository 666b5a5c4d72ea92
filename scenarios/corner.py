"""Corner family: a rectangle round a right-angled corner between two corridors of unit width.

A rectangle of length l and width w <= 1 passes exactly when l <= 2 (sqrt(2) - w) (or l <= 1,
because it then need not turn). At 45 degrees its outer side cuts a triangle of height l / 2 off the
outer corner, which leaves sqrt(2) - l / 2 to the inner corner for its width.
"""

import math

from scenarios.model import Scene, box, scene

DEFAULT_WIDTH = 0.1
PATH_LENGTH = 2.58  # critical: 2.6284 for DEFAULT_WIDTH
TOO_LONG = 2.7


def critical_length(width: float) -> float:
    """Length of the longest rectangle of this width that passes, rounded to a double."""
    return 2.0 * (math.sqrt(2.0) - width)


def corner(
    length: float = PATH_LENGTH, width: float = DEFAULT_WIDTH, name: str = "corner"
) -> Scene:
    """Corner scene for a rectangle of a given length and width.

    The free space is the union of [0, 1] x [0, e] and [0, e] x [0, 1]: the box gives the outer
    walls, one square obstacle the inner corner. Each arm holds the whole rectangle.
    """
    if not 0.0 < width < 1.0:
        raise ValueError(f"corner: width is {width}, must be in (0, 1)")
    extent = 4.0
    if not width <= length <= extent - 1.2:
        raise ValueError(f"corner: length is {length}, must be in [{width}, {extent - 1.2}]")
    middle_of_arm = 0.5 * (1.0 + extent)
    return scene(
        name,
        f"A rectangle {length} x {width} must turn the corner between two corridors of width 1.",
        workspace=(0.0, 0.0, extent, extent),
        robot=box(-0.5 * length, -0.5 * width, 0.5 * length, 0.5 * width),
        obstacles=[box(1.0, 1.0, extent, extent)],
        start=(0.5, middle_of_arm, -0.5 * math.pi),
        goal=(middle_of_arm, 0.5, 0.0),
    )
