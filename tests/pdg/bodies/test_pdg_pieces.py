"""Convex pieces against shapely."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import pdg
from worlds.bodies.random_bodies import blob, convex


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


def test_pieces_pass_through_and_know_their_radii() -> None:
    pieces = pdg.convex_pieces(blob(np.random.default_rng(3)))
    assert pdg.convex_pieces(pieces) is pieces
    assert len(pieces.radii) == len(pieces)
    assert max(pieces.radii) == pieces.radius
    for piece, radius in zip(pieces, pieces.radii, strict=True):
        norm = np.hypot(*piece.T).max()
        assert norm <= radius <= norm * (1 + 1e-14)
