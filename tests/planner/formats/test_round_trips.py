"""Shipped scenes, exported and imported again: the same doubles, the same verdict."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_planner import load_scene, solve
from planar_planner.formats.parts import ImportOptions
from planar_planner.problem.make import make_problem
from support.format_help import convert, same_geometry

SCENES = ("corner", "gear", "bug-trap", "slot-jammed")


@pytest.mark.parametrize("ending", [".geojson", ".wkt"])
@pytest.mark.parametrize("name", SCENES)
def test_whole_formats_lose_nothing(name: str, ending: str, tmp_path: Path) -> None:
    file = tmp_path / f"scene{ending}"
    assert convert(name, file) == 0
    before, after = load_scene(name), load_scene(file)
    same_geometry(before, after)
    ours, theirs = make_problem(before), make_problem(after)
    assert ours.workspace_box == theirs.workspace_box
    assert ours.reference_bounds == theirs.reference_bounds
    assert solve(before).verdict == solve(after).verdict
    assert convert(file, tmp_path / "again.json") == 0
    same_geometry(before, load_scene(tmp_path / "again.json"))


@pytest.mark.parametrize("name", ["corner", "slot-jammed"])
def test_yap_style_files_keep_the_geometry(name: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.txt"
    assert convert(name, file) == 0
    before = load_scene(name)
    ends = {"start": before.start, "goal": before.goal}
    after = load_scene(file, ImportOptions(robot=file.with_suffix(".rob"), **ends))
    same_geometry(before, after)
    assert make_problem(before).workspace_box == make_problem(after).workspace_box
    assert solve(before).verdict == solve(after).verdict
