"""The committed scene files are what the generators make, and are what they claim to be."""

import importlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import shapely

from oracles.dense_path import check_path
from oracles.scene_shapes import shapes
from scenarios import comb, maze, snowflake
from scenarios.catalogue import ENTRIES
from scenarios.generate import FOLDER, files

NAMES = [entry.name for entry in ENTRIES]
ASKED_FOR = {
    *("gear", "gear-wide", "gear-tight", "gear-jammed"),
    *("maze", "maze-blocked", "corner", "corner-too-long", "bug-trap", "bug-trap-closed"),
    *("slot", "slot-jammed", "piano", "piano-jammed", "snowflake", "snowflake-jammed"),
    *("comb", "comb-jammed", "field"),
}
GENERATED = files()


def load(name: str) -> dict[str, Any]:
    content = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    assert isinstance(content, dict)
    return content


def numbers(value: Any) -> Iterator[float]:
    if isinstance(value, (list, tuple)):
        for item in value:
            yield from numbers(item)
    elif isinstance(value, dict):
        for item in value.values():
            yield from numbers(item)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield value


@pytest.mark.parametrize("name", sorted(GENERATED))
def test_file_is_what_its_generator_makes(name: str) -> None:
    assert (FOLDER / name).read_bytes() == GENERATED[name].encode("utf-8")


def test_no_file_is_left_over_or_missing() -> None:
    assert {file.name for file in FOLDER.glob("*.json")} == set(GENERATED)


def test_generators_are_deterministic() -> None:
    assert files() == GENERATED


def test_manifest_lists_every_scene_asked_for() -> None:
    manifest = json.loads((FOLDER / "manifest.json").read_text(encoding="utf-8"))
    assert (manifest["format"], manifest["version"]) == ("planar-planner/manifest", 1)
    listed = manifest["scenes"]
    assert [scene["name"] for scene in listed] == NAMES
    assert len(set(NAMES)) == len(NAMES)
    assert set(NAMES) >= ASKED_FOR
    for scene in listed:
        keys = {"name", "file", "expected", "origin", "licence", "generator"}
        assert set(scene) == keys
        assert scene["expected"] in {"path", "no_path"}
        assert Path(FOLDER / scene["file"]).is_file()
        assert all(scene[key] for key in keys)


def test_generator_named_in_the_manifest_makes_the_file() -> None:
    """Evaluated in its module, the call in the manifest gives what is in the file."""
    for entry in ENTRIES:
        module_name, call = entry.generator.split(".", 1)
        module = importlib.import_module(f"scenarios.{module_name}")
        made = dict(eval(call, vars(module)))  # our own catalogue's text
        shipped = dict(entry.make())
        assert {**made, "name": entry.name} == shipped, entry.name


IN_DECIMALS = {"peg", "peg-jammed"}  # their ends touch as they are written


@pytest.mark.parametrize("name", NAMES)
def test_scene_is_legal(name: str) -> None:
    """Valid shapes (shapely), right header, and start and goal free by the dense checker."""
    scene = load(name)
    assert (scene["format"], scene["version"], scene["name"]) == ("planar-planner/scene", 1, name)
    assert scene["description"]
    made = shapes(scene)  # raises when a geometry is not valid
    assert made.robot.area > 0.0
    assert all(obstacle.area > 0.0 for obstacle in made.obstacles)
    assert all(abs(number) < 1e3 for number in numbers(scene["obstacles"]))
    for end in ("start", "goal") if isinstance(scene["goal"], list) else ("start",):
        found = check_path(scene, [scene[end], scene[end]])
        if name in IN_DECIMALS:
            assert found.within_rounding, (end, found)
        else:
            assert found.depth == found.area == found.outside == 0.0, (end, found)


@pytest.mark.parametrize("name", NAMES)
def test_straight_move_solves_only_the_open_scene(name: str) -> None:
    """A scene made to be hard is not solved by interpolating from start to goal."""
    if name == "field":
        pytest.skip("the field is about size")
    scene = load(name)
    if not isinstance(scene["goal"], list):
        pytest.skip("there is no straight move to a region")
    found = check_path(scene, [scene["start"], scene["goal"]], step=5e-3)
    assert found.within_rounding == (name == "open")


def test_shapes_named_in_the_issue() -> None:
    assert len(snowflake.snowflake_ring()) == 24
    flake = shapely.Polygon(snowflake.snowflake_ring())
    assert flake.area < 0.7 * flake.convex_hull.area  # far from convex
    body = shapely.geometry.shape(comb.comb_polygon())
    assert len(body.interiors) == 2
    assert len(load("field")["obstacles"]) == 2000
    assert load("field")["robot"]["type"] == "MultiPolygon"


def test_maze_is_perfect_and_blocked_by_one_wall() -> None:
    links = maze.perfect_maze(maze.SIZE, maze.SEED)
    cells = maze.SIZE**2
    assert len(links) == cells - 1  # with connectedness: a tree
    reached, stack = {(0, 0)}, [(0, 0)]
    while stack:
        cell = stack.pop()
        for link in links:
            if cell in link:
                (other,) = link - {cell}
                if other not in reached:
                    reached.add(other)
                    stack.append(other)
    assert len(reached) == cells

    def open_area(name: str) -> float:
        walls = shapely.union_all([shapely.geometry.shape(g) for g in load(name)["obstacles"]])
        return 400.0 - float(walls.intersection(shapely.box(0, 0, 20, 20)).area)

    difference = open_area("maze") - open_area("maze-blocked")
    assert 0.08 < difference < 0.11  # one wall of 1 x 0.1, less what overlaps its neighbours
