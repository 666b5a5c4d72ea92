"""Every way to describe a body gives the same body; anything else is refused by name."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
import shapely

import pdg
from worlds.bodies.random_bodies import blob

RING = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)]
ELL = shapely.Polygon(RING)
TRIANGLE = np.array([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])


class Drawn:
    """Something that describes itself."""

    __geo_interface__ = shapely.geometry.mapping(ELL)


def feature(geometry: shapely.Geometry) -> dict[str, object]:
    return {"type": "Feature", "properties": {}, "geometry": shapely.geometry.mapping(geometry)}


@pytest.mark.parametrize(
    "body",
    [
        np.array(RING, dtype=np.float32),
        np.array(RING, dtype=np.int64),
        np.array(RING)[::-1],
        np.asfortranarray(RING),
        RING,
        [*RING, RING[0], RING[0]],
        [np.array(p) for p in RING],
        ELL,
        ELL.exterior,
        shapely.MultiPolygon([ELL]),
        shapely.GeometryCollection([shapely.GeometryCollection([ELL]), shapely.Polygon()]),
        ELL.wkt,
        f" {ELL.wkt}\n",
        ELL.wkb,
        bytearray(ELL.wkb),
        memoryview(ELL.wkb),
        ELL.wkb_hex,
        shapely.geometry.mapping(ELL),
        shapely.to_geojson(ELL),
        feature(ELL),
        json.dumps({"type": "FeatureCollection", "features": [feature(ELL)]}),
        Drawn(),
        [RING],
        np.array([RING]),
        (ELL,),
        [[ELL.wkt]],
    ],
    ids=lambda body: type(body).__name__,
)
def test_every_form_gives_the_same_pieces(body: object) -> None:
    def vertices(value: object) -> set[frozenset[tuple[float, float]]]:
        return {frozenset(map(tuple, p.tolist())) for p in pdg.convex_pieces(value)}

    assert vertices(body) == vertices(RING)


@pytest.mark.parametrize("form", ["multi", "collection", "shapes", "mixed", "overlapping"])
def test_several_polygons_are_one_body(form: str) -> None:
    random = np.random.default_rng(30)
    first, second = blob(random, 3), blob(random, 3)
    if form == "overlapping":
        second = shapely.affinity.translate(first, 0.3, 0.2)
    else:
        second = shapely.affinity.translate(second, 20, 0)
    polygons = [*shapely.get_parts(first), *shapely.get_parts(second)]
    body = {
        "multi": shapely.MultiPolygon(polygons),
        "collection": shapely.GeometryCollection([first, second]),
        "shapes": [first, second],
        "mixed": [first.wkb, second.wkt],
        "overlapping": [first, second],
    }[form]
    union = shapely.union_all([shapely.Polygon(p) for p in pdg.convex_pieces(body)])
    expected = shapely.union(first, second)
    assert union.symmetric_difference(expected).area < 1e-12 * expected.area


def test_rings_in_a_list_are_solid_and_holes_need_a_polygon() -> None:
    outer, inner = TRIANGLE * 9, TRIANGLE + 1
    assert len(pdg.convex_pieces([outer, inner])) == 2
    holed = pdg.convex_pieces(shapely.Polygon(outer, [inner]), cover=False)
    area = sum(shapely.Polygon(p).area for p in holed)
    assert area == pytest.approx(40.5 - 0.5)


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
        ([(0, 0), (1, 0), (0, 10**400)], "real numbers", None),
        (np.array([(0, 0), (1, 0), (0, 1)], dtype=np.longdouble), "real numbers", None),
        ("POINT (1 2)", "Polygon", None),
        ("LINESTRING (0 0, 1 0, 0 1, 0 0)", "Polygon", None),
        ("POLYGON Z ((0 0 1, 1 0 1, 0 1 1, 0 0 1))", "z coordinates", None),
        ("", "not a geometry", None),
        ("00", "not a geometry", None),
        (b"", "not a geometry", None),
        (b"POLYGON", "not a geometry", None),
        ('{"type": "Polygon"', "not a geometry", None),
        ('{"type": "Feature"}', "not a geometry", None),
        ({"type": "FeatureCollection", "features": []}, "empty", None),
        ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), POINT (1 2))", "Polygon", None),
        ([shapely.Point(1, 2).buffer(1), "POINT (1 2)"], "Polygon", None),
        ([TRIANGLE, [(0, 0), (1, 1)]], "three distinct", None),
        ([TRIANGLE, [(0, 0), (1, 0), (1, float("nan"))]], "finite", 2),
        (np.zeros((2, 3, 3)), "(n, 2)", None),
        ([], "(n, 2)", None),
        ("nonsense", "not a geometry", None),
        ({"type": "Polygon"}, "not a geometry", None),
        (shapely.Polygon(), "empty", None),
        (
            shapely.Polygon([(0, 0), (1, 0), (0, 1)], [[(5, 5), (6, 5), (5, 6)]]),
            "invalid polygon",
            None,
        ),
        (
            shapely.Polygon(np.multiply(TRIANGLE, 9), [TRIANGLE + 1, TRIANGLE + 1.2]),
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


def test_curves_and_methods_of_other_types_are_refused() -> None:
    for text in ("CIRCULARSTRING(0 0, 1 1, 2 0)", '{"a":' * 100000):
        with pytest.raises(pdg.PdgError):
            pdg.convex_pieces(text)
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    odd: Any = ([], np.zeros(3), {}, None)
    for method in odd:
        with pytest.raises(pdg.PdgError):
            pdg.c_obstacle_query(square, square, (0, 0, 0, 1, 1, 1), method)
        with pytest.raises(pdg.PdgError):
            pdg.generalized_depth_upper_bound(square, square, method=method)


def test_lists_within_themselves_and_too_deep_ones_are_refused() -> None:
    loop: list[object] = []
    loop.append(loop)
    deep: list[object] = []
    for _ in range(100_000):
        deep = [deep]
    for body in (loop, [TRIANGLE, loop], deep):
        with pytest.raises(pdg.PdgError, match="body") as caught:
            pdg.convex_pieces(body)
        assert caught.value.value is not None
    nested: list[object] = [TRIANGLE]
    for _ in range(50):
        nested = [nested]
    assert len(pdg.convex_pieces(nested)) == 1


def test_cover_must_be_a_bool() -> None:
    odd: Any = (1, "no", None, [])
    for cover in odd:
        with pytest.raises(pdg.PdgError, match="cover: expected True or False") as caught:
            pdg.convex_pieces(TRIANGLE, cover=cover)
        assert caught.value.value == cover
    assert len(pdg.convex_pieces(TRIANGLE, cover=np.bool_(False))) == 1


def test_pieces_in_a_list_are_taken_piece_by_piece() -> None:
    ell = pdg.convex_pieces([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)])
    for body in ([ell, TRIANGLE + 10.0], (TRIANGLE + 10.0, ell), [[ell], TRIANGLE + 10.0]):
        both = [piece.tolist() for piece in pdg.convex_pieces(body)]
        assert len(both) == len(ell) + 1
        assert all(piece.tolist() in both for piece in ell)


def test_a_ring_that_runs_back_along_its_edges_is_taken_by_the_even_odd_rule() -> None:
    spike = [(0, 0), (2, 0), (2, 2), (5, 2), (2, 2), (0, 2)]
    pieces = pdg.convex_pieces(spike, cover=False)
    assert shapely.union_all([shapely.Polygon(p) for p in pieces]).equals(shapely.box(0, 0, 2, 2))
