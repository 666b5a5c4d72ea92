"""OMPL's sampling planners beside this planner, and this planner as one of OMPL's.

The public names need OMPL (extra ``planar-planner[ompl]``). The first use of one of them imports
OMPL.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planar_planner.ompl.planner import CompletePlanner
    from planar_planner.ompl.setup import Setup, make_sampler, set_up, waypoints_of

__all__ = ["CompletePlanner", "Setup", "make_sampler", "set_up", "waypoints_of"]


def __getattr__(name: str) -> Any:
    """Import a public name, and OMPL with it, on first use; the command line starts without it."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from planar_planner.ompl import planner

    return getattr(planner, name)
