"""Certificates: the evidence for an answer as a JSON object, and as a file.

The format and what it proves: docs/certificate.md. Checked by `planar_planner.verify`, which shares
nothing with this side.
"""

from __future__ import annotations

import gzip
import json
import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from planar_planner.fields import Configuration
from planar_planner.fingerprint import fingerprint
from planar_planner.problem import Problem

FORMAT = "planar-planner/certificate"
VERSION = 1

_WALLS = ("x_min", "x_max", "y_min", "y_max")

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
        Of the core, straight after the answer.
    contact_tolerance : float
        Of the query.

    Returns
    -------
    dict or None
        A JSON object; None for an undecided answer.
    """
    from planar_planner import __version__

    kind = evidence["kind"]
    if kind == "none":
        return None
    content: Certificate = {
        "format": FORMAT,
        "version": VERSION,
        "made_by": f"planar-planner {__version__}",
        "scene": fingerprint(problem),
        "verdict": "path" if kind == "path" else "no_path",
        "robot_pieces": _pieces(evidence["robot_pieces"]),
        "obstacle_pieces": _pieces(evidence["obstacle_pieces"]),
    }
    if "outside" in evidence:
        content["outside"] = list(evidence["outside"])
    if kind == "path":
        content |= _path(problem, evidence, contact_tolerance)
    elif kind == "end":
        content |= {"claim": "end", "end": evidence["end"]}
        if "reference_bounds" in evidence:
            content["reference_bounds"] = True
        else:
            content |= _pair(evidence["pair"])
    else:
        content |= _separation(evidence)
    plain: Certificate = _lists(content)
    return plain


def _lists(value: Any) -> Any:
    """Return `value` in JSON's own types: lists instead of tuples."""
    if isinstance(value, dict):
        return {name: _lists(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_lists(item) for item in value]
    return value


def write_certificate(content: Certificate, file: Path, name: str) -> None:
    """Write a certificate to `file`, compressed if `name`, which it will have, ends in ``.gz``."""
    text = json.dumps(content, separators=(",", ":"), allow_nan=False) + "\n"
    data = text.encode()
    if name.endswith(".gz"):
        data = gzip.compress(data, mtime=0)  # the same answer gives the same bytes
    file.write_bytes(data)


def _path(problem: Problem, evidence: Mapping[str, Any], contact_tolerance: float) -> Certificate:
    waypoints = [[x, y, theta, 0] for x, y, theta in evidence["waypoints"]]
    waypoints[-1] = _turned_goal(waypoints[-1], problem.goal)
    ends = [(waypoints[0], problem.start), (waypoints[-1], problem.goal)]
    moved = any((at[0], at[1]) != (end[0], end[1]) for at, end in ends)
    return {
        "contact_tolerance": contact_tolerance if moved else 0.0,
        "waypoints": waypoints,
        "segments": [
            [
                {"from": begin, "to": end, "apart": [[*pair, owner, k] for pair, owner, k in edges]}
                for begin, end, edges in segment
            ]
            for segment in evidence["segments"]
        ],
    }


def _turned_goal(waypoint: Sequence[float], goal: Configuration) -> list[Any]:
    """Write the last angle as the goal's own, which it is up to rounding, and whole turns."""
    turns = round((waypoint[2] - goal[2]) / math.tau)
    return [waypoint[0], waypoint[1], goal[2], turns]


def _separation(evidence: Mapping[str, Any]) -> Certificate:
    content: Certificate = {"claim": evidence["kind"]}
    if evidence["kind"] == "disc":
        content["disc"] = [list(vertex) for vertex in evidence["disc"]]
        content["inside"] = list(evidence["inside"])
        pieces = {(0, 0): content["disc"]}
    else:
        pieces = _by_name(evidence["robot_pieces"])
    obstacles = _by_name(evidence["obstacle_pieces"])
    return content | {
        "domain": _domain(evidence["domain"]),
        "start_side": evidence["start_side"],
        "full": [_claim(claim, pieces, obstacles) for claim in evidence["full"]],
        "full_faces": [_claim(claim, pieces, obstacles) for claim in evidence["full_faces"]],
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


def _claim(
    claim: Mapping[str, Any],
    robot: Mapping[tuple[int, int], Any],
    obstacles: Mapping[tuple[int, int], Any],
) -> Certificate:
    content: Certificate = {"box": claim["box"]}
    if "axis" in claim:
        content["axis"] = claim["axis"]
    if "pair" in claim:
        return content | _pair(claim["pair"])
    terms = [_term(term, robot, obstacles) for term in claim["joint"]]
    heaviest = max(term["weight"] for term in terms)  # only ratios count: one unit for any scene
    content["joint"] = [term | {"weight": term["weight"] / heaviest} for term in terms]
    return content


def _pair(pair: int | Sequence[int]) -> Certificate:
    """Name a pair of pieces, or the wall of that index."""
    return {"wall": _WALLS[pair]} if isinstance(pair, int) else {"pair": list(pair)}


def _term(
    term: Sequence[Any],
    robot: Mapping[tuple[int, int], Any],
    obstacles: Mapping[tuple[int, int], Any],
) -> Certificate:
    """Return a term of a joint claim; the core weighs unit normals, a certificate whole edges."""
    pair, owner, edge, vertex, weight = term
    if isinstance(pair, int):
        return _pair(pair) | {"vertex": list(vertex), "weight": weight}
    p, i, q, j = pair
    piece = obstacles[q, j] if owner == "obstacle" else robot[p, i]
    length = math.dist(piece[edge], piece[(edge + 1) % len(piece)])
    return _pair(pair) | {
        "owner": owner,
        "edge": edge,
        "vertex": vertex,
        "weight": weight / length,
    }


def _pieces(polygons: Mapping[int, Any]) -> Certificate:
    return {str(p): pieces for p, pieces in polygons.items()}


def _by_name(polygons: Mapping[int, Any]) -> dict[tuple[int, int], Any]:
    return {(p, j): piece for p, pieces in polygons.items() for j, piece in enumerate(pieces)}
