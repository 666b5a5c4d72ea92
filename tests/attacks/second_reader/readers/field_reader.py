"""The field's own formats a second time, from their public descriptions, by shapely.

Yap: vertices, then polygons of 1-based indices, the obstacle to the left of the directed edges; so
a place is blocked if the innermost ring round it runs anticlockwise. TPCAP: rings as they stand.
discopygal: polygons, and discs about their location. dynobench: boxes by centre and size. Moving
AI: unit cells, the first row the uppermost, of which ``@``, ``O``, ``T`` and ``W`` are blocked.
"""

from __future__ import annotations

import json
from collections.abc import Sequence

import numpy as np
import shapely

from ..model import Drawing, Exact, Raster, Reading, Region

SLACK = 1e-9
SIDES = 2048
"""Sides of a quarter disc; their distance from the circle is far below the importer's tolerance."""


def read_yap(drawing: Drawing) -> Sequence[Reading]:
    """Return the blocked region of an environment, inside its clockwise boundary if it has one."""
    text = drawing.files[drawing.name].decode().replace("\\\n", " ")
    lines = [line.split("#")[0].replace(",", " ").split() for line in text.splitlines()]
    words = [word for line in lines for word in line]
    count = int(words[0])
    points = np.array(words[1 : 1 + 2 * count], dtype=float).reshape(count, 2)
    polygons = int(words[1 + 2 * count])
    rows = [line for line in lines if line][-polygons:]
    rings = [shapely.LinearRing(points[[int(word) - 1 for word in row]]) for row in rows]
    region: Region = shapely.Polygon()
    for ring in sorted(rings, key=lambda own: -shapely.Polygon(own).area):
        inside = shapely.Polygon(ring)
        region = region.union(inside) if ring.is_ccw else region.difference(inside)
    return [Reading("painted from the outside in", Exact(region, SLACK))]


def read_tpcap(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of a case's obstacles."""
    text = drawing.files[drawing.name].decode()
    values = [float(word) for word in text.replace(",", " ").split()]
    count = int(values[6])
    sizes = [int(value) for value in values[7 : 7 + count]]
    points = np.array(values[7 + count :]).reshape(-1, 2)
    rings = np.split(points, np.cumsum(sizes)[:-1])
    region = shapely.union_all([shapely.Polygon(ring).buffer(0) for ring in rings])
    return [Reading("union", Exact(region, SLACK))]


def read_discopygal(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of a scene's obstacles."""
    shapes = []
    discs = False
    for thing in json.loads(drawing.files[drawing.name])["obstacles"]:
        if "poly" in thing:
            shapes.append(shapely.Polygon(thing["poly"]))
        else:
            discs = True
            shapes.append(shapely.Point(thing["location"]).buffer(thing["radius"], SIDES))
    slack = 1.01 * float(drawing.options["tolerance"]) if discs else SLACK
    return [Reading("union", Exact(shapely.union_all(shapes), slack))]


def read_dynobench(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of a problem's boxes."""
    import yaml

    content = yaml.safe_load(drawing.files[drawing.name])
    boxes = []
    for thing in content["environment"]["obstacles"]:
        half = np.array(thing["size"]) / 2
        low, high = np.array(thing["center"]) - half, np.array(thing["center"]) + half
        boxes.append(shapely.box(*low, *high))
    return [Reading("union", Exact(shapely.union_all(boxes), SLACK))]


def read_octile(drawing: Drawing) -> Sequence[Reading]:
    """Return a map's blocked cells."""
    _, _, cells = drawing.files[drawing.name].decode().partition("map")
    rows = cells.split()
    blocked = np.array([[letter in "@OTW" for letter in row] for row in rows])
    x, y = np.meshgrid(
        np.arange(len(rows[0])) + 0.5, len(rows) - 0.5 - np.arange(len(rows)).astype(float)
    )
    return [Reading("cells", Raster(blocked, x, y, 1.0, 0.0))]
