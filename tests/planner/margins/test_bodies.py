"""Grown, shrunk and scaled bodies keep what they state; false candidates are refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from shapely import affinity

from planar_planner import load_scene
from planar_planner.margins.body import Body, ClaimError, Family, geometry_of, polygons_of
from planar_planner.margins.erosion import depths, eroded
from planar_planner.margins.offset import Offsets
from planar_planner.margins.rounded_hull import circumscribed, inner_radius, outer_radius
from planar_planner.margins.scaling import Scalings
from planar_planner.problem.make import Polygons, make_problem

SLACK = 1e-9  # of the oracle: GEOS's distances and predicates in doubles

FRAME = shapely.Polygon(
    [(-1, -1), (1, -1), (1, 1), (-1, 1)], [[(-0.6, -0.6), (-0.6, 0.6), (0.6, 0.6), (0.6, -0.6)]]
)
DUMBBELL = shapely.union_all(
    [shapely.box(-2, -1, -1, 1), shapely.box(-1, -0.1, 1, 0.1), shapely.box(1, -1, 2, 1)]
)
SPIRAL = shapely.box(0, 0, 4, 4).difference(
    shapely.union_all(
        [shapely.box(-1, 1, 3, 1.5), shapely.box(2.5, 1, 3, 3), shapely.box(1, 2.5, 3, 3)]
    )
)
APART = shapely.MultiPolygon([shapely.box(-2, 0, -1, 1), shapely.box(1, 0, 3, 0.5)])
SHAPES = {
    "frame": FRAME,
    "dumbbell": DUMBBELL,
    "spiral": SPIRAL,
    "apart": APART,
    "gear": shapely.geometry.shape(load_scene("gear").robot),
    "snowflake": shapely.geometry.shape(load_scene("snowflake").robot),
}


def _robot(shape: shapely.Geometry) -> Polygons:
    return polygons_of(
        [
            [np.array(ring.coords)[:-1] for ring in (part.exterior, *part.interiors)]
            for part in shapely.get_parts(shape)
        ]
    )


def _shape(body: Body) -> shapely.Geometry:
    parts = shapely.geometry.shape(geometry_of(body.polygons))
    return shapely.union_all(shapely.get_parts(parts))


def _distance_inside(shape: shapely.Geometry, points: np.ndarray) -> np.ndarray:
    """Return signed distances from the boundary, positive inside."""
    where = shapely.points(points)
    distance = shapely.distance(where, shape.boundary)
    return np.where(shapely.contains_xy(shape, points), distance, -distance)


def _points(shape: shapely.Geometry, reach: float) -> np.ndarray:
    low_x, low_y, high_x, high_y = shape.buffer(reach).bounds
    chance = np.random.default_rng(1)
    return chance.uniform((low_x, low_y), (high_x, high_y), (4000, 2))


def _check(family: Family, shape: shapely.Geometry, low: float, high: float) -> Body:
    """Compare a body with signed distances from the robot's outline at random points."""
    body = family.between(low, high)
    assert low < body.inner <= body.outer < high
    points = _points(shape, max(high, 0.1))
    depth = _distance_inside(shape, points)
    within = shapely.contains_xy(_shape(body), points)
    assert not np.any(within & (-depth > body.outer + SLACK)), "beyond the outer body"
    assert not np.any(~within & (-depth < body.inner - SLACK)), "short of the inner body"
    return body


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize(
    ("low", "high"),
    [(0.0, 1e-2), (0.05, 0.2), (0.5, 0.52), (-1e-2, 0.0), (-0.2, -0.05), (-0.1, -0.099), (-1.0, 0)],
)
def test_offsets_are_between_their_bounds(name: str, low: float, high: float) -> None:
    shape = SHAPES[name]
    _check(Offsets(_robot(shape)), shape, low, high)


def test_a_hole_closes() -> None:
    grown = _shape(_check(Offsets(_robot(FRAME)), FRAME, 0.61, 0.7))
    assert not grown.interiors


def test_a_bar_splits_and_vanishes() -> None:
    family = Offsets(_robot(DUMBBELL))
    split = _check(family, DUMBBELL, -0.2, -0.1)
    assert split.polygons is not None
    assert len(split.polygons) == 2
    assert _check(family, DUMBBELL, -0.7, -0.5).polygons is None
    assert family.vanishing <= -0.5


