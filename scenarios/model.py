"""What a scene file holds, and the few shapes that several families share.

Units are those of the scene; angles are radians, anticlockwise.
Anything that passes through sine, cosine or a square root is rounded to ``DECIMALS`` places, so
that the files are the same to the byte on platforms whose libraries differ in the last bit.
"""

import math
from collections.abc import Sequence
from typing import Any, NotRequired, TypeAlias, TypedDict, cast

DECIMALS = 12  # far below any gap of a scene, far above the last bit of a double of size 1 to 100

Point: TypeAlias = tuple[float, float]
Ring: TypeAlias = list[Point]
Configuration: TypeAlias = tuple[float, float, float]  # x, y, theta
Box: TypeAlias = tuple[float, float, float, float]  # xmin, ymin, xmax, ymax
Geometry: TypeAlias = dict[str, Any]  # a GeoJSON Polygon or MultiPolygon
Goal: TypeAlias = Configuration | dict[str, Any] | str  # a set of configurations, as in a file


class Scene(TypedDict):
    """A scene file as it is written: see the format's JSON Schema."""

    format: str
    version: int
    name: str
    description: str
    workspace: NotRequired[Geometry]
    reference_bounds: NotRequired[list[float]]
    rotation: NotRequired[bool]
    robot: Geometry
    obstacles: list[Geometry]
    start: list[float]
    goal: list[float] | dict[str, Any] | str


def scene(
    name: str,
    description: str,
    *,
    robot: Geometry,
    obstacles: Sequence[Geometry],
    start: Configuration,
    goal: Goal,
    workspace: Box | Geometry | None = None,
    reference_bounds: Box | None = None,
    rotation: bool = True,
) -> Scene:
    """Assemble a scene; keys stand in the order in which they are written."""
    if workspace is None and reference_bounds is None:
        raise ValueError(f"scene {name}: neither workspace nor reference_bounds is given")
    made: dict[str, Any] = {
        "format": "planar-planner/scene",
        "version": 1,
        "name": name,
        "description": description,
    }
    if workspace is not None:
        box_given = isinstance(workspace, tuple)
        made["workspace"] = {"box": [float(v) for v in workspace]} if box_given else workspace
    if reference_bounds is not None:
        made["reference_bounds"] = [float(v) for v in reference_bounds]
    if not rotation:
        made["rotation"] = False
    made["robot"] = robot
    made["obstacles"] = list(obstacles)
    made["start"] = [float(v) for v in start]
    made["goal"] = [float(v) for v in goal] if isinstance(goal, tuple) else goal
    return cast(Scene, made)  # built key by key, so that the file's order is ours


def _closed(ring: Sequence[Point]) -> list[list[float]]:
    """GeoJSON ring: the first vertex is repeated at the end."""
    points = [[float(x), float(y)] for x, y in ring]
    return [*points, points[0]]


def polygon(outer: Sequence[Point], *holes: Sequence[Point]) -> Geometry:
    """GeoJSON Polygon from open rings."""
    return {"type": "Polygon", "coordinates": [_closed(ring) for ring in (outer, *holes)]}


def multi_polygon(parts: Sequence[Geometry]) -> Geometry:
    """GeoJSON MultiPolygon from Polygons that do not overlap."""
    return {"type": "MultiPolygon", "coordinates": [part["coordinates"] for part in parts]}


def box_ring(xmin: float, ymin: float, xmax: float, ymax: float) -> Ring:
    """Anticlockwise corners of an axis-parallel rectangle."""
    return [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]


def box(xmin: float, ymin: float, xmax: float, ymax: float) -> Geometry:
    """Axis-parallel rectangle as a GeoJSON Polygon."""
    return polygon(box_ring(xmin, ymin, xmax, ymax))


def polar(radius: float, angle: float, centre: Point = (0.0, 0.0)) -> Point:
    """Point at a radius and angle from a centre, rounded to ``DECIMALS`` places."""
    return (
        round(centre[0] + radius * math.cos(angle), DECIMALS),
        round(centre[1] + radius * math.sin(angle), DECIMALS),
    )


def regular_ring(sides: int, radius: float, centre: Point = (0.0, 0.0), phase: float = 0.0) -> Ring:
    """Anticlockwise vertices of a regular polygon of the given circumradius."""
    return [polar(radius, phase + 2.0 * math.pi * k / sides, centre) for k in range(sides)]


def mirrored_in_x_axis(ring: Sequence[Point]) -> Ring:
    """Reflection in the x axis, with the order reversed so that the orientation stays."""
    return [(x, -y) for x, y in reversed(ring)]
