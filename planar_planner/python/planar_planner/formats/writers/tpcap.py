"""The writer of parking-competition cases: one row of numbers."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_planner.errors import SceneError
from planar_planner.formats.parts import Parts, Ring
from planar_planner.formats.readers.tpcap import CAR


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return a case in one row.

    Raises
    ------
    SceneError
        If the robot is not the competition's car, an obstacle has holes, or the scene has a
        workspace or forbids turning.
    """
    if parts.robot is None or {p for s in parts.robot for r in s for p in r} != set(CAR[0]):
        raise SceneError("a parking case has the competition's car and no other robot", "robot")
    if parts.workspace is not None or parts.workspace_box is not None:
        raise SceneError("a parking case cannot state a workspace", "workspace")
    if not parts.rotation:
        raise SceneError("a parking case cannot forbid turning", "rotation")
    rings: list[Ring] = []
    for k, shape in enumerate(parts.obstacles):
        if len(shape) > 1:
            raise SceneError("a parking case cannot state holes", f"obstacles[{k}]")
        rings.append(shape[0])
    numbers: list[float] = [*(parts.start or ()), *(parts.goal or ()), len(rings)]
    numbers += [len(ring) for ring in rings]
    numbers += [value for ring in rings for p in ring for value in p]
    return {path: (",".join(repr(n) for n in numbers) + "\n").encode("ascii")}
