"""Bounds for the reference point that stand for the unbounded plane."""

from __future__ import annotations

from planar_planner.scene.fields import Box
from planar_planner.tolerances import BOUNDS_SLACK


def stands_for_plane(bounds: Box, obstacles: Box, reach: float) -> bool:
    """Return whether bounds give every query between places in them its answer in the plane.

    They do if they contain the box of all obstacles, grown by `reach` on every side, since start
    and goal need only be inside (`bounds_of_plane`). Bounds that `bounds_of_plane` chose pass: its
    slack is larger than the rounding here.
    """
    xmin, ymin, xmax, ymax = obstacles
    room = (xmin - bounds[0], ymin - bounds[1], bounds[2] - xmax, bounds[3] - ymax)
    return min(room) >= reach


def bounds_of_plane(box: Box, reach: float) -> Box:
    """Return bounds with which a query has the same answer as in the unbounded plane.

    Let r be the robot's largest distance from its reference point, and B a box that contains all
    obstacles, start and goal, grown by more than r on every side. If the reference point is outside
    B or on its border, the robot meets no obstacle. The map of every point to the nearest one in B
    is continuous and leaves points of B fixed, so a free path has a free image in B: the query has
    the same answer with the bounds B as in the plane. Larger bounds serve as well, so those of a
    robot also serve every robot of smaller reach.

    Parameters
    ----------
    box : (xmin, ymin, xmax, ymax)
        A box that contains the obstacles, the start and the goal; world frame.
    reach : float
        The robot's largest distance from its reference point, r, in the scene's unit; rounded.
    """
    xmin, ymin, xmax, ymax = box
    size = max(map(abs, box))
    margin = reach * BOUNDS_SLACK + size * 2.0**-50  # the second covers the sums' rounding
    return xmin - margin, ymin - margin, xmax + margin, ymax + margin
