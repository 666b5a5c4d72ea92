"""The bisection: bodies of a family are asked until path and no path are near enough.

Every query narrows the bracket whatever it answers; an undecided one leaves a gap that is then
approached from both sides. What is re-used from one body to the next:

- the path, certified again for the larger body, which spares the query;
- its clearance, which lifts the lower end above the body that was asked about;
- its narrow place, whose clearance is a guess of the margin: two queries beside it often do.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from planar_planner.margins.body import Body, ClaimError, Family, Floats
from planar_planner.planning.decimal_core import rests_on_contact
from planar_planner.planning.engine import Listener, ask, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.outcome import STOPS, DecidedBy, StopReason
from planar_planner.problem.make import Problem
from planar_planner.problem.plane import with_robot

SHARE = 0.5
"""The part of the time left that one query may take: an undecided one leaves some for others."""

MOST_UNDECIDED = 6
"""Undecided queries after which the bracket stands as it is."""

NEAR = 0.7
"""A part of the width asked for: how far on either side of a guess is asked first. The body asked
about is in the middle of that, give or take a tenth, so two that are right leave 0.84 of it."""

FARTHER = 4.0
"""How much farther after a miss, so that a wrong guess costs a logarithm of its error."""

BINDINGS = {DecidedBy.START: "start", DecidedBy.GOAL: "goal"}
"""What the upper end rests on where an end collides; otherwise it rests on the way."""

Guess = Callable[["Bracket"], float | None]
"""Guesses the margin from the path at the lower end, or does not."""

NO_PATH: Floats = np.empty((0, 3))


@dataclass
class Bracket:
    """The state of the bisection.

    Attributes
    ----------
    lower, upper : float
        Margins of a path, and of none.
    path : (N, 3)
        The one at `lower`.
    lower_body, upper_body : Body or None
        For which they were proven; None where something else did.
    binding : str
        What `upper` rests on: "way", "start", "goal" or "none".
    undecided : (float, float) or None
        Margins between which queries were undecided.
    rests_on_contact : bool
        Whether an answer may be another one if lengths change by their rounding.
    """

    lower: float
    upper: float
    path: Floats = field(default_factory=NO_PATH.copy)
    lower_body: Body | None = None
    upper_body: Body | None = None
    binding: str = "none"
    undecided: tuple[float, float] | None = None
    reason: str = ""
    rests_on_contact: bool = False
    counts: dict[str, int] = field(
        default_factory=lambda: dict.fromkeys(
            ("queries", "recertified", "bodies", "undecided", "cells"), 0
        )
    )


class Search:
    """A bracket being narrowed: the problem, its family of bodies, and the limits."""

    def __init__(
        self,
        problem: Problem,
        family: Family,
        options: Options,
        listener: Listener | None,
        *,
        reuse: bool = True,
        guess: Guess | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._problem = problem
        self._family = family
        self._options = options
        self._listener = listener
        self._reuse = reuse
        self._guess = guess if reuse else None
        self._clock = clock
        self._deadline = clock() + options.timeout

    def narrow(self, bracket: Bracket, width: float) -> None:
        """Ask until the bracket is as narrow as `width`, or a limit is reached."""
        self._close_in(bracket, width)
        self._bisect(bracket, width)

    def _close_in(self, bracket: Bracket, width: float) -> None:
        """Ask on both sides of where the last path suggests, farther off after a miss."""
        guess, near = self._guessed(bracket), NEAR * width
        while guess is not None and _is_open(bracket, width) and bracket.undecided is None:
            if bracket.lower < guess - near:
                low, high = guess - near, guess
            elif bracket.upper > guess + near:
                low, high = guess, guess + near
            else:
                return
            before = bracket.counts["bodies"]
            self._ask_between(bracket, low, high, needed=False)
            if bracket.counts["bodies"] == before:
                return
            if bracket.upper < high == guess:
                guess, near = bracket.upper, FARTHER * near
            elif bracket.lower > low == guess:
                guess, near = self._guessed(bracket) or bracket.lower, FARTHER * near

    def _guessed(self, bracket: Bracket) -> float | None:
        """Return a guess within the bracket, or None."""
        if self._guess is None or not len(bracket.path):
            return None
        guess = self._guess(bracket)
        if guess is None or not bracket.lower < guess < bracket.upper:
            return None
        return guess

    def _bisect(self, bracket: Bracket, width: float) -> None:
        while _is_open(bracket, width):
            low, high = _open_part(bracket)
            if high - low < 0.25 * width:
                bracket.reason = _stuck(bracket)
                return
            self._ask_between(bracket, low, high)

    def _ask_between(
        self, bracket: Bracket, low: float, high: float, *, needed: bool = True
    ) -> None:
        """Ask a body between two margins; if there is none that is `needed`, note why."""
        try:
            body = self._family.between(low, high)
        except ClaimError as error:
            bracket.reason = str(error) if needed else bracket.reason
            return
        if not low < body.inner <= body.outer < high:
            bracket.reason = "the width of the bracket is below what rounding allows"
            return
        bracket.counts["bodies"] += 1
        self.ask(bracket, body)

    def look_below(self, bracket: Bracket, width: float) -> None:
        """Ask just below the margin at which an end collides: in open scenes that settles it."""
        if bracket.lower >= self._family.neutral and bracket.upper - bracket.lower > width:
            self._ask_between(bracket, bracket.upper - width, bracket.upper, needed=False)

    def ask(self, bracket: Bracket, body: Body) -> None:
        """Learn from one body: from the last path if that still holds, else from a query."""
        if body.polygons is None:
            _accept(bracket, body.inner, NO_PATH, body)
            return
        problem = with_robot(self._problem, body.polygons)
        core = make_core(problem)
        if self._reuse and len(bracket.path):
            check = core.check_path(np.ascontiguousarray(bracket.path))
            if check["valid"]:
                bracket.counts["recertified"] += 1
                raised = self._family.raised(body, check["least_clearance"])
                _accept(bracket, max(raised, body.inner), bracket.path, body)
                return
        left = self._deadline - self._clock()
        if left <= 0.0:
            bracket.reason = STOPS[StopReason.TIMEOUT]
            return
        limits = replace(self._options, timeout=max(SHARE * left, 1e-3), contact_tolerance=0.0)
        answer = ask(core, problem, limits, self._listener)
        bracket.rests_on_contact = bracket.rests_on_contact or rests_on_contact(answer)
        bracket.counts["queries"] += 1
        bracket.counts["cells"] += answer["stats"].cells
        if answer["verdict"] == "path":
            clearance = core.least_clearance() if self._reuse else 0.0
            raised = self._family.raised(body, clearance)
            _accept(bracket, max(raised, body.inner), np.array(answer["path"]), body)
        elif answer["verdict"] == "no_path":
            by = answer["stats"].decided_by
            bracket.upper, bracket.upper_body = body.outer, body
            bracket.binding = BINDINGS.get(by, "way")
        else:
            self._pass_over(bracket, body, answer["stop_reason"])

    def _pass_over(self, bracket: Bracket, body: Body, reason: StopReason) -> None:
        """Note an undecided body, and go on beside it unless that has been done often enough."""
        bracket.counts["undecided"] += 1
        middle = 0.5 * (body.inner + body.outer)
        low, high = bracket.undecided or (middle, middle)
        bracket.undecided = (min(low, middle), max(high, middle))
        if reason is StopReason.INTERRUPTED or bracket.counts["undecided"] >= MOST_UNDECIDED:
            bracket.reason = STOPS[reason]


def _accept(bracket: Bracket, lower: float, path: Floats, body: Body) -> None:
    if lower > bracket.upper:
        raise RuntimeError(f"proven both: a path at {lower!r}, and none at {bracket.upper!r}")
    bracket.lower = max(lower, bracket.lower)
    bracket.path, bracket.lower_body = path, body


def _is_open(bracket: Bracket, width: float) -> bool:
    return bracket.upper - bracket.lower > width and not bracket.reason


def _open_part(bracket: Bracket) -> tuple[float, float]:
    """Return the larger part of the bracket that no undecided query has touched."""
    if bracket.undecided is None:
        return bracket.lower, bracket.upper
    low = min(bracket.undecided[0], bracket.upper)
    high = max(bracket.undecided[1], bracket.lower)
    below, above = (bracket.lower, low), (high, bracket.upper)
    return below if low - bracket.lower >= bracket.upper - high else above


def _stuck(bracket: Bracket) -> str:
    return f"queries at {bracket.undecided} are undecided within the limits"
