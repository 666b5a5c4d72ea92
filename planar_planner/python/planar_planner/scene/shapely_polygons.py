"""Sequences of shapely's polygons → GeoJSON, without a loop over their vertices."""

from __future__ import annotations

import sys
from itertools import pairwise
from typing import Any

from planar_planner.scene.collector import collector_paused


def polygons_of_shapely(value: object) -> list[dict[str, Any]] | None:
    """Return the polygons of a list or tuple as GeoJSON, as their ``__geo_interface__`` gives them.

    None if it is something else or holds something else: that is for others to read. Asking each
    polygon by itself takes ten times as long.

    Parameters
    ----------
    value : object
        Anything.
    """
    shapely = sys.modules.get("shapely")  # who has not imported it has no polygons of it
    if shapely is None or not isinstance(value, (list, tuple)) or not value:
        return None
    if set(map(type, value)) != {shapely.Polygon}:
        return None
    with collector_paused():
        _, coords, (ring_starts, polygon_starts) = shapely.to_ragged_array(list(value))
        if coords.shape[1] != 2:  # of one with a height all would get one
            return None
        positions = coords.tolist()
        rings = [positions[first:end] for first, end in pairwise(ring_starts.tolist())]
        return [
            {"type": "Polygon", "coordinates": rings[first:end]}
            for first, end in pairwise(polygon_starts.tolist())
        ]
