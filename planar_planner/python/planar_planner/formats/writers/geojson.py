"""The writer of GeoJSON: a FeatureCollection whose features have roles."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.formats.assemble import as_geojson
from planar_planner.formats.parts import Parts
from planar_planner.scene.fields import Box


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return a FeatureCollection with roles; nothing is lost."""
    features = [_feature("robot", as_geojson(parts.robot or []))]
    for i, shape in enumerate(parts.obstacles):
        name = {"name": parts.obstacle_names[i]} if i in parts.obstacle_names else {}
        features.append(_feature("obstacle", as_geojson([shape]), **name))
    if parts.workspace is not None:
        features.append(_feature("workspace", as_geojson([parts.workspace])))
    for role, box in (
        ("workspace", parts.workspace_box),
        ("reference_bounds", parts.reference_bounds),
    ):
        if box is not None:
            features.append(_feature(role, as_geojson([[_corners(box)]])))
    for role, q in (("start", parts.start), ("goal", parts.goal)):
        if q is not None:
            point = {"type": "Point", "coordinates": [q[0], q[1]]}
            features.append(_feature(role, point, theta=q[2]))
    content: dict[str, Any] = {"type": "FeatureCollection", "name": parts.name}
    if parts.description:
        content["description"] = parts.description
    if not parts.rotation:
        content["rotation"] = False
    content["features"] = features
    return {path: (json.dumps(content, indent=1, allow_nan=False) + "\n").encode()}


def _corners(box: Box) -> list[tuple[float, float]]:
    return [(box[0], box[1]), (box[2], box[1]), (box[2], box[3]), (box[0], box[3])]


def _feature(role: str, geometry: dict[str, Any], **properties: float | str) -> dict[str, Any]:
    return {"type": "Feature", "properties": {"role": role, **properties}, "geometry": geometry}
