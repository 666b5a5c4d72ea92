"""`planar-planner replay`: exit status, text, JSON, and what it says without pymunk."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from planar_planner.cli import main


def test_a_path_is_witnessed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "replay.json"
    assert main(["replay", "corner", "--json", str(file)]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert out.startswith("corner: witnessed: from start to goal without collision\n")
    assert "Chipmunk" in out
    content = json.loads(file.read_text())
    assert content["format"] == "planar-planner/replay"
    assert content["witnessed"]
    assert content["deepest"] <= content["accuracy"]


def test_a_wrong_path_is_not(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    result = tmp_path / "result.json"
    assert main(["solve", "corner", "--json", str(result), "--quiet"]) == 0
    content = json.loads(result.read_text())
    assert main(["replay", "corner", "--path", str(result), "--quiet"]) == 0
    capsys.readouterr()
    content["path"] = [content["path"][0], content["path"][-1]]  # straight through the walls
    result.write_text(json.dumps(content))
    assert main(["replay", "corner", "--path", str(result), "--quiet"]) == 1
    out, err = capsys.readouterr()
    assert (out.count("\n"), err) == (1, "")
    assert out.startswith("corner: not witnessed: obstacles[")
    assert "is penetrated by" in out


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        ("{", "is not JSON"),
        ("[]", "must be"),
        ('{"format": "planar-planner/result", "version": 1, "verdict": "no_path"}', "verdict"),
        ('{"format": "planar-planner/result", "version": 1, "verdict": "path"}', "path: must be"),
        (
            '{"format":"planar-planner/result","version":1,"verdict":"path","path":[[0,0,0],[1,2]]}',
            "path[1]",
        ),
    ],
)
def test_a_file_that_holds_no_path(
    content: str, complaint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "result.json"
    file.write_text(content)
    assert main(["replay", "corner", "--path", str(file)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert str(file) in err
    assert complaint in err


def test_without_a_path_there_is_nothing_to_replay(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", "gear-jammed"]) == 2
    assert "--push lets a robot try" in capsys.readouterr().err


def test_undecided(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", "gear-jammed", "--max-cells", "10"]) == 3
    assert "gear-jammed: undecided" in capsys.readouterr().out


def test_a_push_where_no_path_is(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["replay", "slot-jammed", "--push", "--seconds", "1", "--tries", "2"]
    assert main(command) == 0
    out, _ = capsys.readouterr()
    assert "none of 2 robots reached the goal" in out
    assert main([*command, "--json", "-"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["format"] == "planar-planner/push"
    assert (content["verdict"], content["reached"], len(content["tries"])) == ("no_path", False, 2)


def test_bad_usage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", "corner", "--push", "--path", "x.json"]) == 2
    assert main(["replay", "corner", "--path", str(tmp_path / "none.json")]) == 2
    assert main(["replay", "corner", "--json", str(tmp_path / "none" / "x.json")]) == 2
    assert main(["replay", "corner", "--step", "0"]) == 2
    assert capsys.readouterr().err.count("\n") == 4


def test_without_pymunk_one_line_names_the_extra(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pymunk", None)
    assert main(["replay", "corner"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert 'pip install "planar-planner[physics]"' in err
