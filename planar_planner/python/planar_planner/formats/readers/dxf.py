"""The reader of DXF drawings, by ezdxf: layers state roles, and blocks are expanded.

Lines, arcs and splines of a layer are joined to closed outlines. If outlines on a layer lie inside
each other, every second one is a hole.
"""

from __future__ import annotations

import io
import itertools
import math
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.drawing import DEFAULT_TOLERANCE, Drawing, mark_of, parts_of
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.chaining import Run, closed_outlines, nested_figures
from planar_planner.formats.outlines.curves import Ellipse, Piece
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point
from planar_planner.formats.reading import coordinate, require
from planar_planner.formats.roles import role_of
from planar_planner.tolerances import JOIN_REACH

_MAX_DEPTH = 16  # depth of blocks in blocks
_MAX_ENTITIES = 10**6
_MARKS = ("start", "goal", "origin")
_SILENT = ("TEXT", "MTEXT", "DIMENSION", "LEADER", "VIEWPORT", "HATCH", "ATTDEF")


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a drawing."""
    del path
    ezdxf: Any = require("ezdxf", "reading DXF", "dxf")
    try:
        document = ezdxf.read(_stream(data))
        entities = list(itertools.islice(_entities(document.modelspace(), "0", 0), _MAX_ENTITIES))
        return _parts(entities, options, notes)
    except SceneError:
        raise
    except Exception as error:  # ezdxf raises many types on a broken file
        reason = cut(" ".join(str(error).split())) or type(error).__name__
        raise SceneError(f"cannot be read as DXF: {reason}") from None


def _stream(data: bytes) -> io.TextIOBase:
    if data.startswith(b"AutoCAD Binary DXF"):
        raise SceneError("is binary DXF; save it as text (ASCII) DXF")
    try:
        return io.StringIO(data.decode("utf-8-sig").replace("\r\n", "\n"))
    except UnicodeDecodeError:
        return io.StringIO(data.decode("cp1252", errors="replace").replace("\r\n", "\n"))


def _entities(layout: Iterable[Any], layer: str, depth: int) -> Iterator[tuple[str, Any]]:
    """Yield (layer, entity) with blocks expanded; layer 0 in a block is its insertion's layer."""
    for entity in layout:
        own = entity.dxf.get("layer", "0")
        own = layer if own == "0" and depth else own
        if entity.dxftype() != "INSERT":
            yield own, entity
        elif depth >= _MAX_DEPTH:
            raise SceneError("has blocks nested too deeply", f"layer {cut(own)!r}")
        else:
            yield from _entities(entity.virtual_entities(), own, depth + 1)


def _parts(entities: list[tuple[str, Any]], options: ImportOptions, notes: Notes) -> Parts:
    drawing = Drawing()
    runs: dict[tuple[str, str], list[Run]] = {}
    for layer, entity in entities:
        role = role_of([layer], options.roles)
        if role is None:
            notes.pass_over("entities on layers without a role ignored", [layer])
        elif role == "ignore" or entity.dxftype() in _SILENT:
            continue
        elif role in _MARKS:
            place = _place(layer, entity)
            x, y, theta = mark_of(_mark_points(entity, place))
            drawing.mark(role, (x, y, theta), place)
        else:
            run = _run(entity, _place(layer, entity))
            if run:
                runs.setdefault((role, layer), []).append(run)
    extent = _extent(runs)
    tolerance = options.tolerance or DEFAULT_TOLERANCE * extent
    for (role, layer), own in runs.items():
        place = f"layer {cut(layer)!r}"
        outlines = closed_outlines(own, JOIN_REACH * extent, place, notes)
        for figure in nested_figures(outlines, tolerance, place):
            drawing.add(role, figure)
    return parts_of(drawing, options, notes)


def _extent(runs: dict[tuple[str, str], list[Run]]) -> float:
    points = [
        (x / w, y / w) for own in runs.values() for run in own for piece in run for x, y, w in piece
    ]
    if not points:
        return 1.0
    xs, ys = zip(*points, strict=True)
    return max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0


def _place(layer: str, entity: Any) -> str:
    handle = entity.dxf.get("handle")
    return f"layer {cut(layer)!r}, {entity.dxftype()}" + (f" {handle}" if handle else "")


def _mark_points(entity: Any, place: str) -> list[Point]:
    kind = entity.dxftype()
    if kind == "POINT":
        return [_xy(entity.dxf.location)]
    if kind == "CIRCLE":
        return [_xy(entity.ocs().to_wcs(entity.dxf.center))]
    run = _run(entity, place)
    if not run:
        raise SceneError("cannot be a mark; use a point, a circle or a line", place)
    return [curves.first_point(run[0]), curves.last_point(run[-1])]


def _run(entity: Any, place: str) -> Run:
    """Return the pieces of an entity in order, with every number checked."""
    kind = entity.dxftype()
    reader = {
        "LINE": _line,
        "LWPOLYLINE": _polyline,
        "POLYLINE": _polyline,
        "CIRCLE": _circle,
        "ARC": _circular_arc,
        "ELLIPSE": _elliptical_arc,
        "SPLINE": _spline,
    }.get(kind)
    if reader is None:
        raise SceneError("is a kind of entity that is not read; turn it into polylines", place)
    run = list(reader(entity, place))
    for piece in run:
        for x, y, w in piece:
            for value in (x / w, y / w):
                coordinate(repr(value), place)
    return run


def _xy(p: Any) -> Point:
    return float(p.x), float(p.y)


def _segment(a: Point, b: Point) -> Iterator[Piece]:
    if a != b:
        yield curves.straight(a, b)


