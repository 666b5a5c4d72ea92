"""Penetration depths of planar bodies that translate and rotate.

It has convex pieces, the translational depth, bounds and brackets of the generalized depth, motion
bounds, the C-obstacle query, and the penetration distance of convex sets in any dimension.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pdg import sets
from pdg.aliases import Point, Pose, RealArray, Rows
from pdg.bodies.body import Body, GeoInterface, Shape
from pdg.bodies.defects import PolygonDefect, polygon_defect
from pdg.bodies.piece_set import ConvexPieces
from pdg.bodies.pieces import convex_pieces, even_odd_pieces
from pdg.depths.batch import Batch
from pdg.depths.depth import generalized_depth_lower_bound, translational_depth
from pdg.depths.depth_bracket import DepthBracket, DepthBrackets, generalized_depth_bracket
from pdg.depths.motion import (
    DistanceBracket,
    DistanceBrackets,
    MotionBounds,
    displacement,
    generalized_distance_bracket,
    motion_bounds,
)
from pdg.depths.query import (
    CellVerdict,
    CObstacleVerdict,
    CObstacleVerdicts,
    QueryMethod,
    c_obstacle_query,
)
from pdg.depths.results import (
    DepthLowerBound,
    DepthLowerBounds,
    PairState,
    TranslationalDepth,
    TranslationalDepths,
)
from pdg.depths.upper_bounds import (
    ConvexSeparators,
    DepthUpperBound,
    DepthUpperBounds,
    FreePlacement,
    FreePlacements,
    PlacementSource,
    UpperBoundMethod,
    convex_separators,
    generalized_depth_upper_bound,
)
from pdg.distance import OriginState, PenetrationDistance, penetration_distance
from pdg.errors import BodyError, PdgError, PlacementError
from pdg.stop_reason import StopReason

__all__ = [
    "Batch",
    "Body",
    "BodyError",
    "CObstacleVerdict",
    "CObstacleVerdicts",
    "CellVerdict",
    "ConvexPieces",
    "ConvexSeparators",
    "DepthBracket",
    "DepthBrackets",
    "DepthLowerBound",
    "DepthLowerBounds",
    "DepthUpperBound",
    "DepthUpperBounds",
    "DistanceBracket",
    "DistanceBrackets",
    "FreePlacement",
    "FreePlacements",
    "GeoInterface",
    "MotionBounds",
    "OriginState",
    "PairState",
    "PdgError",
    "PenetrationDistance",
    "PlacementError",
    "PlacementSource",
    "Point",
    "PolygonDefect",
    "Pose",
    "QueryMethod",
    "RealArray",
    "Rows",
    "Shape",
    "StopReason",
    "TranslationalDepth",
    "TranslationalDepths",
    "UpperBoundMethod",
    "c_obstacle_query",
    "convex_pieces",
    "convex_separators",
    "displacement",
    "even_odd_pieces",
    "generalized_depth_bracket",
    "generalized_depth_lower_bound",
    "generalized_depth_upper_bound",
    "generalized_distance_bracket",
    "motion_bounds",
    "penetration_distance",
    "polygon_defect",
    "sets",
    "translational_depth",
]

if TYPE_CHECKING:
    __version__: str
else:

    def __getattr__(name: str) -> str:
        """Return the version of the distribution, which is looked up on first use."""
        if name != "__version__":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib.metadata import version

        globals()[name] = version("planar-planner")
        return globals()[name]
