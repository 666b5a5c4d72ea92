"""Well-known text, GeoJSON and Yap-style files of a wall with a gap, or a room with pillars."""

from __future__ import annotations

import json
from typing import Any

ROBOT = "robot POLYGON ((-1 -0.5, 1 -0.5, 1 0.5, -1 0.5, -1 -0.5))\n"
ROB = "4 # vertices\n-1 -0.5\n1 -0.5  1 0.5\n-1, 0.5\n"
WKT_SCENE = f"""# a wall with a gap
workspace POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9))
{ROBOT}MULTIPOLYGON (((-1 -9, 1 -9, 1 -1, -1 -1, -1 -9)),
  ((-1 1, 1 1, 1 9, -1 9, -1 1), (-0.5 4, 0.5 4, 0.5 5, -0.5 5, -0.5 4)))
start POINT Z (-5 0 0)
goal: POINT Z (5 0 1.5)
"""


def feature(role: str | None, geometry: dict[str, Any], **properties: Any) -> dict[str, Any]:
    named = properties if role is None else {"role": role, **properties}
    return {"type": "Feature", "id": 7, "properties": named, "geometry": geometry}


def polygon(*rings: list[list[float]]) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": list(rings)}


BODY = polygon([[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5], [-1, -0.5]])
WALL = polygon([[-1, -9, 100], [1, -9, 100], [1, -1, 100], [-1, -1, 100], [-1, -9, 100]])


def collection(*features: dict[str, Any], **members: Any) -> str:
    return json.dumps({"type": "FeatureCollection", "features": list(features), **members})


FULL = collection(
    feature("robot", BODY),
    feature(None, WALL, colour="red"),
    feature("start", {"type": "Point", "coordinates": [-5, 0]}),
    feature("goal", {"type": "Point", "coordinates": [5, 0]}, theta=1.5),
    name="ours",
    crs={"type": "name"},
)

YAP = """# a room with two pillars, one hollow
16   # vertices
-9 -9  9 -9  9 9  -9 9
-2 -2  2 -2  2 2  -2 2
-1 -1  1 -1  1 1  -1 1
3 5  4 5  4 6  3 6
4  # polygons
4 3 \\
  2 1
5 6 7 8 5
12 11 10 9
13 14 15 16
"""
