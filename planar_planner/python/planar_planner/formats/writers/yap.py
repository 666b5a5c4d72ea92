"""The writer of Yap-style environments, with the robot in a ``.rob`` file beside it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.exact import is_anticlockwise, orientation
from planar_planner.formats.parts import Parts, Point, Ring


def write(parts: Parts, path: Path) -> Mapping[Path, bytes]:
    """Return the environment and the robot; neither file can state start and goal.

    Raises
    ------
    SceneError
        If the robot is not star-shaped about its reference point, or the scene bounds the
        reference point or forbids turning.
    """
    if parts.reference_bounds is not None:
        raise SceneError(
            "a Yap-style environment cannot bound the reference point", "reference_bounds"
        )
    if not parts.rotation:
        raise SceneError("a Yap-style environment cannot forbid turning", "rotation")
    rings = [_turned(ring, k == 0) for shape in parts.obstacles for k, ring in enumerate(shape)]
    if parts.workspace is not None:
        rings += [_turned(ring, k > 0) for k, ring in enumerate(parts.workspace)]
    if parts.workspace_box is not None:
        xmin, ymin, xmax, ymax = parts.workspace_box
        rings.append([(xmin, ymin), (xmin, ymax), (xmax, ymax), (xmax, ymin)])
    index: dict[Point, int] = {}
    for ring in rings:
        for p in ring:
            index.setdefault(p, len(index) + 1)
    lines = [str(len(index)), *(f"{x!r} {y!r}" for x, y in index), str(len(rings))]
    lines += [" ".join(str(index[p]) for p in ring) for ring in rings]
    robot = _star(parts)
    robot_lines = [str(len(robot)), *(f"{x!r} {y!r}" for x, y in robot)]
    return {
        path: _text(lines),
        path.with_suffix(".rob"): _text(robot_lines),
    }


def _turned(ring: Ring, anticlockwise: bool) -> Ring:
    return ring if is_anticlockwise(ring) == anticlockwise else ring[::-1]


def _star(parts: Parts) -> Ring:
    robot = parts.robot or []
    if len(robot) != 1 or len(robot[0]) != 1:
        raise SceneError("a .rob file has one polygon without holes", "robot")
    ring = _turned(robot[0][0], anticlockwise=True)
    if any(
        orientation((0.0, 0.0), p, q) < 0 for p, q in zip(ring, ring[1:] + ring[:1], strict=True)
    ):
        raise SceneError(
            "the robot of a .rob file must be star-shaped about its reference point", "robot"
        )
    return ring


def _text(lines: list[str]) -> bytes:
    return ("\n".join(lines) + "\n").encode("ascii")
