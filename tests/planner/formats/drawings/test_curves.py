"""Flattened curves are on one side of the curve, within the tolerance: by dense sampling."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Ellipse, Outline, Piece, flattened
from planar_planner.formats.outlines.exact import contains, orientation
from planar_planner.formats.parts import Point, Ring

SAMPLES = 100


def at(piece: Piece, t: Fraction) -> Point:
    """Return the curve's point by de Casteljau in exact arithmetic, rounded once."""
    row = [tuple(map(Fraction, p)) for p in piece]
    while len(row) > 1:
        row = [
            tuple(a[k] * (1 - t) + b[k] * t for k in range(3)) for a, b in itertools.pairwise(row)
        ]
    x, y, w = row[0]
    return float(x / w), float(y / w)


def samples(outline: Outline, count: int = SAMPLES) -> list[Point]:
    """Return points inside each curved piece, the pieces' ends left out."""
    return [
        at(piece, Fraction(k, count))
        for piece in outline.pieces
        if len(piece) > 2
        for k in range(1, count)
    ]


def is_left_of_or_on(ring: Ring, p: Point) -> bool:
    """Return whether a point is inside an anticlockwise ring or on it; exact."""
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        if orientation(a, b, p) == 0 and min(a, b) <= p <= max(a, b):
            return True
    return contains(ring, p)


def check(outline: Outline, tolerance: float) -> None:
    """Check both sides of an outline that runs anticlockwise without crossing itself."""
    grown, shrunk = flattened(outline, -1, tolerance), flattened(outline, 1, tolerance)
    assert shapely.Polygon(grown).is_valid
    assert shapely.Polygon(shrunk).is_valid
    points = samples(outline)
    for p in points:
        assert is_left_of_or_on(grown, p), p
        assert not contains(shrunk, p), p
    curve = shapely.LinearRing(
        [at(piece, Fraction(k, SAMPLES)) for piece in outline.pieces for k in range(SAMPLES)]
    )
    spacing = max(math.dist(p, q) for p, q in itertools.pairwise(curve.coords))
    for ring in (grown, shrunk):
        edges = shapely.LinearRing(ring).segmentize(tolerance)
        assert shapely.distance(curve, shapely.points(edges.coords)).max() <= tolerance + spacing
        assert shapely.distance(edges, shapely.points(curve.coords)).max() <= tolerance


def closed(pieces: list[Piece]) -> Outline:
    return Outline(tuple(pieces))


@pytest.mark.parametrize("tolerance", [0.3, 0.01, 1e-3])
@pytest.mark.parametrize(
    "ellipse",
    [
        Ellipse((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)),
        Ellipse((123.456, -7.1), (3.0, 0.3), (-0.1, 1.7)),
        Ellipse((1e4, 1e4), (1.0, 0.0), (0.0, 1.0)),
    ],
)
def test_circles_and_ellipses(ellipse: Ellipse, tolerance: float) -> None:
    pieces = curves.arc(ellipse, 0.2, 0.2 + math.tau, None)
    pieces[-1] = (*pieces[-1][:-1], pieces[0][0])
    outline = closed(pieces)
    check(outline, tolerance)
    grown, shrunk = flattened(outline, -1, tolerance), flattened(outline, 1, tolerance)
    area = math.pi * abs(ellipse.u[0] * ellipse.v[1] - ellipse.u[1] * ellipse.v[0])
    assert shapely.Polygon(shrunk).area < area < shapely.Polygon(grown).area


def test_an_arc_is_where_its_angles_say() -> None:
    ellipse = Ellipse((2.0, 3.0), (2.0, 0.5), (-0.5, 1.0))
    for begin, end in ((0.3, 1.1), (0.3, 4.0), (5.0, 0.5), (1.0, -3.0)):
        for piece in curves.arc(ellipse, begin, end, None):
            for k in range(11):
                x, y = at(piece, Fraction(k, 10))
                x, y = x - 2.0, y - 3.0
                area = 2.0 * 1.0 - 0.5 * -0.5
                cos, sin = (x * 1.0 - y * -0.5) / area, (2.0 * y - 0.5 * x) / area
                assert math.hypot(cos, sin) == pytest.approx(1, abs=1e-12)
        first, last = (
            curves.arc(ellipse, begin, end, None)[0],
            curves.arc(ellipse, begin, end, None)[-1],
        )
        assert curves.first_point(first) == ellipse.at(begin)
        assert curves.last_point(last) == pytest.approx(ellipse.at(end), abs=1e-12)


def test_shallow_arcs_of_large_radius() -> None:
    """A radius of a million over a chord of one: no centre is used, so nothing cancels."""
    a, b = (0.0, 0.0), (1.0, 0.0)
    half = math.asin(0.5 / 1e6)
    ellipse = Ellipse((0.5, math.sqrt(1e12 - 0.25)), (1e6, 0.0), (0.0, 1e6))
    (piece,) = curves.arc(ellipse, -math.pi / 2 - half, -math.pi / 2 + half, (a, b))
    sagitta = 0.25 / 2e6
    assert at(piece, Fraction(1, 2))[1] == pytest.approx(-sagitta, rel=1e-6)
    outline = closed([piece, curves.straight(b, (0.5, 1.0)), curves.straight((0.5, 1.0), a)])
    check(outline, 1e-3)


def test_stated_vertices_stay() -> None:
    corner, tip = (0.1, 0.2), (3.3, 0.7)
    pieces = [
        curves.straight(corner, tip),
        curves.bezier([tip, (4.0, 3.0), (1.0, 4.0), (0.3, 2.2)]),
        curves.straight((0.3, 2.2), corner),
    ]
    for side in (1, -1):
        ring = flattened(closed(pieces), side, 0.01)
        assert {corner, tip, (0.3, 2.2)} <= set(ring)
    check(closed(pieces), 0.01)


coordinates = st.floats(-5, 5).map(lambda v: round(v, 3))


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=3),
    st.sampled_from([0.3, 0.02]),
)
def test_any_bezier_curve_is_between_its_sides(inner: list[Point], tolerance: float) -> None:
    """S-shaped, looping and cusped curves from (−6, 0) to (6, 0), closed far below."""
    curve = curves.bezier([(-6.0, 0.0), *inner, (6.0, 0.0)])
    points = [at(curve, Fraction(k, 200)) for k in range(201)]
    assume(shapely.LineString(points).is_simple)
    assume(min(math.dist(p, q) for p, q in itertools.pairwise(points)) > 1e-3)
    far = [(6.0, -30.0), (-6.0, -30.0)]
    outline = closed(
        [
            curve,
            curves.straight((6.0, 0.0), far[0]),
            curves.straight(far[0], far[1]),
            curves.straight(far[1], (-6.0, 0.0)),
        ]
    )
    grown, shrunk = flattened(outline, 1, tolerance), flattened(outline, -1, tolerance)
    assume(shapely.Polygon(grown).is_valid and shapely.Polygon(shrunk).is_valid)
    for p in samples(outline, 64):  # it runs clockwise: left is outside
        assert is_left_of_or_on(grown, p)
        assert not contains(shrunk, p)
        assert shapely.LinearRing(grown).distance(shapely.Point(p)) <= tolerance
        assert shapely.LinearRing(shrunk).distance(shapely.Point(p)) <= tolerance


def test_flattening_takes_few_vertices() -> None:
    circle = curves.arc(Ellipse((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 0, math.tau, None)
    counts = [len(flattened(closed(circle), -1, t)) for t in (1e-1, 1e-2, 1e-3, 1e-4)]
    assert np.all(np.array(counts) <= [16, 64, 128, 512])
