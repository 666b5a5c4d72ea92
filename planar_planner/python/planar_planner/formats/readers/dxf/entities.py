"""The curves that DXF entities draw, as pieces in the frame of the entity's block.

Centres, radii and angles are turned to rational Bézier curves in doubles; vertices stay as stated.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Any

from planar_planner.errors import SceneError
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Ellipse, Homogeneous, Piece
from planar_planner.formats.outlines.strands import Run
from planar_planner.formats.parts import Point

_FRAME = 16
"""Flag of a vertex that belongs to the control frame of a fitted curve, which is not drawn."""


def run_of(entity: Any, place: str) -> Run:
    """Return the pieces of an entity in order.

    Raises
    ------
    SceneError
        If the entity is of a kind that is not read, or its numbers make no curve in the plane.
    """
    reader = {
        "LINE": _line,
        "LWPOLYLINE": _polyline,
        "POLYLINE": _polyline,
        "CIRCLE": _circle,
        "ARC": _circular_arc,
        "ELLIPSE": _elliptical_arc,
        "SPLINE": _spline,
    }.get(entity.dxftype())
    if reader is None:
        raise SceneError("is a kind of entity that is not read; turn it into polylines", place)
    return list(reader(entity, place))


def xy(p: Any) -> Point:
    """Return the x and y of ezdxf's vectors."""
    return float(p.x), float(p.y)


def _segment(a: Point, b: Point) -> Iterator[Piece]:
    if a != b:
        yield curves.straight(a, b)


def _line(entity: Any, place: str) -> Iterator[Piece]:
    del place
    yield from _segment(xy(entity.dxf.start), xy(entity.dxf.end))


def flat_frame(entity: Any, place: str) -> Any:
    """Return the entity's coordinate system if it lies in the plane, from above or below."""
    ocs = entity.ocs()
    if abs(ocs.uz.z) != 1.0:
        raise SceneError("does not lie in the x–y plane", place)
    return ocs


Vertex = tuple[Point, float, float, float]
"""Point in the block's frame, bulge, width at the beginning and at the end of the next segment."""


def vertices_of(entity: Any, place: str) -> tuple[list[Vertex], bool]:
    """Return a polyline's vertices as drawn, and whether it is closed.

    Bulges are those that a viewer from above sees: arcs seen from below turn the other way.
    """
    ocs = flat_frame(entity, place)
    mirror = ocs.uz.z
    if entity.dxftype() == "LWPOLYLINE":
        constant = float(entity.dxf.get("const_width", 0.0))
        return [
            (
                xy(ocs.to_wcs((float(x), float(y), 0))),
                float(b) * mirror,
                float(begin) or constant,
                float(end) or constant,
            )
            for x, y, begin, end, b in entity.get_points("xyseb")
        ], bool(entity.closed)
    if not (entity.is_2d_polyline or entity.is_3d_polyline):
        raise SceneError("is a mesh, not an outline", place)
    drawn = [v for v in entity.vertices if not v.dxf.get("flags", 0) & _FRAME]
    if not drawn and len(entity.vertices):
        raise SceneError("has a control frame but no curve fitted to it", place)
    begin = float(entity.dxf.get("default_start_width", 0.0))
    end = float(entity.dxf.get("default_end_width", 0.0))
    return [
        (
            xy(ocs.to_wcs(v.dxf.location)),
            float(v.dxf.get("bulge", 0.0)) * mirror,
            float(v.dxf.get("start_width", begin)),
            float(v.dxf.get("end_width", end)),
        )
        for v in drawn
    ], bool(entity.is_closed)


def _polyline(entity: Any, place: str) -> Iterator[Piece]:
    corners, closed = vertices_of(entity, place)
    following = [*corners[1:], *(corners[:1] if closed else [])]
    for (a, bulge, *_), (b, *_) in zip(corners, following, strict=False):
        if a != b:
            yield from bulged(a, b, bulge)


def bulged(a: Point, b: Point, bulge: float) -> Iterator[Piece]:
    """Yield the arc from a to b that turns by 4·atan(bulge), anticlockwise if positive."""
    if bulge == 0:
        yield curves.straight(a, b)
        return
    ellipse, begin, turn = arc_of_bulge(a, b, bulge)
    yield from curves.arc(ellipse, begin, begin + turn, (a, b))


def arc_of_bulge(a: Point, b: Point, bulge: float) -> tuple[Ellipse, float, float]:
    """Return the circle of a bulge other than 0, the angle of a, and the turn to b."""
    turn = 4 * math.atan(bulge)
    # the centre is to the left of the chord's middle by (1 − bulge²)/(4·bulge) chords
    up = (1 - bulge * bulge) / (4 * bulge)
    centre = (
        (a[0] + b[0]) / 2 - up * (b[1] - a[1]),
        (a[1] + b[1]) / 2 + up * (b[0] - a[0]),
    )
    radius = math.dist(centre, a)
    begin = math.atan2(a[1] - centre[1], a[0] - centre[0])
    return Ellipse(centre, (radius, 0.0), (0.0, radius)), begin, turn


