"""Cells → polygons, against the union of the cells' squares."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from planar_planner.formats.outlines.occupancy import grid_polygons
from planar_planner.formats.outlines.rings import polygons_of
from planar_planner.formats.parts import Notes


def check(cells: np.ndarray) -> None:
    found = grid_polygons(cells)
    polygons = [shapely.Polygon(rings[0], rings[1:]) for rings in found]
    assert all(map(shapely.is_valid, polygons))
    rows, columns = np.nonzero(cells)
    squares = shapely.box(columns, rows, columns + 1, rows + 1)
    assert sum(p.area for p in polygons) == cells.sum()  # integers: exact, so nothing overlaps
    assert shapely.equals(shapely.union_all(polygons), shapely.union_all(squares))
    for rings in found:  # vertices at corners alone, and nothing left for the gate to repair
        for ring in rings:
            for a, b, c in zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2], strict=True):
                assert (a[0] == b[0]) != (b[0] == c[0])
        notes = Notes()
        assert polygons_of(
            [[(float(x), float(y)) for x, y in r] for r in rings], "", notes, "evenodd"
        )
        assert notes.as_lines() == ()


@settings(max_examples=150, deadline=None)
@given(arrays(np.bool_, st.tuples(st.integers(1, 7), st.integers(1, 7)), elements=st.booleans()))
def test_small_grids(cells: np.ndarray) -> None:
    check(cells)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_larger_random_grids(share: float) -> None:
    check(np.random.default_rng(int(10 * share)).random((40, 50)) < share)


def test_ring_of_diagonal_cells() -> None:
    cells = np.zeros((5, 5), dtype=bool)
    cells[[0, 1, 2, 3, 4, 3, 2, 1], [2, 1, 0, 1, 2, 3, 4, 3]] = True
    check(cells)
    check(~cells)
