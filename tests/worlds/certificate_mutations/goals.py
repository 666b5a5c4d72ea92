"""Mutations of goals that are regions: the certificate's answer is then one to another question."""

from __future__ import annotations

from typing import Any

from worlds.certificate_mutations.registry import (
    Json,
    Mutant,
    has_region,
    is_path,
    mutation,
    separates,
)
from worlds.hand_made_certificates import signed


def around(q: list[float]) -> Json:
    """Return a small square round a configuration's place."""
    x, y, half = q[0], q[1], 2.0**-10
    ring = [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
    return {"type": "Polygon", "coordinates": [ring]}


def with_goal(scene: Json, certificate: Json, goal: Any) -> Mutant:
    scene["goal"] = goal
    return scene, signed(scene, certificate)


@mutation
def region_elsewhere(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or not has_region(scene):
        return None
    x, y, theta, _ = certificate["waypoints"][-1]
    return with_goal(scene, certificate, {"region": around([x + 2.0**-8, y, theta])})


@mutation
def interval_elsewhere(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or not has_region(scene):
        return None
    end = certificate["waypoints"][-1]
    angles = [end[2] + 2.0**-8, end[2] + 2.0**-7]
    return with_goal(scene, certificate, {"region": around(end), "theta": angles})


@mutation
def region_round_the_start(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate) or not has_region(scene):
        return None
    return with_goal(scene, certificate, {"region": around(scene["start"])})


@mutation
def region_whose_end_collides(scene: Json, certificate: Json) -> Mutant:
    """An end that is not free ends a search; a region has no such end."""
    if is_path(certificate) or not has_region(scene):
        return None
    kept = ("format", "version", "made_by", "scene", "verdict", "robot_pieces", "obstacle_pieces")
    forged = {name: certificate[name] for name in kept}
    return scene, forged | {"claim": "end", "end": "goal", "reference_bounds": True}
