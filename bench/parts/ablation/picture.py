"""The picture of ``bench/ablation.py``: what each query culls, what each part is worth."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from matplotlib.axes import Axes

from lib.pictures import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    finish,
    new_panels,
    save,
)
from parts.ablation.culling import QUERIES, Culling
from parts.ablation.variants import ABLATIONS, CELLS, Outcome

COLOURS = (GREY, ORANGE, SKY, BLUE, GREEN, PURPLE)  # of the queries, in their order
FEWEST_CELLS = 30  # in C-obstacle: a ratio of fewer says nothing
PUBLISHED_RATIO = 75.21


def draw(cullings: Sequence[Culling], outcomes: dict[str, list[Outcome]], name: str) -> Path:
    """Draw the picture into ``bench/results/``."""
    figure, (left, right) = new_panels(1, 2, 12, 5, width_ratios=(3, 2))
    _draw_culling(left, [c for c in cullings if c.walk != "search" and c.obstacle >= FEWEST_CELLS])
    _draw_ablations(right, outcomes)
    finish(left, right)
    return save(figure, name)


def _draw_culling(axes: Axes, cullings: Sequence[Culling]) -> None:
    """Draw a point for each scene and query."""
    for colour, (query, label) in zip(COLOURS, QUERIES.items(), strict=True):
        places = range(len(cullings))
        axes.plot(
            places,
            [100.0 * (c.ratio(query) or 0.0) for c in cullings],
            "o",
            color=colour,
            markersize=5,
            label=label,
        )
    axes.axhline(PUBLISHED_RATIO, color=GREY, linewidth=0.8, linestyle="--")
    axes.text(0, PUBLISHED_RATIO + 0.7, "published, their gear", fontsize=7, color=GREY)
    axes.set_xticks(range(len(cullings)), [c.scene for c in cullings], rotation=90, fontsize=7)
    axes.set_ylabel("cells in C-obstacle identified (%)")
    axes.set_title("Cell culling ratio, octree of the published method", fontsize=9)
    axes.legend(frameon=False, fontsize=7, loc="lower right")


def _draw_ablations(axes: Axes, outcomes: dict[str, list[Outcome]]) -> None:
    """Draw a point for each scene and variant: labelled cells over those of all parts."""
    names = [variant.name for variant in ABLATIONS if variant != CELLS]
    for scene in outcomes.values():
        by_name = {o.variant.name: o for o in scene}
        whole = by_name[CELLS.name]
        for decided, marker, colour in ((True, "o", BLUE), (False, ">", VERMILION)):
            chosen = [
                (by_name[name].work / max(whole.work, 1), place)
                for place, name in enumerate(names)
                if by_name[name].decided == decided and whole.work > 0
            ]
            axes.plot(
                [x for x, _ in chosen],
                [y for _, y in chosen],
                marker,
                color=colour,
                markersize=4,
                alpha=0.6,
                linestyle="none",
            )
    axes.set_xscale("log")
    axes.axvline(1.0, color=GREY, linewidth=0.8)
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.invert_yaxis()
    axes.set_xlabel("labelled cells, relative (arrows: undecided at the limit)")
    axes.set_title("Without a part: a point for each shipped scene", fontsize=9)
