"""Certificates: the evidence for an answer as a JSON object, and as a file.

The format and what it proves: docs/certificate.md. Checked by `planar_planner.checker`, which
shares nothing with this side.
"""

from __future__ import annotations

import gzip
import json
import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.goal import GoalRegion
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Configuration
from planar_planner.version import package_version

FORMAT = "planar-planner/certificate"
VERSION = 1

Certificate = dict[str, Any]


def make_certificate(
    problem: Problem, evidence: Mapping[str, Any], contact_tolerance: float
) -> Certificate | None:
    """Build the certificate of an answer from the core's evidence.

    Parameters
    ----------
    problem : Problem
        What was asked, with the start and goal of the query.
    evidence : mapping
        Of the core, straight after the answer; its lists become part of the certificate.
    contact_tolerance : float
        Of the query.

    Returns
    -------
    dict or None
        A JSON object; None for an undecided answer.
    """
    kind = evidence["kind"]
    if kind == "none":
        return None
    content: Certificate = {
        "format": FORMAT,
        "version": VERSION,
        "made_by": f"planar-planner {package_version()}",
        "scene": fingerprint(problem),
        "verdict": "path" if kind == "path" else "no_path",
        "robot_pieces": evidence["robot_pieces"],
        "obstacle_pieces": evidence["obstacle_pieces"],
    }
    if "outside" in evidence:
        content["outside"] = evidence["outside"]
    if kind == "path":
        return content | _path(problem, evidence, contact_tolerance)
    if kind == "end":
        return content | _end(evidence)
    return content | _separation(evidence)


def write_certificate(content: Certificate, file: Path, name: str) -> None:
    """Write a certificate to `file`, compressed if `name`, which it will have, ends in ``.gz``."""
    text = json.dumps(content, separators=(",", ":"), allow_nan=False) + "\n"
    data = text.encode()
    if name.endswith(".gz"):
        data = gzip.compress(data, mtime=0)  # the same answer gives the same bytes
    file.write_bytes(data)


def _path(problem: Problem, evidence: Mapping[str, Any], contact_tolerance: float) -> Certificate:
    waypoints = evidence["waypoints"]
    ends = [(waypoints[0], problem.start)]
    if isinstance(problem.goal, GoalRegion):
        waypoints[-1] = _turned_into(waypoints[-1], problem.goal, problem.rotation)
    else:
        waypoints[-1] = _turned_goal(waypoints[-1], problem.goal)
        ends.append((waypoints[-1], problem.goal))
    moved = any((at[0], at[1]) != (end[0], end[1]) for at, end in ends)
    return {
        "contact_tolerance": contact_tolerance if moved else 0.0,
        "waypoints": waypoints,
        "segments": evidence["segments"],
    }


def _turned_goal(waypoint: Sequence[float], goal: Configuration) -> list[Any]:
    """Write the last angle as the goal's own, which it is up to rounding, and whole turns."""
    turns = round((waypoint[2] - goal[2]) / math.tau)
    return [waypoint[0], waypoint[1], goal[2], turns]


def _turned_into(waypoint: Sequence[float], goal: GoalRegion, turning: bool) -> list[Any]:
    """Write the last angle as one of the goal's interval, which it is up to rounding, and turns."""
    x, y, theta = waypoint[:3]
    if goal.angles is None or not turning:
        return [x, y, theta, 0]
    turns = round((theta - 0.5 * (goal.angles[0] + goal.angles[1])) / math.tau)
    own = theta if turns == 0 else theta - turns * math.tau
    return [x, y, min(max(own, goal.angles[0]), goal.angles[1]), turns]


def _end(evidence: Mapping[str, Any]) -> Certificate:
    content: Certificate = {"claim": "end", "end": evidence["end"]}
    if "reference_bounds" in evidence:
        return content | {"reference_bounds": True}
    return content | dict(evidence["witness"])


def _separation(evidence: Mapping[str, Any]) -> Certificate:
    content: Certificate = {"claim": evidence["kind"]}
    robot = evidence["robot_pieces"]
    if evidence["kind"] == "disc":
        content |= {"disc": evidence["disc"], "inside": evidence["inside"]}
        robot = {"0": [evidence["disc"]]}
    for claim in [*evidence["full"], *evidence["full_faces"]]:
        if "joint" in claim:
            _weigh_whole_edges(claim["joint"], robot, evidence["obstacle_pieces"])
    return content | {
        "domain": _domain(evidence["domain"]),
        "start_side": evidence["start_side"],
        "full": evidence["full"],
        "full_faces": evidence["full_faces"],
    }


def _domain(frame: Mapping[str, Any]) -> Certificate:
    """Express the core's domain, exact doubles in a frame of its own, in the user's unit."""
    unit = Fraction(2) ** -frame["exponent"]
    return {
        "low": [
            _dyadic(Fraction(origin) + Fraction(low) * unit)
            for origin, low in zip(frame["origin"], frame["low"], strict=True)
        ],
        "size": [_dyadic(Fraction(size) * unit) for size in frame["size"]],
    }


def _dyadic(value: Fraction) -> list[int]:
    """Return (m, e) with value = m 2^e."""
    return [value.numerator, 1 - value.denominator.bit_length()]


def _weigh_whole_edges(
    joint: Mapping[str, Any], robot: Mapping[str, Any], obstacles: Mapping[str, Any]
) -> None:
    """Turn weights of unit normals, the core's, into weights of whole edges, the largest 1."""
    for terms in joint["sums"]:
        for term in terms:
            if "wall" in term:
                continue
            p, i, q, j = term["pair"]
            piece = obstacles[str(q)][j] if term["owner"] == "obstacle" else robot[str(p)][i]
            edge = term["edge"]
            term["weight"] /= math.dist(piece[edge], piece[(edge + 1) % len(piece)])
        heaviest = max(term["weight"] for term in terms)
        for term in terms:
            term["weight"] /= heaviest
