"""A goal that is a set of places, or the outline that the robot is to get out of."""

from __future__ import annotations

from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.patches import Patch

from planar_planner.pictures.shapes import polygon_paths
from planar_planner.pictures.style import GOAL, rgba
from planar_planner.problem.goal import GoalSet


def draw_goal_region(axes: Axes, goal: GoalSet) -> list[Artist]:
    """Draw where the reference point is to get, or the polygon that it is to get out of."""
    style: dict[str, Any] = {"linewidth": 1.4, "edgecolor": GOAL}
    if goal.left is None:
        label = "goal: reference point in here"
        style |= {"facecolor": rgba(GOAL, 0.14), "linestyle": "solid"}
    else:
        label = "goal: reference point out of here"
        style |= {"facecolor": "none", "linestyle": (0, (6, 3))}
    if goal.angles is not None:
        label += f", θ in [{goal.angles[0]:.4g}, {goal.angles[1]:.4g}]"
    shapes = polygon_paths(goal.polygons if goal.left is None else goal.left)
    axes.add_collection(PathCollection(shapes, zorder=2.5, **style), autolim=False)
    return [Patch(**style, label=label)]
