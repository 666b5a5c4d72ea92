"""Conversions of GeoJSON geometry to shapes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from planar_planner.errors import SceneError, shown
from planar_planner.formats.outlines.holes import check_holes
from planar_planner.formats.outlines.rings import polygons_of, without_repeats
from planar_planner.formats.parts import Notes, Point, Ring, Shape
from planar_planner.scene import fields
from planar_planner.scene.geojson import iter_polygons


def shapes_of_geometry(geometry: object, path: str) -> Iterator[tuple[str, Shape]]:
    """Yield (field path, shape) of each polygon of a geometry, without repeated last vertices."""
    for place, rings in iter_polygons(geometry, path):
        yield place, [_ring(ring, f"{place}[{r}]") for r, ring in enumerate(rings)]


def repaired(geometry: object, path: str, notes: Notes) -> list[Shape]:
    """Return a geometry's polygons, valid and of the same region; see `polygons_of`.

    Rings after the first are holes in either orientation (the even–odd rule).

    Raises
    ------
    SceneError
        If a hole does not lie in its shell or shares area with another hole.
    """
    found: list[Shape] = []
    for place, rings in shapes_of_geometry(geometry, path):
        shapes = polygons_of(rings, place, notes, "evenodd" if len(rings) > 1 else None)
        if len(rings) > 1 and shapes != [[without_repeats(ring) for ring in rings]]:
            check_holes(rings, shapes, place)
        found += shapes
    written: Any = [rings for _, rings in iter_polygons(geometry, path)]
    heights = sum(len(p) > 2 for rings in written for ring in rings for p in ring)
    notes.count("positions of which only x and y are read", heights)
    return found


def _ring(value: Any, path: str) -> Ring:
    if not isinstance(value, list):
        raise SceneError("a ring must be a list of [x, y]", path, shown(value))
    ring = [position(p, f"{path}[{i}]") for i, p in enumerate(value)]
    return ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring


def position(value: Any, path: str) -> Point:
    """Return a GeoJSON position; an altitude after x and y is left out."""
    if not isinstance(value, list) or not 2 <= len(value) <= 3:
        raise SceneError("a position must be [x, y]", path, shown(value))
    return fields.coordinate(value[0], f"{path}[0]"), fields.coordinate(value[1], f"{path}[1]")
