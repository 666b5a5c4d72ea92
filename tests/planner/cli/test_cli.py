"""The command line with a stand-in for the core: arguments, exit status, output, refusals."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any

import pytest

from planar_planner.cli.main import main
from support.stand_in_core import FREE, FakeCore


@pytest.fixture
def scene_file(tmp_path: Path, scene_dict: dict[str, Any]) -> str:
    file = tmp_path / "small.json"
    file.write_text(json.dumps(scene_dict), encoding="utf-8")
    return str(file)


def refusal(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Run the command, demand exit status 2 and one line of complaint, and return that."""
    assert main(list(arguments)) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert "internal error" not in captured.err
    return captured.err


@pytest.mark.parametrize(("verdict", "status"), [("path", 0), ("no_path", 1), ("undecided", 3)])
def test_exit_status_is_the_verdict(
    fake_core: type[FakeCore],
    scene_file: str,
    capsys: pytest.CaptureFixture[str],
    verdict: str,
    status: int,
) -> None:
    fake_core.verdict = verdict
    for command in ("solve", "check"):
        assert main([command, scene_file]) == status
    captured = capsys.readouterr()
    assert captured.err == ""
    assert captured.out.count("small: ") == 2
    assert captured.out.count("cells: 12") == 1  # statistics from solve, none from check


def test_quiet_prints_the_verdict_alone(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["solve", scene_file, "--quiet"]) == 0
    assert capsys.readouterr().out == "small: path found (certified straight move)\n"


