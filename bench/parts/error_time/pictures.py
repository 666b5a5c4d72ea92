"""Error against time for each family, and cells against the logarithm of the distance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lib.pictures import COLOURS as KINDS
from lib.pictures import GREY, PALE, VERDICT_COLOURS, finish, new_panels, save
from lib.pictures import OURS as OURS_COLOUR
from lib.tables import MS
from parts.error_time.curves import Step, decided, error_curve, logarithmic_law
from parts.error_time.sweep import OURS, Point
from parts.error_time.tables import GOAL_ERROR, GOAL_SECONDS, LARGEST, SMALLEST, names, of
from worlds.critical import SIDES

COLUMNS = 4
COLOURS = (*KINDS, GREY)  # then dashes
DASHES = ("-", "--", ":")


def style(planner: str, others: Sequence[str]) -> dict[str, object]:
    """Return how a planner's line looks: ours black and thick."""
    if planner == OURS:
        return {"color": OURS_COLOUR, "linewidth": 2.2, "zorder": 3}
    k = list(others).index(planner)
    colour = COLOURS[k % len(COLOURS)]
    return {"color": colour, "linestyle": DASHES[k // len(COLOURS)], "linewidth": 1.3}


def panels(count: int, height: float = 2.6) -> tuple[Figure, list[Axes]]:
    """Return a figure of so many panels; what is left of its last row stays empty."""
    rows = -(-count // COLUMNS)
    columns = min(COLUMNS, count)
    figure, axes = new_panels(rows, columns, 3.4 * columns, height * rows + 0.7)
    for spare in axes[count:]:
        spare.remove()
    finish(*axes[:count])
    return figure, axes[:count]


def draw_curve(axes: Axes, curve: Sequence[Step], end: float, label: str, **look: Any) -> None:
    """Draw the steps of an error against time: it stays until the next step."""
    if not curve:
        return
    times = [MS * step.seconds for step in curve] + [MS * end]
    errors = [step.error for step in curve] + [curve[-1].error]
    axes.step(times, errors, where="post", label=label, **look)


def error_picture(points: Sequence[Point], planners: Sequence[str], name: str) -> Path:
    """Draw the error of ours and of some other planners against time, a panel a family."""
    families = names(points, "family")
    figure, axes = panels(len(families))
    shown: dict[str, Artist] = {}
    for panel, family in zip(axes, families, strict=True):
        curves = {p: error_curve(of(points, family=family, planner=p)) for p in (OURS, *planners)}
        times = [step.seconds for curve in curves.values() for step in curve]
        end = 2.0 * max(times, default=1.0)
        panel.axhline(GOAL_ERROR, color=PALE, linewidth=1.0, zorder=0)
        panel.axvline(MS * GOAL_SECONDS, color=PALE, linewidth=1.0, zorder=0)
        for planner, curve in curves.items():
            draw_curve(panel, curve, end, planner, **style(planner, planners))
        panel.set(xscale="log", yscale="log", title=family, ylim=(3e-13, 0.5))
        handles, labels = panel.get_legend_handles_labels()
        shown |= zip(labels, handles, strict=True)
    figure.supxlabel("processor time (ms)")
    figure.supylabel("error (relative)")
    figure.legend(
        list(shown.values()), list(shown), loc="outside upper center", ncols=7, frameon=False
    )
    return save(figure, name)


def cells_picture(points: Sequence[Point], name: str) -> Path:
    """Draw ours' cells against the distance, both sides, with the fitted logarithmic law."""
    ours = of(points, planner=OURS)
    families = names(ours, "family")
    figure, axes = panels(len(families))
    for panel, family in zip(axes, families, strict=True):
        for side in SIDES:
            chosen = decided(of(ours, family=family, side=side), 1.0)
            if not chosen:
                continue
            decades = [-math.log10(p.distance) for p in chosen]
            colour = VERDICT_COLOURS[side]
            label = side.replace("_", " ")
            fitted = [p for p in chosen if p.distance > 0.99 * SMALLEST]
            law = logarithmic_law(fitted, LARGEST)
            if law is not None:
                label += f": {law.slope:.0f} a decade, R² {law.r_squared:.2f}"
            panel.plot(decades, [p.count for p in chosen], "o-", ms=3, lw=1, c=colour, label=label)
        panel.set_title(family)
        panel.set_ylim(bottom=0)
        panel.legend(frameon=False, fontsize=7)
    figure.supxlabel("log10 of 1 / relative distance from critical")
    figure.supylabel("cells")
    return save(figure, name)
