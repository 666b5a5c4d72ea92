from collections.abc import Callable, Sequence
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

_PolygonArrays = tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32]]

def build_info() -> dict[str, str]: ...

class DecidedBy(StrEnum):
    """What a path or its absence was shown by."""

    STRAIGHT_MOVE = "straight move"
    TWO_LEG_MOVE = "two-leg move"
    DISC = "disc"
    FIRST_TRY = "RRT-Connect"
    CHANNEL = "channel"
    RIDGE = "ridge"
    SEPARATION = "separation"
    START = "start"
    GOAL = "goal"
    def __str__(self) -> str: ...

class StopReason(StrEnum):
    """Why a query stayed undecided."""

    RESOLUTION = "resolution"
    CELLS = "cells"
    MEMORY = "memory"
    TIME = "time"
    INTERRUPTED = "interrupted"
    OUT_OF_MEMORY = "out of memory"
    START_TOUCHES_OBSTACLE = "start touches obstacle"
    START_TOUCHES_WORKSPACE = "start touches workspace"
    GOAL_TOUCHES_OBSTACLE = "goal touches obstacle"
    GOAL_TOUCHES_WORKSPACE = "goal touches workspace"
    MOVED_ENDS = "moved ends"
    LOST_CHANNEL = "lost channel"
    def __str__(self) -> str: ...

class Core:
    def __init__(
        self,
        robot: _PolygonArrays,
        obstacles: _PolygonArrays,
        workspace_box: tuple[float, float, float, float] | None,
        workspace: _PolygonArrays | None,
        reference_bounds: tuple[float, float, float, float] | None,
        rotation: bool,
        without: Sequence[str] = ...,
        query: str = "per-normal",
    ) -> None: ...
    def placement(self, q: tuple[float, float, float]) -> dict[str, Any]: ...
    def solve(
        self,
        start: tuple[float, float, float],
        goal: tuple[float, float, float] | tuple[_PolygonArrays, tuple[float, float] | None],
        resolution: float,
        max_cells: int,
        timeout: float,
        max_memory: int,
        contact_tolerance: float,
        listener: Callable[[dict[str, Any]], bool] | None,
    ) -> dict[str, Any]: ...
    def check_path(self, path: NDArray[np.float64]) -> dict[str, Any]: ...
    def least_clearance(self) -> float: ...
    def evidence(self) -> dict[str, Any]: ...
    def cells(self) -> dict[str, Any]: ...
    def bottleneck(self) -> dict[str, Any]: ...

class StateCheck:
    def __init__(self, core: Core) -> None: ...
    def is_free(self, arg0: float, arg1: float, arg2: float, /) -> bool: ...
    def are_free(self, configurations: NDArray[np.float64]) -> NDArray[np.bool_]: ...
    @property
    def checks(self) -> int: ...
    @property
    def bounds(self) -> list[float]: ...
    @property
    def robot_radius(self) -> float: ...
