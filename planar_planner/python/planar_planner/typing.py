"""Types that occur in public signatures, for annotations of one's own.

``Geometry``
    What a polygon or several may be given as: a `GeoObject` (shapely), a GeoJSON mapping, an
    `Array` or a sequence of vertices, shape (n, 2).
``Numbers``
    A few numbers in a row: a configuration (x, y, theta), a box (xmin, ymin, xmax, ymax).
``GoalLike``
    A configuration, a `GoalRegion`, an `Escape`, a mapping as in scene files, or ``"escape"``.
``SceneLike``
    A `Scene`, or whatever `load_scene` makes one of.
``Listener``
    Called about ten times a second with running counts; returning False stops the search.
"""

from __future__ import annotations

from planar_planner.load import SceneLike
from planar_planner.planning.engine import Listener
from planar_planner.scene.geometry import Array, Geometry, GeoObject, Numbers
from planar_planner.scene.goal_forms import GoalLike

__all__ = ["Array", "GeoObject", "Geometry", "GoalLike", "Listener", "Numbers", "SceneLike"]
