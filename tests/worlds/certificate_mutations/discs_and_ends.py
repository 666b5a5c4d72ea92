"""Mutations of discs inside the robot, and of ends that are not free."""

from __future__ import annotations

from worlds.certificate_mutations.registry import Json, Mutant, mutation
from worlds.hand_made_certificates import signed


@mutation
def disc_too_large(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["disc"] = [[x * 1.5, y * 1.5] for x, y in certificate["disc"]]
    return scene, certificate


@mutation
def disc_off_centre(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    reach = max(x for x, _ in certificate["disc"])
    certificate["disc"] = [[x + reach, y] for x, y in certificate["disc"]]
    return scene, certificate


@mutation
def disc_star_shaped(scene: Json, certificate: Json) -> Mutant:
    """A star polygon turns left at every vertex."""
    if "disc" not in certificate:
        return None
    disc = certificate["disc"]
    certificate["disc"] = [disc[3 * k % len(disc)] for k in range(len(disc))]
    return scene, certificate


@mutation
def disc_empty(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["disc"] = []
    return scene, certificate


@mutation
def disc_inside_nothing(scene: Json, certificate: Json) -> Mutant:
    if "disc" not in certificate:
        return None
    certificate["inside"] = [0, 1000]
    return scene, certificate


@mutation
def end_exchanged(scene: Json, certificate: Json) -> Mutant:
    if "end" not in certificate:
        return None
    certificate["end"] = "goal" if certificate["end"] == "start" else "start"
    return scene, certificate


@mutation
def end_is_free(scene: Json, certificate: Json) -> Mutant:
    """Signed: the end is moved to where it is free, and within its bounds."""
    if "end" not in certificate:
        return None
    scene[certificate["end"]] = [5, 2, 0]
    return scene, signed(scene, certificate)
