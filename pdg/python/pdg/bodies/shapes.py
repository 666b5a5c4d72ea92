"""Any description of a body → rings of doubles, one list of rings a polygon, the outer one first.

Coordinates, shapely geometries, WKT, WKB, GeoJSON, convex pieces, and lists of any of these as one
body.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from pdg._gate import ring
from pdg.bodies.piece_set import ConvexPieces
from pdg.errors import BodyError

Rings = list["NDArray[np.float64]"]
_HEXADECIMAL = frozenset("0123456789abcdefABCDEF")
_COLLECTIONS = ("MultiPolygon", "GeometryCollection")


def polygons(value: object, name: str) -> list[Rings]:
    """Return rings per polygon, the outer one first; the body is the union of the polygons.

    `value` is one ring as an (n, 2) array or nested sequence, anything that shapely reads (a
    geometry, WKT, WKB, GeoJSON as text or mapping, an object with ``__geo_interface__``), convex
    pieces, or a sequence of these.
    """
    try:
        return _polygons(value, name)
    except RecursionError as error:
        raise BodyError("nested too deeply, or within itself", name, value=value) from error


def _polygons(value: object, name: str) -> list[Rings]:
    if isinstance(value, ConvexPieces):
        return [[piece] for piece in value]
    geometry = _geometry(value, name)
    if geometry is not None:
        return _polygons_of(geometry, name)
    if _is_list_of_bodies(value):
        return [rings for item in value for rings in _polygons(item, name)]
    return [[ring(value, name)]]


def _is_list_of_bodies(value: object) -> TypeGuard[Iterable[object]]:
    """Whether a sequence holds bodies, and not the points of one ring."""
    if isinstance(value, np.ndarray):
        return value.ndim == 3
    if not isinstance(value, Sequence) or not value:
        return False
    first = value[0]
    if isinstance(first, ConvexPieces) or _describes_geometry(first):
        return True
    if isinstance(first, np.ndarray):
        return first.ndim >= 2
    if not isinstance(first, Sequence) or not first:
        return False
    # A ring's items are points, whose items are numbers.
    return isinstance(first[0], Sequence | np.ndarray) or _is_list_of_bodies(first)


def _describes_geometry(value: object) -> bool:
    return isinstance(value, str | bytes | bytearray | memoryview | Mapping) or hasattr(
        value, "__geo_interface__"
    )


def _geometry(value: object, name: str) -> Any:
    """Return the shapely geometry that `value` is or describes, or None for plain coordinates."""
    if not _describes_geometry(value):
        return None
    # Imported late: plain coordinates do without shapely, which takes long to load.
    import shapely

    if isinstance(value, shapely.Geometry):
        return value
    try:
        if isinstance(value, bytes | bytearray | memoryview):
            return shapely.from_wkb(bytes(value))
        if isinstance(value, str):
            return _from_text(value.strip())
        return _from_geojson(getattr(value, "__geo_interface__", value))
    except (
        shapely.errors.ShapelyError,
        ValueError,
        TypeError,
        KeyError,
        IndexError,
        AttributeError,
        NotImplementedError,  # curves
        RecursionError,
    ) as error:
        raise BodyError(f"not a geometry: {error}", name) from error


def _from_text(text: str) -> Any:
    import shapely

    if text.startswith("{"):
        return _from_geojson(json.loads(text))
    if text and _HEXADECIMAL.issuperset(text):
        return shapely.from_wkb(text)
    return shapely.from_wkt(text)


def _from_geojson(description: Any) -> Any:
    import shapely
    from shapely.geometry import shape

    kind = description["type"]
    if kind == "Feature":
        return _from_geojson(description["geometry"])
    if kind == "FeatureCollection":
        return shapely.GeometryCollection([_from_geojson(f) for f in description["features"]])
    return shape(description)


def _polygons_of(geometry: Any, name: str) -> list[Rings]:
    import shapely

    if geometry.is_empty:
        raise BodyError("the geometry is empty", name)
    kind = geometry.geom_type
    if kind in _COLLECTIONS:
        parts = [part for part in geometry.geoms if not part.is_empty]
        return [rings for part in parts for rings in _polygons_of(part, name)]
    if kind not in ("Polygon", "LinearRing"):
        expected = "expected a Polygon, a MultiPolygon or a GeometryCollection of them"
        raise BodyError(expected, name, value=kind)
    if geometry.has_z:
        raise BodyError("the geometry has z coordinates; see shapely.force_2d", name)
    if kind == "LinearRing":
        return [[ring(shapely.get_coordinates(geometry), name)]]
    lines = (geometry.exterior, *geometry.interiors)
    return [[ring(shapely.get_coordinates(line), name) for line in lines]]
