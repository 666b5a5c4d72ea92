"""From a shape with a role to figures and marks of the drawing; what is not read is refused."""

from __future__ import annotations

import math

from planar_planner.errors import SceneError
from planar_planner.formats.drawing import mark_of
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Outline, Piece
from planar_planner.formats.outlines.figure import EVENODD, NONZERO, Figure
from planar_planner.formats.readers.svg.document import Context, Document
from planar_planner.formats.readers.svg.paint import Paint, fill_of, has_marker, stroke_of
from planar_planner.formats.readers.svg.shapes import centre_of, runs_of
from planar_planner.formats.readers.svg.style import Node, word_of
from planar_planner.formats.reading import coordinate
from planar_planner.scene.fields import angle as checked_angle
from planar_planner.scene.input_limits import MAX_COORDINATE, MIN_COORDINATE

_MARKS = ("start", "goal", "origin")
_SOLID = ("obstacle", "robot")
"""Roles whose area is what a viewer paints; a workspace may be a frame that is not painted."""


def take(document: Document, node: Node, context: Context, role: str, place: str) -> None:
    """Add a shape to the drawing.

    Raises
    ------
    SceneError
        If it is open without fill, or if an effect changes its area that is not read.
    """
    runs = [
        [curves.transformed(piece, context.matrix) for piece in run]
        for run in runs_of(node, context.values, context.size, place)
    ]
    for piece in (piece for run in runs for piece in run):
        _check(piece, place)
    if role in _MARKS:
        document.drawing.mark(role, _mark(node, runs, context, place), place)
        return
    if context.effect:
        raise SceneError(f"{context.effect}: changes what is shown and is not read", place)
    filled = _is_filled(document, node, context, role, place)
    if filled is None:
        return
    runs = [run for run in runs if _has_area(run)]
    if not runs:
        document.notes.pass_over("elements without area are left out")
        return
    for clip in context.clips:
        if not all(clip.holds(piece) for run in runs for piece in run):
            raise SceneError("is cut off by a nested svg or symbol, which is not read", place)
    outlines = tuple(Outline(tuple(_closed(document, run, filled, place))) for run in runs)
    rule = EVENODD if word_of(context.values, "fill-rule", NONZERO) == EVENODD else NONZERO
    document.drawing.add(role, Figure(outlines, rule, place))


def _is_filled(
    document: Document, node: Node, context: Context, role: str, place: str
) -> bool | None:
    """Return whether a viewer fills a shape; None if it shows nothing of it."""
    notes, values = document.notes, context.values
    stroked = stroke_of(values) is Paint.SEEN
    if node.local_name == "line":
        if stroked or role not in _SOLID:
            raise SceneError("is a line without area; draw its outline", place)
        notes.pass_over("elements that a viewer does not show are left out")
        return None
    if role not in _SOLID:
        return "fill" not in values or values["fill"].text.lower() != "none"
    filled = fill_of(values, document.ids, document.sheet, place) is Paint.SEEN
    if not filled and not stroked:
        notes.pass_over("elements that a viewer does not show are left out")
        return None
    if has_marker(values) and node.local_name not in ("rect", "circle", "ellipse"):
        notes.count("markers at the vertices of outlines are ignored")
    if filled and stroked:
        notes.count("outlines taken without the width of their strokes")
    elif stroked:
        notes.count("outlines without fill taken with their inside, without their stroke's width")
    return filled


def _check(piece: Piece, place: str) -> None:
    for x, y, w in piece:
        for value in (x / w, y / w):
            if value != 0 and not MIN_COORDINATE <= abs(value) <= MAX_COORDINATE:
                coordinate(repr(float(value)), place)


def _mark(
    node: Node, runs: list[list[Piece]], context: Context, place: str
) -> tuple[float, float, float]:
    """Return position and direction; the position is a circle's centre or a line's beginning."""
    if node.local_name in ("circle", "ellipse"):
        centre = centre_of(context.values, context.size, place)
        point = curves.transformed(((*centre, 1.0),), context.matrix)
        _check(point, place)
        points = [curves.first_point(point)]
    elif runs:
        points = [curves.first_point(runs[0][0]), curves.last_point(runs[0][-1])]
    else:
        raise SceneError("is empty", place)
    x, y, theta = mark_of(points)
    stated = node.etree_element.get("data-theta")
    if stated is not None:
        try:
            theta = float(stated)
        except ValueError:
            theta = math.nan
        theta = checked_angle(theta, f"{place}, data-theta")
    return x + 0.0, y + 0.0, theta


def _has_area(run: list[Piece]) -> bool:
    """Return whether a run has three different control points; fewer bound nothing."""
    return len({point for piece in run for point in piece}) >= 3


def _closed(document: Document, run: list[Piece], filled: bool, place: str) -> list[Piece]:
    """Return a closed run; a viewer's fill closes it by a straight line (SVG 2, section 13.3.1)."""
    begin, end = curves.first_point(run[0]), curves.last_point(run[-1])
    if begin == end:
        return run
    size = max(max(abs(v) for v in p[:2]) for piece in run for p in piece)
    if math.dist(begin, end) > size * curves.SLACK:
        if not filled:
            raise SceneError(
                f"is open, from {begin!r} to {end!r}, and has no fill; close it with Z", place
            )
        document.notes.count("open outlines closed by a straight line, as a viewer fills them")
    return [*run, curves.straight(end, begin)]
