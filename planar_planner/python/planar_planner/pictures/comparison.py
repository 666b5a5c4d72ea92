"""The picture of a comparison: time to the first solution of every run, per scene and planner."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.axes import Axes

from planar_planner.errors import cut, one_line
from planar_planner.ompl.comparison import spread
from planar_planner.pictures.style import new_figure, save_picture

if TYPE_CHECKING:
    from planar_planner.ompl.compare import SceneComparison, Settings

OURS = "#000000"
# Okabe and Ito's colours, distinct with any common colour blindness; shapes repeat the distinction.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#F0E442")
MARKERS = ("o", "s", "^", "D", "v", "P", "X")

SCENE_WIDTH = 0.9  # inches
OTHER_WIDTH = 4.5  # inches of the axis and the legend
HEIGHT = 4.5
LIMIT_FACTOR = 1.5  # runs without an answer are drawn this much above the limit


def draw_comparison(
    comparisons: Sequence[SceneComparison],
    settings: Settings,
    file: str | os.PathLike[str],
    suffix: str,
) -> None:
    """Draw medians with quartiles, one column per scene; a cross is a median beyond the limit.

    Parameters
    ----------
    comparisons : sequence of SceneComparison
        At least one comparison.
    settings : Settings
        The settings of all comparisons.
    file : path
        File to write.
    suffix : str
        The format: ``.png``, ``.svg`` or ``.pdf``.
    """
    figure = new_figure(OTHER_WIDTH + SCENE_WIDTH * len(comparisons), HEIGHT)
    axes = figure.add_subplot()
    ours = [
        [run.seconds if run.verdict != "undecided" else math.inf for run in each.ours]
        for each in comparisons
    ]
    count = 1 + len(settings.planners)
    _series(
        axes,
        ours,
        settings,
        _offset(0, count),
        label="ours, certified",
        color=OURS,
        marker="*",
    )
    for k, name in enumerate(settings.planners):
        seconds = [[run.total_seconds for run in each.samplers[name]] for each in comparisons]
        colour, marker = COLOURS[k % len(COLOURS)], MARKERS[k // len(COLOURS) % len(MARKERS)]
        offset = _offset(k + 1, count)
        _series(axes, seconds, settings, offset, label=name, color=colour, marker=marker)
    axes.axhline(1e3 * settings.timeout, color="#888888", linewidth=0.8, linestyle="--")
    axes.set_yscale("log")
    axes.set_ylabel("time to first solution, with preparation (ms)\nmedian and quartiles")
    names = [one_line(cut(each.scene)) for each in comparisons]
    axes.set_xticks(
        range(len(names)),
        names,
        rotation=30,
        rotation_mode="anchor",
        ha="right",
        parse_math=False,
    )
    axes.set_title(
        f"{settings.runs} runs each, OMPL's motion resolution {settings.resolution:g}\n"
        f"crosses: the median run has no answer within {settings.timeout:g} s",
        fontsize="small",
    )
    axes.grid(axis="y", color="#E5E5E5")
    axes.set_axisbelow(True)
    figure.legend(loc="outside right upper", fontsize="small")
    save_picture(figure, file, suffix)


def _offset(k: int, count: int) -> float:
    """Return the offsets that spread the planners of a scene over most of its column."""
    return 0.7 * (k / max(count - 1, 1) - 0.5)


def _series(
    axes: Axes,
    seconds: Sequence[Sequence[float]],
    settings: Settings,
    offset: float,
    **style: Any,
) -> None:
    """Draw a planner: for each scene a marker with a bar, or a cross above the limit."""
    ceiling = LIMIT_FACTOR * 1e3 * settings.timeout
    found = [(i + offset, spread(values)) for i, values in enumerate(seconds)]
    solved = [(x, s) for x, s in found if math.isfinite(s.median)]
    axes.errorbar(
        [x for x, _ in solved],
        [1e3 * s.median for _, s in solved],
        yerr=[
            [1e3 * (s.median - s.lower) for _, s in solved],
            [min(1e3 * s.upper, ceiling) - 1e3 * s.median for _, s in solved],
        ],
        markersize=6,
        linestyle="none",
        elinewidth=1.0,
        **style,
    )
    beyond = [x for x, s in found if math.isinf(s.median)]
    axes.plot(beyond, [ceiling] * len(beyond), "x", color=style["color"], markersize=7)
