"""Every command that takes a scene takes files in other formats."""

from __future__ import annotations

import builtins
import importlib
import json
from pathlib import Path
from typing import Any

import pytest

from planar_planner import SceneError, load_scene
from planar_planner.cli.main import main

WKT = """workspace POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9))
robot POLYGON ((-1 -0.5, 1 -0.5, 1 0.5, -1 0.5, -1 -0.5))
POLYGON ((-1 -9, 1 -9, 1 4, -1 4, -1 -9))
start POINT Z (-5 0 0)
goal POINT Z (5 0 0)
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "wall.wkt"
    path.write_text(WKT)
    return path


def test_solve_verify_check_and_show(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    certificate = tmp_path / "c.json"
    assert main(["solve", str(file), "--certificate", str(certificate)]) == 0
    assert main(["verify", str(file), str(certificate)]) == 0
    assert main(["check", str(file)]) == 0
    assert main(["show", str(file)]) == 0
    out = capsys.readouterr().out
    assert "valid: path" in out
    assert "Imported from wall.wkt (well-known text)" in out


def test_ends_of_the_command_line_are_in_the_files_frame(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["show", str(file), "--start", "-6,1,0.5", "--goal", "6,1,0"]) == 0
    assert "start: (-6, 1, 0.5), goal: (6, 1, 0)" in capsys.readouterr().out
    far = file.with_name("far.wkt")
    far.write_text(
        "POLYGON ((1e9 0, 1000000001 0, 1000000001 1, 1e9 1, 1e9 0))\n"
        "robot POLYGON ((0 0, 1 0, 0 1, 0 0))\n"
    )
    ends = ["--start", "1000000005,5,0", "--goal", "999999990,0,0"]
    assert main(["show", str(far), *ends]) == 0
    captured = capsys.readouterr()
    assert "a million times larger" in captured.err
    assert "start: (1000000005, 5, 0), goal: (999999990, 0, 0)" in captured.out


def test_notes_are_silent_when_asked(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file.write_text(WKT.partition("\n")[2])
    assert main(["solve", str(file), "--quiet"]) == 0
    assert capsys.readouterr().err == ""
    assert main(["solve", str(file)]) == 0
    assert "states no bounds" in capsys.readouterr().err


def test_convert_tells_what_it_wrote(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "wall.json"
    assert main(["convert", str(file), str(out)]) == 0
    assert "robot of 4 vertices, 1 obstacle(s) of 4 vertices" in capsys.readouterr().out
    content = json.loads(out.read_text())
    assert content["format"] == "planar-planner/scene"
    assert load_scene(out).goal == [5.0, 0.0, 0.0]


def test_compare_takes_them_too(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import planar_planner.ompl.compare as module

    given: list[Any] = []

    def stop(scene: Any) -> None:
        given.append(scene)
        raise SceneError("enough")

    monkeypatch.setattr(module, "require_ompl", lambda: None)
    monkeypatch.setattr(module, "check_scene", stop)
    assert main(["compare", str(file), "corner", "--start", "-6,1,0"]) == 2
    assert [scene.start for scene in given] == [[-6.0, 1.0, 0.0]]


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["--role", "x"], "'x' is not PATTERN=ROLE"),
        (["--role", "x=wall"], "'x=wall' is not PATTERN=ROLE"),
        (["--tolerance", "-1"], "'-1' is not a positive length"),
        (["--padding", "wide"], "'wide' is not a positive length"),
        (["--flatten", "sideways"], "unknown value 'sideways'"),
        (["--robot", "none.rob"], "none.rob: cannot read"),
        (["--footprint", "[[0,0]]"], "--footprint"),
        (["--footprint", "[[0,0]]", "--robot", "r.rob"], "not both"),
    ],
)
def test_wrong_options_are_named(
    arguments: list[str], problem: str, file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", str(file), *arguments]) == 2
    assert problem in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "module", "extra"),
    [("m.yaml", "yaml", "ros"), ("d.svg", "svgpathtools", "svg"), ("d.dxf", "ezdxf", "dxf")],
)
def test_a_missing_library_is_named_with_its_extra(
    name: str, module: str, extra: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = importlib.import_module

    def without(wanted: str, package: str | None = None) -> Any:
        if wanted.partition(".")[0] == module:
            raise ImportError(wanted)
        return real(wanted, package)

    monkeypatch.setattr(importlib, "import_module", without)
    (tmp_path / name).write_text("<svg/>" if module == "svgpathtools" else "image: x\n")
    with pytest.raises(SceneError) as raised:
        load_scene(tmp_path / name)
    assert f"{module}, which is not installed: pip install 'planar-planner[{extra}]'" in str(
        raised.value
    )


def test_scene_files_need_none_of_the_libraries(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        assert name.partition(".")[0] not in ("yaml", "ezdxf", "svgpathtools", "PIL")
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    assert load_scene("corner").name == "corner"


def test_a_missing_file_with_a_known_ending_is_no_misspelt_scene(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["check", "nothing.svg"]) == 2
    assert "nothing.svg: cannot read the scene: No such file" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["[problem]\n", "<svg>", "POLYGON ((0 0, 1 0, 1 1))"])
def test_content_tells_where_the_name_does_not(text: str, tmp_path: Path) -> None:
    (tmp_path / "scene").write_text(text)
    with pytest.raises(SceneError) as raised:
        load_scene(tmp_path / "scene")
    assert "is not JSON" not in str(raised.value)
