"""What a user writes, for mypy --strict against the installed packages (.ci/run checks it).

Types come through only if both packages ship py.typed. The two marked mistakes must be found:
an ignored line without an error is an error itself.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_type

import pdg
from planar_planner import (
    NoPath,
    Options,
    PathFound,
    Scene,
    Undecided,
    load_scene,
    solve,
    verify_certificate,
)


def waypoints(file: Path) -> list[tuple[float, float, float]]:
    """Return the path of a scene, or nothing."""
    scene = load_scene(file)
    assert_type(scene, Scene)
    result = solve(scene, Options(timeout=1.0), certificate=True)
    assert_type(result, PathFound | NoPath | Undecided)
    match result:
        case PathFound():
            return [(float(x), float(y), float(theta)) for x, y, theta in result.path]
        case NoPath():
            assert_type(result.certificate, dict[str, Any] | None)
            verify_certificate(scene, result.certificate or {})
        case Undecided():
            assert_type(result.reason, str)
    return []


def depth(body: pdg.ConvexPieces) -> float:
    """Return the width of a bracket."""
    found = pdg.bracket(body, [(0, 0), (1, 0), (0, 1)], pose=(0.1, 0.2, 0.3))
    assert_type(found.lo, float)
    return found.hi - found.lo


solve(3)  # type: ignore[arg-type]
Options(timeout="long")  # type: ignore[arg-type]
