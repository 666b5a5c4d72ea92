"""Types of the compiled core. Private: call the functions of `pdg` instead."""

from collections.abc import Callable, Sequence

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
def bracket_depths(
    a: PieceSet,
    b: PieceSet,
    separators: SeparatorSet | None,
    poses: NDArray[np.float64],
    relative_tolerance: float,
    timeout: float,
    max_nodes: int,
) -> tuple[int, NDArray[np.float64], NDArray[np.uint64], NDArray[np.uint8]]: ...
def generalized_depth_lower_bound(
    a: PieceSet, b: PieceSet, pose: _Triple
) -> tuple[float, int, int, _Depth]: ...
def translational_depths(
    a: PieceSet, b: PieceSet, poses: NDArray[np.float64]
) -> tuple[int, NDArray[np.uint8], NDArray[np.float64]]: ...
def generalized_depth_lower_bounds(
    a: PieceSet, b: PieceSet, poses: NDArray[np.float64]
) -> tuple[int, NDArray[np.int32], NDArray[np.uint8], NDArray[np.float64]]: ...
def c_obstacle_queries(
    a: PieceSet, b: PieceSet, cells: NDArray[np.float64], method: int
) -> tuple[NDArray[np.uint8], NDArray[np.int32], NDArray[np.float64]]: ...

class SeparatorSet:
    def __init__(self, body: PieceSet) -> None: ...
    def __len__(self) -> int: ...
    def sides(self, index: int) -> NDArray[np.float64]: ...

def depth_upper_bounds(
    a: PieceSet,
    b: PieceSet,
    separators: SeparatorSet | None,
    poses: NDArray[np.float64],
    draw_back: bool,
) -> tuple[int, NDArray[np.float64], NDArray[np.int32]]: ...
def displacements(
    body: PieceSet, q0: NDArray[np.float64], q1: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def c_obstacle_query(
    a: PieceSet, b: PieceSet, centre: _Triple, half: _Triple, method: int
) -> tuple[bool, int, int, float]: ...
def generalized_distance_bounds(
    body: PieceSet, q0: NDArray[np.float64], q1: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def motion_bounds(half: _Triple, radius: float) -> _Triple: ...
def first_defect(
    coords: NDArray[np.float64],
    ring_starts: NDArray[np.uint32],
    polygon_starts: NDArray[np.uint32],
) -> tuple[int, str, _Pair | None] | None: ...

class ConvexSet:
    @property
    def dimension(self) -> int: ...
    def magnitude(self) -> list[float]: ...
    def error(self) -> list[float]: ...
    def supports(
        self, directions: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

def axis_ellipsoid(radii: NDArray[np.float64], centre: NDArray[np.float64]) -> ConvexSet: ...
def ellipsoid(axes: NDArray[np.float64], centre: NDArray[np.float64]) -> ConvexSet: ...
def box(half_extents: NDArray[np.float64], centre: NDArray[np.float64]) -> ConvexSet: ...
def cross_polytope(radii: NDArray[np.float64], centre: NDArray[np.float64]) -> ConvexSet: ...
def point_set(points: NDArray[np.float64]) -> ConvexSet: ...
def minkowski_sum(sets: Sequence[ConvexSet]) -> ConvexSet: ...
def union_hull(sets: Sequence[ConvexSet]) -> ConvexSet: ...
def affine_image(
    map: NDArray[np.float64], offset: NDArray[np.float64], set: ConvexSet
) -> ConvexSet: ...
def grasp_wrench_set(columns: NDArray[np.float64], largest: bool, idle: bool) -> ConvexSet: ...
def stretched(factors: NDArray[np.float64], set: ConvexSet) -> ConvexSet: ...
def scaled(factor: float, set: ConvexSet) -> ConvexSet: ...
def python_set(
    support: Callable[[NDArray[np.float64]], tuple[float, NDArray[np.float64]]],
    magnitude: Sequence[float],
    error: Sequence[float],
) -> ConvexSet: ...
def penetration_distance(
    a: ConvexSet,
    q: ConvexSet,
    absolute_tolerance: float,
    relative_tolerance: float,
    max_iterations: int,
    max_facets: int,
    timeout: float,
    history: bool,
) -> tuple[
    int,
    int,
    float,
    float,
    list[float],
    list[float],
    int,
    int,
    list[tuple[float, float, int]],
]: ...
def upper_bound_along(a: ConvexSet, q: ConvexSet, u: Sequence[float]) -> float: ...
