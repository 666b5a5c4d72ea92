"""Claims that a robot collides everywhere in a box: by one pair, or by several together.

For one vertex and one edge, at translation t and angle θ, the separating-axis function is
C + D cos θ + E sin θ, and linear in t.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import chain, product
from typing import Any

from planar_planner.checker.arithmetic import BITS, HALF_TURN, Extent, Rotation, Vector, _dot
from planar_planner.checker.case import OTHER, Axis, Case, Edge, Pair, demand, find

MOST_CHOICES = 1024  # of separating edges in one joint claim


HALVINGS = 60  # of a box's angles, in search of one vertex for each part


def negative(D: int, E: int, C: int, ends: Sequence[Rotation]) -> bool:
    """Prove that C + D cos θ + E sin θ < 0 from one end to the other, at most half a turn on."""
    error = abs(D) + abs(E)
    if any(D * c + E * s + error + (C << BITS) >= 0 for c, s in ends):
        return False
    if len(ends) == 1 or (C < 0 and D * D + E * E < C * C):  # it is at most C plus the amplitude
        return True
    (c0, s0), (c1, s1) = ends  # its maximum is at one, if it falls at the first, rises at the last
    return E * c0 - D * s0 + error <= 0 or E * c1 - D * s1 >= error


def negative_edge(edge: Edge, vertices: list[Vector], at: Extent, halvings: int = HALVINGS) -> bool:
    """Prove an edge's function negative: on each part of the angles for some one vertex."""
    ends, corners = at.ends(), at.corners
    if edge.obstacle:  # the translation only adds to the term
        corners = [max(corners, key=lambda t: _dot(edge.normal, t))]
    if at.last - at.first <= HALF_TURN and any(
        all(negative(*edge.term(v, t), ends) for t in corners) for v in vertices
    ):
        return True
    if len(ends) == 1 or halvings == 0:
        return False
    return all(negative_edge(edge, vertices, half, halvings - 1) for half in at.halves())


def check_full(case: Case, place: str, claim: Mapping[str, Any], at: Extent) -> None:
    """Check that no configuration of a box, face or point is free."""
    if "joint" in claim:
        check_joint(case, place, claim["joint"], at)
    elif "pair" in claim:
        check_overlap(case, place, claim["pair"], at)
    else:
        beyond = negative_edge(find(place, case.walls, claim["wall"]), case.outline, at)
        demand(beyond, place, "the robot may be inside the wall")


def check_overlap(case: Case, place: str, pair: Pair, at: Extent, but: Sequence[Axis] = ()) -> None:
    """Check FULL by a pair: every separating-axis function is negative, `but` for some edges'."""
    pieces = case.pair(place, pair)
    for owner, other in OTHER.items():
        for i, edge in enumerate(pieces[owner].edges):
            negated = (owner, i) in but or negative_edge(edge, pieces[other].vertices, at)
            demand(negated, f"{place}, edge {i} of the {owner}", "may separate the pair")


def check_joint(case: Case, place: str, joint: Mapping[str, Any], at: Extent) -> None:
    """Check FULL jointly: whichever of the edges listed separate their pairs, a sum refutes it."""
    for entry in joint["axes"]:  # where all is free, an edge of each pair separates: none but these
        check_overlap(case, place, entry["pair"], at, entry["edges"])
    edges = {entry["pair"]: entry["edges"] for entry in joint["axes"]}
    refuted = [check_sum(case, place, terms, at) for terms in joint["sums"]]
    few = math.prod(map(len, edges.values())) <= MOST_CHOICES
    demand(few, place, "leaves too many choices of separating edges")
    for choice in product(*edges.values()):
        chosen = dict(zip(edges, choice, strict=True))
        hit = any(used.items() <= chosen.items() for used in refuted)
        demand(hit, place, "does not refute every choice of separating edges")


def check_sum(case: Case, place: str, terms: list[Any], at: Extent) -> dict[Pair, Axis]:
    """Check that a weighted sum of terms is negative, and return which edge it has of each pair."""
    used: dict[Pair, Axis] = {}
    parts: list[tuple[int, Edge, Vector]] = []
    scale = math.lcm(*(Fraction(term["weight"]).denominator for term in terms))
    for term in terms:
        if "wall" in term:
            edge, vertex = find(place, case.walls, term["wall"]), term["vertex"]
            own = any(vertex in ring for ring in chain(*case.polygons["robot"].values()))
            demand(own, place, "has a vertex that is not the robot's")
        else:
            choice = term["owner"], term["edge"]
            only = used.setdefault(term["pair"], choice) == choice
            demand(only, place, "has two edges of a pair in one sum")
            edge, vertices = case.edge(place, term["pair"], choice)
            vertex = find(place, vertices, term["vertex"])
        demand(term["weight"] >= 0, place, "has a negative weight")
        parts.append((int(Fraction(term["weight"]) * scale), edge, vertex))
    for t, part in product(at.corners, at.halves() if at.last - at.first > HALF_TURN else [at]):
        weighted = [[weight * x for x in edge.term(v, t)] for weight, edge, v in parts]
        D, E, C = (sum(term[k] for term in weighted) for k in range(3))
        demand(negative(D, E, C, part.ends()), place, "the weighted sum may be 0 or more")
    return used
