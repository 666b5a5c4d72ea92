"""The reader of a path from the file that ``solve --json`` writes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, shown
from planar_planner.planning.result import FORMAT, VERSION
from planar_planner.scene import fields

MOST_BYTES = 2**27  # the same limit as for a scene file


def read_path(file: Path) -> NDArray[np.float64]:
    """Return the waypoints of a result file.

    Returns
    -------
    (N, 3)
        N >= 1; x, y, theta.

    Raises
    ------
    SceneError
        If the file is not a result or contains no path; the message names file and field.
    """
    try:
        return _waypoints(_members(file))
    except SceneError as error:
        raise error.in_source(str(file)) from None


def _members(file: Path) -> object:
    try:
        if file.stat().st_size > MOST_BYTES:
            raise SceneError(f"is larger than {MOST_BYTES} bytes")
        return json.loads(file.read_bytes())
    except OSError as error:
        raise SceneError(f"cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError) as error:
        raise SceneError(f"is not JSON: {error}") from None


def _waypoints(content: object) -> NDArray[np.float64]:
    members = fields.mapping(content, "")
    for key, wanted in (("format", FORMAT), ("version", VERSION), ("verdict", "path")):
        if members.get(key) != wanted:
            raise SceneError(f"must be {wanted!r}", key, shown(members.get(key)))
    path = members.get("path")
    if not isinstance(path, list) or not path:
        raise SceneError("must be a list of [x, y, theta]", "path", shown(path))
    return np.array([fields.configuration(q, f"path[{i}]") for i, q in enumerate(path)])
