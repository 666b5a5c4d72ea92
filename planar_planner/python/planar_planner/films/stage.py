"""The still part of every film: world, start, goal, title, legend and an empty status line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Annotation

from planar_planner.errors import one_line
from planar_planner.films.canvas import blank_figure
from planar_planner.pictures.goal_region import draw_goal_region
from planar_planner.pictures.style import INK
from planar_planner.pictures.world import draw_ends, draw_world, frame_axes, view_box
from planar_planner.planning.path_samples import Floats
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Problem

LEGEND_FROM = 420  # pixels of width; below this the legend would be wider than the picture


@dataclass(frozen=True, eq=False)
class Stage:
    """A figure with one drawing, its legend entries, and the line under the title.

    Attributes
    ----------
    figure : Figure
        A figure of the requested size in pixels.
    axes : Axes
        The drawing, in scene units.
    keys : list of Artist
        Legend entries of the drawing.
    status : Annotation
        Empty line under the title, for text that changes from frame to frame.
    """

    figure: Figure
    axes: Axes
    keys: list[Artist]
    status: Annotation

    def legend(self, more: Sequence[Artist]) -> None:
        """Draw the legend below the drawing, if the picture is wide enough."""
        width = self.figure.get_figwidth() * self.figure.dpi
        if width >= LEGEND_FROM:
            self.figure.legend(
                handles=[*self.keys, *more],
                loc="outside lower center",
                ncols=4 if width >= 2 * LEGEND_FROM else 3,
                frameon=False,
                fontsize=9,
            )


def make_stage(
    problem: Problem,
    path: Floats,
    title: str,
    size: tuple[int, int],
    region: GoalSet | None = None,
) -> Stage:
    """Draw the still part of a film.

    Parameters
    ----------
    problem : Problem
        The scene, with the query that was answered.
    path : (N, 3)
        Waypoints that the picture must contain; may be empty.
    title : str
        Title, without interpretation of its characters as mathematics.
    size : (width, height)
        In pixels.
    region : GoalSet, optional
        Goal to draw.
    """
    figure = blank_figure(size)
    axes = figure.add_subplot()
    keys = draw_world(axes, problem)
    if region is not None:
        keys += draw_goal_region(axes, region)
    keys += draw_ends(axes, problem)
    frame_axes(axes, view_box(problem, path), outlined=problem.reference_bounds is None)
    text = axes.set_title(f"{_fitting(one_line(title), size[0])}\n", color=INK, fontsize=12)
    text.set_parse_math(False)
    status = axes.annotate(
        "",
        (0.5, 1.0),
        xycoords="axes fraction",
        xytext=(0, 6),
        textcoords="offset points",
        ha="center",
        va="bottom",
        fontsize=10,
        color=INK,
        parse_math=False,
    )
    return Stage(figure, axes, keys, status)


def _fitting(title: str, width: int) -> str:
    """Cut a title to the letters that fit; a letter of 12 points takes 9 pixels on average."""
    room = max(8, width // 9)
    return title if len(title) <= room else f"{title[: room - 1]}…"
