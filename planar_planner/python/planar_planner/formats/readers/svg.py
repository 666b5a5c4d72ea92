"""The reader of SVG drawings: ids, labels and classes state roles, and y is turned upwards.

svgpathtools parses path data and transforms. User units are the scene's unit; the document's width,
height and viewBox are ignored.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats.drawing import Drawing, mark_of, parts_of
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Affine, Outline, Piece
from planar_planner.formats.outlines.figure import EVENODD, NONZERO, Figure
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point
from planar_planner.formats.reading import coordinate, require
from planar_planner.formats.roles import role_of
from planar_planner.formats.xml_tree import parse_xml
from planar_planner.scene.fields import angle as checked_angle

_SHAPES = ("path", "rect", "circle", "ellipse", "polygon", "polyline", "line")
_HIDDEN = ("defs", "symbol", "clipPath", "mask", "marker", "pattern", "metadata", "style", "title")
_MARKS = ("start", "goal", "origin")
_UPWARDS: Affine = (1.0, 0.0, 0.0, -1.0, 0.0, 0.0)
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a drawing."""
    del path
    root = parse_xml(data, "svg")
    require("svgpathtools", "reading SVG", "svg")
    drawing = Drawing(rotation=root.get("data-rotation") != "false")
    _walk(root, _Context((), _UPWARDS, NONZERO), drawing, options, notes)
    return parts_of(drawing, options, notes)


class _Context:
    """What an element inherits from its groups: their names, transform and fill rule."""

    def __init__(self, names: tuple[str, ...], matrix: Affine, rule: str) -> None:
        self.names = names
        self.matrix = matrix
        self.rule = rule

    def within(self, element: ElementTree.Element, place: str) -> _Context:
        """Return the context of an element's children."""
        return _Context(
            (*_names(element), *self.names),
            _product(self.matrix, _transform(element, place)),
            _rule(element) or self.rule,
        )


def _walk(
    element: ElementTree.Element,
    context: _Context,
    drawing: Drawing,
    options: ImportOptions,
    notes: Notes,
) -> None:
    for child in element:
        if not isinstance(child.tag, str) or child.tag in _HIDDEN:
            continue
        place = f"{child.tag} {cut(child.get('id') or '')!r}" if child.get("id") else child.tag
        inner = context.within(child, place)
        if child.tag in ("g", "svg", "a", "switch"):
            _walk(child, inner, drawing, options, notes)
            continue
        role = role_of(inner.names, options.roles)
        if role is None and child.tag in _SHAPES:
            notes.pass_over("elements without a role ignored", inner.names)
        elif role is not None and role != "ignore":
            if child.tag not in _SHAPES:
                raise SceneError(f"cannot be read as {role}; turn it into a path", place)
            _take(child, role, inner, drawing, place)


def _take(
    element: ElementTree.Element, role: str, context: _Context, drawing: Drawing, place: str
) -> None:
    runs = [
        [curves.transformed(piece, context.matrix) for piece in run]
        for run in _runs(element, place)
    ]
    runs = [run for run in runs if run]
    for run in runs:
        for piece in run:
            _check(piece, place)
    if role in _MARKS:
        drawing.mark(role, _mark(element, runs, context.matrix, place), place)
        return
    outlines = tuple(Outline(tuple(_closed(run, place))) for run in runs)
    if not outlines:
        raise SceneError("is empty", place)
    drawing.add(role, Figure(outlines, context.rule, place))


def _check(piece: Piece, place: str) -> None:
    for x, y, w in piece:
        for value in (x / w, y / w):
            coordinate(repr(value), place)


def _mark(
    element: ElementTree.Element, runs: list[list[Piece]], matrix: Affine, place: str
) -> tuple[float, float, float]:
    """Return position and direction; the position is a circle's centre or a line's beginning."""
    if element.tag in ("circle", "ellipse"):
        centre = (_length(element, "cx", place), _length(element, "cy", place))
        points = [curves.first_point(curves.transformed(((*centre, 1.0),), matrix))]
    elif runs:
        points = [curves.first_point(runs[0][0]), curves.last_point(runs[0][-1])]
    else:
        raise SceneError("is empty", place)
    x, y, theta = mark_of(points)
    stated = element.get("data-theta")
    if stated is not None:
        try:
            theta = float(stated)
        except ValueError:
            theta = math.nan
        theta = checked_angle(theta, f"{place}, data-theta")
    return x + 0.0, y + 0.0, theta


def _closed(run: list[Piece], place: str) -> list[Piece]:
    begin, end = curves.first_point(run[0]), curves.last_point(run[-1])
    if begin == end:
        return run
    size = max(max(abs(v) for v in p[:2]) for piece in run for p in piece)
    if math.dist(begin, end) > size * curves.SLACK:
        raise SceneError(f"is open, from {begin!r} to {end!r}; close it with Z", place)
    return [*run, curves.straight(end, begin)]


def _runs(element: ElementTree.Element, place: str) -> Iterator[list[Piece]]:
    """Yield the pieces of each connected run of an element, before transforms."""
    if element.tag == "path":
        yield from _path_runs(element.get("d") or "", place)
    elif element.tag in ("circle", "ellipse"):
        yield _ellipse(element, place)
    elif element.tag == "rect":
        yield from _rectangle(element, place)
    elif element.tag == "line":
        a, b = (
            (_length(element, f"x{k}", place), _length(element, f"y{k}", place)) for k in (1, 2)
        )
        yield [curves.straight(a, b)]
    else:
        words = (element.get("points") or "").replace(",", " ").split()
        if len(words) % 2:
            raise SceneError("has an odd number of coordinates", f"{place}, points")
        numbers = [coordinate(word, f"{place}, points") for word in words]
        points = list(zip(numbers[::2], numbers[1::2], strict=True))
        closing = points[:1] if element.tag == "polygon" else []
        ring = [*points, *closing]
        yield [curves.straight(a, b) for a, b in itertools.pairwise(ring)]


