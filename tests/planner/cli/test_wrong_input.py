"""Wrong input of all kinds: status 2 and one line, before any work; never a traceback."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from planar_planner.cli.main import main


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty.json").touch()
    (tmp_path / "list.json").write_text("[1, 2]")
    (tmp_path / "bytes.json").write_bytes(bytes(range(256)))
    (tmp_path / "deep.json").write_text("[" * 100_000)
    (tmp_path / "folder.json").mkdir()
    (tmp_path / "loop.json").symlink_to("loop.json")
    (tmp_path / "cut.svg").write_text("<svg>")
    (tmp_path / "cut.dxf").write_text("0\nSECTION\n")
    (tmp_path / "cut.wkt").write_text("POLYGON((0 0,1")
    (tmp_path / "cut.yaml").write_text("image: absent.png\n")
    (tmp_path / "two\nlines.json").write_text("{}")
    before = sorted(tmp_path.iterdir())
    yield tmp_path
    assert sorted(tmp_path.iterdir()) == before


SCENES = [
    *("empty.json", "list.json", "bytes.json", "deep.json", "folder.json", "loop.json"),
    *("cut.svg", "cut.dxf", "cut.wkt", "cut.yaml", "two\nlines.json"),
    *("absent.json", "", " ", "gear\t", "x" * 5000, "\udcff", "~", "a\0b"),
]


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Demand status 2 and one line of complaint, and return that."""
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("planar-planner")
    assert captured.err.count("\n") == 1
    assert "internal error" not in captured.err
    return captured.err


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: ascii(scene[:12]))
def test_scenes(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    for before, after in (
        (["solve"], []),
        (["show"], ["--json", "-"]),
        (["convert"], ["out.json"]),
        (["verify"], ["absent.json"]),
        (["verify", "corner"], []),
        (["check", "cut.wkt", "--robot"], []),
    ):
        refused(capsys, *before, scene, *after)


@pytest.mark.parametrize(
    "arguments",
    [
        *("--json", "--version=3", "-h=3", "--", "-- solve", "solve --", "SOLVE corner", "sol"),
        *("check corner --json", "check --json -", "list --foo -h", "list corner", "solve -1"),
        *("check corner --quiet=3", "check corner -q", "check corner -5", "solve @x", "completion"),
        *("completion ksh", "check corner --timeout", "check corner --start 1,2"),
        *(
            "check corner --start=1,,2",
            "check corner --goal 1e999,0,0",
            "check corner --goal nan,0,0",
        ),
        *(
            "check corner --max-cells 1_000",
            "check corner --max-cells ٣",
            "check corner --max-cells ''",
        ),
        *(
            "check corner --timeout 1_0",
            "check corner --timeout 0x10",
            "check corner --resolution ٣",
        ),
        *(
            "check corner --max-memory ٣",
            "check corner --max-memory 4Q",
            "check corner --timeout -1",
        ),
        *(
            "check corner --certificate -",
            "check corner --certificate ''",
            "check corner --json ''",
        ),
        *(
            "show corner --plot x.bmp",
            "show corner --plot .png",
            "convert corner out",
            "convert corner",
        ),
        *("compare corner --runs x", "compare corner --planners ''", "compare corner --plot x"),
    ],
)
def test_usage(arguments: str, capsys: pytest.CaptureFixture[str]) -> None:
    refused(capsys, *shlex.split(arguments))


@pytest.mark.parametrize(
    "option",
    [
        *("--robot=absent.rob", "--footprint=[[0,0],[1,0],[0,1]]", "--padding=0.1", "--unknown"),
        *("--flatten=inwards", "--tolerance=0.1", "--join=0.1", "--role=a=robot"),
    ],
)
def test_what_a_scene_says_itself_is_not_ignored(
    option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    name = option.partition("=")[0]
    said = f"corner: is a scene file, and {name} is for files in other formats"
    for command in ("check", "show"):
        assert said in refused(capsys, command, "corner", option)
