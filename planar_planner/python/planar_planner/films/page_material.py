"""The content of a page, as JSON. Coordinates have nine digits, for drawing; no proof uses them.

The content has no clock times, so the same query gives the same page.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from planar_planner.errors import one_line
from planar_planner.explain.cells import LABEL_COLOURS, LABELS
from planar_planner.films.canvas import check_size
from planar_planner.films.cell_bytes import packed_cells
from planar_planner.films.material import Material
from planar_planner.films.pace import Pace
from planar_planner.pictures.style import BOUNDS, GOAL, MIDWAY, START
from planar_planner.pictures.world import view_box
from planar_planner.planning.path_samples import Floats, reach, travel
from planar_planner.planning.result_text import headline
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Polygons, Problem, ends
from planar_planner.scene.fields import Box

FORMAT = "planar-planner/animation"
VERSION = 1

_DIGITS = 9
_MEANINGS = {
    "FREE": "every placement is free",
    "STAR": "its free part is connected",
    "FULL": "every placement collides",
    "MIXED": "undecided",
}


def encodable(name: str) -> str:
    """Return a name with what UTF-8 cannot hold, such as lone surrogates, escaped."""
    return name.encode("utf-8", "backslashreplace").decode()


def page_material(
    material: Material, pace: Pace, size: tuple[int, int] | None = None
) -> dict[str, Any]:
    """Return the player's input.

    Parameters
    ----------
    material : Material
        The content of the animation.
    pace : Pace
        Gives the speed or the seconds; a page draws as often as the screen and holds no frame.
    size : (width, height), optional
        Largest width of the page and largest height of the views, in CSS pixels.

    Raises
    ------
    OptionsError
        If a side of the size is not between 160 and 4096.
    """
    if size is not None:
        check_size(size)
    problem, result = material.problem, material.result
    both = ends(problem)
    along = travel(result.path, reach(problem.robot)) if len(result.path) else np.empty(0)
    length = float(along[-1]) if len(along) else float(np.pi * 2.0)
    return {
        "format": FORMAT,
        "version": VERSION,
        "name": encodable(problem.name),
        "verdict": headline(result).removeprefix(one_line(f"{problem.name}: ")),
        "rotation": problem.rotation,
        "world": _world(problem, result.path),
        "robot": _rings(problem.robot),
        "start": _rounded(problem.start),
        "goal": _rounded(both["goal"]) if "goal" in both else None,
        "region": None if material.region is None else _region(material.region),
        "path": [_rounded(q) for q in result.path.tolist()],
        "travel": _rounded(along.tolist()),
        "seconds": pace.duration(length),
        "size": size,
        "labels": list(LABELS),
        "meanings": _MEANINGS,
        "colours": {
            "start": START,
            "goal": GOAL,
            "robot": MIDWAY,
            "bounds": BOUNDS,
            **LABEL_COLOURS,
        },
        "cells": packed_cells(material.cells, rotation=problem.rotation),
        "statistics": _statistics(material),
        "note": _note(material),
    }


def _world(problem: Problem, path: Floats) -> dict[str, Any]:
    box, workspace = problem.workspace_box, problem.workspace
    outline = None if workspace is None else _rings(workspace)[0]
    return {
        "workspace": outline if box is None else [_rounded(_outline(box))],
        "bounds": problem.reference_bounds,
        "obstacles": _rings(problem.obstacles),
        "view": view_box(problem, path),
    }


def _region(goal: GoalSet) -> dict[str, Any]:
    """Return where the reference point is to get, or the polygon that it is to get out of."""
    escape = goal.left is not None
    text = "goal: the reference point " + ("leaves this area" if escape else "is in this area")
    if goal.angles is not None:
        text += f", θ in [{goal.angles[0]:.4g}, {goal.angles[1]:.4g}]"
    return {"outline": _rings(goal.left or goal.polygons), "escape": escape, "text": text}


def _rings(polygons: Polygons) -> list[list[list[float]]]:
    """Return one list of rings a polygon; a ring is a flat list of x, y, x, y."""
    rings = polygons.ring_starts.tolist()
    return [
        [_rounded(polygons.coords[rings[r] : rings[r + 1]].ravel().tolist()) for r in range(a, b)]
        for a, b in zip(
            polygons.polygon_starts[:-1].tolist(), polygons.polygon_starts[1:].tolist(), strict=True
        )
    ]


def _outline(box: Box) -> list[float]:
    xmin, ymin, xmax, ymax = box
    return [xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax]


def _rounded(values: Sequence[float]) -> list[float]:
    return [float(f"{value:.{_DIGITS}g}") for value in values]


def _statistics(material: Material) -> list[tuple[str, str]]:
    """Return names and values."""
    stats, path = material.result.stats, material.result.path
    rows: list[tuple[str, str]] = []
    if len(path):
        rows = [
            ("path length", f"{stats.path_length:.6g}"),
            ("turning", f"{stats.path_turning:.4g} rad"),
            ("waypoints", f"{len(path):,}"),
            ("least clearance", f"{stats.least_clearance:.3g}"),
        ]
    rows.append(("cells", f"{stats.cells:,}"))
    rows += [(f"– {name.upper()}", f"{count:,}") for name, count in stats.cells_by_label.items()]
    return [
        *rows,
        ("configurations tried first", f"{stats.probe_checks:,}"),
        ("cells labelled", f"{stats.labelled_cells:,}"),
        ("separations", f"{stats.separation_evaluations:,}"),
        ("faces tested", f"{stats.faces_tested:,}"),
        ("search rounds", f"{stats.search_rounds:,}"),
    ]


def _note(material: Material) -> str:
    """Return the note that says what the cells on the page do not show."""
    notes = []
    if material.result.verdict == "no_path" and not material.second_search:
        notes.append(
            "FULL cells separate start from goal, and so do faces between cells on which every "
            "placement collides; the page does not draw faces."
        )
    if material.second_search and len(material.cells):
        notes.append(
            "The answer uses no cells of the robot itself; the "
            f"{len(material.cells):,} cells shown come from a second search with cells only."
        )
    if not len(material.cells):
        notes.append("There are no cells to show.")
    return " ".join(notes)
