"""The scenes that ship with the package: where they are and what the manifest says of them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, shown

MANIFEST_FORMAT = "planar-planner/manifest"
MANIFEST_VERSION = 1
_MANIFEST = "manifest.json"


@cache
def scenes_directory() -> Path:
    """Return the folder of built-in scenes: in the package, or beside it in a source checkout."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "scenarios"
    return installed if (installed / _MANIFEST).is_file() else package.parents[2] / "scenarios"


@cache
def builtin_scenes() -> Mapping[str, Path]:
    """Return name → file of every built-in scene, by name."""
    files = sorted(scenes_directory().glob("*.json"))
    return {file.stem: file for file in files if file.name != _MANIFEST}


@cache
def manifest() -> Mapping[str, Mapping[str, Any]]:
    """Return name → {"expected", "origin", "licence", …} of the built-in scenes.

    Raises
    ------
    SceneError
        If the manifest is missing or is not one: the installation is broken.
    """
    file = scenes_directory() / _MANIFEST
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SceneError(f"cannot read the list of scenes: {error}", source=str(file)) from None
    if not isinstance(content, dict) or content.get("format") != MANIFEST_FORMAT:
        raise SceneError(f"is not a {MANIFEST_FORMAT}", source=str(file))
    if content.get("version") != MANIFEST_VERSION:
        raise SceneError("unknown version", "version", shown(content.get("version")), str(file))
    return {entry["name"]: entry for entry in content["scenes"]}
