"""The outlines of shapes in their own frame, y downwards."""

from __future__ import annotations

import itertools
import math
import re
import warnings
from collections.abc import Iterator
from typing import Any

from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Piece
from planar_planner.formats.parts import Point
from planar_planner.formats.readers.svg import path_grammar
from planar_planner.formats.readers.svg.lengths import Size, numbers, parsed, stated
from planar_planner.formats.readers.svg.style import Node, Value, Values
from planar_planner.formats.reading import require

SHAPES = ("path", "rect", "circle", "ellipse", "polygon", "polyline", "line")


def runs_of(node: Node, values: Values, size: Size, place: str) -> list[list[Piece]]:
    """Return the pieces of each connected run of a shape, before transforms.

    Parameters
    ----------
    node : Node
        A shape.
    values : Values
        Its properties.
    size : Size
        Size of the nearest viewport, for percentages.
    place : str
        For messages.
    """
    kind = node.local_name
    if kind == "path":
        return _path(node, values, place)
    if kind in ("circle", "ellipse"):
        return _ellipse(kind, values, size, place)
    if kind == "rect":
        return _rectangle(values, size, place)
    if kind == "line":
        a, b = (
            (_attribute(node, f"x{k}", size, place), _attribute(node, f"y{k}", size, place))
            for k in (1, 2)
        )
        return [[curves.straight(a, b)]]
    return _polygon(node, place)


def centre_of(values: Values, size: Size, place: str) -> Point:
    """Return the centre of a circle or ellipse."""
    return stated(values, "cx", size, place) or 0.0, stated(values, "cy", size, place) or 0.0


def _attribute(node: Node, name: str, size: Size, place: str) -> float:
    text = node.etree_element.get(name, "0")
    return parsed(Value(text, css=False), size.base(name), f"{place}, {name}")


def _polygon(node: Node, place: str) -> list[list[Piece]]:
    values = numbers(node.etree_element.get("points") or "", f"{place}, points")
    if len(values) % 2:
        raise SceneError("has an odd number of coordinates", f"{place}, points")
    points = list(zip(values[::2], values[1::2], strict=True))
    closing = points[:1] if node.local_name == "polygon" else []
    run = [curves.straight(a, b) for a, b in itertools.pairwise([*points, *closing])]
    return [run] if run else []


def _path(node: Node, values: Values, place: str) -> list[list[Piece]]:
    data = values.get("d")
    if data is not None and data.text.lower() != "none":
        raise SceneError("d: path data in CSS are not read; use the attribute", place)
    text = "none" if data is not None else node.etree_element.get("d") or ""
    return [] if text.strip() == "none" else list(path_runs(text, place))


def path_runs(text: str, place: str) -> Iterator[list[Piece]]:
    """Yield the pieces of each subpath, parsed one by one: svgpathtools joins those that touch."""
    svgpathtools: Any = require("svgpathtools", "reading SVG", "svg")
    path_grammar.check(text, place)
    current, pending = 0j, ""
    for part in re.split(r"(?=[Mm])", path_grammar.without_empty_arcs(text)):
        pending += part
        if not pending.strip():
            continue
        try:
            with warnings.catch_warnings():  # it warns of arcs of radius zero, which are lines
                warnings.simplefilter("ignore")
                path = svgpathtools.parse_path(pending, current_pos=current)
            pieces = [piece for segment in path for piece in _pieces(segment, svgpathtools)]
        except Exception as error:  # the parser raises many types on broken path data
            reason = cut(" ".join(str(error).split())) or "an arc or curve has no length"
            raise SceneError(f"path data cannot be read: {reason}", place, cut(pending)) from None
        if len(path) == 0:
            continue  # this is a move alone, from which the next relative move starts
        current = path[0].start if pending.rstrip(" \t\r\n,")[-1] in "zZ" else path[-1].end
        pending = ""
        if pieces:
            yield pieces


