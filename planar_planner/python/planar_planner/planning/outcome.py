"""What an answer rests on, as enumerations; the sentences that people read are made here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_planner._core import DecidedBy, StopReason

__all__ = ["DecidedBy", "StopReason", "sentence", "sentence_of"]

PATHS: Mapping[DecidedBy, str] = {
    DecidedBy.STRAIGHT_MOVE: "certified straight move",
    DecidedBy.TWO_LEG_MOVE: "certified two-leg move",
    DecidedBy.DISC: "certified for a disc around the robot",
    DecidedBy.FIRST_TRY: "certified after a guess by RRT-Connect",
    DecidedBy.CHANNEL: "certified through a channel of cells",
    DecidedBy.RIDGE: "certified along the ridge of the clearance",
    DecidedBy.TAUT_PATH: "certified exactly, round the corners of C-obstacles that may be touched",
    DecidedBy.JOINED_LAYERS: "certified exactly where it may touch, without turning there, and "
    "through cells between",
}
"""How a path was found."""

PROOFS: Mapping[DecidedBy, str] = {
    DecidedBy.DISC: "a disc inside the robot has no path",
    DecidedBy.SEPARATION: "cells and faces inside the C-obstacle separate start from goal",
    DecidedBy.ODD_CHAIN: "a closed chain of overlapping C-obstacles separates start from goal",
    DecidedBy.START: "the start is not free",
    DecidedBy.GOAL: "the goal is not free",
}
"""How the absence of a path was proven."""

_TOUCHES = "the {} touches {}: allow it to be moved off by a contact tolerance"

STOPS: Mapping[StopReason, str] = {
    StopReason.RESOLUTION: "resolution reached",
    StopReason.MAX_CELLS: "cell limit reached",
    StopReason.MAX_MEMORY: "memory limit reached",
    StopReason.TIMEOUT: "time limit reached",
    StopReason.INTERRUPTED: "interrupted",
    StopReason.OUT_OF_MEMORY: "out of memory",
    StopReason.START_TOUCHES_OBSTACLE: _TOUCHES.format("start", "an obstacle"),
    StopReason.START_TOUCHES_WORKSPACE: _TOUCHES.format("start", "the workspace"),
    StopReason.GOAL_TOUCHES_OBSTACLE: _TOUCHES.format("goal", "an obstacle"),
    StopReason.GOAL_TOUCHES_WORKSPACE: _TOUCHES.format("goal", "the workspace"),
    StopReason.TIGHT_TURN: "resolution reached; a path would have to turn, or to pass at an angle "
    "that is no quarter turn, in less room than that",
    StopReason.NO_DOUBLES: "a path exists, but none was found whose corners are doubles",
    StopReason.MOVED_ENDS: "no path from where the contact tolerance moved the ends; that proves "
    "nothing of the ends themselves",
    StopReason.NO_EVIDENCE: "an answer was found, but the evidence for it cannot be written: its "
    "room is within rounding",
    StopReason.LOST_CHANNEL: "the channel search lost a channel",
}
"""Why a query stayed undecided."""

LEGS = "; ends in contact are left and reached exactly, without turning"
MOVED = "; ends in contact were moved off within the contact tolerance"


def sentence(
    verdict: str,
    decided_by: DecidedBy | None,
    stop_reason: StopReason | None = None,
    *,
    ends_moved: bool = False,
    exact_legs: bool = False,
) -> str:
    """Return in words what an answer rests on.

    Parameters
    ----------
    verdict : {"path", "no_path", "undecided"}
        The verdict.
    decided_by : DecidedBy or None
        What a path or its absence was shown by.
    stop_reason : StopReason or None
        Why the query stayed undecided.
    ends_moved : bool, optional
        Whether the path has legs that move an end off its contact, within the tolerance.
    exact_legs : bool, optional
        Whether it has legs that lead out of contact exactly.

    Raises
    ------
    ValueError
        If the verdict cannot rest on what is named.
    """
    if verdict == "undecided" and stop_reason is not None:
        return STOPS[stop_reason]
    found = (PATHS if verdict == "path" else PROOFS).get(decided_by) if decided_by else None
    if found is None:
        raise ValueError(f"{verdict} by {decided_by!r}, {stop_reason!r}")
    legs = exact_legs and decided_by is not DecidedBy.JOINED_LAYERS
    return found + (LEGS if legs else "") + (MOVED if ends_moved else "")


def sentence_of(answer: Mapping[str, Any]) -> str:
    """Return `sentence` for the core's answer (`planar_planner.planning.engine.ask`)."""
    return sentence(
        answer["verdict"],
        answer["stats"].decided_by,
        answer["stop_reason"],
        ends_moved=answer["ends_moved"],
        exact_legs=answer["exact_legs"],
    )
