"""Error against time, a panel a number of contacts."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from lib.pictures import OURS as OURS_COLOUR
from lib.pictures import VERMILION, finish, new_panels, save

OURS = "ours, eps"
COLOURS = (OURS_COLOUR, VERMILION)
SMALLEST = 1e-12  # errors below are rounding of the true value


class Row(NamedTuple):
    """One method at one setting, over the grasps with so many contacts.

    Attributes
    ----------
    contacts, grasps : int
        How many of each.
    error, largest : float
        Relative errors of d_Q: median and largest.
    milliseconds, lower, upper : float
        For one grasp: median and quartiles of the processor's time.
    """

    contacts: int
    method: str
    grasps: int
    error: float
    largest: float
    milliseconds: float
    lower: float
    upper: float


def draw(rows: Sequence[Row], name: str) -> Path:
    """Draw the largest errors as lines and the medians as dots."""
    counts = sorted({row.contacts for row in rows})
    figure, panels = new_panels(1, len(counts), 3.3 * len(counts), 3.8, sharey=True)
    for axes, count in zip(panels, counts, strict=True):
        for is_ours, colour in zip((True, False), COLOURS, strict=True):
            chosen = [
                r for r in rows if r.contacts == count and r.method.startswith(OURS) == is_ours
            ]
            times = [r.milliseconds for r in chosen]
            label = "ours" if is_ours else "edges, Qhull"
            axes.plot(
                times,
                [max(r.largest, SMALLEST) for r in chosen],
                "o-",
                color=colour,
                markersize=4,
                linewidth=1.4,
                label=f"{label}: largest",
            )
            axes.plot(
                times,
                [max(r.error, SMALLEST) for r in chosen],
                "o:",
                color=colour,
                markersize=3,
                linewidth=1,
                markerfacecolor="white",
                label=f"{label}: median",
            )
            for r in chosen:
                if not is_ours:
                    axes.annotate(
                        r.method.removeprefix("Qhull, ").removesuffix(" edges"),
                        (r.milliseconds, r.largest),
                        textcoords="offset points",
                        xytext=(2, 5),
                        fontsize=7,
                        color=colour,
                    )
        axes.set(xscale="log", yscale="log", xlabel="time (ms)", title=f"{count} contacts")
    panels[0].set_ylabel("relative error of d$_Q$(W)")
    panels[0].legend(frameon=False, fontsize=7)
    finish(*panels)
    return save(figure, name)
