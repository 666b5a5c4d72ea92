"""Scenes of discopygal, problems of dynobench, maps of Moving AI; and what is refused of them."""

from __future__ import annotations

import itertools
import json
import math
from pathlib import Path
from typing import Any

import pytest
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

from planar_planner import ImportOptions, Scene, SceneError, load_scene, solve
from planar_planner.problem.make import Polygons, make_problem
from support.format_help import read

FOOTPRINT = "[[-0.25, -0.125], [0.25, -0.125], [0.25, 0.125], [-0.25, 0.125]]"


def region(polygons: Polygons) -> Any:
    """Return the union of polygons without holes."""
    rings = itertools.pairwise(polygons.ring_starts.tolist())
    return unary_union([Polygon(polygons.coords[first:end]) for first, end in rings])


def regions(scene: Scene) -> Any:
    """Return the union of a scene's obstacles."""
    return region(make_problem(scene).obstacles)


def discopygal(**changes: Any) -> dict[str, Any]:
    wall = [[4, 0], [5, 0], [5, 8], [4, 8]]
    return {
        "__class__": "Scene",
        "obstacles": [
            {"__class__": "ObstaclePolygon", "poly": wall, "data": {}},
            {"__class__": "ObstacleDisc", "location": [4.5, 11], "radius": 1.5, "data": {}},
        ],
        "robots": [
            {
                "__class__": "RobotPolygon",
                "poly": [[0, 0], [1, 0], [1, 1], [0, 1]],
                "start": [1, 1],
                "end": [8, 1],
                "data": {"colour": "red"},
            }
        ],
        "metadata": {"version": "1", "author": "us"},
    } | changes


def test_a_discopygal_scene(tmp_path: Path) -> None:
    scene = read(tmp_path / "d.json", json.dumps(discopygal()))
    problem = make_problem(scene)
    assert not problem.rotation
    assert problem.start == (1, 1, 0) and problem.goal == (8, 1, 0)
    assert region(problem.robot).equals(box(0, 0, 1, 1))
    disc = Point(4.5, 11).buffer(1.5, quad_segs=256)
    drawn = unary_union([box(4, 0, 5, 8), disc])
    assert regions(scene).difference(drawn).area < 0.05
    assert drawn.difference(regions(scene)).area < 1e-9, "grown: the disc is inside"
    assert solve(scene).verdict == "path"
    assert any("curves are flattened outwards" in note for note in scene.notes)
    assert any("metadata passed over: 2" in note for note in scene.notes)


def test_a_discopygal_disc_robot_is_flattened_to_the_side_asked_for(tmp_path: Path) -> None:
    robot = {"__class__": "RobotDisc", "radius": 0.5, "start": [1, 1], "end": [8, 1], "data": {}}
    text = json.dumps(discopygal(robots=[robot]))
    for flatten, holds_for, sign in (("outwards", "path", 1), ("inwards", "no_path", -1)):
        scene = read(tmp_path / "d.json", text, flatten=flatten)
        assert scene.imported.holds_for == holds_for
        area = region(make_problem(scene).robot).area
        assert 0 < sign * (area - math.pi / 4) < 0.02


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"robots": []}, "robot"),
        ({"robots": discopygal()["robots"] * 2}, "robots: has 2 robots, and one is planned for"),
        ({"robots": {}}, "robots: must be a list"),
        ({"obstacles": None}, "obstacles: must be a list"),
        (
            {"robots": [{"__class__": "RobotRod", "length": 1, "start": [0, 0], "end": [1, 1]}]},
            "is a rod, which has no area",
        ),
        ({"obstacles": [{"__class__": "Cloud"}]}, r"obstacles\[0\].__class__: must be one of"),
        (
            {"obstacles": [{"__class__": "ObstacleDisc", "location": [0, 0], "radius": 0}]},
            r"obstacles\[0\].radius: must be positive",
        ),
        ({"obstacles": [{"__class__": "ObstaclePolygon", "poly": [[0, 0]]}]}, "at least 3 points"),
        ({"obstacles": [{"__class__": "ObstaclePolygon", "poly": [[0]] * 3}]}, r"must be \[x, y\]"),
    ],
)
def test_discopygal_scenes_that_are_refused(
    changes: dict[str, Any], problem: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError, match=problem):
        read(tmp_path / "d.json", json.dumps(discopygal(**changes)))


DYNOBENCH = """name: kink
environment:
  min: [0.0, 0.0]
  max: [6, 6]
  obstacles:
    - type: box
      center: [3, 1.5]
      size: [0.5, 3]
    - type: box
      center: [3, 5.5]
      size: [0.5, 1]
robots:
  - type: unicycle2_v0
    start: [1, 1, 0, 0.5, 0] # x, y, theta, v, w
    goal: [5, 1, 0, 0, 0]
"""


