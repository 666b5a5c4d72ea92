"""The installed command with the real core: verdicts, refusals, interrupts, pictures."""

from __future__ import annotations

import itertools
import json
import math
import os
import signal
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest

from planar_planner.scene.builtin import manifest
from support.command import COMMAND
from worlds.endless import ENDLESS, long_search
from worlds.small import square

STATUS = {"path": 0, "no_path": 1}
STATS = {
    "cells",
    "cells_by_label",
    "cells_by_level",
    "labelled_cells",
    "separation_evaluations",
    "pairs_touched",
    "pairs_total",
    "faces_tested",
    "search_rounds",
    "memory_bytes",
    "seconds",
}


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*COMMAND, *arguments], capture_output=True, text=True, timeout=300, check=False
    )


def write(folder: Path, content: dict[str, Any]) -> str:
    file = folder / "scene.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    return str(file)


@pytest.mark.parametrize("name", list(manifest()))
def test_expected_verdict(name: str) -> None:
    done = run("check", name, "--json", "-")
    assert done.stderr == ""
    content = json.loads(done.stdout)
    assert content["verdict"] == manifest()[name]["expected"]
    assert done.returncode == STATUS[content["verdict"]]
    assert (content["format"], content["version"]) == ("planar-planner/result", 1)
    assert content["scene"] == name
    assert content["stats"].keys() >= STATS
    assert (len(content["path"]) >= 2) == (content["verdict"] == "path")


def test_path_runs_from_start_to_goal_with_theta_unwrapped() -> None:
    content = json.loads(run("solve", "gear", "--json", "-").stdout)
    from planar_planner import load_scene

    scene = load_scene("gear")
    path = content["path"]
    assert path[0] == pytest.approx(scene.start, abs=1e-12)
    assert path[-1][:2] == pytest.approx(scene.goal[:2], abs=1e-12)
    turns = (path[-1][2] - scene.goal[2]) / math.tau
    assert turns == pytest.approx(round(turns), abs=1e-9)
    assert all(abs(b[2] - a[2]) < math.tau for a, b in itertools.pairwise(path))


def test_negative_start_and_goal(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    scene_dict["workspace"] = {"box": [-10, -10, 10, 10]}
    file = write(tmp_path, scene_dict)
    done = run("solve", file, "--start", "-5,-5,-1", "--goal", "-5,5,0.5", "--json", "-")
    assert done.returncode == 0
    path = json.loads(done.stdout)["path"]
    assert path[0] == pytest.approx([-5, -5, -1])
    assert path[-1][:2] == pytest.approx([-5, 5])


def test_colliding_start_says_with_what_and_how_deep(
    tmp_path: Path, scene_dict: dict[str, Any]
) -> None:
    scene_dict["obstacles"].insert(0, {"type": "Polygon", "coordinates": [square(9, 1, 0.5)]})
    scene_dict["start"] = [5.0, 3.75, 0.0]  # the unit square is 0.25 deep in the one at (5, 5)
    done = run("solve", write(tmp_path, scene_dict))
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert "start: robot collides with obstacles[1], penetration depth 0.25" in done.stderr


def test_start_outside_the_workspace(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    scene_dict["start"] = [0.25, 5.0, 0.0]
    done = run("check", write(tmp_path, scene_dict))
    assert done.returncode == 2
    assert "start: robot is outside the workspace by 0.25" in done.stderr
    del scene_dict["workspace"]
    scene_dict["reference_bounds"] = [1.0, 0.0, 10.0, 10.0]
    done = run("check", write(tmp_path, scene_dict))
    assert "start: reference point is outside reference_bounds by 0.75" in done.stderr


def test_touching_start_is_legal(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    scene_dict["start"] = [0.5, 0.5, 0.0]  # in the corner of the box
    scene_dict["goal"] = [5.0, 3.5, 0.0]  # under the obstacle, touching it
    assert run("solve", write(tmp_path, scene_dict)).returncode in (0, 3)


def test_cell_limit_is_undecided() -> None:
    done = run("check", "maze", "--max-cells", "50", "--json", "-")
    assert done.returncode == 3
    content = json.loads(done.stdout)
    assert content["verdict"] == "undecided"
    assert content["reason"] != ""
    assert content["path"] == []


def test_a_limit_that_was_reached_names_its_option() -> None:
    done = run("solve", "gear", "--max-cells", "50")
    assert done.returncode == 3
    assert "a larger --max-cells may decide it" in done.stdout


def test_timeout_is_undecided() -> None:
    done = run("check", "maze", "--timeout", "1e-6", "--json", "-")
    assert done.returncode == 3
    assert json.loads(done.stdout)["verdict"] == "undecided"


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_pictures(tmp_path: Path, suffix: str) -> None:
    file = tmp_path / f"gear.{suffix}"
    assert run("solve", "gear", "--plot", str(file)).returncode == 0
    assert file.stat().st_size > 1000
    assert [f.name for f in tmp_path.iterdir()] == [file.name]
    assert run("show", "maze", "--plot", str(file)).returncode == 0


@pytest.mark.skipif(os.name != "posix", reason="sends a POSIX signal")
def test_interrupt_ends_at_once_with_statistics(tmp_path: Path) -> None:
    # A job in the background of a script has Ctrl-C ignored, and its children would inherit that.
    inherited = signal.signal(signal.SIGINT, signal.default_int_handler)
    process = subprocess.Popen(
        [*COMMAND, "solve", long_search(tmp_path), *ENDLESS, "--timeout", "100"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    signal.signal(signal.SIGINT, inherited)
    time.sleep(2.0)
    assert process.poll() is None, process.communicate()
    before = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert time.monotonic() - before < 5
    assert process.returncode == 3
    assert "undecided (interrupted)" in out
    assert "cells:" in out
    assert err == ""
