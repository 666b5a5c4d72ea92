"""The picture of ``ompl_compare.py``: our time beside each of OMPL's planners, per scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from lib.pictures import COLOURS, GREY, INK, OURS, finish, new_panels, save
from parts.ompl.table import SOUND, Entry
from planar_planner.ompl.comparison import spread

MS = 1e3
ROW_HEIGHT = 0.28  # inches
MARKERS = {"wheel": "o", "native": "D"}


def draw(found: Sequence[Entry], limit: float, name: str) -> Path:
    """Draw medians, a row a scene. Hollow: less than 95 % of the planner's paths are sound."""
    scenes = list(dict.fromkeys(entry.scene for entry in found))
    planners = list(dict.fromkeys(e.planner for e in found if e.source != "ours"))
    figure, (axes,) = new_panels(1, 1, 9.0, 1.6 + ROW_HEIGHT * len(scenes))
    ceiling = 1.6 * MS * limit
    for entry in found:
        time = min(MS * spread(entry.seconds).median, ceiling)
        row = scenes.index(entry.scene)
        if entry.source == "ours":
            axes.plot(time, row, "*", color=OURS, markersize=9, zorder=3)
            continue
        colour = COLOURS[planners.index(entry.planner) % len(COLOURS)]
        solved = math.isfinite(spread(entry.seconds).median)
        axes.plot(
            time,
            row,
            MARKERS[entry.source] if solved else "x",
            color=colour,
            markersize=5,
            markerfacecolor=colour if entry.sound >= SOUND else "none",
        )
    axes.axvline(MS * limit, color=GREY, linewidth=0.8, linestyle="--")
    axes.set_xscale("log")
    axes.set_xlabel(
        "median time to the first solution, with preparation (ms); crosses: not within the limit"
    )
    axes.set_yticks(range(len(scenes)), scenes, fontsize="small")
    axes.invert_yaxis()
    finish(axes)
    axes.plot([], [], "*", color=OURS, markersize=9, label="ours, certified")
    for k, planner in enumerate(planners):
        axes.plot([], [], "s", color=COLOURS[k % len(COLOURS)], label=planner)
    axes.plot([], [], "o", color=INK, label="wheel, check through Python")
    axes.plot([], [], "D", color=INK, label="native")
    axes.plot([], [], "o", color=INK, markerfacecolor="none", label="< 95 % of paths sound")
    figure.legend(loc="outside right upper", fontsize="small")
    return save(figure, name)