def test_statistics_name_everything(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    main(["solve", scene_file])
    out = capsys.readouterr().out
    for part in (
        "length 2.5, turning 0 rad, 2 waypoints, least clearance inf",
        "3 free, 2 star, 4 full, 3 mixed",
        "2: 4, 3: 8",
        "0 configurations tried first, 20 cells labelled, 340 separations, 5 of 9 pairs touched, "
        "7 faces, 2 search rounds",
        "3.6 ms (preprocessing 1.0, labelling 2.0, faces 0.5, probe 0.0, search 0.1, path 0.0)",
    ):
        assert part in out
    assert re.search(r"set-up: \d+\.\d ms \(reading \S+, checking \S+, building \S+\)\n", out)


@pytest.mark.parametrize("form", [["--start", "-1,2,0"], ["--start=-1,2,0"], ["--start", "-1,2,0"]])
def test_negative_start(fake_core: type[FakeCore], scene_file: str, form: list[str]) -> None:
    assert main(["solve", scene_file, *form, "--goal", "-.5,-2e0,-1.5708"]) == 0
    start, goal, *_ = fake_core.solved[0]
    assert (start, goal) == ((-1, 2, 0), (-0.5, -2, -1.5708))


def test_limits_reach_the_core(fake_core: type[FakeCore], scene_file: str) -> None:
    arguments = "--resolution 1e-6 --max-cells 7 --timeout inf --max-memory 1.5M"
    assert main(["check", scene_file, *arguments.split(), "--contact-tolerance", "0.25"]) == 0
    assert fake_core.solved[0][2:7] == (1e-6, 7, float("inf"), 3 * 2**19, 0.25)


def test_defaults_reach_the_core(fake_core: type[FakeCore], scene_file: str) -> None:
    main(["check", scene_file])
    assert fake_core.solved[0][:7] == ((1, 1, 0), (9, 9, 0), 1e-9, 5_000_000, 60, 2**32, 0)
    robot, obstacles, box, workspace, bounds, rotation = fake_core.built[0]
    assert robot[0].shape == obstacles[0].shape == (4, 2)
    assert (box, workspace, bounds, rotation) == ((0, 0, 10, 10), None, None, True)


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["dance"],
        ["solve"],
        ["solve", "gear", "--start", "1,2"],
        ["solve", "gear", "--start", "1,2,x"],
        ["solve", "gear", "--start"],
        ["solve", "gear", "--max-cells", "1.5"],
        ["solve", "gear", "--max-memory", "lots"],
        ["solve", "gear", "--max-memory", "9" * 400],
        ["solve", "gear", "--plot", "picture.bmp"],
        ["solve", "gear", "--plot", "picture"],
        ["check", "gear", "--plot", "picture.png"],
        ["solve", "gear", "--no-such-option"],
        ["solve", "gear", "--time", "3"],
    ],
)
def test_usage_errors(capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("planar-planner")
    assert captured.err.endswith("--help)\n")
    assert captured.err.count("\n") == 1


def test_options_out_of_range(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for option, value in (
        ("--resolution", "2"),
        ("--resolution", "nan"),
        ("--timeout", "0"),
        ("--max-cells", "0"),
        ("--contact-tolerance", "inf"),
    ):
        assert option[2:].replace("-", "_") in refusal(
            capsys, "solve", scene_file, f"{option}={value}"
        )


def test_bad_scenes(
    fake_core: type[FakeCore], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "did you mean 'gear'" in refusal(capsys, "solve", "geear")
    assert "cannot read the scene" in refusal(capsys, "check", str(tmp_path))
    assert "No such file" in refusal(capsys, "show", str(tmp_path / "absent.json"))
    file = tmp_path / "bad.json"
    file.write_text('{"format": ')
    assert "bad.json: is not JSON" in refusal(capsys, "solve", str(file))


def test_bad_start_on_the_command_line(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "start[0]: must be a finite number" in refusal(
        capsys, "solve", scene_file, "--start", "nan,0,0"
    )


@pytest.mark.parametrize(
    ("found", "expected"),
    [
        (
            {"state": "colliding", "exact": False, "what": "obstacle", "polygon": 0, "depth": 0.5},
            "goal: robot collides with obstacles[0], penetration depth 0.5 (got [9.0, 9.0, 0.0])",
        ),
        (
            {"state": "outside", "exact": False, "what": "workspace", "depth": 0.25},
            "goal: robot is outside the workspace by 0.25",
        ),
        (
            {"state": "outside", "exact": False, "what": "reference_bounds", "depth": 2.0},
            "goal: reference point is outside reference_bounds by 2",
        ),
    ],
)
def test_goal_that_is_not_free(
    fake_core: type[FakeCore],
    scene_file: str,
    capsys: pytest.CaptureFixture[str],
    found: dict[str, Any],
    expected: str,
) -> None:
    fake_core.placements = staticmethod(lambda q: FREE | found if q[0] == 9 else FREE)
    assert expected in refusal(capsys, "solve", scene_file)
    assert fake_core.solved == []
    depth = str(found["depth"])
    assert main(["solve", scene_file, "--contact-tolerance", depth]) == 0
    fake_core.placements = staticmethod(lambda q: FREE | {"state": "contact", "separation": 0.0})
    assert main(["solve", scene_file]) == 0


def test_collision_names_the_part_of_a_multipolygon(
    fake_core: type[FakeCore],
    tmp_path: Path,
    scene_dict: dict[str, Any],
    capsys: pytest.CaptureFixture[str],
) -> None:
    rings = scene_dict["obstacles"][0]["coordinates"]
    scene_dict["obstacles"].append({"type": "MultiPolygon", "coordinates": [rings, rings]})
    file = tmp_path / "parts.json"
    file.write_text(json.dumps(scene_dict))
    hit = {"state": "colliding", "exact": False, "what": "obstacle", "polygon": 2, "depth": 1.0}
    fake_core.placements = staticmethod(lambda q: FREE | hit)
    assert "start: robot collides with obstacles[1] (at obstacles[1].coordinates[1])," in refusal(
        capsys, "check", str(file)
    )


def test_json_to_standard_output_is_all_there_is(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["solve", scene_file, "--json", "-"]) == 0
    captured = capsys.readouterr()
    content = json.loads(captured.out)
    assert content["format"] == "planar-planner/result"
    assert content["stats"]["least_clearance"] is None
    assert captured.err == ""


def test_json_file_replaces_the_old_one(
    fake_core: type[FakeCore], scene_file: str, tmp_path: Path
) -> None:
    file = tmp_path / "result.json"
    file.write_text("old")
    file.chmod(0o640)
    link = tmp_path / "link.json"
    link.symlink_to(file)
    assert main(["check", scene_file, "--json", str(link)]) == 0
    assert json.loads(file.read_text())["verdict"] == "path"
    assert file.stat().st_mode & 0o777 == 0o640
    assert link.is_symlink()
    assert sorted(f.name for f in tmp_path.iterdir()) == ["link.json", "result.json", "small.json"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs a file that is not a regular one")
def test_pipes_are_written_in_place(
    fake_core: type[FakeCore], scene_file: str, tmp_path: Path
) -> None:
    """On a pipe of our own: a defect here, run by root, would replace a device of the machine."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reading = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        assert main(["check", scene_file, "--json", str(pipe)]) == 0
        assert json.loads(os.read(reading, 1_000_000))["verdict"] == "path"
    finally:
        os.close(reading)
    assert pipe.is_fifo()


def test_unwritable_output_is_refused_before_solving(
    fake_core: type[FakeCore], scene_file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for target in (tmp_path, tmp_path / "absent" / "r.json", Path(scene_file) / "r.json"):
        assert "cannot write" in refusal(capsys, "solve", scene_file, "--json", str(target))
    assert "no directory" in refusal(
        capsys, "show", scene_file, "--plot", str(tmp_path / "absent" / "p.png")
    )
    assert "cannot write" in refusal(capsys, "solve", scene_file, "--json", "a\0b")
    assert "cannot write" in refusal(capsys, "solve", scene_file, "--json", "n" * 300)
    assert fake_core.solved == []


def test_failing_write_keeps_the_old_file(
    fake_core: type[FakeCore],
    scene_file: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    file = tmp_path / "result.json"
    file.write_text("old")

    def full_disk(self: Path, text: str, **_: Any) -> int:
        self.touch()
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full_disk)
    assert main(["solve", scene_file, "--json", str(file)]) == 2
    assert "cannot write" in capsys.readouterr().err
    assert file.read_text() == "old"
    assert sorted(f.name for f in tmp_path.iterdir()) == ["result.json", "small.json"]


def test_interrupt_and_exhaustion_are_undecided(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(_: Any) -> None:
        raise KeyboardInterrupt

    def exhaust(_: Any) -> None:
        raise MemoryError

    for during in (interrupt, exhaust):
        fake_core.during_solve = staticmethod(during)
        assert main(["solve", scene_file]) == 3
        captured = capsys.readouterr()
        if during is interrupt:  # outside the core, so that there is no answer
            assert (captured.out, captured.err) == ("", "planar-planner: interrupted\n")
        else:
            assert captured.out.startswith("small: undecided (out of memory)\n  a --max-memory")
            assert captured.err == ""


def test_defect_prints_one_line(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(_: Any) -> None:
        raise RuntimeError("two\nlines")

    fake_core.during_solve = staticmethod(fail)
    assert main(["solve", scene_file]) == 2
    err = capsys.readouterr().err
    assert err == ("planar-planner: internal error, please report it: RuntimeError: two\\nlines\n")


def test_list_has_every_scene(capsys: pytest.CaptureFixture[str]) -> None:
    from planar_planner.scene.builtin import manifest

    assert main(["list"]) == 0
    heading, *rows = capsys.readouterr().out.splitlines()
    assert heading.split() == ["scene", "obstacles", "vertices", "robot", "expected", "origin"]
    for row, (name, entry) in zip(rows, manifest().items(), strict=True):
        assert row.split()[0] == name
        assert row.endswith(entry["origin"])
        assert f"  {entry['expected'].replace('_', ' ')}  " in row
    gear = next(r.split() for r in rows if r.startswith("gear "))
    assert gear[1:5] == ["2", "128", "32", "path"]


def test_show_describes_a_scene(scene_file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", scene_file]) == 0
    out = capsys.readouterr().out
    assert "small: one obstacle" in out
    assert "obstacles: 1 polygon(s), 4 vertices" in out
    assert "start: (1, 1, 0), goal: (9, 9, 0)" in out
    assert main(["show", "gear-jammed"]) == 0
    assert "expected: no path" in capsys.readouterr().out


def test_help_has_examples_and_exit_status(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    out = capsys.readouterr().out
    assert "planar-planner solve gear --plot gear.png" in out
    assert "2 bad input or usage, 3 undecided" in out
    for command in ("solve", "check", "list", "show"):
        assert main([command, "--help"]) == 0
