"""The wall of a proof of absence, read from its certificate: the boxes that separate."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from planar_planner.explain.cells import FULL, Cells
from planar_planner.problem.make import Problem


def wall_of(problem: Problem, certificate: Mapping[str, Any]) -> Cells | None:
    """Return the boxes and faces that separate start from goal.

    Parameters
    ----------
    problem : Problem
        What the certificate is about; gives the angle of a robot that may not turn.
    certificate : mapping
        As in `result.certificate` (docs/certificate.md).

    Returns
    -------
    Cells or None
        All FULL; a face is a cell without extent along its normal. Of a disc that stands for the
        robot they hold for every angle. None if the proof is no separation.
    """
    if certificate.get("claim") not in ("separation", "disc"):
        return None
    domain = certificate["domain"]
    low, size = (np.array([math.ldexp(m, e) for m, e in domain[k]]) for k in ("low", "size"))
    lower, upper, levels = [], [], []
    for claim in [*certificate["full"], *certificate["full_faces"]]:
        normal = claim.get("axis")
        first = [k / 2**level for level, k in claim["box"]]
        last = [
            (k if axis == normal else k + 1) / 2**level
            for axis, (level, k) in enumerate(claim["box"])
        ]
        lower.append([*(low + size * first[:2]), math.tau * first[2]])
        upper.append([*(low + size * last[:2]), math.tau * last[2]])
        levels.append([level for level, _ in claim["box"]])
    boxes = Cells(_rows(lower), _rows(upper), np.array(levels, np.uint8), _full(len(lower)))
    return boxes if problem.rotation else _at_angle(boxes, problem.start[2])


def _rows(rows: Sequence[Sequence[float]]) -> Any:
    return np.array(rows, dtype=np.float64).reshape(-1, 3)


def _full(count: int) -> Any:
    return np.full(count, FULL, dtype=np.uint8)


def _at_angle(boxes: Cells, theta: float) -> Cells:
    """Return the boxes at the one angle that the robot has."""
    lower, upper = boxes.lower.copy(), boxes.upper.copy()
    lower[:, 2] = upper[:, 2] = theta
    return Cells(lower, upper, boxes.level.copy(), boxes.label.copy())
