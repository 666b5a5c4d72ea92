"""Builds and runs the programs of ``bench/native/``: measurements inside the cores.

The build folder is kept between runs: ``build/bench`` of the checkout, or ``PLANNER_BENCH_BUILD``.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from lib.provenance import ROOT
from planar_planner import load_scene
from planar_planner.problem.make import Polygons, Problem, make_problem, point_goal

SOURCE = ROOT / "bench" / "native"


class NativeError(RuntimeError):
    """A native program could not be built, failed, or took too long."""


def build_folder() -> Path:
    """Return where the programs are built."""
    return Path(os.environ.get("PLANNER_BENCH_BUILD") or ROOT / "build" / "bench")


def build(target: str) -> Path:
    """Build one program, from scratch or what has changed; raise with the compiler's words."""
    folder = build_folder()
    if shutil.which("cmake") is None:
        raise NativeError("cmake is needed: pip install cmake ninja")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    configure = ["cmake", "-S", str(SOURCE), "-B", str(folder), *generator]
    for command in (configure, ["cmake", "--build", str(folder), "--target", target, "-j", "2"]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise NativeError(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return folder / target


def run(program: Path, scene: Any, *arguments: str, timeout: float = 600.0) -> dict[str, Any]:
    """Run a program on a scene; return what it prints as JSON."""
    try:
        done = subprocess.run(
            [str(program), *arguments],
            input=as_numbers(make_problem(load_scene(scene))),
            capture_output=True,
            text=True,
            check=False,
            timeout=timeout,
        )
    except subprocess.TimeoutExpired:
        raise NativeError(f"{program.name} {' '.join(arguments)}: over {timeout:g} s") from None
    if done.returncode != 0:
        raise NativeError(f"{program.name} {' '.join(arguments)}: {done.stderr}")
    answer: dict[str, Any] = json.loads(done.stdout)
    return answer


def instructions(program: Path, scene: Any, function: str, *arguments: str) -> int | None:
    """Count the instructions executed inside one function; None if valgrind is not installed."""
    if shutil.which("valgrind") is None:
        return None
    with tempfile.NamedTemporaryFile(suffix=".callgrind") as out:
        done = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                "--collect-atstart=no",
                f"--toggle-collect={function}",
                f"--callgrind-out-file={out.name}",
                str(program),
                *arguments,
            ],
            input=as_numbers(make_problem(load_scene(scene))),
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            raise NativeError(f"valgrind {program.name}: {done.stderr}")
        counted = re.search(r"Collected : (\d+)", done.stderr)
        if counted is None:
            raise NativeError(f"valgrind {program.name} counted nothing: {done.stderr}")
        return int(counted[1])


def as_numbers(problem: Problem) -> str:
    """Return a problem as ``read_scene.hpp`` reads it; every double exactly."""
    words: list[str] = [str(int(problem.rotation))]
    for rectangle in (problem.workspace_box, problem.reference_bounds):
        words += ["0"] if rectangle is None else ["1", *map(repr, map(float, rectangle))]
    words += ["0"] if problem.workspace is None else ["1", *_polygons(problem.workspace)]
    words += _polygons(problem.robot) + _polygons(problem.obstacles)
    words += [
        repr(float(v))
        for end in (problem.start, point_goal(problem, "the native benchmark"))
        for v in end
    ]
    return " ".join(words) + "\n"


def _polygons(polygons: Polygons) -> list[str]:
    coords = polygons.coords
    words = [str(len(coords)), *(repr(float(v)) for v in coords.ravel())]
    for starts in (polygons.ring_starts, polygons.polygon_starts):
        words += [str(len(starts)), *(str(int(k)) for k in starts)]
    return words
