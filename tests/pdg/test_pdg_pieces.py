"""Convex pieces against shapely."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from pdg_shapes import blob, convex

import pdg


def vertices(geometry: shapely.Geometry) -> set[tuple[float, float]]:
    return {tuple(p) for p in shapely.get_coordinates(geometry).tolist()}


@pytest.mark.parametrize("cover", [True, False])
def test_pieces_cover_the_body_exactly(cover: bool) -> None:
    random = np.random.default_rng(1)
    several = 0
    for _ in range(150):
        body = blob(random)
        pieces = list(pdg.convex_pieces(body, cover=cover))
        several += len(pieces) > 3
        shapes = shapely.polygons([shapely.linearrings(p) for p in pieces])
        union = shapely.union_all(shapes)
        # Shapely's overlays round new intersection points: areas to 1e-12, not exactly.
        assert union.symmetric_difference(body).area < 1e-12 * body.area
        for shape in shapes:
            assert vertices(shape) <= vertices(body)
            assert shape.exterior.is_ccw
            assert shape.convex_hull.area == pytest.approx(shape.area, rel=1e-13)
        if not cover:
            assert shapely.area(shapes).sum() == pytest.approx(body.area, rel=1e-12)
    assert several > 100


def test_convex_body_is_its_own_piece() -> None:
    ring = convex(np.random.default_rng(2))
    (piece,) = pdg.convex_pieces(ring[::-1])
    assert {tuple(v) for v in piece.tolist()} == {tuple(v) for v in ring.tolist()}


@pytest.mark.parametrize("form", ["array", "list", "closed", "shapely", "geojson", "wkt", "multi"])
def test_every_input_form_gives_the_same_pieces(form: str) -> None:
    ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)]
    shape = shapely.Polygon(ring)
    body = {
        "array": np.array(ring, dtype=np.float32),
        "list": ring,
        "closed": [*ring, ring[0], ring[0]],
        "shapely": shape,
        "geojson": shapely.geometry.mapping(shape),
        "wkt": shape.wkt,
        "multi": shapely.MultiPolygon([shape]),
    }[form]
    expected = [p.tolist() for p in pdg.convex_pieces(ring)]
    assert [p.tolist() for p in pdg.convex_pieces(body)] == expected


def test_pieces_pass_through_and_know_their_radii() -> None:
    pieces = pdg.convex_pieces(blob(np.random.default_rng(3)))
    assert pdg.convex_pieces(pieces) is pieces
    assert len(pieces.radii) == len(pieces)
    assert max(pieces.radii) == pieces.radius
    for piece, radius in zip(pieces, pieces.radii, strict=True):
        norm = np.hypot(*piece.T).max()
        assert norm <= radius <= norm * (1 + 1e-14)


@pytest.mark.parametrize(
    ("body", "words", "index"),
    [
        ([(0, 0), (1, 1)], "three distinct", None),
        ([(0, 0), (1, 1), (0, 0), (1, 1)], "three distinct", None),
        ([(0, 0), (1, 0), (float("nan"), 1)], "finite", 2),
        ([(0, 0), (1, 0), (0, float("inf"))], "finite", 2),
        ([(0, 0), (1, 0), (0, 1e-200)], "magnitude", 2),
        ([(0, 0), (2, 2), (2, 0), (0, 2)], "edges cross", None),
        ([(0, 0), (1, 1), (2, 2)], "no area", None),
        ([(0, 0, 0), (1, 1, 0), (2, 3, 0)], "(n, 2)", None),
        ([(0, 0), (1, 0), (1j, 1)], "real numbers", None),
        ([(0, 0), (1, 0), 7], "real numbers", None),
        ("POINT (1 2)", "Polygon", None),
        ("nonsense", "not a geometry", None),
        ({"type": "Polygon"}, "not a geometry", None),
        (shapely.Polygon(), "empty", None),
        (
            shapely.Polygon([(0, 0), (1, 0), (0, 1)], [[(5, 5), (6, 5), (5, 6)]]),
            "invalid polygon",
            None,
        ),
        (None, "real numbers", None),
    ],
)
def test_bad_bodies_are_refused(body: object, words: str, index: int | None) -> None:
    with pytest.raises(pdg.PdgError, match="body") as caught:
        pdg.convex_pieces(body)
    assert words in str(caught.value)
    assert caught.value.name == "body"
    assert caught.value.index == index
