"""Bounds of PD^g along the motions of ``bench/depth_models.py``, as in section 7 of the paper."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import shapely

import pdg
from lib.timing import Spread, repetitions
from worlds.bodies.paper_models import Model

BUDGET = 1.0  # seconds of repetitions for each figure
FEWEST, MOST = 5, 2000
TOLERANCE = 1e-3  # of the bracket, relative
# Rounding of bodies of size 10 in plain doubles (length): `lo` is rounded down, `lb` is not.
ROUNDING = 1e-12
ORDER = ("lb", "lo", "hi", "best", "ub1", "ub2")


class Sample(NamedTuple):
    """Bounds of PD^g under DISP (length) at one configuration.

    Attributes
    ----------
    model : str
    t : float
        Where on the motion, from 0 to 1.
    x, y, theta : float
        The configuration.
    lb, lo, hi, best, ub1, ub2 : float
        Lower bound by pieces; the bracket, to `TOLERANCE`; upper bounds: UB1 drawn back, by
        separators, by hulls.
    source : str
        What UB1 comes from.
    free_x, free_y, free_theta : float
        The free configuration that shows UB1.
    """

    model: str
    t: float
    x: float
    y: float
    theta: float
    lb: float
    lo: float
    hi: float
    best: float
    ub1: float
    ub2: float
    source: str
    free_x: float
    free_y: float
    free_theta: float


class Cost(NamedTuple):
    """A row of the table: what the bodies consist of, and milliseconds for one query.

    Medians and quartiles: of the bounds over repetitions of the whole motion, of the bracket over
    its configurations.
    """

    model: str
    vertices_a: int
    vertices_b: int
    pieces_a: int
    pieces_b: int
    separators: int
    lb: float
    lb_lower: float
    lb_upper: float
    ub1: float
    ub1_lower: float
    ub1_upper: float
    ub2: float
    ub2_lower: float
    ub2_upper: float
    bracket: float
    bracket_lower: float
    bracket_upper: float


@dataclass(frozen=True)
class Prepared:
    """A model's bodies, decomposed once."""

    model: Model
    moving: pdg.ConvexPieces
    fixed: pdg.ConvexSeparators

    @classmethod
    def of(cls, model: Model) -> Prepared:
        """Decompose both bodies and enumerate the fixed one's separators."""
        return cls(model, pdg.convex_pieces(model.moving), pdg.convex_separators(model.fixed))


def samples(prepared: Prepared, count: int) -> Iterator[Sample]:
    """Yield the bounds at evenly spaced configurations of the motion."""
    A, B = prepared.moving, prepared.fixed
    poses: pdg.Rows = prepared.model.configurations(count).tolist()
    lower = pdg.generalized_depth_lower_bound(A, B.pieces, poses)
    first = pdg.generalized_depth_upper_bound(A, B, poses)
    best = pdg.generalized_depth_upper_bound(A, B, poses, method="best")
    second = pdg.generalized_depth_upper_bound(A, B, poses, method="hulls")
    brackets = pdg.generalized_depth_bracket(A, B, poses, TOLERANCE)
    for k, (x, y, theta) in enumerate(poses):
        free_x, free_y, free_theta = first.placement.pose[k].tolist()
        yield Sample(
            prepared.model.name,
            k / (count - 1),
            x,
            y,
            theta,
            float(lower.lower[k]),
            float(brackets.lower[k]),
            float(brackets.upper[k]),
            float(best.upper[k]),
            float(first.upper[k]),
            float(second.upper[k]),
            str(first.placement.source[k]),
            free_x,
            free_y,
            free_theta,
        )


def cost(prepared: Prepared, count: int) -> Cost:
    """Time each bound over the whole motion, bodies prepared, and divide by its configurations."""
    A, B = prepared.moving, prepared.fixed
    poses = prepared.model.configurations(count)

    def milliseconds(call: Callable[[], object]) -> tuple[float, float, float]:
        return _milliseconds([seconds / count for seconds in _seconds(call)])

    return Cost(
        prepared.model.name,
        _vertices(prepared.model.moving),
        _vertices(prepared.model.fixed),
        len(A),
        len(B.pieces),
        len(B),
        *milliseconds(lambda: pdg.generalized_depth_lower_bound(A, B.pieces, poses)),
        *milliseconds(lambda: pdg.generalized_depth_upper_bound(A, B, poses)),
        *milliseconds(lambda: pdg.generalized_depth_upper_bound(A, B, poses, method="hulls")),
        *_milliseconds(
            [_once(partial(pdg.generalized_depth_bracket, A, B, q, TOLERANCE)) for q in poses]
        ),
    )


def broken(sample: Sample) -> str:
    """Return which promise does not hold at a sample, or an empty string."""
    for low, high in pairwise(ORDER):
        if not getattr(sample, low) <= getattr(sample, high) + ROUNDING:
            return f"{low} > {high}"
    return ""


def _seconds(call: Callable[[], object]) -> Iterator[float]:
    for _ in repetitions(BUDGET, FEWEST, MOST):
        yield _once(call)


def _once(call: Callable[[], object]) -> float:
    began = time.process_time()
    call()
    return time.process_time() - began


def _milliseconds(seconds: Sequence[float]) -> tuple[float, float, float]:
    spread = Spread.of([1e3 * s for s in seconds])
    return spread.median, spread.lower, spread.upper


def _vertices(body: shapely.Polygon) -> int:
    return sum(len(ring.coords) - 1 for ring in (body.exterior, *body.interiors))
