"""Certificates: the evidence for an answer as a JSON object, and as a file.

The format and what it proves: docs/certificate.md. `planar_planner.checker` reads and checks it.
"""

from __future__ import annotations

import gzip
import json
import math
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from planar_planner import certificate_keys as keys
from planar_planner._core import (
    ClaimKind,
    NamedClaim,
    NamedCollision,
    NamedDomain,
    NamedEdge,
    NamedEvidence,
    NamedInterval,
    NamedJoint,
    NamedLine,
    NamedPolygon,
    NamedTerm,
)
from planar_planner.problem.decimals import in_small_units
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Configuration
from planar_planner.version import package_version

Certificate = dict[str, Any]

Pieces = dict[str, list[list[list[float]]]]
"""Convex pieces by the number of their polygon, vertices as [x, y]."""


def make_certificate(
    problem: Problem,
    evidence: NamedEvidence,
    contact_tolerance: float,
    places: int | None = None,
) -> Certificate | None:
    """Build the certificate of an answer from the core's evidence.

    Parameters
    ----------
    problem : Problem
        What was asked, with the start and goal of the query.
    evidence : NamedEvidence
        What the core gives straight after the answer.
    contact_tolerance : float
        The query's.
    places : int, optional
        The core was asked about lengths as decimals of so many places.

    Returns
    -------
    dict or None
        A JSON object; None for an undecided answer.
    """
    if evidence.kind == ClaimKind.NONE:
        return None
    robot, obstacles = _pieces(evidence.robot_pieces), _pieces(evidence.obstacle_pieces)
    certificate: Certificate = {
        keys.FORMAT: keys.FORMAT_NAME,
        keys.VERSION: keys.FORMAT_VERSION,
        keys.MADE_BY: f"planar-planner {package_version()}",
        keys.SCENE: fingerprint(problem),
        keys.VERDICT: keys.PATH if evidence.kind == ClaimKind.PATH else keys.NO_PATH,
        keys.ROBOT_PIECES: robot,
        keys.OBSTACLE_PIECES: obstacles,
    }
    if evidence.outside is not None:
        certificate[keys.OUTSIDE] = evidence.outside
    if evidence.reference is not None:
        certificate[keys.REFERENCE] = evidence.reference
    if places is not None:
        certificate[keys.DECIMAL_PLACES] = places
        problem = in_small_units(problem, places)
    if evidence.kind == ClaimKind.PATH:
        return certificate | _path(problem, evidence, contact_tolerance)
    if evidence.kind == ClaimKind.ODD_CHAIN:
        return certificate | _chain(evidence)
    if evidence.kind == ClaimKind.END:
        return certificate | _end(evidence)
    if evidence.kind == ClaimKind.DISC:
        return certificate | _disc(evidence, obstacles)
    separation = _separation(evidence, robot, obstacles)
    return certificate | {keys.CLAIM: keys.SEPARATION_CLAIM} | separation


def write_certificate(content: Certificate, file: Path, name: str) -> None:
    """Write a certificate to `file`, compressed if `name`, which it will have, ends in ``.gz``."""
    text = json.dumps(content, separators=(",", ":"), allow_nan=False) + "\n"
    data = text.encode()
    if name.endswith(".gz"):
        data = gzip.compress(data, mtime=0)  # the same answer gives the same bytes
    file.write_bytes(data)


def _pieces(polygons: Sequence[NamedPolygon]) -> Pieces:
    return {str(named.polygon): named.pieces for named in polygons}


def _owner(edge: NamedEdge) -> str:
    return keys.OBSTACLE if edge.of_obstacle else keys.ROBOT


def _path(problem: Problem, evidence: NamedEvidence, contact_tolerance: float) -> Certificate:
    last = evidence.waypoints[-1]
    waypoints = [[*waypoint, 0] for waypoint in evidence.waypoints[:-1]]  # no turns
    ends = [(evidence.waypoints[0], problem.start)]
    if isinstance(problem.goal, GoalSet):
        waypoints.append(_turned_into(last, problem.goal, problem.rotation))
    else:
        waypoints.append(_turned_goal(last, problem.goal))
        ends.append((last, problem.goal))
    moved = any((at[0], at[1]) != (end[0], end[1]) for at, end in ends)
    return {
        keys.CONTACT_TOLERANCE: contact_tolerance if moved else 0.0,
        keys.WAYPOINTS: waypoints,
        keys.SEGMENTS: [[_interval(each) for each in segment] for segment in evidence.segments],
    }


def _interval(interval: NamedInterval) -> Certificate:
    apart = [[*each.pair, _owner(each.edge), each.edge.edge] for each in interval.separators]
    content: Certificate = {
        keys.FROM: interval.begin,
        keys.TO: interval.end,
        keys.APART: apart,
    }
    if interval.lines:
        content[keys.ALONG] = [_line(line) for line in interval.lines]
    return content


def _line(line: NamedLine) -> list[Any]:
    return [*line.pair, keys.LEFT if line.obstacle_left else keys.RIGHT]


