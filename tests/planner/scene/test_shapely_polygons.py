"""Sequences of shapely's polygons: the short way gives what each polygon says of itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner.scene.geometry import geometries, polygons_of_shapely
from planar_planner.scene.plain import plain


def random_polygons(seed: int) -> list[shapely.Polygon]:
    random = np.random.default_rng(seed)
    found = []
    for _ in range(int(random.integers(1, 20))):
        centre, corners = random.uniform(-50, 50, 2), int(random.integers(3, 12))
        ring = centre + random.uniform(-9, 9, (corners, 2))
        holes = [centre + random.uniform(-1, 1, (3, 2)) for _ in range(int(random.integers(0, 3)))]
        found.append(shapely.Polygon(ring, holes))
    return found


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("kind", [list, tuple])
def test_is_what_each_polygon_says(seed: int, kind: type) -> None:
    polygons = random_polygons(seed)
    expected = [plain(polygon) for polygon in polygons]
    assert polygons_of_shapely(kind(polygons)) == expected
    assert geometries(kind(polygons), "obstacles") == expected


def test_empty_polygons_have_no_rings() -> None:
    found = polygons_of_shapely([shapely.box(0, 0, 1, 1), shapely.Polygon()])
    assert found is not None
    assert found[1] == {"type": "Polygon", "coordinates": []}


@pytest.mark.parametrize(
    "other",
    [
        [],
        shapely.box(0, 0, 1, 1),
        [shapely.box(0, 0, 1, 1), shapely.Point(0, 0)],
        [shapely.box(0, 0, 1, 1), shapely.MultiPolygon([shapely.box(0, 0, 1, 1)])],
        [shapely.box(0, 0, 1, 1), [[0, 0], [1, 0], [0, 1]]],
        [shapely.Polygon([(0, 0, 1), (1, 0, 1), (0, 1, 1)]), shapely.box(0, 0, 1, 1)],
        None,
        3,
    ],
)
def test_leaves_everything_else_to_others(other: Any) -> None:
    assert polygons_of_shapely(other) is None
