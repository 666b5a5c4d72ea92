"""Mutations of chains of sets, and of paths in contact."""

from __future__ import annotations

import math

from worlds.certificate_mutations.registry import Json, Mutant, mutation, outer_rings
from worlds.hand_made_certificates import signed

OTHER_SIDE = {"left": "right", "right": "left"}


@mutation
def chain_link_dropped(scene: Json, certificate: Json) -> Mutant:
    if "chain" not in certificate:
        return None
    certificate["chain"].pop(1)
    return scene, certificate


@mutation
def chain_twice_round(scene: Json, certificate: Json) -> Mutant:
    """A chain that winds an even number of times proves nothing."""
    if "chain" not in certificate:
        return None
    certificate["chain"] *= 2
    return scene, certificate


@mutation
def chain_of_one(scene: Json, certificate: Json) -> Mutant:
    if "chain" not in certificate:
        return None
    certificate["chain"] = certificate["chain"][:1]
    return scene, certificate


@mutation
def chain_round_both_ends(scene: Json, certificate: Json) -> Mutant:
    """Signed: the goal is beside the start."""
    if "chain" not in certificate:
        return None
    x, y, theta = scene["start"]
    scene["goal"] = [x + 2.0**-10, y, theta]
    return scene, signed(scene, certificate)


@mutation
def chain_round_a_robot_that_turns(scene: Json, certificate: Json) -> Mutant:
    if "chain" not in certificate:
        return None
    scene["rotation"] = True
    return scene, signed(scene, certificate)


@mutation
def chain_round_a_turned_robot(scene: Json, certificate: Json) -> Mutant:
    if "chain" not in certificate:
        return None
    scene["start"][2] = scene["goal"][2] = 2.0**-60
    return scene, signed(scene, certificate)


@mutation
def chain_round_a_region(scene: Json, certificate: Json) -> Mutant:
    if "chain" not in certificate:
        return None
    """A region that reaches to the start's side of the chain."""
    (x, y, _), (u, v, _) = scene["goal"], scene["start"]
    a, b = [u + 0.01, v], [u, v + 0.01]
    left = (a[0] - x) * (b[1] - y) > (a[1] - y) * (b[0] - x)
    ring = [[x, y], *((a, b) if left else (b, a))]  # counter-clockwise from the goal on
    scene["goal"] = {"region": {"type": "Polygon", "coordinates": [ring]}}
    return scene, signed(scene, certificate)


@mutation
def chain_round_one_of_two_regions(scene: Json, certificate: Json) -> Mutant:
    """The other one is beside the start."""
    if "chain" not in certificate:
        return None
    (x, y, _), (u, v, _) = scene["goal"], scene["start"]
    rings = [[[[a, b], [a + 2.0**-12, b], [a, b + 2.0**-12]]] for a, b in ((x, y), (u, v))]
    scene["goal"] = {"region": {"type": "MultiPolygon", "coordinates": rings}}
    return scene, signed(scene, certificate)


@mutation
def chain_that_only_touches(scene: Json, certificate: Json) -> Mutant:
    """Signed: the obstacle ends where the robot's place below it begins."""
    if "chain" not in certificate or not outer_rings(scene):
        return None
    ring = outer_rings(scene)[0]
    low = scene.get("reference_bounds", [0, 0.5])[1] + 0.5
    moved = [[x, low if y == min(v for _, v in ring) else y] for x, y in ring]
    scene["obstacles"][0]["coordinates"] = [moved]
    certificate["obstacle_pieces"]["0"] = [moved]
    return scene, signed(scene, certificate)


def lines_along(certificate: Json) -> list[list[object]]:
    intervals = [interval for segment in certificate.get("segments", []) for interval in segment]
    return [line for interval in intervals for line in interval.get("along", [])]


@mutation
def line_of_the_other_side(scene: Json, certificate: Json) -> Mutant:
    for line in lines_along(certificate):
        line[4] = OTHER_SIDE[str(line[4])]
    return (scene, certificate) if lines_along(certificate) else None


@mutation
def line_without_direction(scene: Json, certificate: Json) -> Mutant:
    """A stay at the start, which a line of no direction separates from everything."""
    if not lines_along(certificate):
        return None
    first = certificate["segments"][0][0]
    stay = {"from": 0.0, "to": 1.0, "apart": [], "along": first["along"]}
    certificate["waypoints"].insert(0, certificate["waypoints"][0])
    certificate["segments"].insert(0, [stay])
    return scene, certificate


@mutation
def gate_an_ulp_lower(scene: Json, certificate: Json) -> Mutant:
    """Signed: the block above the gate is a little too low."""
    if not lines_along(certificate):
        return None
    ring = [[x, math.nextafter(y, 0) if y == 1.5 else y] for x, y in outer_rings(scene)[1]]
    scene["obstacles"][1]["coordinates"] = [ring]
    certificate["obstacle_pieces"]["1"] = [ring]
    return scene, signed(scene, certificate)


@mutation
def touching_segment_turned(scene: Json, certificate: Json) -> Mutant:
    if not lines_along(certificate):
        return None
    for waypoint in certificate["waypoints"][1:-1]:
        waypoint[2] += 2.0**-40
    return scene, certificate


@mutation
def decimals_of_doubles(scene: Json, certificate: Json) -> Mutant:
    """Signed: the scene says that its numbers are doubles."""
    if "decimal_places" not in certificate:
        return None
    scene["numbers"] = "doubles"
    return scene, signed(scene, certificate)


@mutation
def decimals_of_another_place(scene: Json, certificate: Json) -> Mutant:
    if "decimal_places" not in certificate:
        return None
    certificate["decimal_places"] += 1
    return scene, certificate


@mutation
def decimals_left_out(scene: Json, certificate: Json) -> Mutant:
    if "decimal_places" not in certificate:
        return None
    del certificate["decimal_places"]
    return scene, certificate


@mutation
def decimals_that_are_none(scene: Json, certificate: Json) -> Mutant:
    """Signed: a length of the scene has more places."""
    if "decimal_places" not in certificate:
        return None
    scene["start"][0] += 2.0**-20
    return scene, signed(scene, certificate)
