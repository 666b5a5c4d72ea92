"""A result as text for people."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from planar_planner.errors import one_line
from planar_planner.planning.outcome import StopReason

if TYPE_CHECKING:
    from planar_planner.planning.result import Result

_HEADLINES = {
    "path": "path found",
    "no_path": "no path, proven",
    "undecided": "undecided",
}

_ALLOW_CONTACT = "--contact-tolerance LENGTH allows it"

HINTS: Mapping[StopReason, str] = {
    StopReason.RESOLUTION: "a smaller --resolution may decide it",
    StopReason.CELLS: "a larger --max-cells may decide it",
    StopReason.MEMORY: "a larger --max-memory may decide it",
    StopReason.TIME: "a longer --timeout may decide it",
    StopReason.OUT_OF_MEMORY: "a --max-memory below what there is stops in time, and counts",
    StopReason.START_TOUCHES_OBSTACLE: _ALLOW_CONTACT,
    StopReason.START_TOUCHES_WORKSPACE: _ALLOW_CONTACT,
    StopReason.GOAL_TOUCHES_OBSTACLE: _ALLOW_CONTACT,
    StopReason.GOAL_TOUCHES_WORKSPACE: _ALLOW_CONTACT,
}
"""What a user of the command line can do about an undecided query; some reasons have no remedy."""


def headline(result: Result, paint: Callable[[str], str] = str) -> str:
    """Return the verdict in one line; `paint` may colour its words."""
    reason = one_line(f" ({result.reason})") if result.reason else ""
    return f"{one_line(result.scene)}: {paint(_HEADLINES[result.verdict])}{reason}"


def statistics(result: Result) -> str:
    """Return what was done and what it took; a statistic that the core left out is left out."""
    stats = result.stats
    if result.stop_reason is StopReason.OUT_OF_MEMORY:  # nothing is left to count
        return f"  {_hint_line(result)}"
    lines = [
        _hint_line(result),
        _path_line(result, stats),
        _cells_line(stats),
        _levels_line(stats),
        _work_line(stats),
        _time_line(stats),
    ]
    return "\n".join(f"  {line}" for line in lines if line)


def _hint_line(result: Result) -> str:
    return "" if result.stop_reason is None else HINTS.get(result.stop_reason, "")


def _path_line(result: Result, stats: Mapping[str, Any]) -> str:
    if result.verdict != "path":
        return ""
    turning = f", turning {stats['path_turning']:.4g} rad" if "path_turning" in stats else ""
    return (
        f"path: length {stats.get('path_length', 0.0):.6g}{turning}, {len(result.path)} waypoints, "
        f"least clearance {stats.get('least_clearance', 0.0):.3g}"
    )


def _cells_line(stats: Mapping[str, Any]) -> str:
    labels = stats.get("cells_by_label", {})
    parts = ", ".join(f"{count:,} {label}" for label, count in labels.items())
    return f"cells: {stats.get('cells', 0):,}" + (f" ({parts})" if parts else "")


def _levels_line(stats: Mapping[str, Any]) -> str:
    levels = stats.get("cells_by_level", [])
    filled = [f"{level}: {count:,}" for level, count in enumerate(levels) if count]
    return "cells by level: " + ", ".join(filled) if filled else ""


def _work_line(stats: Mapping[str, Any]) -> str:
    return (
        f"work: {stats.get('probe_checks', 0):,} configurations tried first, "
        f"{stats.get('labelled_cells', 0):,} cells labelled, "
        f"{stats.get('separation_evaluations', 0):,} separations, "
        f"{stats.get('pairs_touched', 0):,} of {stats.get('pairs_total', 0):,} pairs touched, "
        f"{stats.get('faces_tested', 0):,} faces, {stats.get('search_rounds', 0):,} search rounds, "
        f"{stats.get('memory_bytes', 0) / 2**20:.1f} MiB"
    )


def _time_line(stats: Mapping[str, Any]) -> str:
    seconds = dict(stats.get("seconds", {}))
    if "total" not in seconds:
        return ""
    total = seconds.pop("total")
    parts = ", ".join(f"{name} {1e3 * value:.1f}" for name, value in seconds.items())
    return f"time: {1e3 * total:.1f} ms ({parts})"
