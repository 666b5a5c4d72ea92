"""A scene file's bytes, and the JSON in them."""

from __future__ import annotations

import json
from pathlib import Path

from planar_planner.errors import SceneError, cut
from planar_planner.scene.collector import collector_paused
from planar_planner.scene.input_limits import MAX_FILE_BYTES


def file_bytes(path: Path, source: str) -> bytes:
    """Return a file's content, up to the largest that is read."""
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(f"cannot read the scene: {reason}", source=source) from None
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(f"is larger than {MAX_FILE_BYTES} bytes", source=source)
    return data


def parse(data: bytes, source: str) -> object:
    """Return the JSON content of a scene file named `source` in errors, not yet checked."""
    try:
        with collector_paused():
            return json.loads(data, object_pairs_hook=_without_duplicates)
    except SceneError as error:
        raise error.in_source(source) from None
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        raise SceneError(f"is not JSON: {error.msg} at {where}", source=source) from None
    except UnicodeDecodeError as error:
        raise SceneError(f"is not UTF-8 text: byte {error.start}", source=source) from None
    except RecursionError:
        raise SceneError("is nested too deeply", source=source) from None
    except ValueError as error:  # an integer of thousands of digits
        raise SceneError(f"is not usable JSON: {error}", source=source) from None


def _without_duplicates(pairs: list[tuple[str, object]]) -> dict[str, object]:
    """Build an object, refusing a field that stands twice: JSON leaves open which one counts."""
    result = dict(pairs)
    if len(result) != len(pairs):
        seen: set[str] = set()
        for name, _ in pairs:
            if name in seen:
                raise SceneError("field appears more than once", cut(name))
            seen.add(name)
    return result