def _chain(evidence: NamedEvidence) -> Certificate:
    links = [
        {keys.SIDE: keys.WALLS[link.wall]} if link.wall is not None else {keys.PAIR: link.pair}
        for link in evidence.chain
    ]
    return {keys.CLAIM: keys.CHAIN_CLAIM, keys.CHAIN: links}


def _turned_goal(waypoint: Sequence[float], goal: Configuration) -> list[Any]:
    """Write the last angle as the goal's own, which it is up to rounding, and whole turns."""
    turns = round((waypoint[2] - goal[2]) / math.tau)
    return [waypoint[0], waypoint[1], goal[2], turns]


def _turned_into(waypoint: Sequence[float], goal: GoalSet, turning: bool) -> list[Any]:
    """Write the last angle as one of the goal's interval, which it is up to rounding, and turns."""
    x, y, theta = waypoint
    if goal.angles is None or not turning:
        return [x, y, theta, 0]
    turns = round((theta - 0.5 * (goal.angles[0] + goal.angles[1])) / math.tau)
    own = theta if turns == 0 else theta - turns * math.tau
    return [x, y, min(max(own, goal.angles[0]), goal.angles[1]), turns]


def _end(evidence: NamedEvidence) -> Certificate:
    end = keys.GOAL if evidence.goal_end else keys.START
    content: Certificate = {keys.CLAIM: keys.END_CLAIM, keys.END: end}
    if evidence.out_of_bounds:
        return content | {keys.REFERENCE_BOUNDS: True}
    return content | _collision(evidence.collision)


def _disc(evidence: NamedEvidence, obstacles: Pieces) -> Certificate:
    disc = evidence.disc
    return {
        keys.CLAIM: keys.DISC_CLAIM,
        keys.DISC: disc,
        keys.INSIDE: evidence.disc_holder,
    } | _separation(evidence, {"0": [disc]}, obstacles)


def _separation(evidence: NamedEvidence, robot: Pieces, obstacles: Pieces) -> Certificate:
    return {
        keys.DOMAIN: _domain(evidence.domain),
        keys.START_SIDE: evidence.start_side,
        keys.FULL: [_claim(claim, robot, obstacles) for claim in evidence.full],
        keys.FULL_FACES: [_claim(claim, robot, obstacles) for claim in evidence.full_faces],
    }


def _domain(domain: NamedDomain) -> Certificate:
    """Express the core's domain, exact doubles in a frame of its own, in the user's unit."""
    unit = Fraction(2) ** -domain.exponent
    return {
        keys.LOW: [
            _dyadic(Fraction(origin) + Fraction(low) * unit)
            for origin, low in zip(domain.origin, domain.low, strict=True)
        ],
        keys.SIZE: [_dyadic(Fraction(size) * unit) for size in domain.size],
    }


def _dyadic(value: Fraction) -> list[int]:
    """Return [m, e] with value = m 2^e."""
    return [value.numerator, 1 - value.denominator.bit_length()]


def _claim(claim: NamedClaim, robot: Pieces, obstacles: Pieces) -> Certificate:
    joint = claim.joint
    content = {} if joint is not None else _collision(claim.collision)
    content[keys.BOX] = claim.box
    if claim.axis is not None:
        content[keys.AXIS] = claim.axis
    if joint is not None:
        content[keys.JOINT] = _joint(joint, robot, obstacles)
    return content


def _collision(collision: NamedCollision) -> Certificate:
    if collision.wall is not None:
        return {keys.WALL: keys.WALLS[collision.wall]}
    return {keys.PAIR: collision.pair}


def _joint(joint: NamedJoint, robot: Pieces, obstacles: Pieces) -> Certificate:
    axes = [
        {keys.PAIR: each.pair, keys.EDGES: [[_owner(edge), edge.edge] for edge in each.edges]}
        for each in joint.pairs
    ]
    return {keys.AXES: axes, keys.SUMS: [_sum(terms, robot, obstacles) for terms in joint.sums]}


def _sum(terms: Sequence[NamedTerm], robot: Pieces, obstacles: Pieces) -> list[Certificate]:
    """Return the terms with weights that refer to whole edges, the largest of them 1."""
    weights = [_whole_edge_weight(term, robot, obstacles) for term in terms]
    heaviest = max(weights)
    return [_term(term, weight / heaviest) for term, weight in zip(terms, weights, strict=True)]


def _whole_edge_weight(term: NamedTerm, robot: Pieces, obstacles: Pieces) -> float:
    """Turn the core's weight, of a unit normal, into that of a normal as long as the edge."""
    pair = term.of.pair
    if pair is None:
        return term.weight  # a wall's normal is a unit
    p, i, q, j = pair
    piece = obstacles[str(q)][j] if term.edge.of_obstacle else robot[str(p)][i]
    edge = term.edge.edge
    return term.weight / math.dist(piece[edge], piece[(edge + 1) % len(piece)])


def _term(term: NamedTerm, weight: float) -> Certificate:
    content = _collision(term.of)
    if term.of.pair is None:
        return content | {keys.VERTEX: term.wall_vertex, keys.WEIGHT: weight}
    return content | {
        keys.OWNER: _owner(term.edge),
        keys.EDGE: term.edge.edge,
        keys.VERTEX: term.vertex,
        keys.WEIGHT: weight,
    }
