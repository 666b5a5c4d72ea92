"""Mutations of paths: waypoints, segments, intervals and the edges that separate."""

from __future__ import annotations

import math

from worlds.certificate_mutations.registry import (
    Json,
    Mutant,
    edges_apart,
    has_region,
    is_path,
    mutation,
    outer_rings,
)
from worlds.hand_made_certificates import signed


@mutation
def waypoint_through_an_obstacle(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or len(certificate["waypoints"]) < 3 or not outer_rings(scene):
        return None
    number = next(iter(certificate["obstacle_pieces"]), None)
    if number is None:
        return None
    piece = certificate["obstacle_pieces"][number][0]
    middle = [sum(v[k] for v in piece) / len(piece) for k in (0, 1)]
    certificate["waypoints"][len(certificate["waypoints"]) // 2][:2] = middle
    return scene, certificate


@mutation
def waypoint_beyond_a_wall(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or len(certificate["waypoints"]) < 3:
        return None
    certificate["waypoints"][1][1] += 1e4
    return scene, certificate


@mutation
def waypoint_just_beyond_a_wall(scene: Json, certificate: Json) -> Mutant:
    """Over the block, higher than the ceiling allows; nothing else is in the way there."""
    if not is_path(certificate) or scene.get("workspace") != {"box": [0, 0, 10, 4]}:
        return None
    if certificate["waypoints"][1][:2] != [5, 3]:
        return None
    certificate["waypoints"][1][1] = 3.875
    return scene, certificate


@mutation
def start_moved(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["waypoints"][0][0] += 2.0**-20
    return scene, certificate


@mutation
def goal_moved(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or has_region(scene):
        return None
    certificate["waypoints"][-1][1] -= 2.0**-20
    return scene, certificate


@mutation
def goal_turned(scene: Json, certificate: Json) -> Mutant:
    """Signed: the scene's goal has another theta."""
    if not is_path(certificate) or has_region(scene) or scene.get("rotation") is False:
        return None
    scene["goal"][2] += 2.0**-20
    return scene, signed(scene, certificate)


@mutation
def start_a_turn_on(scene: Json, certificate: Json) -> Mutant:
    """The whole path is a turn on: the same motion, in another form than stated."""
    if not is_path(certificate):
        return None
    for waypoint in certificate["waypoints"]:
        waypoint[3] += 1
    return scene, certificate


@mutation
def turns_changed_at_the_goal(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or not certificate["segments"][-1][-1]["apart"]:
        return None
    certificate["waypoints"][-1][3] += 1
    return scene, certificate


@mutation
def turns_changed_on_the_way(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate) or len(certificate["waypoints"]) < 3:
        return None
    certificate["waypoints"][len(certificate["waypoints"]) // 2][3] -= 1
    return scene, certificate


@mutation
def turned_on_the_way(scene: Json, certificate: Json) -> Mutant:
    """A robot that may not turn does, in free space."""
    if not is_path(certificate) or scene.get("rotation") is not False:
        return None
    certificate["waypoints"].insert(0, certificate["waypoints"][0])
    certificate["waypoints"].insert(1, [*certificate["waypoints"][0][:2], 0.25, 0])
    idle = [{"from": 0.0, "to": 1.0, "apart": []}]
    certificate["segments"] = [idle, idle, *certificate["segments"]]
    return scene, certificate


@mutation
def tolerance_invented(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["contact_tolerance"] = 2.0**-10
    certificate["waypoints"][0][0] += 2.0**-30
    return scene, certificate


@mutation
def tolerance_negative(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["contact_tolerance"] = -1.0
    return scene, certificate


@mutation
def bounds_tighter(scene: Json, certificate: Json) -> Mutant:
    """Signed: the path leaves the bounds of the reference point on its way."""
    if not is_path(certificate) or "reference_bounds" not in scene:
        return None
    waypoints = certificate["waypoints"]
    scene["reference_bounds"][3] = max(w[1] for w in waypoints) - 2.0**-20
    return scene, signed(scene, certificate)


@mutation
def waypoint_dropped(scene: Json, certificate: Json) -> Mutant:
    """A corner is cut."""
    if not is_path(certificate) or len(certificate["waypoints"]) < 4:
        return None
    if not certificate["segments"][0][-1]["apart"]:
        return None
    certificate["waypoints"].pop(1)
    certificate["segments"].pop(1)
    return scene, certificate


@mutation
def segment_dropped(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["segments"].pop()
    return scene, certificate


@mutation
def interval_dropped(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    max(certificate["segments"], key=len).pop()
    return scene, certificate


@mutation
def interval_gap(scene: Json, certificate: Json) -> Mutant:
    intervals = max(certificate.get("segments", [[]]), key=len)
    if len(intervals) < 2:
        return None
    intervals[1]["from"] = math.nextafter(intervals[1]["from"], 1)
    return scene, certificate


@mutation
def interval_overlap(scene: Json, certificate: Json) -> Mutant:
    intervals = max(certificate.get("segments", [[]]), key=len)
    if len(intervals) < 2:
        return None
    intervals[1]["from"] = math.nextafter(intervals[1]["from"], 0)
    return scene, certificate


@mutation
def intervals_short_of_the_end(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["segments"][-1][-1]["to"] = math.nextafter(1, 0)
    return scene, certificate


@mutation
def intervals_late(scene: Json, certificate: Json) -> Mutant:
    if not is_path(certificate):
        return None
    certificate["segments"][0][0]["from"] = 2.0**-60
    return scene, certificate


@mutation
def edge_dropped(scene: Json, certificate: Json) -> Mutant:
    """An interval lists one edge fewer."""
    for intervals in certificate.get("segments", []):
        for interval in intervals:
            if interval["apart"]:
                interval["apart"].pop(0)
                return scene, certificate
    return None


@mutation
def edges_all_dropped(scene: Json, certificate: Json) -> Mutant:
    """No interval lists an edge, nor the certificate an obstacle."""
    if not edges_apart(certificate):
        return None
    certificate["obstacle_pieces"] = {}
    for intervals in certificate["segments"]:
        for interval in intervals:
            interval["apart"] = []
    return scene, certificate


@mutation
def edge_of_the_other_side(scene: Json, certificate: Json) -> Mutant:
    for claim in edges_apart(certificate):
        p, i, q, j, owner, edge = claim
        table, number, piece = ("robot", p, i) if owner == "robot" else ("obstacle", q, j)
        count = len(certificate[f"{table}_pieces"][str(number)][piece])
        claim[5] = (edge + count // 2) % count
    return (scene, certificate) if edges_apart(certificate) else None


@mutation
def edge_that_is_none(scene: Json, certificate: Json) -> Mutant:
    for claim in edges_apart(certificate):
        claim[5] = 1000
    return (scene, certificate) if edges_apart(certificate) else None


@mutation
def obstacle_in_the_way(scene: Json, certificate: Json) -> Mutant:
    """Signed: another obstacle stands on the path."""
    if not is_path(certificate):
        return None
    x, y = certificate["waypoints"][1][:2]
    ring = [[x - 0.01, y - 0.01], [x + 0.01, y - 0.01], [x, y + 0.01]]
    scene["obstacles"].append({"type": "Polygon", "coordinates": [ring]})
    return scene, signed(scene, certificate)
