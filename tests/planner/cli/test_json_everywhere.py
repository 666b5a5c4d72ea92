"""Every command's --json: one envelope, alone on standard output, the same text in a file."""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from typing import Any

import pytest

from planar_planner import ImportReport, Planner, load_scene, margin, solve
from planar_planner.cli.main import main
from planar_planner.scene.builtin import manifest
from support.command import parsers

COMMANDS = {
    "solve": ["corner"],
    "check": ["corner"],
    "verify": ["corner", "c.json"],
    "list": [],
    "show": ["corner"],
    "compare": ["slot", "--runs", "1", "--timeout", "1", "--planners", "RRTConnect"],
    "convert": ["corner", "corner.svg"],
}
COMMANDS["animate"] = ["corner", "corner.gif", "--seconds", "0.2", "--size", "160x160"]
COMMANDS["margin"] = ["slot", "--width", "0.01"]
NO_ANSWER = {"completion"}


@pytest.fixture
def answer_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Any:
    monkeypatch.chdir(tmp_path)

    def answer(*arguments: str, status: int = 0) -> dict[str, Any]:
        assert main([*arguments, "--json", "-"]) == status
        captured = capsys.readouterr()
        assert captured.err == ""
        content = json.loads(captured.out)
        assert main([*arguments, "--json", "answer.json"]) == status
        printed = capsys.readouterr().out
        assert printed
        assert not printed.startswith("{")
        written = Path("answer.json").read_text(encoding="utf-8")
        assert json.loads(written).keys() == content.keys()
        return dict(content)

    return answer


@pytest.mark.parametrize("command", COMMANDS)
def test_envelope(command: str, answer_of: Any, capsys: pytest.CaptureFixture[str]) -> None:
    if command == "compare" and importlib.util.find_spec("ompl") is None:
        pytest.skip("needs ompl")
    if command == "verify":
        assert main(["check", "corner", "--certificate", "c.json"]) == 0
        capsys.readouterr()
    content = answer_of(command, *COMMANDS[command])
    assert content["format"].startswith("planar-planner/")
    assert isinstance(content["version"], int)


def test_every_command_takes_json() -> None:
    for command, parser in parsers().items():
        takes = any("--json" in action.option_strings for action in parser._actions)
        assert takes == (command not in {"", *NO_ANSWER}), command


ROUND = (  # a round pillar between the ends: what is proven of it depends on the flattening
    '<svg xmlns="http://www.w3.org/2000/svg"><circle class="obstacle" cx="0" cy="0" r="3"/>'
    '<rect class="robot" x="-1" y="-1" width="2" height="2"/>'
    '<circle class="start" cx="-9" cy="0" r="1"/><circle class="goal" cx="9" cy="0" r="1"/></svg>'
)
SAYS = {
    "solve": ["round.svg", "--quiet"],
    "check": ["round.svg", "--quiet"],
    "margin": ["round.svg", "--quiet", "--width", "0.5"],
    "animate": ["round.svg", "r.gif", "--quiet", "--seconds", "0.2", "--size", "160x160"],
    "verify": ["round.svg", "c.json"],
    "show": ["round.svg"],
    "convert": ["round.svg", "r.json", "--quiet"],
    "replay": ["round.svg", "--quiet"],
    "replay --push": ["round.svg", "--push", "--seconds", "0.1", "--tries", "1", "--quiet"],
    "compare": ["round.svg", "--runs", "1", "--timeout", "1", "--planners", "RRTConnect"],
}
NO_SCENE = {"list", "completion"}


def test_every_command_of_a_scene_is_asked_for_its_notes() -> None:
    assert {name.split(maxsplit=1)[0] for name in SAYS} | NO_SCENE == set(parsers()) - {""}


@pytest.mark.parametrize("command", SAYS)
def test_notes_of_an_import_are_in_every_result(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if command == "compare" and importlib.util.find_spec("ompl") is None:
        pytest.skip("needs ompl")
    if command.startswith("replay") and importlib.util.find_spec("pymunk") is None:
        pytest.skip("needs pymunk")
    monkeypatch.chdir(tmp_path)
    Path("round.svg").write_text(ROUND)
    scene = load_scene("round.svg")
    assert scene.imported.holds_for == "path" and len(scene.notes) >= 4
    if command == "verify":
        assert main(["check", "round.svg", "--certificate", "c.json"]) == 0
    assert main([command.split(maxsplit=1)[0], *SAYS[command], "--json", "answer.json"]) in (0, 3)
    content = json.loads(Path("answer.json").read_text(encoding="utf-8"))
    said = content["scenes"][0] if command == "compare" else content
    assert {key: said[key] for key in ("notes", "holds_for")} == scene.imported.to_json()


def test_notes_of_an_import_are_in_the_results_of_python(tmp_path: Path) -> None:
    file = tmp_path / "round.svg"
    file.write_text(ROUND)
    scene = load_scene(file)
    for result in (Planner(file).solve(), solve(scene), margin(scene, width=0.5)):
        assert result.imported is scene.imported or result.imported == scene.imported
        assert result.to_json()["notes"] == list(scene.notes)
    assert solve("slot").imported == ImportReport() == load_scene("slot").imported


def test_list(answer_of: Any) -> None:
    content = answer_of("list")
    assert content["format"] == "planar-planner/scenes"
    assert [scene["scene"] for scene in content["scenes"]] == list(manifest())
    gear = content["scenes"][0]
    assert gear["obstacles"] == {"polygons": 2, "vertices": 128}
    assert gear["robot"] == {"polygons": 1, "vertices": 32}
    assert gear["expected"] == "path"


def test_show(answer_of: Any) -> None:
    content = answer_of("show", "corner", "--start", "1,2,3")
    assert content["format"] == "planar-planner/description"
    assert content["scene"] == "corner"
    assert content["workspace"] == {"box": [0.0, 0.0, 4.0, 4.0]}
    assert content["start"] == [1, 2, 3]
    assert content["rotation"] is True
    assert content["expected"] == "path"
    assert content["notes"] == []


def test_convert(answer_of: Any) -> None:
    content = answer_of("convert", "corner", "corner.txt")
    assert content["format"] == "planar-planner/conversion"
    assert sorted(content["files"]) == sorted(map(str, Path().glob("corner.*")))
    assert content["obstacles"] == {"polygons": 1, "vertices": 4}


def test_rejected_and_unreadable_certificates(answer_of: Any) -> None:
    assert main(["check", "corner", "--certificate", "c.json"]) == 0
    content = answer_of_finding("slot", 1)
    assert (content["finding"], content["claim"]) == ("rejected", "scene")
    Path("c.json").write_text("nonsense")
    assert answer_of_finding("corner", 2)["finding"] == "unreadable"


def answer_of_finding(scene: str, status: int) -> dict[str, Any]:
    assert main(["verify", scene, "c.json", "--json", "found.json"]) == status
    return dict(json.loads(Path("found.json").read_text()))


def test_closed_standard_output_is_refused_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    with monkeypatch.context() as closed:
        closed.setattr(sys, "stdout", None)
        for command in ("solve", "list", "show"):
            assert main([command, *COMMANDS[command], "--json", "-"]) == 2
    assert capsys.readouterr().err.count("cannot write standard output: it is closed\n") == 3
