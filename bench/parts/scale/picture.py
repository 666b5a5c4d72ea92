"""The picture of ``bench/scale.py``: a panel for each thing that grows."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.ticker import NullFormatter

from lib.pictures import COLOURS, finish, new_panels, save
from parts.scale.repeated import Repeated

Points = Sequence[tuple[float, Mapping[str, Any]]]
HEADROOM = 5.0  # above the curves, for the legend
PANELS = (  # title, families by the beginning of their names
    ("number of obstacles", ("fixed channel", "growing channel", "field", "irrelevant")),
    ("robot's pieces", ("robot",)),
    ("side of a maze", ("maze",)),
    ("1 / critical clearance", ("corner", "gear")),
)
QUANTITIES: tuple[tuple[str, Callable[[Mapping[str, Any]], float]], ...] = (
    ("core time (ms)", lambda p: 1e3 * sorted(p["seconds"])[len(p["seconds"]) // 2]),
    ("labelled cells", lambda p: float(p["labelled_cells"])),
)


def draw(found: Mapping[str, Points], repeats: Sequence[Repeated], name: str) -> Path:
    """Draw into ``bench/results/``: time above, work below; repeated queries on the right."""
    columns = len(PANELS) + 1
    figure, panels = new_panels(2, columns, 17, 6.4)
    grid = (panels[:columns], panels[columns:])
    for column, (title, prefixes) in enumerate(PANELS):
        names = [family for family in found if family.startswith(prefixes)]
        for row, (label, quantity) in enumerate(QUANTITIES):
            axes = grid[row][column]
            _draw_growth(axes, {family: found[family] for family in names}, quantity)
            axes.set_ylabel(label)
            axes.set_xlabel(title)
        low, high = grid[0][column].get_ylim()
        grid[0][column].set_ylim(low, HEADROOM * high)
        grid[0][column].legend(frameon=False, fontsize=7, loc="upper left", ncols=2)
    _draw_repeated(grid[0][-1], repeats, [lambda r: r.kept, lambda r: r.fresh])
    grid[0][-1].set_ylabel("time of a query (ms)\nsolid: kept planner, dotted: fresh ones")
    _draw_cells(grid[1][-1], repeats)
    finish(*panels)
    return save(figure, name)


def _draw_growth(
    axes: Axes, found: Mapping[str, Points], quantity: Callable[[Mapping[str, Any]], float]
) -> None:
    for number, (name, points) in enumerate(found.items()):
        decided = [(x, quantity(p)) for x, p in points if p["verdict"] in ("path", "no_path")]
        decided = [(x, y) for x, y in decided if y > 0]
        colour = COLOURS[number % len(COLOURS)]
        axes.loglog(
            [x for x, _ in decided],
            [y for _, y in decided],
            "o-",
            markersize=3,
            linewidth=1,
            color=colour,
            label=name,
        )
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_formatter(NullFormatter())


def _draw_repeated(
    axes: Axes, repeats: Sequence[Repeated], series: Sequence[Callable[[Repeated], list[float]]]
) -> None:
    for colour, each in zip(COLOURS, repeats, strict=False):
        for style, of in zip(("-", ":"), series, strict=True):
            times = [1e3 * t for t in of(each)]
            axes.semilogy(range(1, len(times) + 1), times, style, color=colour, label=each.scene)
    axes.set_xlabel("number of the query")


def _draw_cells(axes: Axes, repeats: Sequence[Repeated]) -> None:
    for colour, each in zip(COLOURS, repeats, strict=False):
        axes.plot(range(1, len(each.cells) + 1), each.cells, color=colour, label=each.scene)
    axes.set_xlabel("number of the query")
    axes.set_ylabel("cells of the kept planner")
    axes.legend(frameon=False, fontsize=7)
