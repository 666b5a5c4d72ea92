"""Goals that are sets of configurations, as users make them and as scene files have them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from planar_planner.scene.geometry import Geometry, Numbers, body
from planar_planner.scene.plain import plain


@dataclass(frozen=True)
class GoalRegion:
    """A goal: the reference point lies in a region, theta in an interval.

    Attributes
    ----------
    region : geometry
        Polygons in the world frame, by shapely, GeoJSON or vertices; kept as GeoJSON. They are
        closed: their boundary is part of the goal.
    theta : (lo, hi), optional
        Closed interval in radians, lo <= hi, up to whole turns; any theta without it.

    Raises
    ------
    SceneError
        If the region is no geometry. Whether it is valid is checked when it is planned on.
    """

    region: Geometry
    theta: Numbers | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "region", body(self.region, "goal.region"))
        object.__setattr__(self, "theta", plain(self.theta, "goal.theta"))


@dataclass(frozen=True)
class Escape:
    """A goal: the reference point is not in the interior of a polygon.

    Attributes
    ----------
    polygon : geometry
        One polygon without holes in the world frame, by shapely, GeoJSON or vertices; kept as
        GeoJSON.

    Raises
    ------
    SceneError
        If it is no geometry. Whether it is valid is checked when it is planned on.
    """

    polygon: Geometry

    def __post_init__(self) -> None:
        object.__setattr__(self, "polygon", body(self.polygon, "goal.escape"))


GoalLike: TypeAlias = Numbers | GoalRegion | Escape | Mapping[str, Any] | str
"""(x, y, theta), a `GoalRegion`, an `Escape`, the same as in a scene file, or ``"escape"``."""


def goal_json(goal: GoalLike) -> Any:
    """Return a goal as scene files have it; nothing else is checked.

    Raises
    ------
    SceneError
        If a region is no geometry, or the goal has no JSON form; without a source.
    """
    if isinstance(goal, GoalRegion):
        return {"region": goal.region} | ({} if goal.theta is None else {"theta": goal.theta})
    if isinstance(goal, Escape):
        return {"escape": goal.polygon}
    found = plain(goal, "goal")
    if isinstance(found, dict):
        for name in ("region", "escape"):
            if name in found:
                found[name] = body(found[name], f"goal.{name}")
    return found
