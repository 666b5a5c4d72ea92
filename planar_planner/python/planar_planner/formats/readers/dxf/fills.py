"""What DXF drawings show filled: hatches, solids, and polylines with a width."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.chaining import Joining, closed_outlines
from planar_planner.formats.outlines.curves import Affine, Ellipse, Outline, Piece, whole_ellipse
from planar_planner.formats.outlines.figure import Figure
from planar_planner.formats.outlines.nesting import Nesting, nested_figures
from planar_planner.formats.outlines.strands import Run, Strand, Traced
from planar_planner.formats.parts import Notes, Point
from planar_planner.formats.readers.dxf.entities import (
    Vertex,
    arc_of_bulge,
    bulged,
    flat_frame,
    spline_pieces,
    through,
    vertices_of,
    xy,
)

HATCHES = ("HATCH", "MPOLYGON")
SOLIDS = ("SOLID", "TRACE")
POLYLINES = ("LWPOLYLINE", "POLYLINE")


def has_width(entity: Any, place: str) -> bool:
    """Return whether an entity is a polyline that is drawn with a width."""
    if entity.dxftype() not in POLYLINES:
        return False
    if entity.dxftype() == "POLYLINE" and not entity.is_2d_polyline:
        return False
    return any(begin or end for _, _, begin, end in vertices_of(entity, place)[0])


# ---- solids -----------------------------------------------------------------------------------


def solid(entity: Any, place: str) -> Outline:
    """Return a SOLID or TRACE, whose third and fourth corners are stored in reverse order."""
    ocs = flat_frame(entity, place)
    stored = [xy(ocs.to_wcs(entity.dxf.get(f"vtx{k}", entity.dxf.vtx2))) for k in range(4)]
    return _polygon([stored[0], stored[1], stored[3], stored[2]])


def _polygon(corners: Sequence[Point]) -> Outline:
    ring = [p for p, q in zip(corners, [*corners[1:], corners[0]], strict=True) if p != q]
    return Outline(
        tuple(curves.straight(a, b) for a, b in zip(ring, ring[1:] + ring[:1], strict=True))
    )


# ---- polylines with a width -------------------------------------------------------------------


def bands(entity: Any, place: str) -> Iterator[Outline]:
    """Yield the parts of the band that a polyline with a width is drawn as; they overlap.

    An arc is a band between two arcs. Straight parts meet in mitres.
    """
    vertices, closed = vertices_of(entity, place)
    following = [*vertices[1:], *(vertices[:1] if closed else [])]
    segments = [(a, b[0]) for a, b in zip(vertices, following, strict=False) if a[0] != b[0]]
    for start, end in segments:
        yield _arc_band(start, end, place) if start[1] else _polygon(_corners(start, end))
    joints = list(zip(segments, segments[1:] + segments[: 1 if closed else 0], strict=False))
    for (a, p), (b, q) in joints:
        if a[1] == 0 and b[1] == 0:
            yield from _mitre(_corners(a, p), _corners(b, q), p)


def _corners(start: Vertex, end: Point) -> list[Point]:
    """Return the corners of a straight part: left begin, left end, right end, right begin."""
    (x, y), _, begin_width, end_width = start
    length = math.dist((x, y), end)
    nx, ny = (y - end[1]) / length, (end[0] - x) / length
    left, right = begin_width / 2, end_width / 2
    return [
        (x + nx * left, y + ny * left),
        (end[0] + nx * right, end[1] + ny * right),
        (end[0] - nx * right, end[1] - ny * right),
        (x - nx * left, y - ny * left),
    ]


def _mitre(before: list[Point], after: list[Point], joint: Point) -> Iterator[Outline]:
    """Yield what fills the outside of a bend between two straight parts."""
    turn = _cross(_minus(before[1], before[0]), _minus(after[1], after[0]))
    if turn == 0:
        return
    outside = (before[3], before[2], after[3], after[2]) if turn > 0 else (*before[:2], *after[:2])
    a, b, c, d = outside  # along the outside of the first part, then of the second
    u, v = _minus(b, a), _minus(d, c)
    across = _cross(u, v)
    tip = []
    if across != 0:
        share = _cross(_minus(c, b), v) / across
        p = b[0] + share * u[0], b[1] + share * u[1]
        if share >= 0 and math.dist(p, joint) <= _MITRE_LIMIT * math.dist(b, joint):
            tip = [p]
    yield _polygon([joint, b, *tip, c])


_MITRE_LIMIT = 4.0
"""Longest mitre, in half widths: bends sharper than 29 degrees are cut off, as viewers do."""


def _minus(p: Point, q: Point) -> Point:
    return p[0] - q[0], p[1] - q[1]


def _cross(p: Point, q: Point) -> float:
    return p[0] * q[1] - p[1] * q[0]


def _arc_band(start: Vertex, q: Point, place: str) -> Outline:
    p, bulge, begin_width, end_width = start
    if begin_width != end_width:
        raise SceneError("has an arc whose width changes; turn it into outlines", place)
    circle, begin, turn = arc_of_bulge(p, q, bulge)
    radius = circle.u[0]
    sides: list[list[Piece]] = []
    for share in (1 + begin_width / 2 / radius, 1 - begin_width / 2 / radius):
        if share < 0:
            raise SceneError("has an arc wider than its circle; turn it into outlines", place)
        if share == 0:
            sides.append([])  # the band reaches the centre
            continue
        side = Ellipse(circle.centre, (radius * share, 0.0), (0.0, radius * share))
        sides.append(curves.arc(side, begin, begin + turn, None))
    outer, inner = sides
    back: list[Piece] = [curves.reversed_piece(piece) for piece in reversed(inner)]
    first, last = curves.first_point(outer[0]), curves.last_point(outer[-1])
    if back:
        joint = curves.straight(last, curves.first_point(back[0]))
        end = curves.straight(curves.last_point(back[-1]), first)
        return Outline((*outer, joint, *back, end))
    centre = circle.centre
    return Outline((*outer, curves.straight(last, centre), curves.straight(centre, first)))


# ---- hatches ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Tracing:
    """Lengths in the drawing's unit: see `Joining` and `Nesting`."""

    reach: float
    tolerance: float
    join: float | None


