"""Files that are the same, standard streams, and names that are no text."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

from planar_planner import load_scene
from planar_planner.cli.main import main

PROGRAM = [sys.executable, "-m", "planar_planner"]
FAULTS = Path(__file__).parents[2] / "worlds" / "faults"


@pytest.fixture
def slot(tmp_path: Path) -> Path:
    file = tmp_path / "slot.json"
    file.write_text(json.dumps(load_scene("slot").to_dict()))
    return file


def test_one_file_is_not_written_twice(slot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    same = str(slot.with_name("same.json"))
    assert main(["solve", str(slot), "--json", same, "--certificate", same]) == 2
    assert "--json and the certificate are the same file" in capsys.readouterr().err
    assert not Path(same).exists()


@pytest.mark.parametrize("tail", [["--json"], ["--certificate"]])
def test_no_output_replaces_the_scene(
    tail: list[str], slot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    link = slot.with_name("link.json")
    link.symlink_to(slot)
    before = slot.read_bytes()
    for output in (slot, link):
        assert main(["solve", str(slot), *tail, str(output)]) == 2
        assert "the scene and" in capsys.readouterr().err
        assert slot.read_bytes() == before


@pytest.mark.parametrize(
    ("arguments", "same"),
    [
        (["replay", "slot.json", "--save", "r.gif", "--json", "r.gif"], "--json and --save"),
        (["replay", "slot.json", "--path", "slot2.json", "--json", "slot2.json"], "--path and"),
        (["convert", "slot.json", "x.txt", "--json", "x.rob"], "x.rob and --json"),
        (["convert", "slot.json", "slot2.txt", "--json", "slot2.rob"], "slot2.rob and --json"),
        (["animate", "slot.json", "r.gif", "--json", "r.gif"], "the output and --json"),
        (["margin", "slot.json", "--plot", "m.svg", "--json", "./m.svg"], "--json and --plot"),
    ],
)
def test_no_command_writes_one_file_twice(
    arguments: list[str],
    same: str,
    slot: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(slot.parent)
    Path("slot2.json").write_bytes(slot.read_bytes())
    before = {file.name for file in slot.parent.iterdir()}
    assert main(arguments) == 2
    assert f"{same}" in capsys.readouterr().err
    assert {file.name for file in slot.parent.iterdir()} == before


def test_standard_input_is_one_scene(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", "-", "-"]) == 2
    assert "name - once" in capsys.readouterr().err


def test_json_to_the_device_of_a_pipe() -> None:
    done = subprocess.run(
        [*PROGRAM, "solve", "slot", "--json", "/dev/stdout"], capture_output=True, check=True
    )
    assert json.loads(done.stdout)["verdict"] == "path"


@pytest.mark.parametrize(
    "name", ["slot.json", "utm.geojson", "dxf/minsert_raw.dxf", "hole_outside.wkt", "cup.svg"]
)
def test_a_scene_from_standard_input(name: str, slot: Path) -> None:
    data = slot.read_bytes() if name == "slot.json" else (FAULTS / name).read_bytes()
    done = subprocess.run(
        [*PROGRAM, "solve", "-", "--json", "-"], input=data, capture_output=True, check=False
    )
    if name == "hole_outside.wkt":  # what is wrong with it is a matter of its own format
        assert done.returncode == 2 and b"hole does not lie in its shell" in done.stderr
    else:
        blocked = name == "dxf/minsert_raw.dxf"
        assert json.loads(done.stdout)["verdict"] == ("no_path" if blocked else "path")


@pytest.mark.parametrize("name", ["a\ud800b", "a\x00\x1b[31mb", "\u9053", "$x_{$"])
@pytest.mark.filterwarnings("error")
def test_names_that_are_no_text_are_escaped(
    name: str, slot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = json.loads(slot.read_text())
    named = [obstacle | {"name": name} for obstacle in scene["obstacles"]]
    slot.write_text(json.dumps(scene | {"name": name, "obstacles": named}))
    for ending in ("png", "svg"):
        assert main(["solve", str(slot), "--plot", str(slot.with_suffix(f".{ending}"))]) == 0
    assert (
        main(["margin", str(slot), "--width", "0.1", "--plot", str(slot.with_name("m.svg"))]) == 0
    )
    assert main(["animate", str(slot), str(slot.with_name("a.html"))]) == 0
    film = ["--seconds", "0.2", "--size", "160x160"]
    assert main(["animate", str(slot), str(slot.with_name("a.gif")), *film]) == 0
    if importlib.util.find_spec("pymunk") is not None:
        assert main(["replay", str(slot), "--save", str(slot.with_name("r.gif"))]) == 0
    assert main(["convert", str(slot), str(slot.with_name("out.svg"))]) == 0
    assert main(["convert", str(slot), str(slot.with_name("out.wkt"))]) == 0
    assert "\x1b" not in capsys.readouterr().out


def test_a_small_overlap_names_the_tolerance(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "near.wkt"
    for depth, named in ((1e-4, True), (1e-1, False)):
        file.write_text(
            "robot POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))\n"
            "start POINT Z (0 0 0)\ngoal POINT Z (0 5 0)\n"
            f"POLYGON (({1 - depth} -1, 2 -1, 2 1, {1 - depth} 1, {1 - depth} -1))\n"
        )
        assert main(["solve", str(file)]) == 2
        assert ("--contact-tolerance 0.00011 takes it" in capsys.readouterr().err) == named
    assert main(["solve", str(file), "--contact-tolerance", "1e-3"]) == 2
    assert "--contact-tolerance" not in capsys.readouterr().err


def test_an_interrupt_while_drawing_keeps_the_verdict(
    slot: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("planar_planner.pictures.views.draw_view", interrupted)
    picture = slot.with_name("slot.png")
    assert main(["solve", str(slot), "--plot", str(picture)]) == 0
    assert "interrupted" in capsys.readouterr().err
    assert not picture.exists()
