"""Anything a caller may pass → checked arrays of doubles. Nothing behind this checks again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pdg import _core
from pdg.errors import PdgError

if TYPE_CHECKING:
    from numpy.typing import NDArray

Triple = tuple[float, float, float]

# Squares and products of a few such numbers neither over- nor underflow.
MIN_SET_COORDINATE = 1e-60
MAX_SET_COORDINATE = 1e60


def ring(value: object, name: str) -> NDArray[np.float64]:
    """Return the ring as an (n, 2) array without a repeated last or consecutive vertex."""
    points = _numbers(value, name)
    if points.ndim != 2 or points.shape[1] != 2:
        raise PdgError("a ring is an array of shape (n, 2)", name, value=points.shape)
    magnitude = np.abs(points)
    # Negated, so that NaN fails too.
    sane = (magnitude == 0) | (
        (magnitude >= _core.MIN_COORDINATE) & (magnitude <= _core.MAX_COORDINATE)
    )
    if not sane.all():
        row = int(np.flatnonzero(~sane.all(axis=1))[0])
        problem = (
            "coordinates must be finite, and 0 or between "
            f"{_core.MIN_COORDINATE:.3g} and {_core.MAX_COORDINATE:.3g} in magnitude"
        )
        raise PdgError(problem, name, row, points[row].tolist())
    if len(points):
        points = points[np.any(points != np.roll(points, 1, axis=0), axis=1)]
    if len(np.unique(points, axis=0)) < 3:
        raise PdgError("a ring needs at least three distinct points", name, value=len(points))
    return np.ascontiguousarray(points)


def polygons(value: object, name: str) -> list[list[NDArray[np.float64]]]:
    """Return rings per polygon, the outer one first.

    `value` is an (n, 2) array or nested sequence (one ring), a shapely Polygon, MultiPolygon or
    LinearRing, a GeoJSON geometry (mapping or `__geo_interface__`) or a WKT string.
    """
    geometry = _geometry(value, name)
    if geometry is None:
        return [[ring(value, name)]]
    parts = {
        "Polygon": lambda: [geometry],
        "LinearRing": lambda: [geometry],
        "MultiPolygon": lambda: list(geometry.geoms),
    }.get(geometry.geom_type)
    if parts is None:
        raise PdgError("expected a Polygon or MultiPolygon", name, value=geometry.geom_type)
    if geometry.is_empty:
        raise PdgError("the geometry is empty", name)
    return [_rings(part, name) for part in parts()]


def triple(value: object, name: str) -> Triple:
    """Return three finite numbers (x, y, theta): lengths in any one unit, and radians."""
    x, y, theta = _vector(value, name, 3, "(x, y, theta)")
    return x, y, theta


def half_extents(value: object, name: str) -> Triple:
    """Return three finite numbers >= 0 (h_x, h_y, h_theta)."""
    h_x, h_y, h_theta = _vector(value, name, 3, "(h_x, h_y, h_theta)")
    _check_not_negative((h_x, h_y, h_theta), name, 0)
    return h_x, h_y, h_theta


def cell(value: object, name: str) -> tuple[Triple, Triple]:
    """Return the centre and the half-extents of (x, y, theta, h_x, h_y, h_theta)."""
    x, y, theta, *half = _vector(value, name, 6, "(x, y, theta, h_x, h_y, h_theta)")
    _check_not_negative(half, name, 3)
    h_x, h_y, h_theta = half
    return (x, y, theta), (h_x, h_y, h_theta)


def length(value: object, name: str) -> float:
    """Return one finite number >= 0."""
    number = _numbers(value, name)
    if number.shape != ():
        raise PdgError("expected one number", name, value=number.shape)
    _check_magnitude(number.reshape(1), name)
    if number < 0:
        raise PdgError("must not be negative", name, value=float(number))
    return float(number)


def coordinates(
    value: object, name: str, axes: int, smallest: float = MIN_SET_COORDINATE
) -> NDArray[np.float64]:
    """Return a contiguous array, not empty, with `axes` axes, of a convex set's numbers.

    Those are 0 or between `smallest` and `MAX_SET_COORDINATE` in magnitude.
    """
    numbers = _numbers(value, name)
    if numbers.ndim != axes or numbers.size == 0:
        kind = {1: "a vector (n,)", 2: "a matrix (m, n)"}[axes]
        raise PdgError(f"expected {kind}, not empty", name, value=numbers.shape)
    magnitude = np.abs(numbers)
    sane = (magnitude == 0) | ((magnitude >= smallest) & (magnitude <= MAX_SET_COORDINATE))
    if not sane.all():
        row = int(np.argwhere(~sane)[0][0])
        problem = (
            f"must be finite, and 0 or between {smallest:g} and {MAX_SET_COORDINATE:g} in magnitude"
        )
        raise PdgError(problem, name, row, numbers[row].tolist())
    return np.ascontiguousarray(numbers)


def _numbers(value: object, name: str) -> NDArray[np.float64]:
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise PdgError("expected real numbers", name, value=value) from error
    if array.dtype.kind not in "iuf":
        raise PdgError("expected real numbers", name, value=value)
    return array.astype(np.float64, copy=False)


def _vector(value: object, name: str, size: int, meaning: str) -> list[float]:
    numbers = _numbers(value, name)
    if numbers.shape != (size,):
        raise PdgError(f"expected {size} numbers {meaning}", name, value=numbers.shape)
    _check_magnitude(numbers, name)
    return [float(v) for v in numbers]


def _check_not_negative(extents: Sequence[float], name: str, first: int) -> None:
    for i, extent in enumerate(extents, first):
        if extent < 0:
            raise PdgError("a half-extent must not be negative", name, i, extent)


def _check_magnitude(numbers: NDArray[np.float64], name: str) -> None:
    bad = ~(np.abs(numbers) <= _core.MAX_COORDINATE)  # negated, so that NaN fails too
    if bad.any():
        i = int(np.flatnonzero(bad)[0])
        problem = f"must be finite and at most {_core.MAX_COORDINATE:.3g} in magnitude"
        raise PdgError(problem, name, i, float(numbers[i]))


def _geometry(value: object, name: str) -> Any:
    """Return the shapely geometry that `value` is or describes, or None for plain coordinates."""
    described: Any = getattr(value, "__geo_interface__", value)
    if not isinstance(described, str | Mapping):
        return None
    # Imported late: plain coordinates do without shapely, which takes long to load.
    import shapely
    from shapely.geometry import shape

    if isinstance(value, shapely.Geometry):
        return value
    try:
        if isinstance(described, str):
            return shapely.from_wkt(described)
        return shape(described)
    except (shapely.errors.ShapelyError, ValueError, TypeError, KeyError, AttributeError) as error:
        raise PdgError(f"not a geometry: {error}", name) from error


def _rings(polygon: Any, name: str) -> list[NDArray[np.float64]]:
    import shapely

    if polygon.geom_type == "LinearRing":
        return [ring(shapely.get_coordinates(polygon), name)]
    # The core takes the even-odd interior, so a hole outside its shell would count as solid.
    if len(polygon.interiors) > 0 and not polygon.is_valid:
        raise PdgError(f"invalid polygon: {shapely.is_valid_reason(polygon)}", name)
    return [
        ring(shapely.get_coordinates(line), name) for line in (polygon.exterior, *polygon.interiors)
    ]
