"""How large a scene is, counted without numpy so that listing scenes starts quickly."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from planar_planner.scene.geojson import iter_polygons
from planar_planner.scene.model import Scene


@dataclass(frozen=True)
class SceneSize:
    """Numbers of polygons and vertices as written; a ring's repeated last vertex counts once."""

    obstacle_polygons: int
    obstacle_vertices: int
    robot_polygons: int
    robot_vertices: int


def size_json(size: SceneSize) -> dict[str, dict[str, int]]:
    """Return a size as the members ``robot`` and ``obstacles`` of a JSON object."""
    return {
        "robot": {"polygons": size.robot_polygons, "vertices": size.robot_vertices},
        "obstacles": {"polygons": size.obstacle_polygons, "vertices": size.obstacle_vertices},
    }


def scene_size(scene: Scene) -> SceneSize:
    """Count a scene that the gate would accept.

    Raises
    ------
    SceneError
        On what is no geometry.
    """
    obstacles, obstacle_vertices = _count(
        (f"obstacles[{i}]", geometry) for i, geometry in enumerate(scene.obstacles)
    )
    robots, robot_vertices = _count([("robot", scene.robot)])
    return SceneSize(obstacles, obstacle_vertices, robots, robot_vertices)


def _count(geometries: Iterable[tuple[str, Any]]) -> tuple[int, int]:
    polygons = vertices = 0
    for path, geometry in geometries:
        for _, rings in iter_polygons(geometry, path):
            polygons += 1
            vertices += sum(_ring_vertices(ring) for ring in rings)
    return polygons, vertices


def _ring_vertices(ring: Any) -> int:
    return len(ring) - 1 if len(ring) > 1 and ring[0] == ring[-1] else len(ring)
