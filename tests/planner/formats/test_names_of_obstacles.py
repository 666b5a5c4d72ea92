"""What an obstacle is called in its file, and every place that says what the robot touches."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from planar_planner import (
    ImportOptions,
    Planner,
    Scene,
    SceneError,
    load_scene,
    margin,
    solve,
    verify_certificate,
)
from planar_planner.cli.main import main
from planar_planner.margins.text import margin_details
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.make import make_problem
from worlds.outside_files.dxf import box as dxf_box
from worlds.outside_files.dxf import dxf

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
INSIDE = ImportOptions(
    start=[5.0, 5.0, 0.0], goal=[30.0, 5.0, 0.0], footprint="[[0,0],[1,0],[0,1]]"
)
SQUARE = "0 0, 10 0, 10 10, 0 10, 0 0"
RING = [[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]
GEOJSON = {
    "type": "Feature",
    "properties": {"name": "the shed"},
    "geometry": {"type": "Polygon", "coordinates": [RING]},
}
RECT = '<rect {}x="0" y="-10" width="10" height="10"/>'


def svg(inside: str) -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg">{inside}</svg>'


FILES = {
    "wkt": (f"# a room\nPOLYGON (({SQUARE}))\n", "line 2"),
    "geojson": (json.dumps({"type": "FeatureCollection", "features": [GEOJSON]}), "the shed"),
    "txt": ("4\n0 0\n10 0\n10 10\n0 10\n1\n1 2 3 4\n", "line 7"),
    "dxf": (
        dxf(lambda space: dxf_box(space, "obstacle", 0, 0, 10, 10)),
        "layer 'obstacle', LWPOLYLINE",
    ),
    "id.svg": (svg(RECT.format('id="obstacle-7" ')), "rect 'obstacle-7'"),
    "class.svg": (svg(RECT.format('class="obstacle" ')), "rect 1 of 'obstacle'"),
    "group.svg": (svg(f'<g id="obstacles">{RECT.format("")}</g>'), "rect 1 of 'obstacles'"),
}


@pytest.mark.parametrize("kind", FILES)
def test_a_collision_names_what_the_file_calls_the_obstacle(kind: str, tmp_path: Path) -> None:
    text, name = FILES[kind]
    file = tmp_path / f"room.{kind}"
    file.write_text(text)
    scene = load_scene(file, INSIDE)
    assert scene.obstacles[0]["name"].startswith(name)
    with pytest.raises(SceneError, match="robot collides with obstacle ") as refused:
        solve(scene)
    assert name in str(refused.value) and "obstacles[" not in str(refused.value)


@pytest.mark.parametrize(
    ("feature", "name"),
    [
        (GEOJSON | {"properties": {}, "id": 17}, "17"),
        (GEOJSON | {"properties": {"id": "b"}}, "b"),
        (GEOJSON | {"properties": None}, "features[0]"),
        (GEOJSON | {"properties": {"name": ""}, "id": "x"}, "x"),
    ],
)
def test_names_of_features(feature: dict[str, object], name: str, tmp_path: Path) -> None:
    file = tmp_path / "f.geojson"
    file.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    assert load_scene(file, INSIDE).obstacles[0]["name"] == name


def test_meshes_name_their_nodes_and_maps_their_cells() -> None:
    world = load_scene(FAULTS / "both.cfg")
    assert all(obstacle["name"].startswith("node '") for obstacle in world.obstacles)
    cells = load_scene(
        FAULTS / "al.yaml",
        replace(INSIDE, unknown=True),
    )
    assert all(o["name"].startswith("cells of columns ") for o in cells.obstacles)


def test_copies_keep_the_names_of_all(tmp_path: Path) -> None:
    file = tmp_path / "twice.svg"
    file.write_text(svg(RECT.format('id="obstacle-a" ') + RECT.format('id="obstacle-b" ')))
    (obstacle,) = load_scene(file, INSIDE).obstacles
    assert obstacle["name"] == "rect 'obstacle-a', rect 'obstacle-b'"


@pytest.mark.parametrize("suffix", ["json", "geojson"])
def test_names_survive_a_conversion(suffix: str, tmp_path: Path) -> None:
    first = tmp_path / "room.svg"
    first.write_text(svg(RECT.format('id="obstacle-7" ')))
    out = tmp_path / f"again.{suffix}"
    arguments = ["--start", "-5,5,0", "--goal", "30,5,0", "--footprint", "[[0,0],[1,0],[0,1]]"]
    assert main(["convert", str(first), str(out), "--quiet", *arguments]) == 0
    assert load_scene(out).obstacles[0]["name"] == "rect 'obstacle-7'"


ROOM = {
    "robot": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
    "start": (-5, 0, 0),
    "goal": (5, 0, 0),
    "workspace": (-10, -10, 10, 10),
    "rotation": False,
}
SHELF = {"type": "Polygon", "coordinates": [[[-1, 2], [1, 2], [0, 9]]], "name": "shelf"}
BENCH = {
    "type": "Feature",
    "properties": {"name": "bench"},
    "geometry": {"type": "Polygon", "coordinates": [[[-1, -9], [1, -9], [0, -2]]]},
}


def test_margins_and_replays_name_what_pinches() -> None:
    scene = Scene(**ROOM, obstacles=[SHELF, BENCH])
    found = margin(scene)
    assert found.narrow_place is not None
    assert {c.name for c in found.narrow_place.contacts} <= {"shelf", "bench", ""}
    named = found.to_json()["narrow_place"]["contacts"][0]
    assert (named["name"], named["obstacle"]) in {("shelf", 0), ("bench", 1)}
    assert f"obstacle '{named['name']}'" in margin_details(found)


def test_replays_name_what_the_path_touches() -> None:
    pytest.importorskip("pymunk")
    from planar_planner.physics import replay

    problem = make_problem(Scene(**ROOM, obstacles=[SHELF, BENCH]))
    through = replay(problem, np.array([(-5.0, 5.0, 0.0), (5.0, 5.0, 0.0)]))
    assert through.contacts[0].what == "obstacle 'shelf'"


def test_names_change_neither_the_problem_nor_its_certificate() -> None:
    named = Scene(**ROOM, obstacles=[SHELF, BENCH])
    bare = Scene(**ROOM, obstacles=[{k: v for k, v in SHELF.items() if k != "name"}, BENCH])
    assert fingerprint(make_problem(named)) == fingerprint(make_problem(bare))
    evidence = Planner(named).solve(certificate=True).certificate
    assert evidence is not None
    assert verify_certificate(bare, evidence).verdict == "path"


@pytest.mark.parametrize("name", [3, None, ["a"], {"a": 1}])
def test_a_name_is_text(name: object) -> None:
    with pytest.raises(SceneError, match="must be a string") as refused:
        make_problem(Scene(**ROOM, obstacles=[SHELF | {"name": name}]))
    assert refused.value.field == "obstacles[0].name"


def test_hostile_names_stay_on_one_line() -> None:
    here = ROOM | {"start": (0, 3, 0)}
    scene = Scene(**here, obstacles=[SHELF | {"name": "a\nb\x1b[31m\ud800" + "x" * 10**5}])
    with pytest.raises(SceneError) as refused:
        solve(scene)
    assert str(refused.value).isprintable() and len(str(refused.value)) < 300