def _path_runs(text: str, place: str) -> Iterator[list[Piece]]:
    """Yield the pieces of each subpath, parsed one by one: svgpathtools joins those that touch."""
    svgpathtools: Any = require("svgpathtools", "reading SVG", "svg")
    current, pending = 0j, ""
    for part in re.split(r"(?=[Mm])", text):
        pending += part
        if not pending.strip():
            continue
        try:
            path = svgpathtools.parse_path(pending, current_pos=current)
            pieces = [piece for segment in path for piece in _pieces(segment, svgpathtools)]
        except Exception as error:  # the parser raises many types on broken path data
            reason = cut(" ".join(str(error).split())) or type(error).__name__
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
    rx, ry = segment.radius.real, segment.radius.imag
    turn = math.radians(segment.rotation)
    u = (rx * math.cos(turn), rx * math.sin(turn))
    v = (-ry * math.sin(turn), ry * math.cos(turn))
    begin = math.radians(segment.theta)
    end = begin + math.radians(segment.delta)
    ends = (_xy(segment.start), _xy(segment.end))
    yield from curves.arc(curves.Ellipse(_xy(segment.center), u, v), begin, end, ends)


def _xy(p: complex) -> Point:
    return float(p.real), float(p.imag)


def _ellipse(element: ElementTree.Element, place: str) -> list[Piece]:
    centre = (_length(element, "cx", place), _length(element, "cy", place))
    if element.tag == "circle":
        rx = ry = _length(element, "r", place)
    else:
        rx, ry = _length(element, "rx", place), _length(element, "ry", place)
    if rx < 0 or ry < 0:
        raise SceneError("must not be negative", f"{place}, radius", shown(min(rx, ry)))
    if rx == 0 or ry == 0:
        return []
    pieces = curves.arc(curves.Ellipse(centre, (rx, 0.0), (0.0, ry)), 0.0, math.tau, None)
    return [*pieces[:-1], (*pieces[-1][:-1], pieces[0][0])]


def _rectangle(element: ElementTree.Element, place: str) -> Iterator[list[Piece]]:
    x, y = _length(element, "x", place), _length(element, "y", place)
    width, height = _length(element, "width", place), _length(element, "height", place)
    if width <= 0 or height <= 0:
        return
    rx, ry = element.get("rx"), element.get("ry")
    rx, ry = (rx if rx is not None else ry), (ry if ry is not None else rx)
    if rx is None or ry is None:
        points = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
        yield [curves.straight(a, b) for a, b in itertools.pairwise(points)]
        return
    a = min(_number(rx, f"{place}, rx"), width / 2)
    b = min(_number(ry, f"{place}, ry"), height / 2)
    yield from _path_runs(
        f"M {x + a!r} {y!r} H {x + width - a!r} A {a!r} {b!r} 0 0 1 {x + width!r} {y + b!r} "
        f"V {y + height - b!r} A {a!r} {b!r} 0 0 1 {x + width - a!r} {y + height!r} "
        f"H {x + a!r} A {a!r} {b!r} 0 0 1 {x!r} {y + height - b!r} "
        f"V {y + b!r} A {a!r} {b!r} 0 0 1 {x + a!r} {y!r} Z",
        place,
    )


def _length(element: ElementTree.Element, name: str, place: str) -> float:
    return _number(element.get(name, "0"), f"{place}, {name}")


def _number(text: str, place: str) -> float:
    return coordinate(text.strip().removesuffix("px"), place)


def _names(element: ElementTree.Element) -> tuple[str, ...]:
    label = element.get(_LABEL)
    own = [element.get("id"), label, *(element.get("class") or "").split()]
    return tuple(name for name in own if name)


def _rule(element: ElementTree.Element) -> str | None:
    """Return the fill rule that an element states, as attribute or in its style."""
    value = element.get("fill-rule")
    for declaration in (element.get("style") or "").split(";"):
        name, _, stated = declaration.partition(":")
        if name.strip() == "fill-rule":
            value = stated.strip()
    return value if value in (EVENODD, NONZERO) else None


def _transform(element: ElementTree.Element, place: str) -> Affine:
    text = element.get("transform")
    if not text:
        return 1.0, 0.0, 0.0, 1.0, 0.0, 0.0
    svgpathtools: Any = require("svgpathtools.parser", "reading SVG", "svg")
    try:
        m = svgpathtools.parse_transform(text, strict=True)
        values = [float(m[i][j]) for j in range(3) for i in range(2)]
    except Exception as error:  # the parser raises many types on a broken transform
        reason = cut(" ".join(str(error).split())) or type(error).__name__
        raise SceneError(f"transform cannot be read: {reason}", place, cut(text)) from None
    if not all(map(math.isfinite, values)):
        raise SceneError("transform must have finite numbers", place, cut(text))
    a, b, c, d, e, f = values
    return a, b, c, d, e, f


def _product(m: Affine, n: Affine) -> Affine:
    """Return the transform that applies n, then m."""
    a, b, c, d, e, f = m
    p, q, r, s, t, u = n
    return (
        a * p + c * q,
        b * p + d * q,
        a * r + c * s,
        b * r + d * s,
        a * t + c * u + e,
        b * t + d * u + f,
    )
