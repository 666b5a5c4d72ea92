"""The C++ driver of OMPL's planners (``ompl_native/``): building it, and running it."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lib.provenance import ROOT
from planar_planner.planning.path_judge import unwrapped
from planar_planner.problem.make import Polygons, Problem, point_goal
from planar_planner.scene.fields import Box, Configuration

PLANNERS = ("RRTConnect", "PRM", "KPIECE1", "EST")
SOURCE = ROOT / "bench" / "ompl_native"
BUILD = ROOT / "build" / "ompl_native"
GRACE = 30.0  # seconds beyond the limit, after which a run is ended
INSTALL_HINT = "no OMPL development package is installed (Debian: apt-get install libompl-dev)"


class DriverMissingError(Exception):
    """The driver cannot be built here; the message says why."""


def build_driver() -> Path:
    """Configure and build the driver; return the program.

    Raises
    ------
    DriverMissingError
        If OMPL's development package or CMake is missing, or it does not compile.
    """
    cmake = shutil.which("cmake")
    if cmake is None:
        raise DriverMissingError("no cmake is installed (pip install cmake)")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    configured = _command(cmake, "-S", str(SOURCE), "-B", str(BUILD), *generator)
    if configured.returncode != 0:
        missing = "omplConfig.cmake" in configured.stderr
        raise DriverMissingError(INSTALL_HINT if missing else configured.stderr.strip())
    built = _command(cmake, "--build", str(BUILD), "--parallel", "2")
    if built.returncode != 0:
        raise DriverMissingError(f"does not compile:\n{built.stdout[-2000:]}")
    return BUILD / "ompl_native"


def _command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(arguments, capture_output=True, text=True, check=False)


def dump(problem: Problem) -> str:
    """Return a problem as the driver reads it: numbers and blanks; doubles survive exactly."""
    workspace = problem.workspace
    parts = [
        f"{int(problem.rotation)}",
        _numbers(problem.start),
        _numbers(point_goal(problem, "OMPL")),
        _box(problem.workspace_box),
        _box(problem.reference_bounds),
        _polygons(problem.robot),
        _polygons(problem.obstacles),
        "0" if workspace is None else f"1\n{_polygons(workspace)}",
    ]
    return "\n".join(parts) + "\n"


def _numbers(values: Configuration | Box | Iterable[float]) -> str:
    return " ".join(repr(float(value)) for value in values)


def _box(box: Box | None) -> str:
    return "0" if box is None else f"1 {_numbers(box)}"


def _polygons(polygons: Polygons) -> str:
    points, rings, starts = polygons.arrays
    return "\n".join(
        [
            f"{len(points)} {_numbers(points.ravel().tolist())}",
            f"{len(rings)} {' '.join(map(str, rings.tolist()))}",
            f"{len(starts)} {' '.join(map(str, starts.tolist()))}",
        ]
    )


@dataclass(frozen=True)
class Request:
    """One run: planner, seed, limit in seconds, resolution of motion validation."""

    planner: str
    seed: int
    limit: float
    resolution: float


def run_driver(program: Path, dumped: Path, request: Request) -> dict[str, Any]:
    """Run a planner once in a process of its own; what comes back is as of `sampler_run`."""
    numbers = (str(request.seed), repr(request.limit), repr(request.resolution))
    try:
        done = subprocess.run(
            [str(program), str(dumped), request.planner, *numbers],
            capture_output=True,
            text=True,
            timeout=2 * request.limit + GRACE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return {"error": "did not stop at its limit"}
    if done.returncode != 0:
        return {"error": done.stderr.strip() or f"ended with status {done.returncode}"}
    answer: dict[str, Any] = json.loads(done.stdout)
    return answer | {"path": unwrapped(answer["path"]).tolist()}