def _line(entity: Any, place: str) -> Iterator[Piece]:
    del place
    yield from _segment(_xy(entity.dxf.start), _xy(entity.dxf.end))


def _flat(entity: Any, place: str) -> Any:
    """Return the entity's coordinate system if it lies in the plane, from above or below."""
    ocs = entity.ocs()
    if abs(ocs.uz.z) != 1.0:
        raise SceneError("does not lie in the x–y plane", place)
    return ocs


def _polyline(entity: Any, place: str) -> Iterator[Piece]:
    ocs = _flat(entity, place)
    if entity.dxftype() == "LWPOLYLINE":
        corners = [(ocs.to_wcs((x, y, 0)), b) for x, y, b in entity.get_points("xyb")]
        closed = bool(entity.closed)
    else:
        if not (entity.is_2d_polyline or entity.is_3d_polyline):
            raise SceneError("is a mesh, not an outline", place)
        corners = [(ocs.to_wcs(v.dxf.location), v.dxf.get("bulge", 0.0)) for v in entity.vertices]
        closed = bool(entity.is_closed)
    mirror = ocs.uz.z  # arcs that are seen from below turn the other way
    following = [*corners[1:], *(corners[:1] if closed else [])]
    for (p, bulge), (q, _) in zip(corners, following, strict=False):
        a, b = _xy(p), _xy(q)
        if a != b:
            yield from _bulged(a, b, float(bulge) * mirror)


def _bulged(a: Point, b: Point, bulge: float) -> Iterator[Piece]:
    """Yield the arc from a to b that turns by 4·atan(bulge), anticlockwise if positive."""
    if bulge == 0:
        yield curves.straight(a, b)
        return
    turn = 4 * math.atan(bulge)
    # the centre is to the left of the chord's middle by (1 − bulge²)/(4·bulge) chords
    up = (1 - bulge * bulge) / (4 * bulge)
    centre = (
        (a[0] + b[0]) / 2 - up * (b[1] - a[1]),
        (a[1] + b[1]) / 2 + up * (b[0] - a[0]),
    )
    radius = math.dist(centre, a)
    begin = math.atan2(a[1] - centre[1], a[0] - centre[0])
    ellipse = Ellipse(centre, (radius, 0.0), (0.0, radius))
    yield from curves.arc(ellipse, begin, begin + turn, (a, b))


def _circle_of(entity: Any, place: str) -> Ellipse:
    ocs = _flat(entity, place)
    radius = float(entity.dxf.radius)
    if not 0 < radius < math.inf:
        raise SceneError("must be positive", f"{place}, radius", repr(radius))
    centre = _xy(ocs.to_wcs(entity.dxf.center))
    return Ellipse(centre, _xy(ocs.to_wcs((radius, 0, 0))), _xy(ocs.to_wcs((0, radius, 0))))


def _circle(entity: Any, place: str) -> Iterator[Piece]:
    yield from _whole(_circle_of(entity, place), 0.0)


def _whole(ellipse: Ellipse, begin: float) -> Iterator[Piece]:
    pieces = curves.arc(ellipse, begin, begin + math.tau, None)
    yield from pieces[:-1]
    yield (*pieces[-1][:-1], pieces[0][0])


def _circular_arc(entity: Any, place: str) -> Iterator[Piece]:
    begin, end = float(entity.dxf.start_angle), float(entity.dxf.end_angle)
    ellipse = _circle_of(entity, place)
    turn = (end - begin) % 360.0
    if turn == 0:
        yield from _whole(ellipse, math.radians(begin))
    else:
        begin = math.radians(begin % 360.0)
        yield from curves.arc(ellipse, begin, begin + math.radians(turn), None)


def _elliptical_arc(entity: Any, place: str) -> Iterator[Piece]:
    _flat(entity, place)
    ellipse = Ellipse(_xy(entity.dxf.center), _xy(entity.dxf.major_axis), _xy(entity.minor_axis))
    area = ellipse.u[0] * ellipse.v[1] - ellipse.u[1] * ellipse.v[0]
    if area == 0 or not math.isfinite(area):
        raise SceneError("has no area", place)
    begin, end = float(entity.dxf.start_param), float(entity.dxf.end_param)
    turn = (end - begin) % math.tau
    if turn < curves.SLACK or math.tau - turn < curves.SLACK:
        yield from _whole(ellipse, begin)
    else:
        yield from curves.arc(ellipse, begin, begin + turn, None)


def _spline(entity: Any, place: str) -> Iterator[Piece]:
    """Yield the Bézier curves of a spline; weights are a third coordinate."""
    math_module: Any = require("ezdxf.math", "reading DXF", "dxf")
    points = [_xy(math_module.Vec3(p)) for p in entity.control_points]
    if not points:
        raise SceneError("has no control points; turn it into a spline that has them", place)
    weights = [float(w) for w in entity.weights] or [1.0] * len(points)
    if len(weights) != len(points) or not all(0 < w < math.inf for w in weights):
        raise SceneError("must have one positive weight per control point", place)
    spline = math_module.BSpline(
        [(x * w, y * w, w) for (x, y), w in zip(points, weights, strict=True)],
        order=int(entity.dxf.degree) + 1,
        knots=list(entity.knots) or None,
    )
    if not spline.is_clamped:
        raise SceneError("does not end at its control points; turn it into a clamped one", place)
    for controls in spline.bezier_decomposition():
        piece = tuple((float(p.x), float(p.y), float(p.z)) for p in controls)
        if len(set(piece)) > 1:
            yield piece
