"""What a page shows, as JSON. Coordinates are for drawing: nine digits, and proofs do not use them.

Clock times are left out, so the same query gives the same page.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from planar_planner.cli.report import headline
from planar_planner.errors import one_line
from planar_planner.explain.cells import LABEL_COLOURS, LABELS
from planar_planner.films.canvas import check_size
from planar_planner.films.cell_bytes import packed_cells
from planar_planner.films.material import Material
from planar_planner.films.pace import Pace
from planar_planner.pictures.style import BOUNDS, GOAL, MIDWAY, START
from planar_planner.pictures.world import view_box
from planar_planner.planning.path_samples import Floats, reach, travel
from planar_planner.problem.goal import GoalSet
from planar_planner.problem.make import Polygons, Problem, ends
from planar_planner.scene.fields import Box

FORMAT = "planar-planner/animation"
VERSION = 1

_DIGITS = 9
_MEANINGS = {
    "FREE": "every placement is free",
    "STAR": "its free part hangs together",
    "FULL": "every placement collides",
    "MIXED": "not decided",
}


def page_material(
    material: Material, pace: Pace, size: tuple[int, int] | None = None
) -> dict[str, Any]:
    """Return what the player takes.

    Parameters
    ----------
    material : Material
        What to show.
    pace : Pace
        Its speed or seconds; a page draws as often as the screen, and holds nothing.
    size : (width, height), optional
        The most CSS pixels that the page's width and the views' height may be.

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
        "name": problem.name,
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
    text = "goal: reference point gets " + ("out of here" if escape else "in here")
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
    """Return names and values; what the answer did not count is left out."""
    stats, path = material.result.stats, material.result.path
    rows: list[tuple[str, str]] = []
    if len(path):
        rows = [
            ("path length", f"{stats.get('path_length', 0.0):.6g}"),
            ("turning", f"{stats.get('path_turning', 0.0):.4g} rad"),
            ("waypoints", f"{len(path):,}"),
            ("least clearance", f"{stats.get('least_clearance', 0.0):.3g}"),
        ]
    by_label = stats.get("cells_by_label", {})
    rows += [("cells", f"{stats['cells']:,}")] if "cells" in stats else []
    rows += [(f"– {name.upper()}", f"{count:,}") for name, count in by_label.items()]
    for key, name in (
        ("probe_checks", "configurations tried first"),
        ("labelled_cells", "cells labelled"),
        ("separation_evaluations", "separations"),
        ("faces_tested", "faces tested"),
        ("search_rounds", "search rounds"),
    ):
        if key in stats:
            rows.append((name, f"{stats[key]:,}"))
    return rows


def _note(material: Material) -> str:
    """Return what a reader must know of the cells to take them for no more than they are."""
    notes = []
    if material.result.verdict == "no_path" and not material.second_search:
        notes.append(
            "Between start and goal lie FULL cells, and faces of cells on which every placement "
            "collides; faces are not drawn."
        )
    if material.second_search and len(material.cells):
        notes.append(
            "The answer rests on no cells of the robot itself; the "
            f"{len(material.cells):,} shown are those of a second search, by cells only."
        )
    if not len(material.cells):
        notes.append("There are no cells to show.")
    return " ".join(notes)
