"""From the parts of a file to a scene.

The options supply what a file does not state; one error names everything that is still missing. The
unbounded plane gets bounds that change no verdict. Coordinates stay those of the file, however far
from the origin they are, so that paths and goals are in its frame.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point, Shape
from planar_planner.scene.fields import Box, Configuration
from planar_planner.scene.geojson import named
from planar_planner.scene.import_report import ImportReport
from planar_planner.scene.model import Scene
from planar_planner.scene.plane import bounds_of_plane

FAR = 2.0**20
"""Coordinates that are this many times larger than the scene's extent are worth a note. The core's
error bounds are relative to the largest coordinate, so such a scene is resolved more coarsely."""

_QUADRANGLE = 4
_CARRIES = {
    "path": "a path holds for the curves too, 'no path' only for the flattened outlines",
    "no_path": "a proof of 'no path' holds for the curves too, a path only for the flattened "
    "outlines",
}


def scene_of_parts(parts: Parts, options: ImportOptions, notes: Notes, source: str) -> Scene:
    """Return the scene.

    Raises
    ------
    SceneError
        If robot, start or goal is in neither the parts nor the options; without a source.
    """
    given = replace(
        parts,
        start=_configuration(options.start) or parts.start,
        goal=_configuration(options.goal) or parts.goal,
    )
    _complete(given)
    given = _bounded(_without_copies(given, notes), notes)
    _far(given, notes)
    _counted(given, options, notes)
    if given.holds_for:
        notes.say(_CARRIES[given.holds_for])
    workspace = None if given.workspace is None else as_geojson([given.workspace])
    sentences = [part for part in (given.description, *notes.as_lines()) if part]
    return Scene(
        robot=as_geojson(given.robot or []),
        obstacles=[
            named(as_geojson([shape]), given.obstacle_names.get(i, ""))
            for i, shape in enumerate(given.obstacles)
        ],
        start=given.start or (),
        goal=given.goal or (),
        workspace=given.workspace_box if workspace is None else workspace,
        bounds=given.reference_bounds,
        bounds_are_chosen=given.bounds_are_chosen,
        rotation=given.rotation,
        name=given.name,
        description=" ".join(part if part.endswith(".") else f"{part}." for part in sentences),
        source=source,
        imported=ImportReport(notes.as_lines(), given.holds_for),
    )


def as_geojson(shapes: list[Shape]) -> dict[str, Any]:
    """Return a Polygon, or a MultiPolygon of several shapes, with closed rings."""
    polygons = [[[list(p) for p in (*ring, ring[0])] for ring in shape] for shape in shapes]
    if len(polygons) == 1:
        return {"type": "Polygon", "coordinates": polygons[0]}
    return {"type": "MultiPolygon", "coordinates": polygons}


def _configuration(value: list[float] | None) -> Configuration | None:
    return None if value is None else (value[0], value[1], value[2])


def _complete(parts: Parts) -> None:
    missing = []
    if not parts.robot:
        missing.append("robot: name a file that has one with --robot FILE, or --footprint")
    missing += [
        f"{name}: give it with --{name} X,Y,THETA (theta in radians)"
        for name, value in (("start", parts.start), ("goal", parts.goal))
        if value is None
    ]
    if missing:
        raise SceneError("the file does not state everything; missing " + "; ".join(missing))


def _without_copies(parts: Parts, notes: Notes) -> Parts:
    """Drop obstacles that are equal to an earlier one, which takes over their names."""
    kept: dict[tuple[tuple[Point, ...], ...], tuple[Shape, dict[str, None]]] = {}
    for i, shape in enumerate(parts.obstacles):
        _, names = kept.setdefault(tuple(map(tuple, shape)), (shape, {}))
        if i in parts.obstacle_names:
            names[parts.obstacle_names[i]] = None
    notes.count("copies of other obstacles dropped", len(parts.obstacles) - len(kept))
    different = replace(parts, obstacles=[], obstacle_names={})
    for shape, names in kept.values():
        different.add_obstacles([shape], ", ".join(names))
    return different


def _counted(parts: Parts, options: ImportOptions, notes: Notes) -> None:
    """Say how many things became what, and refuse a plane in which there is nothing to avoid.

    A workspace that is not a quadrangle has walls of its own, so it needs no obstacles.
    """
    obstacles, robot = len(parts.obstacles), len(parts.robot or [])
    notes.say(
        f"{obstacles} obstacle{'s'[obstacles == 1 :]}, robot of {robot} "
        f"polygon{'s'[robot == 1 :]}, {notes.passed_over} of the file's things became nothing"
    )
    walls = parts.workspace is not None and (
        len(parts.workspace) > 1 or len(parts.workspace[0]) > _QUADRANGLE
    )
    if parts.obstacles or walls:
        return
    if not options.allow_empty:
        raise SceneError(
            "the file has no obstacles, and an answer in an empty plane says nothing about it; "
            "--allow-empty takes it as it is" + notes.names_met() + "; ".join(["", *notes.hints])
        )
    notes.say("WARNING: the file has no obstacles" + notes.names_met())


def _far(parts: Parts, notes: Notes) -> None:
    """Say if the coordinates are much larger than the scene; they are planned on as they are."""
    box = _bounds(list(_world_points(parts)))
    extent = max(box[2] - box[0], box[3] - box[1])
    if 0 < extent * FAR <= max(map(abs, box)):
        notes.say(
            "coordinates are a million times larger than the scene and are planned on as they "
            "are; very narrow gaps may stay undecided"
        )


def _world_points(parts: Parts) -> Iterator[Point]:
    for shape in [*parts.obstacles, *([parts.workspace] if parts.workspace else [])]:
        for ring in shape:
            yield from ring
    for box in (parts.workspace_box, parts.reference_bounds):
        if box is not None:
            yield from (box[:2], box[2:])
    for q in (parts.start, parts.goal):
        if q is not None:
            yield q[0], q[1]


def _bounds(points: list[Point]) -> Box:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _bounded(parts: Parts, notes: Notes) -> Parts:
    """Give the unbounded plane bounds for the reference point that change no verdict."""
    if (parts.workspace or parts.workspace_box or parts.reference_bounds) is not None:
        return parts
    radius = max(math.hypot(*p) for shape in parts.robot or [] for p in shape[0])
    bounds = bounds_of_plane(_bounds(list(_world_points(parts))), radius)
    notes.say("the file states no bounds: reference_bounds are chosen so that no verdict changes")
    return replace(parts, reference_bounds=bounds, bounds_are_chosen=True)
