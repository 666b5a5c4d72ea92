"""What every import says, and the frame in which it plans."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from planar_planner import Planner, SceneError, load_scene, verify_certificate
from planar_planner.cli.main import main
from planar_planner.formats.parts import ImportOptions

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
EMPTY = (
    "robot POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))\nstart POINT Z (0 0 0)\ngoal POINT Z (5 0 0)\n"
)


def test_far_coordinates_are_the_files_own() -> None:
    scene = load_scene(FAULTS / "utm.geojson")
    planner = Planner(scene)
    goal = (500001.0, 4649777.75, 0.5)
    for answer in (planner.solve(certificate=True), planner.solve(goal=goal, certificate=True)):
        assert answer.verdict == "path"
        assert tuple(answer.path[0]) == (500001.0, 4649777.25, 0.0)
        assert answer.certificate is not None
    assert tuple(answer.path[-1]) == goal
    evidence = planner.solve(certificate=True).certificate
    assert evidence is not None
    assert verify_certificate(scene, evidence).verdict == "path"


def test_a_file_without_obstacles_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "empty.wkt"
    file.write_text(EMPTY)
    assert main(["solve", str(file)]) == 2
    assert "no obstacles" in capsys.readouterr().err
    assert main(["solve", str(file), "--allow-empty"]) == 0
    assert "WARNING: the file has no obstacles" in capsys.readouterr().err
    with pytest.raises(SceneError, match="no obstacles"):
        load_scene(file)
    assert load_scene(file, ImportOptions(allow_empty=True)).obstacles == []


def test_every_import_counts_what_became_of_its_things(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "one.wkt"
    file.write_text(EMPTY + "POLYGON ((9 9, 10 9, 9 10, 9 9))\n")
    out = tmp_path / "result.json"
    assert main(["solve", str(file), "--json", str(out)]) == 0
    count = "1 obstacle, robot of 1 polygon, 0 of the file's things became nothing"
    assert count in capsys.readouterr().err
    result = json.loads(out.read_text())
    assert count in result["notes"]
    assert result["holds_for"] == ""


def test_names_without_a_role_are_listed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "names.svg"
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg">'
        '<rect id="steel" width="1" height="1"/><rect id="wood" width="1" height="1"/></svg>'
    )
    assert main(["solve", str(file)]) == 2
    assert "names without a role: 'steel', 'wood'" in capsys.readouterr().err


def test_the_only_shape_of_a_file_is_the_robot_and_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, body = tmp_path / "one.wkt", tmp_path / "body.wkt"
    file.write_text(EMPTY + "POLYGON ((9 9, 10 9, 9 10, 9 9))\n")
    body.write_text("POLYGON ((0 0, 1 0, 0 1, 0 0))\n")
    assert main(["check", str(file), "--robot", str(body)]) == 0
    said = capsys.readouterr().err
    assert "the only shape of body.wkt is the robot" in said
    assert "gives way" in said
