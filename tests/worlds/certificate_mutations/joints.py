"""Mutations of joint claims: sums, their weights and terms, the edges to choose from."""

from __future__ import annotations

from worlds.certificate_mutations.registry import (
    Json,
    Mutant,
    joint_claims,
    mutation,
    weighted_sums,
    weighted_terms,
)


@mutation
def joint_term_dropped(scene: Json, certificate: Json) -> Mutant:
    for terms in weighted_sums(certificate):
        terms.pop()
    return (scene, certificate) if joint_claims(certificate) else None


@mutation
def joint_terms_all_dropped(scene: Json, certificate: Json) -> Mutant:
    for terms in weighted_sums(certificate):
        terms.clear()
    return (scene, certificate) if joint_claims(certificate) else None


@mutation
def sums_dropped(scene: Json, certificate: Json) -> Mutant:
    for joint in joint_claims(certificate):
        joint["sums"] = []
    return (scene, certificate) if joint_claims(certificate) else None


@mutation
def one_more_edge_may_separate(scene: Json, certificate: Json) -> Mutant:
    """A pair gets a further edge to choose, which no sum refutes."""
    for joint in joint_claims(certificate):
        for entry in joint["axes"]:
            edges = [list(edge) for edge in entry["edges"]]
            more = next(i for i in range(3) if ["obstacle", i] not in edges)
            entry["edges"].append(["obstacle", more])
            return scene, certificate
    return None


@mutation
def edge_that_may_separate_denied(scene: Json, certificate: Json) -> Mutant:
    for joint in joint_claims(certificate):
        for entry in joint["axes"]:
            entry["edges"] = entry["edges"][1:]
    return (scene, certificate) if any(j["axes"] for j in joint_claims(certificate)) else None


@mutation
def pair_of_a_joint_claim_unlisted(scene: Json, certificate: Json) -> Mutant:
    changed = [joint for joint in joint_claims(certificate) if joint["axes"]]
    for joint in changed:
        joint["axes"] = []
    return (scene, certificate) if changed else None


@mutation
def too_many_choices(scene: Json, certificate: Json) -> Mutant:
    """The one edge that may separate is listed very often, each refuted: true, but endless."""
    for joint in joint_claims(certificate):
        for entry in joint["axes"]:
            entry["edges"] = entry["edges"] * 2000
            return scene, certificate
    return None


@mutation
def weight_changed(scene: Json, certificate: Json) -> Mutant:
    for terms in weighted_sums(certificate):
        terms[0]["weight"] *= 64
        terms[-1]["weight"] /= 64
    return (scene, certificate) if weighted_terms(certificate) else None


@mutation
def weight_negative(scene: Json, certificate: Json) -> Mutant:
    """A wall's term that is large enough to make any sum negative, if weights may be."""
    for terms in weighted_sums(certificate):
        for term in terms:
            if "wall" in term:
                other = {"x_min": "x_max", "x_max": "x_min", "y_min": "y_max", "y_max": "y_min"}
                false = {**term, "wall": other[term["wall"]], "weight": -64.0}
                terms.append(false)
                return scene, certificate
    return None


@mutation
def term_of_another_edge(scene: Json, certificate: Json) -> Mutant:
    """A pair has terms of two edges, the second one without weight."""
    for terms in weighted_sums(certificate):
        for term in terms:
            if "pair" in term:
                terms.append({**term, "edge": (term["edge"] + 1) % 3, "weight": 0.0})
                return scene, certificate
    return None


@mutation
def edge_of_a_term_changed(scene: Json, certificate: Json) -> Mutant:
    terms = [term for term in weighted_terms(certificate) if "pair" in term]
    for term in terms:
        term["edge"] = (term["edge"] + 1) % 3
    return (scene, certificate) if terms else None


@mutation
def vertex_of_a_term_changed(scene: Json, certificate: Json) -> Mutant:
    terms = [term for term in weighted_terms(certificate) if "pair" in term]
    for term in terms:
        term["vertex"] += 1000
    return (scene, certificate) if terms else None


@mutation
def vertex_not_of_the_robot(scene: Json, certificate: Json) -> Mutant:
    """A wall's term is of a point far outside the robot, which is beyond the wall indeed."""
    for term in weighted_terms(certificate):
        if "wall" in term:
            reach = -1000 if term["wall"].endswith("min") else 1000
            term["vertex"] = [reach, reach]
            return scene, certificate
    return None
