"""Mutations of separations: cells, faces, witnesses, the domain, the scene beneath them."""

from __future__ import annotations

import copy
from typing import Any

from worlds.certificate_mutations.registry import (
    Json,
    Mutant,
    full_claims,
    has_region,
    mutation,
    outer_rings,
    separates,
    weighted_terms,
)
from worlds.hand_made_certificates import signed


@mutation
def start_cell_removed(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    certificate["start_side"] = certificate["start_side"][:1]
    certificate["start_side"][0] = [[60, 0], [60, 0], certificate["start_side"][0][2]]
    return scene, certificate


@mutation
def cell_removed(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate) or len(certificate["start_side"]) < 2:
        return None
    certificate["start_side"].pop(len(certificate["start_side"]) // 2)
    return scene, certificate


@mutation
def cells_all_removed(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    certificate["start_side"] = []
    return scene, certificate


@mutation
def seam_cell_removed(scene: Json, certificate: Json) -> Mutant:
    """A cell that ends at turn 1 is removed, and with it all whose only neighbour it was."""
    if not separates(certificate):
        return None
    for i, (_, _, (level, k)) in enumerate(certificate["start_side"]):
        if level > 0 and k + 1 == 1 << level:
            certificate["start_side"].pop(i)
            return scene, certificate
    return None


@mutation
def cell_shrunk(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    span = certificate["start_side"][0][0]
    span[:] = [span[0] + 1, 2 * span[1]]
    return scene, certificate


@mutation
def cell_grown(scene: Json, certificate: Json) -> Mutant:
    """All of the domain is the start's side."""
    if not separates(certificate):
        return None
    certificate["start_side"].append([[0, 0], [0, 0], [0, 0]])
    return scene, certificate


@mutation
def cell_shifted(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    span = certificate["start_side"][-1][0]
    span[1] += 1
    return scene, certificate


@mutation
def cell_beyond_the_domain(scene: Json, certificate: Json) -> Mutant:
    """A true claim about a box that is none of the domain's."""
    if not separates(certificate) or "workspace" not in scene:
        return None
    certificate["full"].append({"box": [[2, 5], [0, 0], [0, 0]], "wall": "x_max"})
    return scene, certificate


@mutation
def cell_with_angles(scene: Json, certificate: Json) -> Mutant:
    """A claim about half a turn where there is only one angle."""
    turning = scene.get("rotation") is not False and certificate.get("claim") != "disc"
    if not separates(certificate) or turning or not full_claims(certificate):
        return None
    claim = copy.deepcopy(full_claims(certificate)[0])
    claim["box"][2] = [1, 0]
    certificate["full_faces" if "axis" in claim else "full"].append(claim)
    return scene, certificate


@mutation
def full_cell_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"].pop(0)
    return scene, certificate


@mutation
def full_cells_all_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"] = []
    return scene, certificate


@mutation
def face_dropped(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full_faces"):
        return None
    certificate["full_faces"].pop(0)
    return scene, certificate


@mutation
def face_of_another_axis(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full_faces"):
        return None
    certificate["full_faces"][0]["axis"] = 1 - min(certificate["full_faces"][0]["axis"], 1)
    return scene, certificate


@mutation
def full_cell_shifted(scene: Json, certificate: Json) -> Mutant:
    if not certificate.get("full"):
        return None
    certificate["full"][0]["box"][0][1] ^= 1
    return scene, certificate


@mutation
def full_cell_grown(scene: Json, certificate: Json) -> Mutant:
    """FULL is said of all translations."""
    if not certificate.get("full"):
        return None
    certificate["full"][0]["box"][:2] = [[0, 0], [0, 0]]
    return scene, certificate


@mutation
def witness_is_a_wall(scene: Json, certificate: Json) -> Mutant:
    """Every claim by a pair is made by a wall."""
    pairs = [claim for claim in full_claims(certificate) if "pair" in claim]
    if not pairs or "workspace" not in scene:
        return None
    for claim in pairs:
        del claim["pair"]
        claim["wall"] = "x_min"
    return scene, certificate


@mutation
def wall_is_another(scene: Json, certificate: Json) -> Mutant:
    other = {"x_min": "x_max", "x_max": "x_min", "y_min": "y_max", "y_max": "y_min"}
    walls = [claim for claim in full_claims(certificate) if "wall" in claim]
    for claim in walls:
        claim["wall"] = other[claim["wall"]]
    return (scene, certificate) if walls else None


@mutation
def witnesses_exchanged(scene: Json, certificate: Json) -> Mutant:
    """The witness of another claim."""
    pairs = [claim["pair"] for claim in full_claims(certificate) if "pair" in claim]
    pieces = [claim for claim in full_claims(certificate) if "pair" in claim]
    if len({tuple(pair) for pair in pairs}) < 2:
        return None
    for claim, pair in zip(pieces, pairs[::-1], strict=True):
        claim["pair"] = pair
    return scene, certificate


@mutation
def witness_of_no_piece(scene: Json, certificate: Json) -> Mutant:
    pieces = [claim for claim in full_claims(certificate) if "pair" in claim]
    for claim in pieces:
        claim["pair"][3] += 1000
    return (scene, certificate) if pieces else None


def _resize(certificate: Json, low: int, size: int) -> None:
    """Move the domain by `low` / 32 of its size and change that by `size` / 32; so its boxes."""
    for name, parts in (("low", low), ("size", size)):
        for k in (0, 1):
            m, e = certificate["domain"][name][k]
            length, exponent = certificate["domain"]["size"][k]
            moved = (m << (e + 120)) + parts * (length << (exponent + 115))
            certificate["domain"][name][k] = [moved, -120]


@mutation
def domain_shrunk(scene: Json, certificate: Json) -> Mutant:
    """Its sides are no longer beyond the workspace; all claims hold as before."""
    if not separates(certificate) or certificate["made_by"] != "hand":
        return None
    _resize(certificate, 1, -2)
    return scene, certificate


@mutation
def domain_halved(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    _resize(certificate, 8, -16)
    return scene, certificate


@mutation
def domain_shifted(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    _resize(certificate, 12, 0)
    return scene, certificate


@mutation
def domain_turned_inside_out(scene: Json, certificate: Json) -> Mutant:
    if not separates(certificate):
        return None
    _resize(certificate, 32, -64)
    return scene, certificate


@mutation
def goal_in_the_start_side(scene: Json, certificate: Json) -> Mutant:
    """Signed: the goal is the start."""
    if not separates(certificate):
        return None
    scene["goal"] = scene["start"]
    return scene, signed(scene, certificate)


@mutation
def start_outside_its_side(scene: Json, certificate: Json) -> Mutant:
    """Signed: the start is the goal."""
    if not separates(certificate) or has_region(scene):
        return None
    scene["start"] = scene["goal"]
    return scene, signed(scene, certificate)


@mutation
def robot_smaller(scene: Json, certificate: Json) -> Mutant:
    """Signed, and the pieces are legitimate: the robot is a thousandth of its size."""
    if not separates(certificate) or scene["robot"]["type"] != "Polygon":
        return None
    if certificate["made_by"] == "hand" and not weighted_terms(certificate):
        return None  # there is no way for any robot

    def scaled(points: list[Any]) -> list[Any]:
        return [[x * 2.0**-10, y * 2.0**-10] for x, y in points]

    scene["robot"]["coordinates"] = [scaled(ring) for ring in scene["robot"]["coordinates"]]
    pieces = certificate["robot_pieces"]
    certificate["robot_pieces"] = {p: [scaled(v) for v in each] for p, each in pieces.items()}
    if "disc" in certificate:
        certificate["disc"] = scaled(certificate["disc"])
    return scene, signed(scene, certificate)


@mutation
def obstacles_elsewhere(scene: Json, certificate: Json) -> Mutant:
    """Signed, and the pieces are legitimate: the obstacles are far away."""
    if not full_claims(certificate) or "outside" in certificate:
        return None
    for ring in outer_rings(scene):
        ring[:] = [[x + 1024, y] for x, y in ring]
    for pieces in certificate["obstacle_pieces"].values():
        for piece in pieces:
            piece[:] = [[x + 1024, y] for x, y in piece]
    return scene, signed(scene, certificate)


@mutation
def box_listed_twice(scene: Json, certificate: Json) -> Mutant:
    """True, but work without end for whoever checks it."""
    if not separates(certificate):
        return None
    certificate["start_side"].append(certificate["start_side"][0])
    return scene, certificate
