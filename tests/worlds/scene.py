"""What a scene is to the tests: the content of its file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Scene = dict[str, Any]


def plain(scene: Mapping[str, object]) -> Scene:
    """Return a scene with lists where tuples were, as a file has them."""

    def convert(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: convert(item) for key, item in value.items()}
        return [convert(item) for item in value] if isinstance(value, (list, tuple)) else value

    converted: Scene = convert(dict(scene))
    return converted
