"""Drawings that were once read wrongly, with their right answers."""

from __future__ import annotations

from pathlib import Path

import pytest
import shapely

from planar_planner import Scene, SceneError, load_scene, solve
from planar_planner.formats.parts import ImportOptions

FAULTS = Path(__file__).parents[3] / "worlds" / "faults" / "svg"
POINT = "[[-0.01,-0.01],[0.01,-0.01],[0.01,0.01],[-0.01,0.01]]"


def loaded(name: str) -> Scene:
    options = ImportOptions(footprint=POINT, start=[0.0, 0.0, 0.0], goal=[1.0, 0.0, 0.0])
    return load_scene(FAULTS / name, options)


def area(scene: Scene) -> shapely.Geometry:
    polygons = [shapely.Polygon(r[0], r[1:]) for r in (o["coordinates"] for o in scene.obstacles)]
    return shapely.union_all(polygons)


@pytest.mark.parametrize("name", ["use.svg", "nested.svg", "s_css.svg", "s_origin.svg"])
def test_the_wall_is_whole(name: str) -> None:
    assert solve(load_scene(FAULTS / name)).verdict == "no_path"


@pytest.mark.parametrize(
    ("name", "bounds", "size", "note"),
    [
        ("css_class.svg", (40, -20, 50, -10), 100, "pixels"),
        ("style_evenodd_css.svg", (10, -20, 20, -10), 64, "pixels"),
        ("display_none.svg", (10, -20, 20, -10), 100, "does not show are left out: 2"),
        ("switch.svg", (10, -20, 20, -10), 100, "does not show are left out: 1"),
        ("arc_zero_radius.svg", (10, -20, 20, -10), 100, "pixels"),
        ("points_compact.svg", (10, 10, 20, 20), 100, "pixels"),
        ("polyline_open.svg", (10, -20, 20, -10), 100, "closed by a straight line"),
        ("open.svg", (4, -8, 6, 0), 16, "closed by a straight line"),
    ],
)
def test_the_area_is_what_a_viewer_fills(
    name: str, bounds: tuple[float, ...], size: float, note: str
) -> None:
    scene = loaded(name)
    assert area(scene).bounds == bounds
    assert area(scene).area == pytest.approx(size, abs=1e-4)
    assert any(note in line for line in scene.notes)


def test_a_radius_that_is_too_small_grows() -> None:
    half_disc = shapely.Point(15, -10).buffer(5, quad_segs=256) & shapely.box(0, -10, 30, 0)
    found = area(loaded("arc_toosmall.svg"))
    assert found.covers(half_disc.buffer(-1e-3))
    assert half_disc.buffer(0.011).covers(found)  # the default tolerance is 0.01


@pytest.mark.parametrize(
    ("name", "note"),
    [
        ("px.svg", "pixels (px, 1/96 inch), not mm; its size is 794 by 1123"),
        ("mmpx.svg", "user units of the viewBox; the stated size of 100mm by 100mm"),
    ],
)
def test_the_unit_is_said(name: str, note: str) -> None:
    scene = load_scene(FAULTS / name)
    assert any(note in line for line in scene.notes)
    assert solve(scene).verdict == "path"


def test_a_drawing_without_size_says_nothing_of_units() -> None:
    assert not any("unit" in line for line in load_scene(FAULTS / "cup.svg").notes)


def test_a_lone_shape_is_the_robot_and_that_is_said() -> None:
    options = ImportOptions(robot=FAULTS / "part.svg")
    scene = load_scene(FAULTS / "use.svg", options)
    robot = shapely.Polygon(scene.robot["coordinates"][0])
    assert robot.bounds == (-1.0, -0.5, 1.0, 0.5)
    assert "the drawing's only shape, rect 'part', is taken as the robot" in scene.notes
    with pytest.raises(SceneError, match="nothing has a role"):
        loaded("part.svg")


@pytest.mark.parametrize("name", ["ent16.svg", "lol16.svg"])
def test_entities_are_refused_in_every_encoding(name: str) -> None:
    with pytest.raises(SceneError, match="defines XML entities, which are not read"):
        load_scene(FAULTS / name)
