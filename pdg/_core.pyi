"""Types of the compiled core. Private: call the functions of `pdg` instead."""

import numpy as np
from numpy.typing import NDArray

MIN_COORDINATE: float
MAX_COORDINATE: float

_Pair = tuple[float, float]
_Triple = tuple[float, float, float]
_Depth = tuple[int, float, _Pair, _Pair, _Pair]

class PieceSet:
    def __init__(
        self,
        coords: NDArray[np.float64],
        ring_starts: NDArray[np.uint32],
        polygon_starts: NDArray[np.uint32],
        cover: bool,
    ) -> None: ...
    def __len__(self) -> int: ...
    @property
    def radius(self) -> float: ...
    def radii(self) -> list[float]: ...
    def arrays(self) -> tuple[NDArray[np.float64], NDArray[np.uint32]]: ...

def translational_depth(a: PieceSet, b: PieceSet, pose: _Triple) -> _Depth: ...
def generalized_depth_lower_bound(
    a: PieceSet, b: PieceSet, pose: _Triple
) -> tuple[float, int, int, _Depth]: ...
def c_obstacle_query(
    a: PieceSet, b: PieceSet, centre: _Triple, half: _Triple, method: int
) -> tuple[bool, int, int, float]: ...
def displacement(body: PieceSet, q0: _Triple, q1: _Triple) -> float: ...
def generalized_distance_bounds(body: PieceSet, q0: _Triple, q1: _Triple) -> _Pair: ...
def motion_bounds(half: _Triple, radius: float) -> _Triple: ...
def first_defect(
    coords: NDArray[np.float64],
    ring_starts: NDArray[np.uint32],
    polygon_starts: NDArray[np.uint32],
) -> tuple[int, str] | None: ...
