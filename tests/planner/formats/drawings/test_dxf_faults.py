"""Drawings that were once read wrongly, or refused though usual, with their right answers."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest
import shapely

from planar_planner import Scene, SceneError, load_scene, solve
from planar_planner.formats.parts import ImportOptions

FAULTS = Path(__file__).parents[3] / "worlds" / "faults" / "dxf"
POINT = "[[-0.01,-0.01],[0.01,-0.01],[0.01,0.01],[-0.01,0.01]]"


def loaded(name: str, **options: Any) -> Scene:
    far = {"footprint": POINT, "start": [500.0, 500.0, 0.0], "goal": [501.0, 500.0, 0.0]}
    return load_scene(FAULTS / name, ImportOptions(**{**far, **options}))


def area(scene: Scene) -> float:
    polygons = [shapely.Polygon(r[0], r[1:]) for r in (o["coordinates"] for o in scene.obstacles)]
    return float(shapely.union_all(polygons).area)


@pytest.mark.parametrize("name", ["minsert_raw", "d_width", "d_hatch"])
def test_the_wall_is_whole(name: str) -> None:
    assert solve(load_scene(FAULTS / f"{name}.dxf")).verdict == "no_path"


def test_a_control_frame_is_not_drawn() -> None:
    with pytest.raises(SceneError, match="goal: robot collides"):
        solve(load_scene(FAULTS / "pfit2.dxf"))


def test_what_is_not_shown_is_counted() -> None:
    note = "entities not shown ignored (invisible, or their layer is off or frozen)"
    scene = load_scene(FAULTS / "d_off.dxf")
    assert f"{note}: 1" in scene.notes
    assert solve(scene).verdict == "path"
    scene = loaded("hidden.dxf")
    assert f"{note}: 3" in scene.notes
    assert area(scene) == 1


@pytest.mark.parametrize("turn", [0, 30])
def test_a_hole_may_touch_its_outline(turn: int) -> None:
    assert area(loaded(f"d_holetouch_{turn}.dxf")) == pytest.approx(3300, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "note"),
    [
        ("T_junction", "lines that only divide what an outline bounds ignored: 1"),
        ("dup_line", "lines that are drawn twice taken once: 1"),
    ],
)
def test_lines_that_meet_or_repeat_bound_one_area(name: str, note: str) -> None:
    scene = loaded(f"{name}.dxf")
    assert area(scene) == 16
    assert note in scene.notes


def test_outlines_that_share_corners_are_united() -> None:
    """A base of 180 by 20 and two blocks on it, each between a spline and a corner at 90, 45."""
    scene = loaded("fixture.dxf", tolerance=0.01)
    (found,) = (shapely.Polygon(o["coordinates"][0]) for o in scene.obstacles)
    assert found.bounds == (-90, -60, 90, 45)
    for inside in ((0, -50), (80, 0), (-80, 0), (70, -40), (-70, -40)):
        assert found.contains(shapely.Point(inside))
    assert not found.contains(shapely.Point(0, -30))


def test_overlapping_curves_are_named_with_their_place() -> None:
    with pytest.raises(SceneError) as raised:
        loaded("overlap.dxf")
    assert "LWPOLYLINE 31, CIRCLE 32" in str(raised.value)
    assert "are on both sides" in str(raised.value)


@pytest.mark.parametrize(
    ("name", "gap", "join", "expected"),
    [("gap", "1", 1.0, 2.01), ("gap2", "0.0001", 1e-4, 2.0001), ("gap_1e-3", "0.001", 1e-3, 16)],
)
def test_gaps_are_stated_and_joined_if_asked(
    name: str, gap: str, join: float, expected: float
) -> None:
    """The robot of ``gap`` is open by 1; a wide join still closes the narrow gap first."""
    with pytest.raises(SceneError, match=rf"is {gap} away \(--join {gap} "):
        loaded(f"{name}.dxf")
    scene = loaded(f"{name}.dxf", join=join)
    assert area(scene) == pytest.approx(expected, abs=join / 100)
    assert any("ends that do not meet were joined" in note for note in scene.notes)
    assert any(f"--join is {join!r}" in note for note in scene.notes)


def test_layers_without_roles_are_named() -> None:
    with pytest.raises(SceneError, match="the layers are 'PART', 'PINS', 'WALL_1'"):
        loaded("cad.dxf")
    scene = loaded("cad.dxf", roles=(("wall*", "obstacle"), ("part", "robot")))
    assert "layers without a role: 'PINS'" in scene.notes
    assert "$INSUNITS states unit 1 (inches); lengths stay in the drawing's unit" in scene.notes


def test_nested_blocks_are_counted_before_they_are_taken_apart() -> None:
    began = time.process_time()
    with pytest.raises(SceneError, match="entities with blocks taken apart"):
        loaded("blocks.dxf")
    assert time.process_time() - began < 1
