"""A family's critical parameter, bracketed by asking the planner."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from lib.timing import Measured, measure
from planar_planner import Options
from scenarios.model import Scene


@dataclass(frozen=True)
class Bisection:
    """A parameter's bracket: no path at `blocked`, a path at `passing`; and each decision made."""

    blocked: float
    passing: float
    decisions: list[tuple[float, Measured]]

    @property
    def slowest(self) -> tuple[float, Measured]:
        """The decision with the largest median of core time."""
        return max(self.decisions, key=lambda decision: decision[1].core.median)


def bisect(
    make: Callable[[float], Scene],
    blocked: float,
    passing: float,
    width: float,
    *,
    repetitions: int = 5,
    options: Options | None = None,
) -> Bisection:
    """Halve a bracket until it is narrower than `width`; raise if a decision stays undecided."""
    decisions = []
    while abs(passing - blocked) > width:
        middle = 0.5 * (blocked + passing)
        measured = measure(make(middle), options, most=repetitions)
        decisions.append((middle, measured))
        if measured.result.verdict == "undecided":
            raise RuntimeError(f"undecided at {middle!r}: {measured.result.reason}")
        if measured.result.verdict == "path":
            passing = middle
        else:
            blocked = middle
    return Bisection(blocked, passing, decisions)
