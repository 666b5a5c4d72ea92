"""Polygons as ragged arrays are judged exactly, and regions between rings are decomposed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

import pdg
from worlds.bodies.random_bodies import blob

Ring = Sequence[tuple[float, float]]
SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
HOLE = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]
OUT = "coordinate outside the range of exact arithmetic"
BOW = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]


def ragged(*polygons: Sequence[Ring]) -> tuple[NDArray, NDArray, NDArray]:
    rings = [ring for polygon in polygons for ring in polygon]
    return (
        np.array([point for ring in rings for point in ring]).reshape(-1, 2),
        np.cumsum([0, *map(len, rings)]),
        np.cumsum([0, *map(len, polygons)]),
    )


def shifted(ring: Ring, x: float) -> list[tuple[float, float]]:
    return [(a + x, b) for a, b in ring]


def test_valid_polygons_have_no_defect() -> None:
    assert pdg.polygon_defect(*ragged([SQUARE, HOLE], [SQUARE], [HOLE])) is None
    assert pdg.polygon_defect(*ragged()) is None


@pytest.mark.parametrize(
    ("polygon", "words"),
    [
        ([BOW], "self-intersection at (1, 1)"),
        ([SQUARE, shifted(HOLE, 9)], "hole lies outside shell at (11, 1)"),
        ([[*SQUARE, (0.0, 4.0)]], "ring self-intersection at (0, 4)"),
        ([SQUARE[:2]], "ring with fewer than three vertices"),
        ([SQUARE, [(1.0, 1.0)]], "ring with fewer than three vertices"),
        (
            [[*SQUARE[:3], (0.0, 1e200)]],
            f"{OUT} at (0, 1e+200)",
        ),
        (
            [[*SQUARE[:3], (0.0, math.nan)]],
            f"{OUT} at (0, nan)",
        ),
    ],
)
@pytest.mark.parametrize("before", [0, 3])
def test_the_first_defect_is_found(polygon: list[Ring], words: str, before: int) -> None:
    defect = pdg.polygon_defect(*ragged(*[[SQUARE, HOLE]] * before, polygon, [BOW], [HOLE[:1]]))
    assert defect is not None
    assert (defect.polygon, str(defect)) == (before, words)
    if defect.where is not None:
        assert words == f"{defect.problem} at ({defect.where[0]:g}, {defect.where[1]:g})"


@pytest.mark.parametrize("broken", [BOW, HOLE[:2], [*HOLE[:2], (math.inf, 0.0)]])
def test_a_defect_that_is_evident_does_not_hide_an_earlier_one(broken: Ring) -> None:
    defect = pdg.polygon_defect(*ragged([SQUARE], [BOW], [broken]))
    assert defect is not None
    assert (defect.polygon, defect.problem) == (1, "self-intersection")


def test_as_shapely_judges() -> None:
    random = np.random.default_rng(31)
    valid = 0
    for _ in range(300):
        points = random.integers(0, 5, (int(random.integers(3, 7)), 2)).astype(float)
        if (points == np.roll(points, 1, axis=0)).all(axis=1).any():
            continue
        ring = [tuple(p) for p in points.tolist()]
        expected = bool(shapely.Polygon(ring).is_valid)
        valid += expected
        assert (pdg.polygon_defect(*ragged([ring])) is None) == expected, ring
    assert 20 < valid < 250


@pytest.mark.parametrize(
    ("arrays", "name", "index"),
    [
        ((np.zeros((3, 3)), [0, 3], [0, 1]), "coords", None),
        (("junk", [0, 3], [0, 1]), "coords", None),
        ((SQUARE, [0, 3], [0, 1]), "ring_starts", None),
        ((SQUARE, [1, 4], [0, 1]), "ring_starts", None),
        ((SQUARE, [0.0, 4.0], [0, 1]), "ring_starts", None),
        ((SQUARE, [], [0, 1]), "ring_starts", None),
        ((SQUARE, [0, 4], [0, 2]), "polygon_starts", None),
        ((SQUARE, [0, 3, 2, 4], [0, 3]), "ring_starts", 2),
        ((SQUARE, [0, 4], [0, 0, 1]), "polygon_starts", 1),
    ],
)
def test_arrays_that_do_not_fit_are_named(arrays: Any, name: str, index: int | None) -> None:
    with pytest.raises(pdg.PdgError) as caught:
        pdg.polygon_defect(*arrays)
    assert (caught.value.name, caught.value.index) == (name, index)


@pytest.mark.parametrize("cover", [True, False])
def test_even_odd_pieces_of_rings_in_each_other(cover: bool) -> None:
    """An island in a hole, which as a polygon with two holes would not be valid."""
    island = [(1.25, 1.25), (1.75, 1.25), (1.75, 1.75), (1.25, 1.75)]
    pieces = pdg.even_odd_pieces([island, np.array(SQUARE), HOLE[::-1]], cover=cover)
    region = shapely.union_all([shapely.Polygon(piece) for piece in pieces])
    assert region.area == 16 - 1 + 0.25
    assert not region.contains(shapely.Point(1.1, 1.1))
    assert region.contains(shapely.Point(1.5, 1.5))
    with pytest.raises(pdg.BodyError):
        pdg.convex_pieces(shapely.Polygon(SQUARE, [HOLE, island]))


def test_even_odd_pieces_of_a_polygon_are_its_convex_pieces() -> None:
    random = np.random.default_rng(32)
    for _ in range(10):
        body = blob(random)
        shape = body if body.geom_type == "Polygon" else body.geoms[0]
        rings = [shapely.get_coordinates(line) for line in (shape.exterior, *shape.interiors)]
        pieces, others = pdg.even_odd_pieces(rings), pdg.convex_pieces(shape)
        assert all(np.array_equal(one, two) for one, two in zip(pieces, others, strict=True))


@pytest.mark.parametrize(
    ("rings", "name"),
    [
        ([SQUARE, [(0.0, 0.0), (1.0, 1.0)]], "rings[1]"),
        ([BOW], "rings"),
        ([SQUARE, SQUARE], "rings"),
        ([SQUARE, [(0.0, math.nan), (1.0, 1.0), (2.0, 0.0)]], "rings[1]"),
    ],
)
def test_rings_that_bound_no_region_are_named(rings: Any, name: str) -> None:
    with pytest.raises(pdg.BodyError) as caught:
        pdg.even_odd_pieces(rings)
    assert caught.value.name == name
