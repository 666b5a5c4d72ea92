"""Lone convex outlines are flattened to one side alone: as the comparison of both sides has it."""

from __future__ import annotations

import math

import pytest
import shapely
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from planar_planner.formats import drawing
from planar_planner.formats.drawing import Drawing, parts_of
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.curves import Ellipse, Outline, whole_ellipse
from planar_planner.formats.outlines.exact import convex_turn
from planar_planner.formats.outlines.figure import EVENODD, Figure
from planar_planner.formats.outlines.rings import convex_ring, polygons_of
from planar_planner.formats.parts import ImportOptions, Notes, Ring, Shape

WHOLE = st.integers(-6, 6)
POINT = st.tuples(WHOLE, WHOLE).map(lambda p: (float(p[0]), float(p[1])))


def reversed_outline(outline: Outline) -> Outline:
    return Outline(tuple(curves.reversed_piece(piece) for piece in reversed(outline.pieces)))


def read(outline: Outline, tolerance: float, flatten: str) -> list[Shape]:
    made = Drawing()
    made.add("obstacle", Figure((outline,), EVENODD, "here"))
    return parts_of(made, ImportOptions(tolerance=tolerance, flatten=flatten), Notes()).obstacles


def slowly(outline: Outline, tolerance: float, flatten: str) -> list[Shape]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(drawing, "_FEW", 0)
        return read(outline, tolerance, flatten)


@settings(max_examples=300, deadline=None)
@given(
    st.tuples(POINT, POINT, POINT),
    st.floats(0.001, 3),
    st.booleans(),
    st.sampled_from(["outwards", "inwards"]),
)
@example(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 1.35, False, "outwards")
def test_ellipses_are_as_by_both_sides(
    frame: tuple[tuple[float, float], ...], tolerance: float, backwards: bool, flatten: str
) -> None:
    ellipse = Ellipse(*frame)
    assume(ellipse.u[0] * ellipse.v[1] != ellipse.u[1] * ellipse.v[0])
    outline = Outline(tuple(whole_ellipse(ellipse, 0.25)))
    outline = reversed_outline(outline) if backwards else outline
    try:
        expected = slowly(outline, tolerance, flatten)
    except SceneError:  # as thin as the tolerance: the convex polygon still is on its side
        assume(flatten == "outwards")
        (shape,) = read(outline, tolerance, flatten)
        inside = shapely.Polygon([ellipse.at(k * math.tau / 64) for k in range(64)])
        assert shapely.Polygon(shape[0]).buffer(1e-9).covers(inside)
        return
    assert read(outline, tolerance, flatten) == expected


@settings(max_examples=400, deadline=None)
@given(
    st.lists(st.lists(POINT, min_size=1, max_size=3), min_size=2, max_size=5),
    st.floats(0.01, 2),
    st.sampled_from(["outwards", "inwards"]),
)
def test_any_outline_is_as_by_both_sides(
    corners: list[list[tuple[float, float]]], tolerance: float, flatten: str
) -> None:
    """Curves with loops, spikes and turns to both sides: what one side accepts, both accept."""
    following = [*corners[1:], corners[0]]
    runs = [[*own, after[0]] for own, after in zip(corners, following, strict=True)]
    assume(all(len(set(run)) > 1 for run in runs))
    outline = Outline(tuple(curves.bezier(run) for run in runs))
    assume(outline.curved)
    try:
        expected = slowly(outline, tolerance, flatten)
    except SceneError:
        return
    assert read(outline, tolerance, flatten) == expected


def test_a_lone_circle_is_flattened_once(monkeypatch: pytest.MonkeyPatch) -> None:
    sides = []

    def flattened(outline: Outline, side: int, tolerance: float) -> Ring:
        sides.append(side)
        return curves.flattened(outline, side, tolerance)

    monkeypatch.setattr(drawing, "flattened", flattened)
    read(curves.circle((3.0, 4.0), 2.0), 0.01, "outwards")
    assert sides == [-1]


@settings(max_examples=500, deadline=None)
@given(st.lists(POINT, min_size=3, max_size=8))
@example([(0.0, 2.0), (1.0, -2.0), (-2.0, 1.0), (2.0, 1.0), (-1.0, -2.0)])  # a star, twice round
def test_convex_rings_are_those_of_the_slow_judgement(ring: list[tuple[float, float]]) -> None:
    turns = [
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        for a, b, c in zip(ring, [*ring[1:], ring[0]], [*ring[2:], *ring[:2]], strict=True)
    ]
    simple = len(set(ring)) == len(ring) and shapely.Polygon(ring).is_valid
    expected = 0
    if simple and all(t > 0 for t in turns):
        expected = 1
    elif simple and all(t < 0 for t in turns):
        expected = -1
    assert convex_turn(ring) == convex_ring(ring) == expected
    if expected:
        assert polygons_of([ring], "here", Notes()) == [[ring]]


def test_coordinates_out_of_range_are_left_to_the_slow_judgement() -> None:
    tiny = [(0.0, 0.0), (1e-60, 0.0), (0.0, 1.0)]
    assert convex_turn(tiny) == 1
    assert convex_ring(tiny) == 0