def test_the_empty_body_is_refused_too_early() -> None:
    ring = [np.array(DUMBBELL.exterior.coords)[:-1]]
    with pytest.raises(ClaimError, match="leaves out more"):
        depths(ring, [], 0.49)
    assert depths(ring, [], 0.51)[1] == pytest.approx(0.51)


@pytest.mark.parametrize("name", ["frame", "dumbbell", "spiral", "gear"])
def test_false_candidates_are_refused(name: str) -> None:
    shape = list(_rings(SHAPES[name]))
    good = eroded(shape, 0.04, 0.01)
    shallow, deep = depths(shape, good, 0.06)
    assert 0.04 - SLACK <= shallow <= deep <= 0.06 + SLACK
    body = shapely.MultiPolygon([(p[0], p[1:]) for p in good])
    wrong = {
        "moved": affinity.translate(body, 0.03, 0.0),
        "far": affinity.translate(body, 50.0, 0.0),
        "larger": SHAPES[name].buffer(0.01),
        "a bite": body.difference(shapely.Point(_deepest(body)).buffer(0.05)),
        "half": shapely.clip_by_rect(body, *_half(body)),
    }
    for what, candidate in wrong.items():
        parts = [list(_rings(part)) for part in shapely.get_parts(candidate)]
        with pytest.raises(ClaimError):
            depths(shape, parts, 0.06)
            pytest.fail(what)


def test_a_filled_hole_is_refused() -> None:
    shape = list(_rings(FRAME))
    with pytest.raises(ClaimError, match="fills a hole"):
        depths(shape, [[np.array([(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (-0.8, 0.8)])]], 1.0)


def test_touching_polygons_are_not_shrunk() -> None:
    family = Offsets(
        _robot(shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)]))
    )
    with pytest.raises(ClaimError, match="touch or overlap"):
        family.between(-0.1, 0.0)


def test_measured_radii_do_not_trust_the_construction() -> None:
    ring = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0)])
    around = circumscribed(ring, 0.5, 0.01)
    assert inner_radius(ring, around) == pytest.approx(0.5)
    assert 0.5 < outer_radius(ring, around) <= 0.51 + SLACK
    around[3] *= 0.9
    assert inner_radius(ring, around) < 0.5 - 1e-3
    around[3] *= 1.5
    assert outer_radius(ring, around) > 0.52


def test_scaling_is_monotone_only_if_star_shaped() -> None:
    assert not Scalings(_robot(FRAME), "reference").monotone
    assert not Scalings(_robot(SPIRAL), "centroid").monotone
    star = Scalings(_robot(SHAPES["snowflake"]), "reference")
    assert star.monotone
    body = star.between(1.2, 1.4)
    assert body.inner < 1.3 < body.outer
    assert body.outer - body.inner < 1e-13
    scaled = affinity.scale(SHAPES["snowflake"], 1.3, 1.3, origin=(0, 0))
    assert _shape(body).symmetric_difference(scaled).area < SLACK


def test_clearance_raises_the_lower_end() -> None:
    robot = make_problem(load_scene("corner")).robot
    offsets, scalings = Offsets(robot), Scalings(robot, "reference")
    grown, shrunk = offsets.between(0.0, 0.01), offsets.between(-0.01, 0.0)
    assert offsets.raised(grown, 0.5) == pytest.approx(grown.inner + 0.5)
    assert offsets.raised(shrunk, 0.5) == shrunk.inner
    assert offsets.raised(grown, math.inf) == grown.inner
    body = scalings.between(1.0, 1.2)
    reach = float(np.hypot(*robot.coords.T).max())
    assert scalings.raised(body, 0.5) == pytest.approx(body.inner + 0.5 / reach)


def _rings(polygon: shapely.Polygon) -> list[np.ndarray]:
    return [np.array(ring.coords)[:-1] for ring in (polygon.exterior, *polygon.interiors)]


def _deepest(body: shapely.Geometry) -> tuple[float, float]:
    largest = max(shapely.get_parts(body), key=lambda part: part.area)
    centre = shapely.maximum_inscribed_circle(largest).coords[0]
    return float(centre[0]), float(centre[1])


def _half(body: shapely.Geometry) -> tuple[float, float, float, float]:
    low_x, low_y, high_x, high_y = body.bounds
    return low_x, low_y, 0.5 * (low_x + high_x), high_y
