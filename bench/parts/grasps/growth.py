"""How the bracket narrows and the time grows with the iterations, in (b2), (e2), (h) and (a1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from parts.depth_accuracy.common import timed
from parts.grasps.picture_growth import Growth
from parts.grasps.situations import SITUATIONS
from pdg.grasp import WrenchSet, active_wrench_set, force_efficiency, grasp_wrench_set

SHOWN = ("b2", "e2", "h")
COUNTS = 16
REPETITIONS = 15
LONGER = 10  # by which the eps of the last run is smaller
HEADER = ("run", "iterations", "lower", "upper", "facets", "milliseconds", "exponent")


def runs(eps: float) -> Iterator[Growth]:
    """Yield W of each situation of Fig. 4, then W^a of each; last a longer run, of (a1)."""
    chosen = [s for s in SITUATIONS if s.name in SHOWN]
    for situation in chosen:
        yield run(f"({situation.name}) W", grasp_wrench_set(situation.contacts()), eps)
    for situation in chosen:
        active = active_wrench_set(situation.hand())
        if active is not None:
            yield run(f"({situation.name}) W$^a$", active, eps)
    yield run("(a1) W", grasp_wrench_set(SITUATIONS[0].contacts()), eps / LONGER)


def run(title: str, wrenches: WrenchSet, eps: float) -> Growth:
    """Record one run, then time runs that stop earlier."""
    whole = force_efficiency(wrenches, None, eps, history=True).distance
    steps = np.array(whole.history)
    counts = np.unique(np.linspace(1, whole.iterations, COUNTS).astype(int))
    seconds = np.array(
        [
            timed(
                partial(force_efficiency, wrenches, None, eps, max_iterations=int(k)), REPETITIONS
            )
            for k in counts
        ]
    )
    late = counts >= counts[-1] / 4
    exponent = float(np.polyfit(np.log(counts[late]), np.log(seconds[late]), 1)[0])
    lower, upper, facets = steps.T
    return Growth(title, lower, upper, facets, counts.astype(float), seconds, exponent)


def rows(found: Sequence[Growth]) -> Iterator[tuple[object, ...]]:
    """Yield the timed steps of each run."""
    for one in found:
        for k, seconds in zip(one.counts, one.seconds, strict=True):
            at = min(int(k), len(one.lower) - 1)
            facets = int(one.facets[at])
            yield (
                one.title,
                int(k),
                one.lower[at],
                one.upper[at],
                facets,
                1e3 * seconds,
                one.exponent,
            )
