"""As Fig. 4 of [GFE]: the bracket and the root of the time against the iterations."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lib.pictures import BLUE, GREEN, VERMILION, new_panels, save

LOWER, UPPER, TIME = BLUE, VERMILION, GREEN


class Growth(NamedTuple):
    """One run of the algorithm.

    Attributes
    ----------
    title : str
        Situation and set.
    lower, upper : ndarray of shape (K + 1,)
        d_k and the least h_A/h_Q seen, after k iterations.
    facets : ndarray of shape (K + 1,)
        Numbers of facets of the polytope.
    counts, seconds : ndarray of shape (n,)
        Least processor seconds of runs that stop after so many iterations.
    exponent : float
        Slope of log(time) against log(iterations) over the last three quarters of the counts.
    """

    title: str
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    facets: NDArray[np.float64]
    counts: NDArray[np.float64]
    seconds: NDArray[np.float64]
    exponent: float


def draw(runs: Sequence[Growth], name: str) -> Path:
    """Draw a panel a run; the published figure has the same two curves."""
    columns = (len(runs) + 1) // 2
    figure, panels = new_panels(2, columns, 3.7 * columns, 6.2)
    for spare in panels[len(runs) :]:
        spare.remove()
    for k, (axes, run) in enumerate(zip(panels, runs, strict=False)):
        axes.plot(run.upper, color=UPPER, linewidth=1, label="upper bound")
        axes.plot(run.lower, color=LOWER, linewidth=1.5, label="$d_k$, lower bound")
        top = 2 * float(run.lower[-1])
        axes.set(ylim=(0, top), xlabel="iterations", title=run.title)
        axes.spines["top"].set_visible(False)
        other = axes.twinx()
        other.plot(
            run.counts, np.sqrt(1e3 * run.seconds), "o-", color=TIME, markersize=3, linewidth=1
        )
        other.set_ylim(bottom=0)
        other.spines["top"].set_visible(False)
        other.set_ylabel(r"$\sqrt{t / \mathrm{ms}}$", color=TIME)
        axes.text(
            0.97,
            0.05,
            f"time ~ iterations$^{{{run.exponent:.2f}}}$",
            transform=axes.transAxes,
            ha="right",
            fontsize=8,
            color=TIME,
        )
        if k == 0:
            axes.legend(frameon=False, fontsize=8, loc="upper left", bbox_to_anchor=(0.2, 1.0))
    return save(figure, name)
