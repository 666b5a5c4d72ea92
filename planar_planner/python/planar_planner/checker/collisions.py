"""Claims that a box of configurations is FULL: by a pair, by a wall, or jointly.

docs/certificate.md, "separation", step 4. For one vertex and one edge, at translation t and angle
θ, the separating-axis function is C + D cos θ + E sin θ, and linear in t.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from fractions import Fraction
from itertools import chain, product
from typing import NamedTuple

from planar_planner import certificate_keys as keys
from planar_planner.checker.arithmetic import ROTATION_BITS, Ring, Rotation, Vector, dot
from planar_planner.checker.case import Case
from planar_planner.checker.demands import demand, find
from planar_planner.checker.extents import Extent
from planar_planner.checker.pieces import Edge, Sinusoid
from planar_planner.checker.records import Collision, EdgeName, Joint, PairName, PairTerm, WallTerm

MOST_CHOICES = 1024
"""Most choices of separating edges in one joint claim."""
HALVINGS = 60
"""Most halvings of a box's angles in the search for one vertex of each part."""

HALF_TURN = Fraction(1, 2)


class WeightedTerm(NamedTuple):
    """One term of a sum, with its weight as an integer."""

    weight: int
    edge: Edge
    vertex: Vector


def is_negative(sinusoid: Sinusoid, ends: Sequence[Rotation]) -> bool:
    """Prove that a sinusoid is negative from one rotation to the next, at most half a turn on."""
    C, D, E = sinusoid
    error = abs(D) + abs(E)
    if any(D * c + E * s + error + (C << ROTATION_BITS) >= 0 for c, s in ends):
        return False
    if len(ends) == 1 or (C < 0 and D * D + E * E < C * C):  # it is at most C plus the amplitude
        return True
    (c0, s0), (c1, s1) = ends  # its maximum is at one, if it falls at the first, rises at the last
    return E * c0 - D * s0 + error <= 0 or E * c1 - D * s1 >= error


def is_negative_edge(edge: Edge, vertices: Ring, extent: Extent, halvings: int = HALVINGS) -> bool:
    """Prove an edge's function negative: on each part of the angles for some one vertex."""
    ends, corners = extent.end_rotations(), extent.corners
    if edge.of_obstacle:  # the translation only adds to the function
        corners = [max(corners, key=lambda corner: dot(edge.normal, corner))]
    if extent.last - extent.first <= HALF_TURN and any(
        all(is_negative(edge.sinusoid(vertex, corner), ends) for corner in corners)
        for vertex in vertices
    ):
        return True
    if len(ends) == 1 or halvings == 0:
        return False
    return all(is_negative_edge(edge, vertices, half, halvings - 1) for half in extent.halves())


def check_full(case: Case, place: str, collision: Collision, extent: Extent) -> None:
    """Check that no configuration of a box, face or point is free."""
    case.deadline.check()
    if collision.joint is not None:
        check_joint(case, place, collision.joint, extent)
    elif collision.pair is not None:
        check_overlap(case, place, collision.pair, extent)
    else:
        wall = find(place, case.walls, collision.wall)
        beyond = is_negative_edge(wall, case.outline, extent)
        demand(beyond, place, "the robot may be inside the wall")


def check_overlap(
    case: Case, place: str, pair: PairName, extent: Extent, but: Collection[EdgeName] = ()
) -> None:
    """Check that every separating-axis function of a pair is negative, `but` for some edges'."""
    robot, obstacle = case.pieces.pair(place, pair)
    for owner, own, other in (
        (keys.ROBOT, robot, obstacle),
        (keys.OBSTACLE, obstacle, robot),
    ):
        for i, edge in enumerate(own.edges):
            negative = (owner, i) in but or is_negative_edge(edge, other.vertices, extent)
            demand(negative, f"{place}, edge {i} of the {owner}", "may separate the pair")


def check_joint(case: Case, place: str, joint: Joint, extent: Extent) -> None:
    """Check that a sum refutes each choice of the edges listed, one of every pair.

    Where a configuration is free, an edge of each pair separates it, and that is one listed.
    """
    for listed in joint.axes:
        check_overlap(case, place, listed.pair, extent, listed.edges)
    edges = {listed.pair: listed.edges for listed in joint.axes}
    refuted = [check_sum(case, place, terms, extent) for terms in joint.sums]
    few = math.prod(map(len, edges.values())) <= MOST_CHOICES
    demand(few, place, "leaves too many choices of separating edges")
    for choice in product(*edges.values()):
        chosen = dict(zip(edges, choice, strict=True))
        hit = any(used.items() <= chosen.items() for used in refuted)
        demand(hit, place, "does not refute every choice of separating edges")


def check_sum(
    case: Case, place: str, terms: Sequence[PairTerm | WallTerm], extent: Extent
) -> dict[PairName, EdgeName]:
    """Check that a weighted sum is negative, and return which edge it has of each pair."""
    used: dict[PairName, EdgeName] = {}
    for term in terms:
        demand(term.weight >= 0, place, "has a negative weight")
        if isinstance(term, PairTerm):
            only = used.setdefault(term.pair, term.edge) == term.edge
            demand(only, place, "has two edges of a pair in one sum")
    weighted = weighted_terms(case, place, terms)
    wide = extent.last - extent.first > HALF_TURN
    parts = extent.halves() if wide else [extent]
    for corner, part in product(extent.corners, parts):
        total = weighted_sum(weighted, corner)
        demand(is_negative(total, part.end_rotations()), place, "the weighted sum may be 0 or more")
    return used


def weighted_terms(
    case: Case, place: str, terms: Sequence[PairTerm | WallTerm]
) -> list[WeightedTerm]:
    """Return the edges and vertices that the terms name, with weights as integers in proportion."""
    weights = [Fraction(term.weight) for term in terms]
    scale = math.lcm(*(weight.denominator for weight in weights))
    weighted = []
    for term, weight in zip(terms, weights, strict=True):
        if isinstance(term, PairTerm):
            edge, vertices = case.pieces.edge(place, term.pair, term.edge)
            vertex = find(place, vertices, term.vertex)
        else:
            edge, vertex = find(place, case.walls, term.wall), term.vertex
            own = any(vertex in ring for ring in chain(*case.robot.values()))
            demand(own, place, "has a vertex that is not the robot's")
        weighted.append(WeightedTerm(int(weight * scale), edge, vertex))
    return weighted


def weighted_sum(terms: Sequence[WeightedTerm], translation: Vector) -> Sinusoid:
    """Return the sum of weighted separating-axis functions at one translation."""
    C = D = E = 0
    for weight, edge, vertex in terms:
        constant, cosine, sine = edge.sinusoid(vertex, translation)
        C, D, E = C + weight * constant, D + weight * cosine, E + weight * sine
    return C, D, E
