"""DISP and the bounds of the generalized distance D_g between two configurations."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterator
from decimal import Decimal
from functools import partial

import numpy as np

import pdg
from oracles.exact.depths import exact_displacement
from oracles.placing import Array, Pose, placed
from parts.depth_accuracy.bodies import oval
from parts.depth_accuracy.common import ALLOWED, UNIT, Row, in_microseconds, timed

TURNS = (0.0, 1e-6, 0.1, 0.5, 1.0, 2.0, 3.0)
EXACT = 20  # configurations for each turn that are compared with 50 places


def rows(seed: int, count: int) -> Iterator[Row]:
    """Yield DISP's error, and the width of the bounds of D_g, for growing turns.

    The upper bound may exceed the lower one by a factor of sqrt(2 - (2 sin(turn / 2) / turn)^2) at
    most (docs/pdg.md; no closed form of D_g is known).
    """
    random = np.random.default_rng(seed)
    body = oval(random, 12)
    pieces = pdg.convex_pieces(body)
    for turn in TURNS:
        ends = [_ends(random, turn) for _ in range(count)]
        units, errors = [], []
        for q0, q1 in ends[:EXACT]:
            truth = exact_displacement(body, q0, q1)
            off = abs(Decimal(pdg.displacement(pieces, q0, q1)) - truth)
            scale = max(np.abs(placed(body, q)).max() for q in (q0, q1))
            units.append(float(off) / (UNIT * scale))
            errors.append(float(off / truth))
        yield Row(
            "DISP",
            f"turn {turn:g}",
            "pdg.displacement",
            statistics.median(errors),
            max(errors),
            *in_microseconds(timed(partial(pdg.displacement, pieces, *q)) for q in ends[:50]),
            max(units) <= ALLOWED,
            f"off by up to {max(units):.1f} roundings",
        )
        bounds = [pdg.generalized_distance_bracket(pieces, q0, q1) for q0, q1 in ends]
        widths = [bracket.upper / bracket.lower - 1 for bracket in bounds]
        most = math.sqrt(2 - (2 * math.sin(0.5 * turn) / turn) ** 2) - 1 if turn else 0.0
        yield Row(
            "D_g",
            f"turn {turn:g}",
            "upper over lower, less 1",
            statistics.median(widths),
            max(widths),
            *in_microseconds(
                timed(partial(pdg.generalized_distance_bracket, pieces, *q)) for q in ends[:50]
            ),
            min(widths) >= 0
            and all(
                width <= most + _outward(body, *q, bracket.lower)
                for width, bracket, q in zip(widths, bounds, ends, strict=True)
            ),
            f"at most {most:.3g} is proven",
        )


def _ends(random: np.random.Generator, turn: float) -> tuple[Pose, Pose]:
    """Return two configurations that differ by a turn and a random shift."""
    x, y, dx, dy = (float(v) for v in random.uniform(-2, 2, 4))
    theta = float(random.uniform(-3, 3))
    return (x, y, theta), (x + dx, y + dy, theta + turn)


def _outward(body: Array, q0: Pose, q1: Pose, lower: float) -> float:
    """Return what rounding outward adds to a width at most (docs/rounding.md, "D_g").

    Either bound gives way by DISP's error, 16 u of the lengths, up to three times, at most 1.3 of
    it relative to `lower`, and by three paddings of 32 u.
    """
    radius = float(np.hypot(*body.T).max())
    lengths = math.hypot(*q0[:2]) + math.hypot(*q1[:2]) + radius * (1 + abs(q0[2]) + abs(q1[2]))
    return UNIT * (128 * lengths / lower + 256)
