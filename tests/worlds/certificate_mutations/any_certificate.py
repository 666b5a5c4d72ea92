"""Mutations of what every certificate has: hash, verdict, pieces."""

from __future__ import annotations

import math

from worlds.certificate_mutations.registry import (
    Json,
    Mutant,
    edges_apart,
    full_claims,
    has_region,
    is_path,
    mutation,
    outer_rings,
    piece_lists,
)


@mutation
def scene_changed_by_an_ulp(scene: Json, certificate: Json) -> Mutant:
    """The certificate is of another scene; nothing but the hash can tell."""
    robot = scene["robot"]["coordinates"]
    ring = robot[0] if scene["robot"]["type"] == "Polygon" else robot[0][0]
    vertex = next(vertex for vertex in ring if vertex[0] != 0)
    vertex[0] = math.nextafter(vertex[0], math.inf)
    return scene, certificate


@mutation
def goal_changed_by_an_ulp(scene: Json, certificate: Json) -> Mutant:
    if has_region(scene):
        return None
    scene["goal"][0] = math.nextafter(scene["goal"][0], math.inf)
    return scene, certificate


@mutation
def hash_changed(scene: Json, certificate: Json) -> Mutant:
    certificate["scene"] = certificate["scene"][::-1]
    return scene, certificate


@mutation
def verdict_swapped(scene: Json, certificate: Json) -> Mutant:
    certificate["verdict"] = "no_path" if is_path(certificate) else "path"
    return scene, certificate


@mutation
def version_changed(scene: Json, certificate: Json) -> Mutant:
    certificate["version"] = 2
    return scene, certificate


@mutation
def piece_missing(scene: Json, certificate: Json) -> Mutant:
    if not any(piece_lists(certificate)):
        return None
    max(piece_lists(certificate), key=len).pop()
    return scene, certificate


@mutation
def piece_duplicated(scene: Json, certificate: Json) -> Mutant:
    if not any(piece_lists(certificate)):
        return None
    pieces = piece_lists(certificate)[0]
    pieces.append(pieces[0])
    return scene, certificate


@mutation
def piece_shrunk(scene: Json, certificate: Json) -> Mutant:
    """A vertex goes inwards: the piece is still convex, but no longer part of a partition."""
    if not any(piece_lists(certificate)):
        return None
    piece = piece_lists(certificate)[0][0]
    (ax, ay), (bx, by), (cx, cy) = piece[0], piece[1], piece[2]
    piece[1] = [(ax + 14 * bx + cx) / 16, (ay + 14 * by + cy) / 16]
    return scene, certificate


@mutation
def piece_outside_its_polygon(scene: Json, certificate: Json) -> Mutant:
    if not any(piece_lists(certificate)):
        return None
    for piece in piece_lists(certificate)[0]:
        for vertex in piece:
            vertex[0] += 0.125
    return scene, certificate


@mutation
def piece_clockwise(scene: Json, certificate: Json) -> Mutant:
    if not any(piece_lists(certificate)):
        return None
    piece_lists(certificate)[0][0].reverse()
    return scene, certificate


@mutation
def pieces_not_convex(scene: Json, certificate: Json) -> Mutant:
    """An obstacle that nothing refers to is listed as one piece, though it is not convex."""
    for number, ring in enumerate(outer_rings(scene)):
        if str(number) not in certificate["obstacle_pieces"] and len(ring) == 6:
            certificate["obstacle_pieces"][str(number)] = [ring]
            return scene, certificate
    return None


@mutation
def pieces_of_no_polygon(scene: Json, certificate: Json) -> Mutant:
    if not any(piece_lists(certificate)):
        return None
    certificate["obstacle_pieces"]["99999"] = piece_lists(certificate)[0]
    return scene, certificate


@mutation
def pieces_not_listed(scene: Json, certificate: Json) -> Mutant:
    if not (full_claims(certificate) or edges_apart(certificate)):
        return None
    certificate["robot_pieces"] = certificate["obstacle_pieces"] = {}
    return scene, certificate


@mutation
def outside_too_small(scene: Json, certificate: Json) -> Mutant:
    """What is outside the workspace shrinks to a far rectangle, and the path leads through it."""
    if "outside" not in certificate or not is_path(certificate):
        return None
    certificate |= {"outside": [-5, -5, -4, -4]}
    if certificate["made_by"] == "hand":
        certificate["obstacle_pieces"] = {}
        certificate["waypoints"][1] = [8, 3, 0, 0]
    return scene, certificate