def hatch_runs(entity: Any, place: str) -> list[list[Run]]:
    """Return the runs of each boundary of a hatch that its style shows."""
    ocs = flat_frame(entity, place)
    mirror: Affine = (ocs.uz.z, 0.0, 0.0, 1.0, 0.0, 0.0)
    style = int(entity.dxf.get("hatch_style", 0))
    shown = list(entity.paths.rendering_paths(style)) or list(entity.paths)
    return [
        [
            [curves.transformed(piece, mirror) if ocs.uz.z < 0 else piece for piece in run]
            for run in _boundary(path, place)
            if run
        ]
        for path in shown
    ]


def hatch_figures(
    boundaries: Sequence[Sequence[Run]], place: str, how: Tracing, notes: Notes
) -> Iterator[Figure]:
    """Yield the figures that the boundaries of a hatch make; one inside another is a hole."""
    joining = Joining(how.reach, how.join, place)
    traced: list[Traced] = []
    for boundary in boundaries:
        strands = [Strand(run, "its boundary") for run in boundary]
        traced += closed_outlines(strands, joining, notes)
    nameless = [Traced(item.outline, ()) for item in traced]
    if nameless:
        yield from nested_figures(nameless, Nesting(how.tolerance, how.reach, place), notes)


def _boundary(path: Any, place: str) -> Iterator[Run]:
    if hasattr(path, "vertices"):
        corners = [((float(x), float(y)), float(bulge)) for x, y, bulge in path.vertices]
        run: Run = []
        for (a, bulge), (b, _) in zip(corners, corners[1:] + corners[:1], strict=True):
            if a != b:
                run += bulged(a, b, bulge)
        yield run
        return
    for edge in path.edges:
        yield list(_edge(edge, place))


def _edge(edge: Any, place: str) -> Iterator[Piece]:
    kind = edge.type.name
    if kind == "LINE":
        a, b = xy(edge.start), xy(edge.end)
        if a != b:
            yield curves.straight(a, b)
    elif kind == "SPLINE":
        points = [xy(p) for p in edge.control_points]
        if points:
            weights, knots = [float(w) for w in edge.weights], [float(t) for t in edge.knot_values]
            yield from spline_pieces(points, weights, knots, int(edge.degree), place)
        else:
            tangents = {"start_tangent": edge.start_tangent, "end_tangent": edge.end_tangent}
            yield from through(edge.fit_points, tangents, place)
    else:
        yield from _arc_edge(edge, kind, place)


def _arc_edge(edge: Any, kind: str, place: str) -> Iterator[Piece]:
    """Yield an arc or elliptical arc; ezdxf states the angles of both anticlockwise."""
    if kind == "ARC":
        size = float(edge.radius)
        begin, end = math.radians(edge.start_angle), math.radians(edge.end_angle)
        u, v = (size, 0.0), (0.0, size)
    else:
        (x, y), ratio = xy(edge.major_axis), float(edge.ratio)
        begin, end = float(edge.start_param), float(edge.end_param)
        u, v = (x, y), (-y * ratio, x * ratio)
    if not 0 < abs(u[0] * v[1] - u[1] * v[0]) < math.inf:
        raise SceneError("has an arc without area", place)
    ellipse = Ellipse(xy(edge.center), u, v)
    turn = (end - begin) % math.tau
    if turn < curves.SLACK or math.tau - turn < curves.SLACK:
        yield from whole_ellipse(ellipse, begin)
    else:
        yield from curves.arc(ellipse, begin, begin + turn, None)