def _circle_of(entity: Any, place: str) -> Ellipse:
    ocs = flat_frame(entity, place)
    radius = float(entity.dxf.radius)
    if not 0 < radius < math.inf:
        raise SceneError("must be positive", f"{place}, radius", repr(radius))
    centre = xy(ocs.to_wcs(entity.dxf.center))
    return Ellipse(centre, xy(ocs.to_wcs((radius, 0, 0))), xy(ocs.to_wcs((0, radius, 0))))


def _circle(entity: Any, place: str) -> Iterator[Piece]:
    yield from curves.whole_ellipse(_circle_of(entity, place), 0.0)


def _circular_arc(entity: Any, place: str) -> Iterator[Piece]:
    begin, end = float(entity.dxf.start_angle), float(entity.dxf.end_angle)
    ellipse = _circle_of(entity, place)
    turn = (end - begin) % 360.0
    if turn == 0:
        yield from curves.whole_ellipse(ellipse, math.radians(begin))
    else:
        begin = math.radians(begin % 360.0)
        yield from curves.arc(ellipse, begin, begin + math.radians(turn), None)


def _elliptical_arc(entity: Any, place: str) -> Iterator[Piece]:
    flat_frame(entity, place)
    ellipse = Ellipse(xy(entity.dxf.center), xy(entity.dxf.major_axis), xy(entity.minor_axis))
    area = ellipse.u[0] * ellipse.v[1] - ellipse.u[1] * ellipse.v[0]
    if area == 0 or not math.isfinite(area):
        raise SceneError("has no area", place)
    begin, end = float(entity.dxf.start_param), float(entity.dxf.end_param)
    turn = (end - begin) % math.tau
    if turn < curves.SLACK or math.tau - turn < curves.SLACK:
        yield from curves.whole_ellipse(ellipse, begin)
    else:
        yield from curves.arc(ellipse, begin, begin + turn, None)


def _spline(entity: Any, place: str) -> Iterator[Piece]:
    points = [(float(x), float(y)) for x, y, *_ in entity.control_points]
    if not points:
        yield from through(entity.fit_points, entity.dxf, place)
        return
    weights = [float(w) for w in entity.weights]
    knots = [float(t) for t in entity.knots]
    yield from spline_pieces(points, weights, knots, int(entity.dxf.degree), place)


def through(points: Sequence[Any], tangents: Any, place: str) -> Iterator[Piece]:
    """Yield the cubic curve through fit points, as CAD programs lay it."""
    from ezdxf.math import fit_points_to_cad_cv

    if len(points) < 2:
        raise SceneError("has neither control points nor fit points", place)
    ends = [tangents.get("start_tangent"), tangents.get("end_tangent")]
    spline = fit_points_to_cad_cv(points, tangents=None if None in ends else ends)
    controls = [xy(p) for p in spline.control_points]
    yield from spline_pieces(controls, [], [float(t) for t in spline.knots()], spline.degree, place)


def spline_pieces(
    points: Sequence[Point],
    weights: Sequence[float],
    knots: Sequence[float],
    degree: int,
    place: str,
) -> Iterator[Piece]:
    """Yield the Bézier curves of a spline, clamped or not; weights are a third coordinate.

    The control points between the knots s < t are the blossom's values at s (degree − k times) and
    t (k times), by de Boor's recursion (Farin, Curves and Surfaces for CAGD, section 8.4).
    """
    count = len(points)
    weights = weights or [1.0] * count
    if len(weights) != count or not all(0 < w < math.inf for w in weights):
        raise SceneError("must have one positive weight per control point", place)
    if not knots and degree < count:
        knots = [float(min(max(k - degree, 0), count - degree)) for k in range(count + degree + 1)]
    ascending = all(s <= t for s, t in itertools.pairwise(knots))
    if not 1 <= degree < count or len(knots) != count + degree + 1 or not ascending:
        raise SceneError("must have ascending knots, one per control point and order", place)
    controls = [(x * w, y * w, w) for (x, y), w in zip(points, weights, strict=True)]
    for k in range(degree, count):
        s, t = knots[k], knots[k + 1]
        if s == t:
            continue
        piece = tuple(
            _blossom(controls, knots, k, [s] * (degree - n) + [t] * n) for n in range(degree + 1)
        )
        if len(set(piece)) > 1:
            yield piece


def _blossom(
    controls: Sequence[Homogeneous], knots: Sequence[float], span: int, at: Sequence[float]
) -> Homogeneous:
    """Return the blossom of a span's polynomial at parameters, one per degree."""
    degree = len(at)
    row = list(controls[span - degree : span + 1])
    for level, t in enumerate(at, 1):
        first = span - degree + level
        row = [
            _between(a, b, (t - knots[first + i]), (knots[first + i + degree + 1 - level] - t))
            for i, (a, b) in enumerate(itertools.pairwise(row))
        ]
    return row[0]


def _between(a: Homogeneous, b: Homogeneous, done: float, left: float) -> Homogeneous:
    """Return the point that divides a to b as done to left; the ends exactly."""
    if done == 0 or a == b:
        return a
    if left == 0:
        return b
    p, q = left / (done + left), done / (done + left)
    return p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]
