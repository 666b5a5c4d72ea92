"""Repair of rings: the same region, exactly, or a refusal; against shapely's areas."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_planner.errors import SceneError
from planar_planner.formats.outlines.merge import merged
from planar_planner.formats.outlines.rings import polygons_of
from planar_planner.formats.parts import Notes, Ring, Shape
from planar_planner.problem.rings import judged_exactly
from planar_planner.scene.raw_polygons import RawPolygons


def region(shapes: list[Shape]) -> shapely.Geometry:
    return shapely.union_all([shapely.Polygon(s[0], s[1:]) for s in shapes])


def check(rings: list[Ring], area: float, rule: str | None = None) -> list[Shape]:
    shapes = polygons_of(rings, "here", Notes(), rule)
    stated = {p for ring in rings for p in ring}
    for shape in shapes:
        assert valid(shape)
        assert {p for ring in shape for p in ring} <= stated
    assert region(shapes).area == area
    assert sum(shapely.Polygon(s[0], s[1:]).area for s in shapes) == area
    return shapes


def valid(shape: Shape) -> bool:
    coords = np.array([p for ring in shape for p in ring])
    starts = np.cumsum([0, *map(len, shape)]).astype(np.uint32)
    ends = np.array([0, len(shape)], dtype=np.uint32)
    return judged_exactly(RawPolygons(coords, starts, ends, ("",), np.zeros(1, np.uint32))) is None


def box(x0: float, y0: float, x1: float, y1: float) -> Ring:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


@pytest.mark.parametrize(
    ("rings", "area", "count"),
    [
        ([[(0, 0), (0, 0), (4, 0), (4, 0), (4, 3), (0, 0)]], 6.0, 1),
        ([box(0, 0, 4, 4)[::-1]], 16.0, 1),
        ([[(0, 0), (4, 0), (4, 4), (6, 6), (4, 4), (0, 4)]], 16.0, 1),  # a spike
        ([[(0, 0), (2, 0), (6, 0), (4, 0), (4, 4), (0, 4)]], 16.0, 1),  # a spike along an edge
        ([[(0, 0), (2, 2), (4, 0), (4, 4), (2, 2), (0, 4)]], 8.0, 2),  # touches itself: two parts
        ([[(0, 0), (4, 0), (4, 4), (2, 4), (3, 3), (1, 3), (2, 4), (0, 4)]], 15.0, 1),  # a hole
        ([[(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)]], 8.0, 2),  # a vertex on an edge
        (
            [[(0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (2, 2), (2, 4), (4, 4), (4, 2), (2, 2)]],
            32.0,
            1,
        ),  # a hole joined by a bridge
        ([box(0, 0, 6, 6), box(2, 2, 4, 4)[::-1]], 32.0, 1),
        ([box(0, 0, 6, 6), box(0, 2, 4, 4)[::-1]], 28.0, 1),  # a notch that shares an edge
        ([box(0, 0, 2, 2), box(2, 0, 4, 2)], 8.0, 1),  # neighbours
        ([box(0, 0, 2, 2), box(5, 0, 7, 2)], 8.0, 2),
        ([box(0, 0, 9, 9), box(1, 1, 8, 8)[::-1], box(2, 2, 7, 7)], 81 - 49 + 25.0, 2),
    ],
)
def test_regions_stay(rings: list[Ring], area: float, count: int) -> None:
    rings = [[(float(x), float(y)) for x, y in ring] for ring in rings]
    assert len(check(rings, area)) == count


def test_rules_say_what_nested_rings_mean() -> None:
    rings = [box(0, 0, 6, 6), box(2, 2, 4, 4)]
    check(rings, 32.0, "evenodd")
    check(rings, 36.0, "nonzero")
    with pytest.raises(SceneError, match="here: rings go round the same place more than once"):
        polygons_of([rings[0], box(0, 2, 4, 4)], "here", Notes())


@pytest.mark.parametrize(
    "rings",
    [
        [[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)]],
        [box(0, 0, 3, 3), box(1, 1, 5, 5)],
    ],
)
def test_crossings_are_refused_with_their_place(rings: list[Ring]) -> None:
    with pytest.raises(SceneError, match=r"here: outline crosses itself \(got near \("):
        polygons_of(rings, "here", Notes())


def test_rings_without_area_are_dropped_and_told() -> None:
    notes = Notes()
    for ring in ([], [(1.0, 1.0)], [(0.0, 0.0), (1.0, 1.0)], [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]):
        assert polygons_of([ring], "here", notes) == []
    assert notes.as_lines() == ("rings without area dropped: 4",)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(
        st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=3, max_size=9),
        min_size=1,
        max_size=2,
    ),
    st.sampled_from(["evenodd", "nonzero"]),
)
def test_random_rings_on_a_grid(grid: list[list[tuple[int, int]]], rule: str) -> None:
    """Rings full of repeats, spikes, touches and overlaps; those that cross are refused."""
    rings = [[(float(x), float(y)) for x, y in ring] for ring in grid]
    try:
        shapes = polygons_of(rings, "here", Notes(), rule)
    except SceneError as error:
        assert "crosses" in error.problem
        return
    assert all(valid(shape) for shape in shapes)
    found = region(shapes)
    for i in range(17):  # points off every line through grid points
        for j in range(17):
            p = ((i + 0.37) / 4, (j + 0.4142) / 4)
            turns = sum(winding(ring, p) for ring in rings)
            inside = turns % 2 == 1 if rule == "evenodd" else turns != 0
            assert shapely.contains_xy(found, *p) == inside


def winding(ring: Ring, p: tuple[float, float]) -> int:
    turns = 0
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        across = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        turns += (a[1] <= p[1] < b[1] and across > 0) - (b[1] <= p[1] < a[1] and across < 0)
    return turns


@settings(max_examples=60, deadline=None)
@given(
    st.lists(
        st.tuples(*(2 * [st.tuples(st.integers(0, 6), st.integers(0, 6))]), st.integers(0, 6)),
        min_size=1,
        max_size=12,
    )
)
def test_pieces_are_united_to_the_same_region(corners: list[tuple[tuple[int, int], ...]]) -> None:
    pieces: list[Ring] = []
    for (ax, ay), (bx, by), c in corners:
        pieces.append([(float(ax), float(ay)), (float(bx), float(by)), (float(c), float(ay))])
    shapes = [shape for part in merged(pieces, "world", Notes()) for shape in part.shapes]
    whole = shapely.union_all([shapely.Polygon(p) for p in pieces if shapely.Polygon(p).area])
    assert all(valid(shape) for shape in shapes)
    assert {p for s in shapes for r in s for p in r} <= {p for r in pieces for p in r}
    assert shapely.symmetric_difference(region(shapes), whole).area < 1e-9
