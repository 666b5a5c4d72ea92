"""A result as text for people."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from planar_planner.planning.outcome import StopReason

if TYPE_CHECKING:
    from planar_planner.planning.result import Result, Statistics

_ALLOW_CONTACT = "--contact-tolerance LENGTH allows it"

HINTS: Mapping[StopReason, str] = {
    StopReason.RESOLUTION: "a smaller --resolution may decide it",
    StopReason.TIGHT_TURN: "a smaller --resolution may decide it, unless it touches",
    StopReason.MAX_CELLS: "a larger --max-cells may decide it",
    StopReason.MAX_MEMORY: "a larger --max-memory may decide it",
    StopReason.TIMEOUT: "a longer --timeout may decide it",
    StopReason.OUT_OF_MEMORY: "a --max-memory below what there is stops in time, and counts",
    StopReason.START_TOUCHES_OBSTACLE: _ALLOW_CONTACT,
    StopReason.START_TOUCHES_WORKSPACE: _ALLOW_CONTACT,
    StopReason.GOAL_TOUCHES_OBSTACLE: _ALLOW_CONTACT,
    StopReason.GOAL_TOUCHES_WORKSPACE: _ALLOW_CONTACT,
}
"""What a user of the command line can do about an undecided query; some reasons have no remedy."""


def statistics(result: Result, *, contact_tolerance: float = 0.0) -> str:
    """Return what was done and what it took; a hint names no option that was given."""
    stats = result.stats
    if result.stop_reason is StopReason.OUT_OF_MEMORY:  # nothing is left to count
        return f"  {_hint_line(result, contact_tolerance)}"
    lines = [
        _hint_line(result, contact_tolerance),
        _path_line(result, stats),
        _cells_line(stats),
        _levels_line(stats),
        _work_line(stats),
        _time_line(stats),
    ]
    return "\n".join(f"  {line}" for line in lines if line)


def _hint_line(result: Result, contact_tolerance: float) -> str:
    hint = "" if result.stop_reason is None else HINTS.get(result.stop_reason, "")
    if hint == _ALLOW_CONTACT and contact_tolerance > 0:
        return f"there is no way out of contact within --contact-tolerance {contact_tolerance:g}"
    return hint


def _path_line(result: Result, stats: Statistics) -> str:
    if result.verdict != "path":
        return ""
    return (
        f"path: length {stats.path_length:.6g}, turning {stats.path_turning:.4g} rad, "
        f"{len(result.path)} waypoints, "
        f"least clearance {stats.least_clearance:.3g}"
    )


def _cells_line(stats: Statistics) -> str:
    parts = ", ".join(f"{count:,} {label}" for label, count in stats.cells_by_label.items())
    return f"cells: {stats.cells:,} ({parts})"


def _levels_line(stats: Statistics) -> str:
    filled = [f"{level}: {count:,}" for level, count in enumerate(stats.cells_by_level) if count]
    return "cells by level: " + ", ".join(filled) if filled else ""


def _work_line(stats: Statistics) -> str:
    return (
        f"work: {stats.probe_checks:,} configurations tried first, "
        f"{stats.labelled_cells:,} cells labelled, "
        f"{stats.separation_evaluations:,} separations, "
        f"{stats.pairs_touched:,} of {stats.pairs_total:,} pairs touched, "
        f"{stats.faces_tested:,} faces, {stats.search_rounds:,} search rounds, "
        f"{stats.memory_bytes / 2**20:.1f} MiB"
    )


def setup_line(reading: float, setup: Mapping[str, float]) -> str:
    """Return what it took to make a planner; `reading` is the time of reading its file."""
    seconds = {**setup, "reading": reading + setup["reading"]}
    parts = ", ".join(f"{name} {1e3 * value:.1f}" for name, value in seconds.items())
    return f"  set-up: {1e3 * sum(seconds.values()):.1f} ms ({parts})"


def _time_line(stats: Statistics) -> str:
    seconds = stats.seconds.to_dict()
    total = seconds.pop("total")
    parts = ", ".join(f"{name} {1e3 * value:.1f}" for name, value in seconds.items())
    return f"time: {1e3 * total:.1f} ms ({parts})"
