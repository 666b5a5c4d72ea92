"""The registry of mutations, and the places in scenes and certificates that they change."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

Json = dict[str, Any]
Mutant = tuple[Json, Json] | None
Mutation = Callable[[Json, Json], Mutant]

MUTATIONS: dict[str, Mutation] = {}


def mutation(mutate: Mutation) -> Mutation:
    MUTATIONS[mutate.__name__] = mutate
    return mutate


def mutant(name: str, scene: Json, certificate: Json) -> Mutant:
    """Return scene and certificate changed by the mutation of that name."""
    return MUTATIONS[name](copy.deepcopy(scene), copy.deepcopy(certificate))


def outer_rings(scene: Json) -> list[Any]:
    """Return the outer rings of the obstacles; scenes here have only polygons of them."""
    shapes = [shape for shape in scene["obstacles"] if shape["type"] == "Polygon"]
    return [shape["coordinates"][0] for shape in shapes]


def piece_lists(certificate: Json) -> list[Any]:
    """Return the lists of pieces of all polygons."""
    return [*certificate["robot_pieces"].values(), *certificate["obstacle_pieces"].values()]


def full_claims(certificate: Json) -> list[Json]:
    return [*certificate.get("full", []), *certificate.get("full_faces", [])]


def edges_apart(certificate: Json) -> list[Any]:
    segments = certificate.get("segments", [])
    return [each for intervals in segments for interval in intervals for each in interval["apart"]]


def joint_claims(certificate: Json) -> list[Json]:
    return [claim["joint"] for claim in full_claims(certificate) if "joint" in claim]


def weighted_sums(certificate: Json) -> list[Any]:
    return [terms for joint in joint_claims(certificate) for terms in joint["sums"]]


def weighted_terms(certificate: Json) -> list[Any]:
    return [term for terms in weighted_sums(certificate) for term in terms]


def has_region(scene: Json) -> bool:
    """Whether any of a set of configurations is a goal."""
    return not isinstance(scene["goal"], list)


def is_path(certificate: Json) -> bool:
    return bool(certificate["verdict"] == "path")


def separates(certificate: Json) -> bool:
    return certificate.get("claim") in ("separation", "disc")