def _pieces(segment: Any, svgpathtools: Any) -> Iterator[Piece]:
    if isinstance(segment, svgpathtools.Arc):
        yield from _arc(segment)
        return
    points = [_xy(p) for p in segment.bpoints()]
    if len(points) == 2:
        if points[0] != points[1]:
            yield curves.straight(points[0], points[1])
    elif len(set(points)) > 1:
        yield curves.bezier(points)


def _arc(segment: Any) -> Iterator[Piece]:
    """Yield an elliptical arc (SVG 2, appendix B.2), its ends as the file states them."""
    rx, ry = float(segment.radius.real), float(segment.radius.imag)
    turn = math.radians(segment.rotation)
    u = (rx * math.cos(turn), rx * math.sin(turn))
    v = (-ry * math.sin(turn), ry * math.cos(turn))
    begin = math.radians(segment.theta)
    end = begin + math.radians(segment.delta)
    ends = (_xy(segment.start), _xy(segment.end))
    yield from curves.arc(curves.Ellipse(_xy(segment.center), u, v), begin, end, ends)


def _xy(p: complex) -> Point:
    return float(p.real), float(p.imag)


def _ellipse(kind: str, values: Values, size: Size, place: str) -> list[list[Piece]]:
    centre = centre_of(values, size, place)
    if kind == "circle":
        rx = ry = stated(values, "r", size, place)
    else:
        rx, ry = (stated(values, name, size, place) for name in ("rx", "ry"))
        rx, ry = (rx if rx is not None else ry), (ry if ry is not None else rx)
    a, b = rx or 0.0, ry or 0.0
    if a < 0 or b < 0:
        raise SceneError("must not be negative", f"{place}, radius", shown(min(a, b)))
    if a == 0 or b == 0:
        return []
    pieces = curves.arc(curves.Ellipse(centre, (a, 0.0), (0.0, b)), 0.0, math.tau, None)
    return [[*pieces[:-1], (*pieces[-1][:-1], pieces[0][0])]]


def _rectangle(values: Values, size: Size, place: str) -> list[list[Piece]]:
    """Return a rectangle; a negative radius counts as ``auto`` (SVG 2, section 10.2)."""
    x, y, width, height = (
        stated(values, name, size, place) or 0.0 for name in ("x", "y", "width", "height")
    )
    if width <= 0 or height <= 0:
        return []
    radii = [stated(values, name, size, place) for name in ("rx", "ry")]
    rx, ry = (None if radius is not None and radius < 0 else radius for radius in radii)
    rx, ry = (rx if rx is not None else ry), (ry if ry is not None else rx)
    a, b = min(rx or 0.0, width / 2), min(ry or 0.0, height / 2)
    if a == 0 or b == 0:
        points = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
        return [[curves.straight(p, q) for p, q in itertools.pairwise(points)]]
    return [_rounded((x, y, x + width, y + height), a, b)]


def _rounded(box: tuple[float, float, float, float], a: float, b: float) -> list[Piece]:
    """Return a rectangle (x0, y0, x1, y1) with corners of radii a and b."""
    x0, y0, x1, y1 = box
    corners = (  # centre, quarter at which it begins, ends
        ((x1 - a, y0 + b), -1, ((x1 - a, y0), (x1, y0 + b))),
        ((x1 - a, y1 - b), 0, ((x1, y1 - b), (x1 - a, y1))),
        ((x0 + a, y1 - b), 1, ((x0 + a, y1), (x0, y1 - b))),
        ((x0 + a, y0 + b), 2, ((x0, y0 + b), (x0 + a, y0))),
    )
    pieces: list[Piece] = []
    last = (x0 + a, y0)
    for centre, quarter, ends in corners:
        if last != ends[0]:
            pieces.append(curves.straight(last, ends[0]))
        ellipse = curves.Ellipse(centre, (a, 0.0), (0.0, b))
        begin = quarter * math.pi / 2
        pieces += curves.arc(ellipse, begin, begin + math.pi / 2, ends)
        last = ends[1]
    return pieces
