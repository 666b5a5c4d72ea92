"""The shipped scenes that a benchmark can use."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_planner import load_scene
from planar_planner.scene.builtin import manifest


def with_point_goals() -> dict[str, Mapping[str, Any]]:
    """Return the manifest's scenes whose goal is one configuration."""
    return {
        name: entry for name, entry in manifest().items() if isinstance(load_scene(name).goal, list)
    }
