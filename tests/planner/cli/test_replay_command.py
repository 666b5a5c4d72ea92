"""`planar-planner replay`: exit status, text, JSON, and what it says without pymunk."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_planner.cli.main import main
from planar_planner.films.pace import Pace
from planar_planner.films.physics import save_replay
from planar_planner.physics import replay
from planar_planner.physics.replay import problem_of


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
    assert "slot-jammed: no path, proven" in out
    assert main([*command, "--quiet"]) == 0
    assert capsys.readouterr().out == "slot-jammed: none of 2 robots reached the goal\n"
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


@pytest.mark.parametrize("option", ["seconds", "tries", "seed"])
def test_what_only_pushing_has_is_refused_without_it(
    option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["replay", "corner", f"--{option}", "1"]) == 2
    assert capsys.readouterr() == ("", f"planar-planner: --{option} is for --push\n")


def test_without_pymunk_one_line_names_the_extra(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pymunk", None)
    assert main(["replay", "corner"]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert 'pip install "planar-planner[physics]"' in err


def test_films(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    film, again = tmp_path / "push.gif", tmp_path / "again.gif"
    command = ["replay", "slot-jammed", "--push", "--seconds", "1", "--tries", "2", "--quiet"]
    assert main([*command, "--save", str(film)]) == 0
    assert main([*command, "--save", str(again)]) == 0
    assert film.read_bytes() == again.read_bytes()
    with Image.open(film) as image:
        assert image.n_frames == 17  # 16 a second, and the first
    assert main(["replay", "corner", "--save", str(tmp_path / "film.avi")]) == 2
    assert main(["replay", "corner", "--save", str(tmp_path / "none" / "film.gif")]) == 2
    assert capsys.readouterr().err.count("\n") == 2


def test_in_a_film_a_robot_in_collision_changes_colour(tmp_path: Path) -> None:
    problem = problem_of("corner")
    found = replay(problem, [problem.start, problem.goal], step=0.05)
    pace = Pace(seconds=1.0, fps=10.0, hold=0.0)
    save_replay(problem, found, tmp_path / "wrong.gif", ".gif", pace)
    assert found.depths[0] == 0.0 < found.depths.max()
    with Image.open(tmp_path / "wrong.gif") as image:
        shown = [coloured(image, 0)]
        where = found.depths.argmax() / (len(found.depths) - 1)
        shown.append(coloured(image, round(where * (image.n_frames - 1))))
    assert shown[1] > 1.5 * shown[0]  # the goal and the legend have the colour, too


def coloured(image: Image.Image, frame: int) -> int:
    """Return how many pixels of a frame have the colour of collision, or nearly."""
    image.seek(frame)
    pixels = np.asarray(image.convert("RGB")).astype(int)
    return int((np.abs(pixels - (0xD5, 0x5E, 0x00)).sum(axis=2) < 60).sum())
