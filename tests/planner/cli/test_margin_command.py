"""`planar-planner margin`: exit status, text, JSON and picture."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from planar_planner import Options, load_scene, margin, solve
from planar_planner.cli.main import main
from planar_planner.margins.find import Asked, bracketed
from planar_planner.pictures.margin import draw_margin
from planar_planner.problem.make import make_problem
from scenarios import maze


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (["corner"], 0, "corner: a path exists; a path for the robot grown by 0.009"),
        (["corner-too-long"], 1, "no path, proven; a path for the robot shrunk by 0.012"),
        (["corner", "--by", "scale"], 0, "a path exists; a path for the robot scaled by 1.01"),
        (["slot", "--max-cells", "1"], 3, "stopped short"),
        (["open"], 0, "bound by: a larger robot collides at the start"),
        (["window-fixed"], 1, "bound by: only a robot that is shrunk to nothing passes"),
    ],
)
def test_status_and_text(
    arguments: list[str], status: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["margin", *arguments]) == status
    captured = capsys.readouterr()
    assert said in captured.out
    assert captured.err == ""


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["corner", "--width", "0"], "width must be positive and finite"),
        (["corner", "--width", "x"], "'x' is not a number"),
        (["corner", "--by", "luck"], "luck"),
        (["cornr"], "corner"),
        (["corner", "--plot", "no/such/folder.png"], "cannot write"),
    ],
)
def test_refused(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["margin", *arguments]) == 2
    captured = capsys.readouterr()
    assert said in captured.err
    assert captured.out == ""


def test_json_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told, drawn = tmp_path / "margin.json", tmp_path / "margin.png"
    arguments = ["margin", "corner", "--quiet", "--json", str(told), "--plot", str(drawn)]
    assert main(arguments) == 0
    assert len(capsys.readouterr().out.splitlines()) == 1
    content = json.loads(told.read_text())
    assert content["lower"] < content["upper"] < content["lower"] + content["width"]
    assert {contact["obstacle"] for contact in content["narrow_place"]["contacts"]} == {0, -1}
    assert drawn.read_bytes().startswith(b"\x89PNG")


def test_the_picture_shows_the_bottleneck_close_up() -> None:
    found = margin("corner")
    place = found.narrow_place
    assert place is not None
    whole, close = draw_margin(load_scene("corner"), found).axes
    x, y, _ = place.configuration
    (left, right), (low, high) = close.get_xlim(), close.get_ylim()
    assert left < x < right
    assert low < y < high
    assert right - left < whole.get_xlim()[1] - whole.get_xlim()[0]
    empty = draw_margin(load_scene("window-fixed"), margin("window-fixed"))
    assert len(empty.axes) == 1


def test_the_bodies_decide_as_the_margin_says() -> None:
    scene = load_scene("slot").to_dict()
    found = margin(scene)
    assert solve({**scene, "robot": found.robot_lower}).verdict == "path"
    assert solve({**scene, "robot": found.robot_upper}).verdict == "no_path"


def test_reuse_spares_queries_and_changes_no_claim() -> None:
    for scene in ("corner", "slot-jammed"):
        with_it, without = (
            margin(scene),
            bracketed(make_problem(load_scene(scene)), Options(), Asked(reuse=False)),
        )
        assert with_it.counts["queries"] < without.counts["queries"]
        assert max(with_it.lower, without.lower) <= min(with_it.upper, without.upper)


def test_a_listener_stops_it() -> None:
    """The first query takes several tenths of a second, so that the listener is called in it."""
    found = margin(maze.maze(64), Options(), width=1e-4, listener=lambda _: False)
    assert found.reason == "interrupted"
    assert not found.decided
