"""Margins in the unbounded plane: files without bounds, whose margins a formula gives."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from planar_planner import ImportOptions, Options, Planner, SceneError, margin, solve
from planar_planner.cli.main import main
from planar_planner.load import load_scene
from planar_planner.margins.result import By
from planar_planner.margins.text import margin_headline
from planar_planner.problem.make import make_problem
from planar_planner.problem.plane import with_robot
from planar_planner.scene.model import Scene
from support.format_help import read
from worlds.outside_files.dxf import box as dxf_box
from worlds.outside_files.dxf import dxf
from worlds.outside_files.texts import collection, feature, polygon

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"

Box = tuple[float, float, float, float]

WALL: list[Box] = [(0.0, 0.0, 20.0, 4.0)]
GATED: list[Box] = [  # a room of 20 by 20 whose right wall has a gate of width 3
    (-11.0, -11.0, 11.0, -10.0),
    (-11.0, 10.0, 11.0, 11.0),
    (-11.0, -10.0, -10.0, 10.0),
    (10.0, -10.0, 11.0, -1.5),
    (10.0, 1.5, 11.0, 10.0),
]


def _ring(box: Box) -> list[list[float]]:
    x0, y0, x1, y1 = box
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]


def _wkt(boxes: list[Box], robot: Box, start: list[float], goal: list[float]) -> str:
    def text(box: Box) -> str:
        return "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in _ring(box)) + "))"

    ends = [f"start POINT Z ({' '.join(map(str, start))})"]
    ends += [f"goal POINT Z ({' '.join(map(str, goal))})"]
    return "\n".join([f"robot {text(robot)}", *map(text, boxes), *ends]) + "\n"


def _geojson(boxes: list[Box], robot: Box, start: list[float], goal: list[float]) -> str:
    points = {
        name: {"type": "Point", "coordinates": q[:2]}
        for name, q in (("start", start), ("goal", goal))
    }
    return collection(
        feature("robot", polygon(_ring(robot))),
        *(feature("obstacle", polygon(_ring(box))) for box in boxes),
        feature("start", points["start"], theta=start[2]),
        feature("goal", points["goal"], theta=goal[2]),
    )


def _dxf(boxes: list[Box], robot: Box, start: list[float], goal: list[float]) -> str:
    def draw(space: Any) -> None:
        dxf_box(space, "robot", *robot)
        for box in boxes:
            dxf_box(space, "obstacle", *box)
        for name, (x, y, _) in (("start", start), ("goal", goal)):
            space.add_point((x, y), dxfattribs={"layer": name})

    return dxf(draw, ends=False)


FORMATS: dict[str, Callable[..., str]] = {"wkt": _wkt, "geojson": _geojson, "dxf": _dxf}

BODY, SQUARE = (-3.0, -2.0, 3.0, 2.0), (-1.0, -1.0, 1.0, 1.0)
CASES: dict[str, tuple[list[Box], Box, list[float], list[float], By, float, str]] = {
    "past a wall": (WALL, BODY, [9.0, 14.0, 0.0], [9.0, -12.0, 0.0], "offset", 8.0, "start"),
    "far ends": (WALL, BODY, [9.0, 104.0, 0.0], [9.0, -90.0, 0.0], "offset", 88.0, "goal"),
    "scaled": (WALL, BODY, [9.0, 14.0, 0.0], [9.0, -12.0, 0.0], "scale", 5.0, "start"),
    "out of a gate": (GATED, SQUARE, [0.0, 0.0, 0.0], [30.0, 0.0, 0.0], "offset", 0.5, "way"),
}


@pytest.mark.parametrize("kind", FORMATS)
@pytest.mark.parametrize("name", CASES)
def test_margin_of_a_file_without_bounds(name: str, kind: str, tmp_path: Path) -> None:
    boxes, robot, start, goal, by, true, binding = CASES[name]
    scene = read(tmp_path / f"s.{kind}", FORMATS[kind](boxes, robot, start, goal))
    assert scene.bounds_are_chosen
    found = margin(scene, by=by)
    assert found.lower <= true * (1 + 1e-9) and true * (1 - 1e-9) <= found.upper, (found, true)
    assert found.upper - found.lower <= found.width
    assert found.decided and found.binding == binding


@pytest.mark.parametrize(("name", "true"), [("cup", 8.0), ("mmpx", 31.6228)])
def test_margin_of_a_drawing_is_set_by_its_start(name: str, true: float) -> None:
    found = margin(load_scene(FAULTS / f"{name}.svg"))
    assert found.binding == "start" and found.decided
    assert found.lower - 1e-4 <= true <= found.upper + 1e-4


def test_margin_grows_with_the_plane_and_not_with_stated_bounds() -> None:
    chosen = load_scene(FAULTS / "cup.svg")
    stated = load_scene(chosen.to_dict() | {"bounds_are_chosen": False})
    assert not stated.bounds_are_chosen
    assert margin(stated).upper < 2.0 < margin(chosen).lower
    problem = make_problem(stated)
    assert with_robot(problem, problem.robot).reference_bounds == problem.reference_bounds


def test_a_grown_robot_passes_in_its_own_plane() -> None:
    """What the margin proves of a body, `solve` proves of it in bounds chosen for it."""
    scene = load_scene(FAULTS / "cup.svg")
    found = margin(scene)
    grown = scene.to_dict() | {"robot": found.robot_lower}
    far = 4.0 * max(map(abs, scene.bounds))
    wide = load_scene(grown | {"reference_bounds": [-far, -far, far, far]})
    assert solve(wide, Options(timeout=20.0)).verdict == "path"
    problem = make_problem(scene)
    around = with_robot(problem, make_problem(wide).robot).reference_bounds
    assert around is not None and problem.reference_bounds is not None
    reach = max(math.hypot(*p) for ring in found.robot_lower["coordinates"][0] for p in ring)
    for i, side in enumerate(problem.reference_bounds):
        assert abs(around[i] - side) > reach


def test_nothing_prints_as_minus_zero() -> None:
    found = margin(FAULTS / "clip.json")
    assert "no path for one shrunk by 0.0" in margin_headline(found)
    assert json.dumps(found.to_json()["upper"]) == "0.0"
    assert math.copysign(1.0, found.upper) == 1.0


def test_a_scene_says_that_its_bounds_are_chosen() -> None:
    scene = load_scene(FAULTS / "cup.svg")
    again = Scene(
        robot=scene.robot, obstacles=scene.obstacles, start=scene.start, goal=scene.goal,
        bounds=scene.bounds, name=scene.name, description=scene.description,
    )  # fmt: skip
    assert scene != again and "bounds_are_chosen" not in again.to_dict()
    assert load_scene(scene.to_dict()) == scene and scene.to_dict()["bounds_are_chosen"] is True


@pytest.mark.parametrize("kind", ["json", "svg", "dxf", "geojson", "wkt", "txt"])
def test_margin_of_a_converted_drawing_is_the_drawing_s(kind: str, tmp_path: Path) -> None:
    """Bounds that an import chose stay chosen, whatever the scene is written as."""
    file = tmp_path / f"cup.{kind}"
    assert main(["convert", str(FAULTS / "cup.svg"), str(file), "--quiet"]) == 0
    drawn = load_scene(FAULTS / "cup.svg")
    missing = ImportOptions(list(drawn.start), list(drawn.goal), tmp_path / "cup.rob")
    again = load_scene(file, missing if kind == "txt" else None)
    assert again.bounds_are_chosen
    found = margin(again)
    assert found.binding == "start" and found.decided
    assert found.lower - 1e-4 <= 8.0 <= found.upper + 1e-4


@pytest.mark.parametrize(
    ("changed", "problem"),
    [
        ({"reference_bounds": [-1, -1, 101, 101]}, "must contain the box of all obstacles"),
        ({"workspace": {"box": [-500, -500, 500, 500]}}, "needs reference_bounds"),
        ({"reference_bounds": None, "workspace": {"box": [-500, -500, 500, 500]}}, "needs"),
        ({"bounds_are_chosen": "yes"}, "must be true or false"),
    ],
)
def test_bounds_that_do_not_stand_for_the_plane_are_refused(
    changed: dict[str, object], problem: str
) -> None:
    scene = load_scene(FAULTS / "cup.svg").to_dict() | changed
    with pytest.raises(SceneError, match=problem) as refused:
        make_problem(load_scene(scene))
    assert refused.value.field == "bounds_are_chosen"


def test_a_start_outside_the_chosen_bounds_is_taken_as_in_the_drawing(tmp_path: Path) -> None:
    file = tmp_path / "cup.json"
    assert main(["convert", str(FAULTS / "cup.svg"), str(file), "--quiet"]) == 0
    far = ImportOptions(start=[-400.0, 50.0, 0.0])
    for scene in (load_scene(FAULTS / "cup.svg", far), load_scene(file, far)):
        assert solve(scene).verdict == "path"
    with pytest.raises(SceneError, match="chosen for a file that states none"):
        Planner(load_scene(file)).solve(start=far.start)