def test_a_dynobench_problem(tmp_path: Path) -> None:
    scene = read(tmp_path / "kink.yaml", DYNOBENCH, footprint=FOOTPRINT)
    problem = make_problem(scene)
    assert problem.rotation
    assert problem.reference_bounds == (0, 0, 6, 6)
    assert problem.start == (1, 1, 0) and problem.goal == (5, 1, 0)
    assert regions(scene).equals(unary_union([box(2.75, 0, 3.25, 3), box(2.75, 5, 3.25, 6)]))
    assert solve(scene).verdict == "path"
    assert "speeds of states passed over: 4" in scene.notes
    assert any("steering is not modelled" in note for note in scene.notes)


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("unicycle2_v0", "car1_v0", "is no single body in the plane"),
        ("type: box", "type: sphere", "must be a box"),
        ("[3, 1.5]", "[3, 1.5, 0]", "must be a pair"),
        ("[0.5, 3]", "[0.5, 0]", "must be positive"),
        ("[1, 1, 0, 0.5, 0]", "[1, 1]", "must begin with x, y, theta"),
        ("robots:", "robots: []\nothers:", "must be a list of one robot"),
        ("obstacles:", "obstacles: 3\n  more:", "must be a list"),
    ],
)
def test_dynobench_problems_that_are_refused(
    old: str, new: str, problem: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError, match=problem):
        read(tmp_path / "kink.yaml", DYNOBENCH.replace(old, new, 1), footprint=FOOTPRINT)


def test_a_dynobench_problem_has_no_robot_of_its_own(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="robot"):
        read(tmp_path / "kink.yaml", DYNOBENCH)


OCTILE = """type octile
height 4
width 5
map
..@..
.GT..
.SW..
.....
"""
ENDS = {"start": [0.5, 2.5, 0.0], "goal": [4.5, 2.5, 0.0], "footprint": FOOTPRINT}


def test_a_moving_ai_map(tmp_path: Path) -> None:
    scene = read(tmp_path / "arena.map", OCTILE, **ENDS)
    assert regions(scene).equals(box(2, 1, 3, 4))
    assert scene.workspace is not None
    assert solve(scene).verdict == "path"
    for said in ("3 cells of 5 × 4 make 1 polygons", "swamp taken as ground: 1", "water taken"):
        assert any(said in note for note in scene.notes), said
    assert "columns 2 to 2, rows 0 to 2" in json.dumps(scene.to_dict())


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("octile", "hexagonal", "type: must be octile"),
        ("width 5", "width 6", "line 5: must have 6 cells, and has 5"),
        ("height 4", "height 5", "must have 5 rows"),
        ("height 4", "height 3", "must have 3 rows"),
        ("height 4", "height 0", "height: must be between"),
        ("width 5\n", "", "is missing before the line 'map': width"),
        ("map\n", "", "must be type, height or width"),
        (".GT..", ".GX..", "must be of"),
        ("type octile\nheight 4\nwidth 5\nmap\n..@..\n.GT..\n.SW..\n.....\n", "", "no line 'map'"),
    ],
)
def test_moving_ai_maps_that_are_refused(old: str, new: str, problem: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=problem):
        read(tmp_path / "arena.map", OCTILE.replace(old, new, 1), **ENDS)


def test_a_moving_ai_map_without_a_type_is_read_as_octile_and_says_so(tmp_path: Path) -> None:
    scene = read(tmp_path / "arena.map", OCTILE.replace("type octile\n", ""), **ENDS)
    assert regions(scene).equals(box(2, 1, 3, 4))
    assert any("states no type and is read as octile" in note for note in scene.notes)


@pytest.mark.parametrize("separator", ["\t", " "])
def test_a_scenario_is_refused_with_the_first_problem_in_the_maps_frame(
    separator: str, tmp_path: Path
) -> None:
    problem = separator.join(["0", "arena.map", "5", "4", "0", "3", "4", "0", "7.2"])
    message = (
        r"list of problems \(2\).* on arena\.map from --start 0\.5,0\.5,0 to --goal 4\.5,3\.5,0"
    )
    with pytest.raises(SceneError, match=message):
        read(tmp_path / "a.scen", f"version 1\n{problem}\n{problem}\n")
    with pytest.raises(SceneError, match="must have 9 fields, and has 3"):
        read(tmp_path / "a.scen", "version 1\n0 arena.map 5\n")
    with pytest.raises(SceneError, match=r"list of problems \(0\)"):
        read(tmp_path / "a.scen", "")


@pytest.mark.parametrize("suffix", [".stl", ".OBJ", ".ply"])
def test_meshes_that_are_not_read_name_the_one_that_is(suffix: str, tmp_path: Path) -> None:
    file = tmp_path / f"part{suffix}"
    file.write_bytes(b"solid \xff\n")
    with pytest.raises(SceneError, match=r"save it as Collada \(\.dae\)"):
        load_scene(file, ImportOptions())


@pytest.mark.parametrize("text", ["Boundary Box2D [0:1 ; 0:1]\n", "# made\nMultiBodies\n2\n"])
def test_pmpl_environments_are_refused_with_what_is_missing(text: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="pmpl environment, whose bodies are meshes in space"):
        read(tmp_path / "room.env", text)


def test_a_map_image_alone_says_what_is_missing(tmp_path: Path) -> None:
    file = tmp_path / "map.png"
    file.write_bytes(b"\x89PNG\r\n\x1a\n")
    with pytest.raises(SceneError, match=r"picture without scale; a ROS map\.yaml states"):
        load_scene(file, ImportOptions())
