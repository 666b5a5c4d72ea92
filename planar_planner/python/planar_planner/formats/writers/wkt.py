"""The writer of well-known text: one line per geometry, with its role before it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_planner.formats.parts import Parts
from planar_planner.formats.writers import geojson


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return one line per geometry; only the description's line breaks are lost."""
    (content,) = geojson.write(parts, path).values()
    lines = [f"# {' '.join(part.split())}" for part in (parts.name, parts.description) if part]
    if not parts.rotation:
        lines.append("rotation false")
    for feature in json.loads(content)["features"]:
        role, geometry = feature["properties"]["role"], feature["geometry"]
        coordinates = geometry["coordinates"]
        if geometry["type"] == "Point":
            numbers = " ".join(map(repr, [*coordinates, feature["properties"]["theta"]]))
            lines.append(f"{role} POINT Z ({numbers})")
        else:
            lines.append(f"{role} {geometry['type'].upper()} {_brackets(coordinates)}")
    return {path: ("\n".join(lines) + "\n").encode()}


def _brackets(value: list[Any]) -> str:
    if isinstance(value[0], list) and not isinstance(value[0][0], list):
        return "(" + ", ".join(" ".join(map(repr, p)) for p in value) + ")"
    return "(" + ", ".join(_brackets(part) for part in value) + ")"
